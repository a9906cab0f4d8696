// The interface around a body in 3D: faces of its lattice, corners that follow its particles.
#include <Eigen/LU>
#include <cmath>
#include <numeric>
#include <numbers>
#include <random>
#include <set>

#include "engine/particles/surface.hpp"
#include "engine/particles/surface_facets.hpp"
#include "tests/catch.hpp"
#include "tests/neighbor/scopes.hpp"

namespace sluice::test_surface_3d {
namespace {

/// A packed body with its surface.
struct Body {
    Body(const ShapePtr& shape, double spacing) : packing(pack(*shape, spacing, 3)) {
        surface.add_body(packing, 0, 7);
        surface.allocate(elements);
        for (const Point& p : packing.position) initial.push_back({{p[0], p[1], p[2]}});
        Array<std::uint64_t> ids(initial.size());
        std::iota(ids.begin(), ids.end(), std::uint64_t{0});
        index_of_id = IdIndex(ids);
        move([](const Vec<3>& x) { return x; });
    }
    /// Brings the particles from their initial places to others, and the surface with them.
    template <class Motion>
    void move(Motion&& motion) {
        VectorField<3> position;
        for (std::size_t i = 0; i < initial.size(); ++i) position.push_back(motion(initial[i]));
        surface.update(position, index_of_id, elements);
    }
    Vec<3> sum_of_area() const {
        Vec<3> sum;
        for (std::size_t k = 0; k < elements.owned; ++k) sum += elements.area_normal[k];
        return sum;
    }
    double area() const {
        double sum = 0;
        for (std::size_t k = 0; k < elements.owned; ++k) sum += norm(elements.area_normal[k]);
        return sum;
    }
    /// By the divergence theorem: ⅓ Σ x·n ΔΓ.
    double enclosed_volume() const {
        double sum = 0;
        for (std::size_t k = 0; k < elements.owned; ++k) sum += dot(elements.position[k], elements.area_normal[k]) / 3;
        return sum;
    }

