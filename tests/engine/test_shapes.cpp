// Shapes and their lattice packings.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "engine/geometry/packing.hpp"
#include "engine/geometry/simple_polygon.hpp"
#include "tests/catch.hpp"

using namespace sluice;

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
    const Packing p = pack(*make_circle({0, 0, 0}, 1), 0.25, 3);
    for (std::size_t i = 1; i < p.site.size(); ++i) {
        const auto &a = p.site[i - 1], &b = p.site[i];
        REQUIRE(std::tuple(a[2], a[1], a[0]) < std::tuple(b[2], b[1], b[0]));
    }
    for (std::size_t i = 0; i < p.site.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            REQUIRE(p.position[i][k] == Approx(-1 + (p.site[i][k] + 0.5) * p.spacing[k]).margin(1e-15));
}

TEST_CASE("a circle is a disc in 2D and a ball in 3D", "[shape]") {
    const auto circle = make_circle({1, 2, 0}, 0.5);
    const Packing disc = pack(*circle, 0.01, 2), ball = pack(*circle, 0.05, 3);
    // The count of lattice points misses the area by no more than a share of the rim's, about d / r.
    CHECK(filled(disc) == Approx(std::numbers::pi * 0.25).epsilon(0.01 / 0.5));
    CHECK(filled(ball) == Approx(std::numbers::pi / 6).epsilon(0.05 / 0.5));
    CHECK(circle->contains({1.5, 2, 0}));
    CHECK_FALSE(circle->contains({1.36, 2.36, 0}));
    CHECK_FALSE(circle->contains({1.3, 2.3, 0.3}));
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

TEST_CASE("union and difference count each site once", "[shape][packing]") {
    const auto left = make_box({0, 0, 0}, {0.6, 1, 0}), right = make_box({0.4, 0, 0}, {1, 1, 0});
    CHECK(pack(*make_union({left, right}), 0.1, 2).position.size() == 100);
    CHECK(pack(*make_difference(make_box({0, 0, 0}, {1, 1, 0}), {make_box({0.2, 0.2, 0}, {0.8, 0.8, 0})}), 0.1, 2)
              .position.size() == 64);
    CHECK(pack(*make_difference(left, {right}), 0.1, 2).position.size() == 40);
    const auto both = make_union({left, make_circle({2, 2, 0}, 1)});
    CHECK(both->bounds().max == Point{3, 3, 1});
    CHECK(both->contains({2.5, 2, 0}));
    CHECK_FALSE(both->contains({0.9, 0.5, 0}));
}

TEST_CASE("sites are counted before they are made", "[packing]") {
    CHECK(count_sites(*make_box({0, 0, 0}, {1, 1, 1}), 0.1, 2) == 100);
    CHECK(count_sites(*make_box({0, 0, 0}, {1, 1, 1}), 1e-9, 3) == Approx(1e27));
}
