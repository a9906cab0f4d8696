// Do the bodies of a scene fit together in space, and is its sound fast enough?
#include <algorithm>
#include <cmath>

#include "engine/scene/check/checks.hpp"
#include "engine/scene/check/memory_check.hpp"
#include "engine/scene/check/overlap.hpp"
#include "engine/scene/check/thickness.hpp"
#include "tests/catch.hpp"
#include "tests/engine/scene_text.hpp"

namespace sluice::test_scene_checks {
using namespace scene_text;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

const std::string tank = R"(gravity = [0.0, -9.81]
[method]
spacing = 1e-3
[materials]
water = { kind = "fluid", density = 1000.0, sound_speed = 30 }
rubber = { kind = "solid", density = 1100.0, youngs_modulus = 1.2e7, poisson_ratio = 0.4 }
[bodies.water]
material = "water"
shape = { box = { min = [-0.1, 0.0], max = [0.0, 0.14] } }
spacing = 2e-3
[bodies.gate]
material = "rubber"
shape = { box = { min = [0.0, 0.0], max = [0.005, 0.08] } }
clamp = { box = { min = [0.0, 0.075], max = [0.005, 0.08] } }
[walls.bottom]
kind = "mirror"
point = [0.0, 0.0]
normal = [0.0, 1.0]
[walls.upper]
kind = "fixed"
shape = { box = { min = [0.0, 0.08], max = [0.005, 0.14] } }
[probes.free_end]
kind = "displacement"
body = "gate"
at = [0.0025, 0.0]
[output]
end = 0.4
)";

void check(const std::string& text, const std::vector<std::string>& overrides = {}) {
    const Scene scene = load(text, overrides);
    const std::vector<Packing> bodies = pack_bodies(scene);
    check_geometry(scene, bodies, pack_walls(scene));
    check_mach(scene, bodies);
}

std::string check_error(const std::string& text) {
    return error_of([&] { check(text); });
}

std::string error_with(const std::string& from, const std::string& to) { return check_error(with(tank, from, to)); }

double expected_speed(const std::string& text) {
    const Scene scene = load(text);
    return expected_fluid_speed(scene, pack_bodies(scene));
}

}  // namespace

TEST_CASE("bodies that touch are accepted", "[checks]") {
    CHECK(check_error(tank) == "");
    const Scene scene = load(tank);
    const auto bodies = pack_bodies(scene), walls = pack_walls(scene);
    REQUIRE(bodies.size() == 2);
    CHECK(bodies[0].position.size() == 50 * 70);
    CHECK(bodies[1].position.size() == 5 * 80);
    REQUIRE(walls.size() == 2);
    CHECK(walls[0].position.empty());
    CHECK(walls[1].position.size() == 5 * 60);
}

TEST_CASE("a body or wall without particles", "[checks]") {
    // A ring finer than the lattice: no site's centre falls into it.
    const std::string ring =
        "{ difference = [{ box = { min = [0.0, 0.0], max = [0.005, 0.08] } }, { box = { min = "
        "[0.0001, 0.0001], max = [0.0049, 0.0799] } }] }";
    CHECK(error_with("{ box = { min = [0.0, 0.0], max = [0.005, 0.08] } }", ring) ==
          "13: bodies.gate.shape: found no particle in it at a spacing of 0.001 m, expected one or more: reduce "
          "method.spacing");
    const std::string thin_wall =
        "{ difference = [{ box = { min = [0.0, 0.08], max = [0.005, 0.14] } }, { box = { min = "
        "[0.0001, 0.08], max = [0.005, 0.14] } }] }\nspacing_ratio = 1";
    CHECK(error_with("{ box = { min = [0.0, 0.08], max = [0.005, 0.14] } }", thin_wall) ==
          "21: walls.upper.shape: found no particle in it at a spacing of 0.001 m, expected one or more: reduce "
          "walls.upper.spacing_ratio");
}

TEST_CASE("a spacing too small to count the particles", "[checks]") {
    CHECK(error_with("spacing = 2e-3", "spacing = 1e-9") ==
          "10: bodies.water.spacing: found 1e-09 m, which makes 1.4e+16 lattice sites for bodies.water, expected a "
          "spacing "
          "that makes 2.1e+09 at the most");
}

TEST_CASE("a solid thinner than two particles", "[checks]") {
    CHECK(error_with("material = \"rubber\"", "material = \"rubber\"\nspacing = 0.004") ==
          "13: bodies.gate.spacing: found a spacing of 0.004 m, which makes bodies.gate one particle thick along x at "
          "(0.0025, 0.002), expected 0.0025 m or less for two particles across its 0.005 m");
    // Without a spacing of its own the body answers for the scene's.
    CHECK_THAT(error_with("spacing = 1e-3", "spacing = 4e-3"),
               StartsWith("3: method.spacing: found a spacing of 0.004 m, which makes bodies.gate one particle thick"));
    CHECK(error_with("material = \"rubber\"", "material = \"rubber\"\nspacing = 0.0025") == "");
}