    Packing packing;
    std::vector<Vec<3>> initial;
    IdIndex index_of_id;
    BodySurface<3> surface;
    ParticleSet<3> elements;
};

std::vector<Site> block(std::int32_t nx, std::int32_t ny, std::int32_t nz) {
    std::vector<Site> sites;
    for (std::int32_t z = 0; z < nz; ++z)
        for (std::int32_t y = 0; y < ny; ++y)
            for (std::int32_t x = 0; x < nx; ++x) sites.push_back({x, y, z});
    return sites;
}

const ShapePtr plain_box = make_box({0.2, 0.1, -0.3}, {0.5, 0.6, -0.1});
/// Shapes with all that a surface can have: curvature, a hole through, a cavity, inner edges, parts that touch along an
/// edge.
const std::vector<ShapePtr> shapes{
    plain_box,
    make_ball({0.1, 0, 0}, 0.3),
    make_difference(make_cylinder({0, 0, 0}, {0, 0.2, 0}, 0.3), {make_cylinder({0, 0, 0}, {0, 0.2, 0}, 0.15)}),
    make_difference(make_box({0, 0, 0}, {0.4, 0.4, 0.4}), {make_box({0.15, 0.15, 0.1}, {0.25, 0.25, 0.3})}),
    make_extrusion({{0, 0, 0}, {0.4, 0, 0}, {0.4, 0.2, 0}, {0.2, 0.2, 0}, {0.2, 0.4, 0}, {0, 0.4, 0}}, 0, {0, 0.3}),
    make_union({make_box({0, 0, 0}, {0.2, 0.2, 0.2}), make_box({0.2, 0.2, 0}, {0.4, 0.4, 0.2})}),
};

}  // namespace

TEST_CASE("A block has the faces of its sides and shares the corners between them", "[surface]") {
    const auto facets = trace_surface(block(3, 2, 2));
    REQUIRE(facets.faces.size() == 2 * (3 * 2 + 3 * 2 + 2 * 2));
    REQUIRE(facets.corners.size() == 4 * 3 * 3 - 2);  // all corners but the two inside
    // A cavity is a second closed surface: 6 faces and 8 corners more.
    auto hollow = block(5, 5, 5);
    hollow.erase(std::find(hollow.begin(), hollow.end(), Site{2, 2, 2}));
    const auto outer = trace_surface(block(5, 5, 5)), both = trace_surface(hollow);
    REQUIRE(both.faces.size() == outer.faces.size() + 6);
    REQUIRE(both.corners.size() == outer.corners.size() + 8);
}

TEST_CASE("Every edge of the surface is run through as often in one direction as in the other", "[surface]") {
    std::mt19937 random(1);
    for (int round = 0; round < 20; ++round) {
        // Cubes of eight bricks put down at random touch in every way: at faces, edges, corners.
        std::set<Site> taken;
        for (int cube = 0; cube < 12; ++cube) {
            const Site at{static_cast<std::int32_t>(random() % 5), static_cast<std::int32_t>(random() % 5),
                          static_cast<std::int32_t>(random() % 5)};
            for (const Site& s : block(2, 2, 2)) taken.insert({at[0] + s[0], at[1] + s[1], at[2] + s[2]});
        }
        const std::vector<Site> sites(taken.begin(), taken.end());
        const auto facets = trace_surface(sites);
        std::multiset<std::pair<Index, Index>> edges;
        for (const auto& face : facets.faces)
            for (std::size_t c = 0; c < 4; ++c) edges.insert({face[c], face[(c + 1) % 4]});
        for (const auto& [a, b] : edges) REQUIRE(edges.count({a, b}) == edges.count({b, a}));
    }
}

TEST_CASE("The surface around a box is the box", "[surface]") {
    const Body body(plain_box, 0.05);
    const auto& e = body.elements;
    REQUIRE(e.owned == 2 * (6 * 10 + 10 * 4 + 6 * 4));
    REQUIRE(e.body == Array<std::uint16_t>(e.owned, 7));
    const Bounds box = plain_box->bounds();
    for (std::size_t k = 0; k < e.owned; ++k) {
        const Vec<3> n = e.area_normal[k], x = e.position[k];
        // Weights are known to 1e-13, see the test of the least-squares shares; lengths are of the order of 1 m.
        REQUIRE(norm(n) == Approx(0.05 * 0.05).epsilon(1e-11));
        int on_sides = 0;
        for (int a = 0; a < 3; ++a) {
            const auto s = static_cast<std::size_t>(a);
            const double side = n[a] > 0 ? box.max[s] : box.min[s];
            if (std::abs(n[a]) > 0.9 * norm(n)) on_sides += std::abs(x[a] - side) < 1e-12;
        }
        REQUIRE(on_sides == 1);
    }
    REQUIRE(body.enclosed_volume() == Approx(0.3 * 0.5 * 0.2).epsilon(1e-11));
}

TEST_CASE("Around any shape the area vectors add up to nothing, however it deforms", "[surface]") {
    for (const ShapePtr& shape : shapes) {
        Body body(shape, 0.05);
        const double volume = body.packing.volume * static_cast<double>(body.initial.size());
        REQUIRE(body.enclosed_volume() == Approx(volume).epsilon(1e-10));
        std::mt19937 random(3);
        std::uniform_real_distribution<double> shift(-0.05, 0.05);
        for (int round = 0; round < 3; ++round) {
            // Particles thrown about by a spacing, far from the origin.
            body.move([&](const Vec<3>& x) { return x + Vec<3>{{5 + shift(random), shift(random), shift(random)}}; });
            // Rounding of places at 5 m, times the length of an edge, over some 1000 elements.
            REQUIRE(norm(body.sum_of_area()) < 1e-14);
        }
    }
}

TEST_CASE("An affine deformation takes the surface along exactly", "[surface]") {
    Eigen::Matrix3d f;
    f << 1.2, 0.3, -0.2, 0.1, 0.8, 0.4, -0.3, 0.2, 1.1;
    const Eigen::Matrix3d cofactor = f.determinant() * f.inverse().transpose();
    const auto times = [](const Eigen::Matrix3d& m, const Vec<3>& x) {
        const Eigen::Vector3d y = m * Eigen::Vector3d(x[0], x[1], x[2]);
        return Vec<3>{{y[0], y[1], y[2]}};
    };
    for (const ShapePtr& shape : shapes) {
        Body body(shape, 0.05);
        const auto x = body.elements.position, n = body.elements.area_normal;
        const Vec<3> shift{{0.3, -0.1, 0.2}};
        body.move([&](const Vec<3>& p) { return times(f, p) + shift; });
        for (std::size_t k = 0; k < body.elements.owned; ++k) {
            // Nanson's formula: n ΔΓ turns and grows with the cofactor of the gradient.
            REQUIRE(norm(body.elements.position[k] - times(f, x[k]) - shift) < 1e-12);
            REQUIRE(norm(body.elements.area_normal[k] - times(cofactor, n[k])) < 1e-11 * norm(n[k]));
        }
    }
}

TEST_CASE("Areas and places follow a smooth deformation to second order", "[surface]") {
    // A block bent around the z-axis, twisted and stretched, with its gradient.
    const auto motion = [](const Vec<3>& x) {
        const double r = 1 + x[0] + 0.1 * x[2] * x[2], angle = x[1] + 0.3 * x[2];
        return Vec<3>{{r * std::cos(angle), r * std::sin(angle), x[2] * (1 + 0.2 * x[1])}};
    };
    const auto gradient = [&](const Vec<3>& x) {
        Eigen::Matrix3d f;
        constexpr double step = 1e-5;  // central differences: error step² and rounding/step, both 1e-10
        for (int k = 0; k < 3; ++k) {
            Vec<3> ahead = x, behind = x;
            ahead[k] += step, behind[k] -= step;
            const Vec<3> column = (0.5 / step) * (motion(ahead) - motion(behind));
            for (int i = 0; i < 3; ++i) f(i, k) = column[i];
        }
        return f;
    };
    struct Errors {
        double place = 0, area = 0, inner_area = 0, volume = 0, total_area = 0;
    };
    const auto errors_at = [&](double d) {
        Body body(make_box({0, 0, 0}, {0.4, 0.8, 0.4}), d);
        const auto x = body.elements.position, n = body.elements.area_normal;
        const double sides = body.area();
        double exact_volume = 0, exact_area = 0, inner = 0;
        for (const Vec<3>& p : body.initial) exact_volume += gradient(p).determinant() * d * d * d;
        body.move(motion);
        Errors e;
        for (std::size_t k = 0; k < body.elements.owned; ++k) {
            const Eigen::Matrix3d f = gradient(x[k]);
            const Eigen::Vector3d exact =
                f.determinant() * f.inverse().transpose() * Eigen::Vector3d(n[k][0], n[k][1], n[k][2]);
            const Vec<3> found = body.elements.area_normal[k];
            const double miss2 = (exact - Eigen::Vector3d(found[0], found[1], found[2])).squaredNorm() / norm2(n[k]);
            const double share = norm(n[k]) / sides;
            e.area += share * miss2;
            e.place += share * norm2(body.elements.position[k] - motion(x[k]));
            exact_area += exact.norm();
            // More than two spacings from the edges of the block.
            int near_sides = 0;
            for (int a = 0; a < 3; ++a) near_sides += std::min(x[k][a], (a == 1 ? 0.8 : 0.4) - x[k][a]) < 2 * d;
            if (near_sides > 1) continue;
            e.inner_area += share * miss2;
            inner += share;
        }
        return Errors{std::sqrt(e.place), std::sqrt(e.area), std::sqrt(e.inner_area / inner),
                      std::abs(body.enclosed_volume() / exact_volume - 1), std::abs(body.area() / exact_area - 1)};
    };
    const Errors coarse = errors_at(0.05), fine = errors_at(0.025);
    const auto order = [](double a, double b) { return std::log2(a / b); };
    CAPTURE(coarse.area, coarse.inner_area, coarse.total_area, coarse.volume, coarse.place);
    // As surface.hpp derives: second order, but first order in a share of the area that is itself of first order, which
    // makes the root mean square of the areas 3/2. Measured 1.97, 2.00, 1.51, 1.94, 1.93 between these two spacings.
    CHECK(order(coarse.place, fine.place) > 1.9);
    CHECK(order(coarse.inner_area, fine.inner_area) > 1.9);
    CHECK(order(coarse.area, fine.area) > 1.4);
    CHECK(order(coarse.total_area, fine.total_area) > 1.8);
    CHECK(order(coarse.volume, fine.volume) > 1.8);
    // With 16 bricks across a radius of curvature of 0.8 m: d²/8R² is 5e-4, and the fit misses a few times that.
    CHECK(coarse.inner_area < 2e-3);
}

TEST_CASE("Parts that touch along an edge part without pulling at each other", "[surface]") {
    Body body(shapes.back(), 0.05);
    const auto x = body.elements.position, n = body.elements.area_normal;
    const Vec<3> shift{{0.3, 0.1, 0}};
    const auto is_second = [](const Vec<3>& p) { return p[0] + p[1] > 0.4; };  // beyond the common edge
    body.move([&](const Vec<3>& p) { return is_second(p) ? p + shift : p; });
    for (std::size_t k = 0; k < body.elements.owned; ++k) {
        // An element's own part lies against its normal.
        const Vec<3> expected = is_second(x[k] - (0.025 / norm(n[k])) * n[k]) ? x[k] + shift : x[k];
        REQUIRE(norm(body.elements.position[k] - expected) < 1e-12);
        REQUIRE(norm(body.elements.area_normal[k] - n[k]) < 1e-11 * norm(n[k]));
    }
}

TEST_CASE("The surface is the same to the bit on any number of threads", "[surface]") {
    Body body(make_box({0, 0, 0}, {1, 1, 1}), 0.04);  // 3750 elements: enough to be shared out
    std::vector<ParticleSet<3>> results;
    for (const int threads : {1, 2, 4}) {
        const ThreadScope scope(threads);
        body.move([](const Vec<3>& x) { return Vec<3>{{std::sin(x[0] + x[1]), x[1] * x[2], std::exp(x[2])}}; });
        results.push_back(body.elements);
    }
    for (const auto& e : results) {
        REQUIRE(e.position.c == results[0].position.c);
        REQUIRE(e.area_normal.c == results[0].area_normal.c);
    }
}

}  // namespace sluice::test_surface_3d
