// Shapes and their lattice packings.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "engine/geometry/packing.hpp"
#include "engine/geometry/simple_polygon.hpp"
#include "tests/catch.hpp"

namespace sluice::test_shapes {

namespace {

double count(const Packing& p) { return static_cast<double>(p.position.size()); }
double filled(const Packing& p) { return p.volume * count(p); }

}  // namespace

TEST_CASE("a box is filled exactly, whatever the spacing", "[packing]") {
    for (const double d : {0.002, 0.003, 0.0081, 0.05, 1.0}) {
        const auto box = make_box({-0.1, 0, 0}, {0, 0.14, 0.06});
        const Packing flat = pack(*box, d, 2), solid = pack(*box, d, 3);
        CAPTURE(d);
        CHECK(count(flat) == std::max(1.0, std::round(0.1 / d)) * std::max(1.0, std::round(0.14 / d)));
        // Products of a handful of rounded quotients: a few units in the last place.
        CHECK(filled(flat) == Approx(0.1 * 0.14).epsilon(1e-14));
        CHECK(filled(solid) == Approx(0.1 * 0.14 * 0.06).epsilon(1e-14));
        CHECK(flat.position.front()[0] - flat.spacing[0] / 2 == Approx(-0.1).epsilon(1e-14));
        CHECK(flat.position.back()[1] + flat.spacing[1] / 2 == Approx(0.14).epsilon(1e-14));
        CHECK(flat.spacing[2] == 1);
        CHECK(flat.position.front()[2] == 0);
    }
}

TEST_CASE("sites are unique and ascend in z, y, x", "[packing]") {
    const Packing p = pack(*make_ball({0, 0, 0}, 1), 0.25, 3);
    for (std::size_t i = 1; i < p.site.size(); ++i) {
        const auto &a = p.site[i - 1], &b = p.site[i];
        REQUIRE(std::tuple(a[2], a[1], a[0]) < std::tuple(b[2], b[1], b[0]));
    }
    for (std::size_t i = 0; i < p.site.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            REQUIRE(p.position[i][k] == Approx(-1 + (p.site[i][k] + 0.5) * p.spacing[k]).margin(1e-15));
}

TEST_CASE("a ball is a disc in 2D", "[shape]") {
    const auto circle = make_ball({1, 2, 0}, 0.5);
    const Packing disc = pack(*circle, 0.01, 2), ball = pack(*circle, 0.05, 3);
    // The count of lattice points misses the area by no more than a share of the rim's, about d / r.
    CHECK(filled(disc) == Approx(std::numbers::pi * 0.25).epsilon(0.01 / 0.5));
    CHECK(filled(ball) == Approx(std::numbers::pi / 6).epsilon(0.05 / 0.5));
    CHECK(circle->contains({1.5, 2, 0}));
    CHECK_FALSE(circle->contains({1.36, 2.36, 0}));
    CHECK_FALSE(circle->contains({1.3, 2.3, 0.3}));
}

TEST_CASE("a cylinder holds its ends and its rim", "[shape]") {
    const auto upright = make_cylinder({1, 2, 3}, {1, 2, 5}, 0.5);
    CHECK(upright->bounds().min == Point{0.5, 1.5, 3});
    CHECK(upright->bounds().max == Point{1.5, 2.5, 5});
    for (const Point& p : {Point{1.5, 2, 3}, Point{1, 1.5, 5}, Point{1.3, 2.4, 4}}) CHECK(upright->contains(p));
    for (const Point& p : {Point{1.36, 2.36, 4}, Point{1, 2, 2.99}, Point{1, 2, 5.01}})
        CHECK_FALSE(upright->contains(p));
    // An oblique one: bounds that touch it, ends square to its axis, the same from either end.
    const Point a{0, 0, 0}, b{2, 1, 2};
    const auto oblique = make_cylinder(a, b, 0.3), reversed = make_cylinder(b, a, 0.3);
    const double across_y = std::sqrt(1 - 1.0 / 9);  // the axis is (2, 1, 2)/3
    CHECK(oblique->bounds().max[1] == Approx(1 + 0.3 * across_y).epsilon(1e-14));
    CHECK(reversed->bounds().max[1] == Approx(oblique->bounds().max[1]).epsilon(1e-14));
    CHECK(oblique->contains({2 - 2 * 0.1 / across_y, 1 + 0.299 * across_y, 2 - 2 * 0.1 / across_y}) ==
          reversed->contains({2 - 2 * 0.1 / across_y, 1 + 0.299 * across_y, 2 - 2 * 0.1 / across_y}));
    CHECK(oblique->contains({1, 0.5, 1}));
    CHECK_FALSE(oblique->contains({2.02, 1, 2}));
    CHECK_FALSE(oblique->contains({-0.02, 0, 0}));
}

TEST_CASE("an extrusion is its polygon along each axis", "[shape]") {
    const std::vector<Point> triangle{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}};
    for (const std::size_t axis : {0u, 1u, 2u}) {
        CAPTURE(axis);
        const auto prism = make_extrusion(triangle, axis, {3, 4});
        const auto across = axes_across(axis);
        const std::size_t u = across[0], v = across[1];  // a lambda may not capture a structured binding (Clang 14)
        CHECK(u < v);
        const auto at = [&](double first, double second, double along) {
            Point p{};
            p[u] = first, p[v] = second, p[axis] = along;
            return p;
        };
        CHECK(prism->bounds().min == at(0, 0, 3));
        CHECK(prism->bounds().max == at(2, 1, 4));
        for (const auto& p : {at(1, 0.5, 3), at(2, 0, 4), at(0, 0.3, 3.5)}) CHECK(prism->contains(p));
        for (const auto& p : {at(1, 0.51, 3.5), at(0.5, 0.5, 4.01), at(0.5, 0.5, 2.99)})
            CHECK_FALSE(prism->contains(p));
    }
}

namespace {

/// Root mean square over 40 spacings around d of the packing's relative error in volume.
double volume_error(const Shape& shape, double volume, double d) {
    double sum = 0;
    for (int i = 0; i < 40; ++i) {
        const double relative = filled(pack(shape, d * (0.8 + 0.01 * i), 3)) / volume - 1;
        sum += relative * relative;
    }
    return std::sqrt(sum / 40);
}

}  // namespace

TEST_CASE("volumes converge with the spacing", "[shape][packing]") {
    const double pi = std::numbers::pi, root = std::sqrt(1.1);
    struct Solid {
        const char* name;
        ShapePtr shape;
        double volume, surface;
    };
    const auto hollow = make_difference(make_box({0, 0, 0}, {1, 1, 1}), {make_ball({0.5, 0.5, 0.5}, 0.4)});
    // Edges of a slope like 1 or 1/5 run along rows of sites, which it then holds or loses all at once; a polygon
    // without such slopes tells more about the method.
    const auto prism = make_extrusion({{0, 0, 0}, {1, 0.237, 0}, {0.313, 0.911, 0}}, 1, {0, 1});
    for (const Solid& solid : {
             Solid{"sphere", make_ball({0.1, 0.2, 0.3}, 0.5), pi / 6, pi},
             Solid{"cylinder along x", make_cylinder({0, 0, 0}, {1, 0, 0}, 0.5), pi / 4, 1.5 * pi},
             Solid{"oblique cylinder", make_cylinder({0, 0, 0}, {0.7, 0.5, 0.6}, 0.4), 0.16 * pi * root,
                   0.32 * pi + 0.8 * pi * root},
             Solid{"prism", prism, 0.4184095, 2 * 0.4184095 + 1.0277 + 0.9632 + 0.9624},
             Solid{"box with a spherical hole", hollow, 1 - pi / 6 * 0.512, 6 + 0.64 * pi},
         }) {
        const double coarse = volume_error(*solid.shape, solid.volume, 0.08);
        const double fine = volume_error(*solid.shape, solid.volume, 0.02);
        const double order = std::log2(coarse / fine) / 2;
        CAPTURE(solid.name, coarse, fine, order);
        // Wrong can only be the sites whose cells the surface cuts: those within half a cell's diagonal of it.
        CHECK(coarse < solid.surface * 0.08 * std::sqrt(3) / 2 / solid.volume);
        CHECK(fine < solid.surface * 0.02 * std::sqrt(3) / 2 / solid.volume);
        // That makes first order certain. They err to both sides, so more is usual: 1.2 to 1.8 were measured.
        CHECK(order > 1);
    }
}

TEST_CASE("a polygon holds its inside and its edges", "[shape]") {
    const auto arrow = make_polygon({{0, 0, 0}, {2, -1, 0}, {1, 0, 0}, {2, 1, 0}});
    CHECK(arrow->contains({0.5, 0, 0}));
    CHECK(arrow->contains({1, 0, 0}));
    CHECK(arrow->contains({1.5, 0.6, 0}));
    CHECK(arrow->contains({1, 0.5, 0}));
    CHECK_FALSE(arrow->contains({1.5, 0, 0}));
    CHECK_FALSE(arrow->contains({-0.1, 0, 0}));
    const Bounds bounds = arrow->bounds();
    CHECK(bounds.min == Point{0, -1, 0});
    CHECK(bounds.max == Point{2, 1, 0});
}

TEST_CASE("a polygon with sites on its edge keeps all of them", "[shape][packing]") {
    // A lattice of 0.1 puts the centres of the diagonal exactly on the hypotenuse, apart from rounding.
    const Packing p = pack(*make_polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), 0.1, 2);
    CHECK(p.position.size() == 55);
}