TEST_CASE("thin places", "[checks]") {
    const auto thin = [](const ShapePtr& shape, double d, int dimension) {
        return find_thin_place(*shape, pack(*shape, d, dimension), dimension);
    };
    // Tips and poles end in single particles, which is no fault.
    CHECK_FALSE(thin(make_polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), 0.1, 2));
    for (const double diameters : {2, 3, 5, 7, 9}) {
        CAPTURE(diameters);
        CHECK_FALSE(thin(make_ball({0, 0, 0}, 0.5), 1 / diameters, 2));
        CHECK_FALSE(thin(make_ball({0, 0, 0}, 0.5), 1 / diameters, 3));
    }
    // A single particle has nothing to lean on.
    CHECK(thin(make_ball({0, 0, 0}, 0.5), 1, 2));
    // A block with a strip one particle thick, found where the strip is.
    const auto strip =
        thin(make_union({make_box({0, 0, 0}, {0.4, 0.4, 0}), make_box({0.4, 0.1, 0}, {1, 0.2, 0})}), 0.1, 2);
    REQUIRE(strip);
    CHECK(strip->axis == 1);
    CHECK(strip->thickness == Approx(0.1).epsilon(1e-5));  // bisected to 2^-24 of a spacing, either side
    const auto plate = thin(make_box({0, 0, 0}, {1, 1, 0.1}), 0.1, 3);
    REQUIRE(plate);
    CHECK(plate->axis == 2);
    CHECK_FALSE(thin(make_box({0, 0, 0}, {1, 1, 0.2}), 0.1, 3));
}

TEST_CASE("bodies that overlap", "[checks]") {
    CHECK(error_with("min = [0.0, 0.0], max = [0.005, 0.08]", "min = [-0.003, 0.0], max = [0.005, 0.08]") ==
          "13: bodies.gate.shape: found an overlap with bodies.water.shape (line 9): a particle inside the other's "
          "shape at "
          "(-0.0025, 0.0005), expected shapes that touch at the most");
    // A circle inside a box with a hole of just its size: no centre is inside the other shape, but some are too close.
    const std::string disc = R"({ circle = { centre = [-0.05, 0.07], radius = 0.02 } }
spacing_ratio = 2.1
[bodies.lake]
material = "water"
shape = { difference = [{ box = { min = [-0.1, 0], max = [0, 0.14] } },
  { circle = { centre = [-0.05, 0.07], radius = 0.02 } }] }
)";
    CHECK_THAT(error_with("{ box = { min = [-0.1, 0.0], max = [0.0, 0.14] } }", disc),
               StartsWith("13: bodies.lake.shape: found an overlap with bodies.water.shape (line 9): particles ") &&
                   Contains("m apart, less than half the finer spacing of 0.002 m"));
    CHECK_THAT(
        error_with("max = [0.005, 0.08]", "max = [0.005, 0.1]"),
        StartsWith("13: bodies.gate.shape: found an overlap with walls.upper.shape (line 21): a particle inside"));
}

