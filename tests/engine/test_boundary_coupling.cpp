// The coupling by a moving boundary in whole steps: momentum, energy, threads, precision, frames of reference.
#include <algorithm>

#include "engine/particles/id_index.hpp"
#include "tests/catch.hpp"
#include "tests/engine/collision_scenes.hpp"
#include "tests/neighbor/clouds.hpp"

namespace sluice::test_boundary_coupling {
namespace {

using collisions::coupled;

/// How far momentum has changed, as a share of what it was; `impulse` is what force times time comes to, likewise.
struct Exchange {
    double lost = 0, impulse = 0, residual = 0;
};

template <int Dim>
Exchange collide(const std::string& text, const std::vector<std::string>& overrides, int steps) {
    Simulation<Dim> s(scene_text::load(text, overrides));
    const Vec<Dim> before = s.momentum();
    double force = 0;
    for (int n = 0; n < steps; ++n) {
        s.step();
        force = std::max(force, norm(s.force_on(1)));
    }
    return {norm(s.momentum() - before) / norm(before), force * s.time() / norm(before),
            s.interface_balance().residual};
}

/// Relative rounding of momentum: sums of 10⁵ terms in double; single for the fluid's own pairs in mixed precision.
double rounding(const std::string& precision) { return precision == "double" ? 1e-12 : 1e-6; }

}  // namespace

TEST_CASE("A collision keeps momentum to rounding in two dimensions, at any rate and precision") {
    const std::string precision = GENERATE("double", "mixed"), rate = GENERATE("single-rate", "multi-rate");
    CAPTURE(precision, rate);
    const Exchange e =
        collide<2>(collisions::flat(), coupled({"method.precision=" + precision, "method.time_stepping=" + rate}), 200);
    CHECK(e.impulse > 0.1);  // they do meet
    CHECK(e.residual < 1e-12);
    CHECK(e.lost < rounding(precision));
}

TEST_CASE("A collision keeps momentum to rounding in three dimensions") {
    const std::string precision = GENERATE("double", "mixed");
    CAPTURE(precision);
    const Exchange e = collide<3>(collisions::solid(),
                                  coupled({"method.precision=" + precision, "method.time_stepping=multi-rate"}), 60);
    CHECK(e.impulse > 0.1);
    CHECK(e.residual < 1e-12);
    CHECK(e.lost < rounding(precision));
}

TEST_CASE("A collision keeps momentum in adaptive steps and with all that the modern preset has") {
    const Exchange e = collide<2>(collisions::flat(), {"method.preset=modern", "method.precision=double"}, 200);
    CHECK(e.impulse > 0.1);
    CHECK(e.residual < 1e-12);
    CHECK(e.lost < 1e-12);
}

TEST_CASE("A hypoelastic solid as moving boundary keeps momentum to rounding") {
    const std::string rate = GENERATE("single-rate", "multi-rate");
    const Exchange e =
        collide<2>(collisions::flat(), {"method.coupling=moving-boundary", "method.time_stepping=" + rate}, 200);
    CHECK(e.impulse > 0.1);
    CHECK(e.residual < 1e-12);
    CHECK(e.lost < 1e-12);
}

TEST_CASE("A collision creates no energy, however long the fluid's step") {
    const std::string courant = GENERATE("0.4", "0.6", "0.8", "0.9");
    CAPTURE(courant);
    Simulation<2> s(scene_text::load(collisions::flat(),
                                     coupled({"method.time_stepping=multi-rate", "method.courant=" + courant})));
    REQUIRE(s.solid_substeps() > 1);
    const double start = s.energy().total();
    double highest = start;
    while (s.time() < 0.02) {
        s.step();
        highest = std::max(highest, s.energy().total());
    }
    CAPTURE(highest / start, s.energy().total() / start);
    // The force is held over a step of the fluid, and so is not quite that of the energy; nothing dissipates here.
    CHECK(highest < 1.01 * start);
}

TEST_CASE("A collision gives the same bits on any number of threads") {
    std::vector<VectorField<2>> fluid, solid;
    for (const int threads : {1, 2, 4}) {
        const ThreadScope scope(threads);
        Simulation<2> s(scene_text::load(collisions::flat(), {"method.preset=modern"}));
        advance(s, 60);
        fluid.push_back(s.fluid().velocity);
        solid.push_back(s.solid().velocity);
    }
    for (const std::size_t t : {1, 2}) {
        CHECK(fluid[t].c == fluid[0].c);
        CHECK(solid[t].c == solid[0].c);
    }
}

TEST_CASE("Mixed precision follows double in a collision") {
    Simulation<2> exact(scene_text::load(collisions::flat(), coupled())),
        mixed(scene_text::load(collisions::flat(), coupled({"method.precision=mixed"})));
    advance(exact, 200);
    advance(mixed, 200);
    double moved = 0, apart = 0;
    for (std::size_t id = 0; id < exact.solid().owned; ++id) {
        const std::size_t a = exact.solid_index_of_id()[id], b = mixed.solid_index_of_id()[id];
        apart = std::max(apart, norm(exact.solid().position[a] - mixed.solid().position[b]));
        moved = std::max(moved, norm(exact.solid().velocity[a]) * exact.time());
    }
    CAPTURE(apart, moved);
    CHECK(moved > 1e-4);
    CHECK(apart < 1e-3 * moved);  // 1e-7 per pair, grown over 200 steps
}

TEST_CASE("A collision is the same seen from a train, with either coupling and solid model") {
    const std::string coupling = GENERATE("interface-force", "moving-boundary");
    const std::string model = GENERATE("hypoelastic", "st-venant-kirchhoff");
    CAPTURE(coupling, model);
    const std::vector<std::string> overrides{"method.coupling=" + coupling, "materials.rubber.model=" + model,
                                             "method.time_step=5e-5"};
    Simulation<2> still(scene_text::load(collisions::flat(), overrides)),
        train(scene_text::load(collisions::flat(10, -6), overrides));
    double largest_force = 0;
    for (int n = 0; n < 200; ++n) {
        still.step();
        train.step();
        largest_force = std::max(largest_force, norm(still.force_on(1)));
    }
    // 0.1 m further: eight times the length of the block.
    const Vec<2> way = train.time() * Vec<2>{{10, -6}};
    double apart = 0;
    for (std::size_t id = 0; id < still.solid().owned; ++id)
        apart = std::max(apart, norm(train.solid().position[train.solid_index_of_id()[id]] - way -
                                     still.solid().position[still.solid_index_of_id()[id]]));
    CAPTURE(apart, largest_force);
    CHECK(largest_force > 1);
    // Rounding of positions ten times as large; lists are built at other times, so that sums have another order.
    CHECK(apart < 1e-8);
    CHECK(train.interface_balance().residual < 1e-12);
}

}  // namespace sluice::test_boundary_coupling
