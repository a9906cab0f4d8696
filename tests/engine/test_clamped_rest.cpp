// Particles that are clamped with all that is around them are left out of the solid's passes: nothing may change by
// that.
#include "kernels/passes/total_lagrangian_passes.hpp"

#include "engine/particles/state.hpp"
#include "engine/step/neighborhood.hpp"
#include "engine/step/parts/clamp_extension.hpp"
#include "engine/step/parts/resting.hpp"
#include "kernels/passes/fluid_passes.hpp"
#include "kernels/passes/solid_passes.hpp"
#include "neighbor/cluster_grid.hpp"
#include "tests/catch.hpp"
#include "tests/engine/physics_scenes.hpp"

namespace sluice::test_clamped_rest {
namespace {

/// The paper's method, but the solid in its reference configuration.
const std::vector<std::string> elastic{"method.preset=paper", "materials.rubber.model=neo-hookean",
                                       "method.solid.artificial_viscosity=0"};

/// A beam, the left two thirds of it clamped, that swings, and beside it a block that is clamped altogether.
template <int Dim>
std::string swinging_beam() {
    const std::string low = Dim == 2 ? "" : ", 0.0", high = Dim == 2 ? "" : ", 0.02";
    const auto box = [&](const std::string& from, const std::string& to) {
        return "{ box = { min = [" + from + low + "], max = [" + to + high + "] } }\n";
    };
    return "dimension = " + std::to_string(Dim) + "\n" + preamble(Dim == 2 ? 0.002 : 0.005) +
           "[bodies.beam]\nmaterial = \"rubber\"\nvelocity = [\"0\", \"x\"" + (Dim == 2 ? "" : ", \"0.2*x\"") +
           "]\nshape = " + box("0.0, 0.0", "0.18, 0.02") + "clamp = " + box("0.0, 0.0", "0.12, 0.02") +
           "[bodies.block]\nmaterial = \"rubber\"\nshape = " + box("0.0, 0.1", "0.06, 0.12") +
           "clamp = " + box("0.0, 0.1", "0.06, 0.12");
}

/// Every particle's neighbours among `position`, which stand in the order of the engine's clusters.
template <int Dim>
NeighborList whole_list(const Scene& scene, const VectorField<Dim>& position, const ScalarField& h, double skin) {
    const double cell = std::pow(64, 1.0 / Dim) / scene.method.smoothing_length * h[0];
    ClusterGrid<Dim> grid;
    grid.build(position, 0, position.size(), cell, h);
    for (std::size_t i = 0; i < position.size(); ++i) REQUIRE(grid.order()[i] == i);
    grid.particles_were_sorted(0);
    const ClusterGrid<Dim>* const target = &grid;
    const typename NeighborSearch<Dim>::Set all{position, h};
    const double half_support = 0.5 * Smoothing<Dim>(scene.method.smoothing_function).support;
    NeighborList list;
    NeighborSearch<Dim> search;
    search.build(grid, {&target, 1}, {skin, half_support, half_support}, list);
    search.prune(all, all, {0, half_support, half_support}, list);
    return list;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("Stress and force are, to the bit, those of passes over all particles", "", ((int Dim), Dim), 2,
                       3) {
    Simulation<Dim> s(scene_text::load(swinging_beam<Dim>(), elastic));
    ParticleSet<Dim> start = s.solid();
    const std::uint64_t before = s.work().pairs;
    advance(s, 1);
    const std::uint64_t in_a_step = s.work().pairs - before;
    advance(s, 30);
    const auto& solid = s.solid();
    const PairMethod<Dim> method(Precision::full, Smoothing<Dim>(s.scene().method.smoothing_function));
    const NeighborList list = whole_list<Dim>(s.scene(), solid.reference_position, solid.smoothing_length, 0);
    TupleField<Dim * Dim> deformation, stress;
    VectorField<Dim> acceleration;
    deformation.resize(solid.owned), stress.resize(solid.owned), acceleration.resize(solid.owned);
    // What the clamp's neighbours see of it, as the run does.
    ParticleSet<Dim> twin = solid;
    const ClampExtension<Dim> behind(s.scene(), start, list, method.smoothing.support * solid.smoothing_length[0]);
    behind.displace(twin);
    const auto view = view_of(twin);
    const Hyperelastic law = s.solid_materials().front().law;
    elastic_deformation<Dim>(view, list, {&law, 1}, method, deformation, stress);
    elastic_momentum<Dim>(view, list, {}, method, acceleration);
    twin.acceleration = acceleration;
    behind.hand_over(twin);
    acceleration = twin.acceleration;
    double moved = 0;
    bool same_forces = true;
    for (std::size_t i = 0; i < solid.owned; ++i) {
        moved = std::max(moved, norm(solid.position[i] - solid.reference_position[i]));
        if (!solid.clamped[i]) same_forces = same_forces && acceleration[i] == solid.acceleration[i];
    }
    CHECK(moved > 1e-5);  // it does swing
    CHECK((deformation.c == solid.deformation.c));
    CHECK((stress.c == solid.corrected_stress.c));
    CHECK(same_forces);
    // Two passes, with a good half of all rows or less.
    CHECK(in_a_step < 2 * (list.pairs() * 6 / 10));
}

TEMPLATE_TEST_CASE_SIG("A hypoelastic solid's rates and forces are, to the bit, those of passes over all particles", "",
                       ((int Dim), Dim), 2, 3) {
    const Scene scene = scene_text::load(swinging_beam<Dim>(), {"method.preset=paper"});
    const Effects effects(scene);
    State<Dim> state = place_particles<Dim>(scene, effects);
    const Smoothing<Dim> smoothing(scene.method.smoothing_function);
    Neighborhood<Dim> neighbors(state, effects, scene.method.smoothing_length, smoothing.support);
    auto& solid = state.solid;
    Pairing& stressed = neighbors.pair(
        {SetId::solid, SetId::solid, Upkeep::with_solid, Targets::own, Reach::mean, state.hypoelastic});
    Pairing& moving = neighbors.derive(stressed, "moving");
    stressed.searched = [&] { leave_out_resting<Dim>(solid, {}, {}, stressed.list, moving.list); };
    neighbors.build();
    const std::size_t n = solid.owned;
    // Rows are pruned to what the first sub-step may need; what lies beyond adds zero.
    const NeighborList list = whole_list<Dim>(scene, solid.position, solid.smoothing_length, 0.8 * state.min_h);
    CHECK(stressed.list.size() < list.size());
    CHECK(moving.list.size() < stressed.list.size());
    const PairMethod<Dim> method(Precision::full, smoothing);
    for (std::size_t i = 0; i < n; ++i)
        solid.stress_over_rho2.c[0][i] = 1e-3 * std::sin(1e3 * solid.position[i][0]);  // some stress

    struct Rates {
        ScalarField density;
        TupleField<Dim * Dim> gradient;
        VectorField<Dim> acceleration, filtered;
    };
    const auto rates = [&](const NeighborList& of_stress, const NeighborList& of_force) {
        Rates r;
        r.density.assign(n, 0.0), r.gradient.resize(n), r.acceleration.resize(n), r.filtered.resize(n);
        solid_rates<Dim>(view_of(solid), of_stress, method, r.density, r.gradient);
        solid_momentum<Dim>(view_of(solid), of_force, {1, 40, 0, 4, 1.5}, method, r.acceleration);
        velocity_filter<Dim>(view_of(solid), of_force, 0.9, method, r.filtered);
        return r;
    };
    const Rates all = rates(list, list), some = rates(stressed.list, moving.list);
    CHECK(some.density == all.density);
    CHECK(some.gradient.c == all.gradient.c);
    bool same = true;
    for (std::size_t i = 0; i < n; ++i)
        same = same && (solid.clamped[i] ||
                        (some.acceleration[i] == all.acceleration[i] && some.filtered[i] == all.filtered[i]));
    CHECK(same);
}

TEMPLATE_TEST_CASE_SIG("A body that is clamped altogether takes no pass", "", ((int Dim), Dim), 2, 3) {
    const std::string model = GENERATE("hypoelastic", "neo-hookean");
    std::vector<std::string> all_clamped = elastic;
    const std::string corner = Dim == 2 ? "[0.2, 0.2]" : "[0.2, 0.2, 0.2]";
    all_clamped.push_back("bodies.beam.clamp.box.max=" + corner);
    all_clamped.push_back("materials.rubber.model=" + model);
    Simulation<Dim> at_rest(scene_text::load(swinging_beam<Dim>(), all_clamped));
    const auto positions = at_rest.solid().position.c;
    const std::uint64_t pairs = at_rest.work().pairs;
    advance(at_rest, 5);
    CHECK(at_rest.work().pairs == pairs);
    CHECK(at_rest.solid().position.c == positions);
    CHECK(at_rest.energy().kinetic == 0);
}

}  // namespace sluice::test_clamped_rest
