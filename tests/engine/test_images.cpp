// Ghosts across mirror walls.
#include "engine/particles/ghosts.hpp"

#include "tests/catch.hpp"

namespace sluice::test_images {
namespace {

const GhostPlane<2> floor_plane{{{0.0, 0.0}}, {{0.0, 1.0}}};
const GhostPlane<2> left_plane{{{0.0, 0.0}}, {{1.0, 0.0}}};

}  // namespace

TEST_CASE("Particles near a plane have an image behind it, others none") {
    VectorField<2> x;
    x.push_back({{0.5, 0.01}});
    x.push_back({{0.5, 0.5}});
    Ghosts<2> ghosts;
    ghosts.create({floor_plane}, x, 2, [](std::size_t) { return 0.1; });
    REQUIRE(ghosts.count() == 1);
    REQUIRE(x.size() == 3);
    REQUIRE(x[2] == Vec<2>{{0.5, -0.01}});
    REQUIRE(ghosts.parent(0) == 0);
}

TEST_CASE("In a corner the image of an image fills the quarter behind both planes") {
    VectorField<2> x;
    x.push_back({{0.02, 0.01}});
    Ghosts<2> ghosts;
    ghosts.create({floor_plane, left_plane}, x, 1, [](std::size_t) { return 0.1; });
    REQUIRE(ghosts.count() == 3);
    REQUIRE(x[1] == Vec<2>{{0.02, -0.01}});
    REQUIRE(x[2] == Vec<2>{{-0.02, 0.01}});
    REQUIRE(x[3] == Vec<2>{{-0.02, -0.01}});
}

TEST_CASE("Ghosts follow their owners: velocities reflected, scalars copied") {
    VectorField<2> x, v;
    x.push_back({{0.02, 0.01}});
    v.push_back({{3.0, -1.0}});
    ScalarField p{7.0};
    Ghosts<2> ghosts;
    ghosts.create({floor_plane, left_plane}, x, 1, [](std::size_t) { return 0.1; });
    ghosts.extend<Mirror::same>(p, 1);
    v.resize(4);
    p[0] = 8;
    x.set(0, {{0.03, 0.02}});
    ghosts.follow<Mirror::same>(p, 1);
    ghosts.follow<Mirror::direction>(v, 1);
    ghosts.follow<Mirror::place>(x, 1);
    REQUIRE(v[1] == Vec<2>{{3.0, 1.0}});
    REQUIRE(v[2] == Vec<2>{{-3.0, -1.0}});
    REQUIRE(v[3] == Vec<2>{{-3.0, 1.0}});
    REQUIRE(x[3] == Vec<2>{{-0.03, -0.02}});
    REQUIRE(p == ScalarField{8, 8, 8, 8});
}

TEST_CASE("Planes are told apart however many there are") {
    // Twice 256 and more, of which the particle meets the last two.
    std::vector<GhostPlane<2>> planes(600, {{{0.0, -100.0}}, {{0.0, 1.0}}});
    planes.push_back(floor_plane);
    planes.push_back(left_plane);
    VectorField<2> x;
    x.push_back({{0.02, 0.01}});
    Ghosts<2> ghosts;
    ghosts.create(planes, x, 1, [](std::size_t) { return 0.1; });
    REQUIRE(ghosts.count() == 3);
    REQUIRE(x[1] == Vec<2>{{0.02, -0.01}});
    REQUIRE(x[2] == Vec<2>{{-0.02, 0.01}});
    REQUIRE(x[3] == Vec<2>{{-0.02, -0.01}});
}

TEST_CASE("Ghosts by more ways across planes than have numbers are refused, not mixed up") {
    // Each plane doubles the ways to a particle that it meets, the one across no plane included.
    const auto ghosts_across = [](std::size_t planes) {
        VectorField<2> x;
        x.push_back({{0.02, 0.01}});
        Ghosts<2> ghosts;
        ghosts.create(std::vector<GhostPlane<2>>(planes, floor_plane), x, 1, [](std::size_t) { return 0.1; });
        return ghosts.count();
    };
    REQUIRE(ghosts_across(16) == 65535);
    REQUIRE_THROWS_AS(ghosts_across(17), TooManyGhostPaths);
}

TEST_CASE("An oblique plane reflects along its normal") {
    const double r = std::sqrt(0.5);
    const GhostPlane<2> plane{{{1.0, 0.0}}, {{r, r}}};
    REQUIRE(plane.distance({{2.0, 0.0}}) == Approx(r));
    const Vec<2> image = plane.image_position({{2.0, 0.0}});
    REQUIRE(image[0] == Approx(1.0).margin(1e-15));
    REQUIRE(image[1] == Approx(-1.0));
}

}  // namespace sluice::test_images