TEST_CASE("the search for close particles finds what all pairs show", "[checks]") {
    // A ball in a hole of its own size, packed at another spacing: some are too close and some not.
    int overlaps = 0, clear = 0;
    for (const int dimension : {2, 3})
        for (int step = 0; step < 12; ++step) {
            const ShapePtr ball = make_ball({0.3, -0.2, 0.1 * (dimension - 2)}, 1);
            const ShapePtr hole = make_difference(make_box({-2, -2, -2.0 * (dimension - 2)}, {2, 2, 2}), {ball});
            const double d_ball = 0.1 + 0.013 * step, d_hole = 0.2;
            const Packing inner = pack(*ball, d_ball, dimension), outer = pack(*hole, d_hole, dimension);
            double least = 10;
            for (const Point& p : inner.position)
                for (const Point& q : outer.position)
                    least = std::min(least, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
            const bool expected = least < 0.5 * std::min(d_ball, d_hole);
            CAPTURE(dimension, step, least);
            const PackedRegion a{ball.get(), &inner, d_ball}, b{hole.get(), &outer, d_hole};
            CHECK(find_overlap(a, b).has_value() == expected);
            CHECK(find_overlap(b, a).has_value() == expected);
            (expected ? overlaps : clear)++;
        }
    CHECK(overlaps > 0);
    CHECK(clear > 0);
}

TEST_CASE("fluid behind a mirror wall", "[checks]") {
    CHECK(error_with("point = [0.0, 0.0]", "point = [0.0, 0.01]") ==
          "9: bodies.water.shape: found a particle at (-0.099, 0.001), 0.009 m behind walls.bottom (line 15), expected "
          "all "
          "of the fluid on the side that its normal points to");
}

TEST_CASE("a clamp that holds nothing", "[checks]") {
    CHECK(error_with("min = [0.0, 0.075], max = [0.005, 0.08]", "min = [0.0, 0.0796], max = [0.005, 0.08]") ==
          "14: bodies.gate.clamp: found no particle of bodies.gate in it, expected one or more");
}

TEST_CASE("a displacement probe away from its body", "[checks]") {
    CHECK(error_with("at = [0.0025, 0.0]", "at = [0.0025, -0.01]") ==
          "25: probes.free_end.at: found (0.0025, -0.01), 0.0105 m from the nearest particle of bodies.gate (line 11), "
          "expected a place within its smoothing length of 0.0015 m");
    CHECK(error_with("at = [0.0025, 0.0]", "at = [0.005, 0.0]") == "");
}

TEST_CASE("the expected speed of the fluid", "[checks]") {
    // Torricelli over the whole column.
    CHECK(expected_speed(tank) == Approx(std::sqrt(2 * 9.81 * 0.14)).epsilon(1e-12));
    CHECK(expected_speed(with(tank, "spacing = 1e-3", "spacing = 1e-3\nexpected_speed = 3.5")) == 3.5);
    CHECK(expected_speed(with(tank, "spacing = 2e-3", "spacing = 2e-3\nvelocity = [3, \"4*(y > 0.1)\"]")) == 5);
    CHECK(expected_speed(with(tank, "gravity = [0.0, -9.81]", "")) == 0);
    // Onto whichever is lower: a wall below, or the mirror floor.
    CHECK(expected_speed(
              with(tank, "min = [0.0, 0.08], max = [0.005, 0.14]", "min = [0.0, -0.06], max = [0.005, 0.0]")) ==
          Approx(std::sqrt(2 * 9.81 * 0.2)).epsilon(1e-12));
    CHECK(expected_speed(with(tank, "point = [0.0, 0.0]", "point = [0.0, -0.86]")) ==
          Approx(std::sqrt(2 * 9.81 * 1.0)).epsilon(1e-12));
    CHECK(expected_speed(with(tank, "material = \"water\"", "material = \"rubber\"")) == 0);
}

TEST_CASE("sound too slow for the expected speed", "[checks]") {
    // sqrt(2 · 9.81 · 0.14) = 1.657 m/s, so 16.6 m/s are just enough for Mach 0.1.
    CHECK(error_with("sound_speed = 30", "sound_speed = 10") ==
          "5: materials.water.sound_speed: found 10 m/s; Mach 0.17 expected (1.66 m/s), limit 0.1: raise sound_speed "
          "to at "
          "least 16.6");
    CHECK(error_with("sound_speed = 30", "sound_speed = 16.6") == "");
    CHECK_THAT(
        error_with("spacing = 1e-3", "spacing = 1e-3\nexpected_speed = 6"),
        Contains("Mach 0.2 expected (6 m/s by method.expected_speed), limit 0.1: raise sound_speed to at least 60"));
    CHECK_THROWS_WITH(check(tank, {"materials.water.sound_speed=10"}),
                      Contains(".toml: --set materials.water.sound_speed: found 10 m/s"));
}

TEST_CASE("A scene that does not fit into memory is refused with what it needs") {
    const Scene scene = load(tank);
    const std::vector<Packing> bodies = pack_bodies(scene), walls = pack_walls(scene);
    CHECK_NOTHROW(check_memory(scene, bodies, walls, 1e9));
    CHECK_THROWS_WITH(check_memory(scene, bodies, walls, 1e5),
                      Contains("method.spacing: found 0.001 m, which makes ") && Contains(" particles; they take ") &&
                          Contains("0.0001 GB are free; expected 0."));
    CHECK(available_memory() > 1e7);  // this process runs
}

TEST_CASE("A spacing far beyond a body's size is refused") {
    CHECK_THROWS_WITH(check(tank, {"bodies.water.spacing=0.3"}),
                      Contains("found a spacing of 0.3 m, more than twice the 0.1 m of bodies.water along x"));
    CHECK_THROWS_WITH(check(tank, {"bodies.water.spacing=1e308"}), Contains("expected 0.1 m or less"));
}

}  // namespace sluice::test_scene_checks
