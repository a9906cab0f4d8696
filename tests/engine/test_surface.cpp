// The interface polygon around a body: outline on the lattice, elements, closedness.
#include "engine/particles/surface.hpp"

#include <cmath>

#include "engine/particles/state.hpp"
#include "engine/particles/surface_chain.hpp"
#include "tests/catch.hpp"
#include "tests/engine/physics_scenes.hpp"

namespace sluice::test_surface {
namespace {

/// A body of this shape beside a little water, its elements up to date.
State<2> state_of(const std::string& shape) {
    const Scene scene = scene_text::load(preamble(0.001) + R"toml(
[bodies.water]
material = "water"
shape = { box = { min = [1.0, 1.0], max = [1.01, 1.01] } }
[bodies.body]
material = "rubber"
shape = )toml" + shape + "\n");
    State<2> state = place_particles<2>(scene, Effects(scene));
    state.surface.update(state.solid.position, IdIndex(state.solid.id), state.elements);
    return state;
}

Vec<2> sum_of_area(const ParticleSet<2>& e) {
    Vec<2> sum;
    for (std::size_t k = 0; k < e.owned; ++k) sum += e.area_normal[k];
    return sum;
}

/// Area inside the polygon by the divergence theorem: ½ Σ x·n ΔΓ.
double enclosed_area(const ParticleSet<2>& e) {
    double area = 0;
    for (std::size_t k = 0; k < e.owned; ++k) area += 0.5 * dot(e.position[k], e.area_normal[k]);
    return area;
}

double length(const ParticleSet<2>& e) {
    double sum = 0;
    for (std::size_t k = 0; k < e.owned; ++k) sum += norm(e.area_normal[k]);
    return sum;
}

}  // namespace

TEST_CASE("The outline of lattice sites runs once around, material on the left") {
    // A 3 × 2 block: every particle is at the boundary, corners stand once.
    std::vector<std::array<std::int32_t, 3>> block;
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x) block.push_back({x, y, 0});
    const auto loops = trace_outline(block);
    REQUIRE(loops.size() == 1);
    REQUIRE(loops[0] == std::vector<Index>{0, 1, 2, 5, 4, 3});

    // A frame of 5 × 5 with a hole: one loop outside and one around the hole.
    std::vector<std::array<std::int32_t, 3>> frame;
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 5; ++x)
            if (x != 2 || y != 2) frame.push_back({x, y, 0});
    REQUIRE(trace_outline(frame).size() == 2);
}

TEST_CASE("The polygon around a box is the box") {
    const auto state = state_of("{ box = { min = [0.2, 0.1], max = [0.23, 0.15] } }");
    REQUIRE(norm(sum_of_area(state.elements)) < 1e-15);
    REQUIRE(enclosed_area(state.elements) == Approx(0.03 * 0.05).epsilon(1e-12));
    REQUIRE(length(state.elements) == Approx(2 * (0.03 + 0.05)).epsilon(1e-12));
    for (std::size_t k = 0; k < state.elements.owned; ++k) {
        const Vec<2> x = state.elements.position[k];
        const bool on_edge = std::abs(x[0] - 0.2) < 1e-12 || std::abs(x[0] - 0.23) < 1e-12 ||
                             std::abs(x[1] - 0.1) < 1e-12 || std::abs(x[1] - 0.15) < 1e-12;
        REQUIRE(on_edge);
    }
}

TEST_CASE("Around any shape the area vectors add up to nothing and enclose its area") {
    const std::string ring =
        "{ difference = [{ circle = { centre = [0, 0], radius = 0.03 } }, "
        "{ circle = { centre = [0, 0], radius = 0.015 } }] }";
    for (const auto& [shape, area] :
         {std::pair{std::string("{ circle = { centre = [0, 0], radius = 0.03 } }"), M_PI * 9e-4},
          std::pair{ring, M_PI * (9e-4 - 2.25e-4)}}) {
        const auto state = state_of(shape);
        REQUIRE(norm(sum_of_area(state.elements)) < 1e-15);
        // The outline follows a lattice of a thirtieth of the radius: half a site's width along the rim is 3 %.
        REQUIRE(enclosed_area(state.elements) == Approx(area).epsilon(0.03));
    }
}

TEST_CASE("Elements turn and move with the body") {
    auto state = state_of("{ box = { min = [0.0, 0.0], max = [0.03, 0.05] } }");
    const double c = std::cos(0.7), s = std::sin(0.7);
    const auto before = state.elements.area_normal;
    for (std::size_t i = 0; i < state.solid.owned; ++i) {
        const Vec<2> x = state.solid.position[i];
        state.solid.position.set(i, {{c * x[0] - s * x[1] + 5, s * x[0] + c * x[1] - 3}});
    }
    state.surface.update(state.solid.position, IdIndex(state.solid.id), state.elements);
    for (std::size_t k = 0; k < state.elements.owned; ++k) {
        const Vec<2> n = before[k], turned{{c * n[0] - s * n[1], s * n[0] + c * n[1]}};
        REQUIRE(norm(state.elements.area_normal[k] - turned) < 1e-14);  // rounding at coordinates of 5 m
    }
}

}  // namespace sluice::test_surface