TEST_CASE("polygons that cross themselves are found", "[shape]") {
    CHECK(find_crossing_edges({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}) ==
          std::pair<std::size_t, std::size_t>{0, 2});
    CHECK_FALSE(find_crossing_edges({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    CHECK_FALSE(find_crossing_edges({{0, 0, 0}, {2, -1, 0}, {1, 0, 0}, {2, 1, 0}}));
    CHECK(find_crossing_edges({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 0, 0}, {0, 1, 0}}));
    CHECK(polygon_area({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}) == 1);
    CHECK(polygon_area({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}) == 0);
}

TEST_CASE("A tank's lattice fits what is cut out of it, whatever its walls' thickness", "[shape][packing]") {
    // A cavity of 1 x 0.5, open above; walls of 0.23, 0.31 at the right and 0.27 below.
    const auto tank = make_difference(make_box({-0.23, -0.27, 0}, {1.31, 0.8, 0}), {make_box({0, 0, 0}, {1, 0.9, 0})});
    const Packing p = pack(*tank, 0.1, 2, Fit::cavity);
    double left = -1, right = 9, below = -1;
    for (const Point& x : p.position) {
        CHECK(tank->contains(x));
        if (x[1] > 0 && x[0] < 0) left = std::max(left, x[0]);
        if (x[1] > 0 && x[0] > 0) right = std::min(right, x[0]);
        if (x[0] > 0 && x[0] < 1) below = std::max(below, x[1]);
    }
    CHECK(left == Approx(-0.05));
    CHECK(right == Approx(1.05));
    CHECK(below == Approx(-p.spacing[1] / 2));
    CHECK(p.spacing[0] == Approx(0.1));
    CHECK(count_sites(*tank, 0.1, 2, Fit::cavity) >= static_cast<double>(p.position.size()));
    for (const Site& site : p.site) CHECK(std::min({site[0], site[1], site[2]}) >= 0);

    SECTION("where the thickness is whole, and where there is no cavity, it is the lattice of the outside") {
        const auto whole =
            make_difference(make_box({-0.3, -0.3, 0}, {1.3, 0.8, 0}), {make_box({0, 0, 0}, {1, 0.9, 0})});
        const auto box = make_box({0, 0, 0}, {1, 0.33, 0});
        const auto pierced = make_difference(box, {make_box({0.31, 0.1, 0}, {0.52, 0.2, 0})});
        for (const auto& shape : {whole, box, pierced}) {
            const Packing inner = pack(*shape, 0.1, 2, Fit::cavity), outer = pack(*shape, 0.1, 2);
            REQUIRE(inner.position.size() == outer.position.size());
            for (std::size_t k = 0; k < inner.position.size(); ++k)
                for (std::size_t axis = 0; axis < 2; ++axis)
                    CHECK(inner.position[k][axis] == Approx(outer.position[k][axis]).margin(1e-12));
        }
    }
}

TEST_CASE("union and difference count each site once", "[shape][packing]") {
    const auto left = make_box({0, 0, 0}, {0.6, 1, 0}), right = make_box({0.4, 0, 0}, {1, 1, 0});
    CHECK(pack(*make_union({left, right}), 0.1, 2).position.size() == 100);
    CHECK(pack(*make_difference(make_box({0, 0, 0}, {1, 1, 0}), {make_box({0.2, 0.2, 0}, {0.8, 0.8, 0})}), 0.1, 2)
              .position.size() == 64);
    CHECK(pack(*make_difference(left, {right}), 0.1, 2).position.size() == 40);
    const auto both = make_union({left, make_ball({2, 2, 0}, 1)});
    CHECK(both->bounds().max == Point{3, 3, 1});
    CHECK(both->contains({2.5, 2, 0}));
    CHECK_FALSE(both->contains({0.9, 0.5, 0}));
}

TEST_CASE("sites on an edge in 3D are kept all or, where it is cut out, none", "[shape][packing]") {
    // Centres of the diagonal plane lie exactly on the prism's oblique face, apart from rounding.
    const auto prism = make_extrusion({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 2, {0, 0.7});
    CHECK(pack(*prism, 0.1, 3).position.size() == 55 * 7);
    const auto cube = make_box({0, 0, 0}, {1, 1, 0.7});
    CHECK(pack(*make_difference(cube, {prism}), 0.1, 3).position.size() == 45 * 7);
    // Centres at distance 0.5 from the axis, by the triple 3-4-5: (±0.3, ±0.4), (±0.4, ±0.3), and on the axes.
    const auto log = make_cylinder({0, 0, 0}, {0, 0, 1}, 0.5);
    const auto block = make_box({-0.55, -0.55, 0}, {0.55, 0.55, 1});  // centres at multiples of 0.1
    const auto inside = pack(*make_union({block, log}), 0.1, 3);
    std::size_t held = 0, rim = 0;
    for (const Point& p : inside.position) {
        const bool on_rim = std::abs(std::hypot(p[0], p[1]) - 0.5) < 1e-6;
        rim += on_rim;
        held += on_rim && log->contains(p);
    }
    CHECK(rim == 12 * 10);
    CHECK(held == rim);
    CHECK(pack(*make_difference(block, {log}), 0.1, 3).position.size() == (121 - 81) * 10);
}

TEST_CASE("sites are counted before they are made", "[packing]") {
    CHECK(count_sites(*make_box({0, 0, 0}, {1, 1, 1}), 0.1, 2) == 100);
    CHECK(count_sites(*make_box({0, 0, 0}, {1, 1, 1}), 1e-9, 3) == Approx(1e27));
}

}  // namespace sluice::test_shapes
