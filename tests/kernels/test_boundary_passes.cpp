// The passes between fluid and moving boundary against their plain twins, and what they keep.
#include "kernels/passes/boundary_passes.hpp"

#include "tests/catch.hpp"
#include "tests/kernels/compare.hpp"
#include "tests/kernels/twins_moving_boundary.hpp"

namespace sluice::test_boundary_passes {

namespace {

/// Fluid and boundary side by side and partly through each other, both in a random state.
template <int Dim>
struct BoundaryScene {
    Particles<Dim> fluid, solid;
    VectorField<Dim> acceleration;  ///< of the boundary [m/s²]
    Vec<Dim> gravity;

    explicit BoundaryScene(Scene scene, Layout layout = Layout::shuffled)
        : fluid(make_scene<Dim>(scene, 1, layout)), solid(make_scene<Dim>(scene, 2, layout)) {
        for (double& x : solid.position.c[1]) x -= scene == Scene::crowded ? 0.03 : 0.9;
        Random random(3);
        // Strong enough to bring pressures down to zero, which are 1e4 Pa: ρ a d = 1e3 kg/m³ · 200 m/s² · 0.1 m.
        for (std::size_t s = 0; s < solid.size(); ++s) acceleration.push_back(random.vector<Dim>(-200, 200));
        gravity[0] = 3;
        gravity[1] = -9.81;
    }
    ParticleView<Dim> boundary() const {
        ParticleView<Dim> v = solid.view();
        v.mean_acceleration = columns_of(acceleration);
        return v;
    }
};

template <int Dim>
struct BoundaryResult {
    VectorField<Dim> on_fluid, on_solid;  ///< acceleration [m/s²], force [N]
    ScalarField rate;
    Vec<Dim> sum_fluid, sum_solid;  ///< as the passes return them [N]
};

template <int Dim>
BoundaryResult<Dim> evaluate(const BoundaryScene<Dim>& s, const NeighborList& fluid_solid,
                             const NeighborList& solid_fluid, Precision precision) {
    BoundaryResult<Dim> r{
        zeros<Dim>(s.fluid.size()), zeros<Dim>(s.solid.size()), ScalarField(s.fluid.size(), 0.0), {}, {}};
    BlockTotals<Dim> totals;
    r.sum_fluid = boundary_pressure_on_fluid<Dim>(s.fluid.view(), s.boundary(), fluid_solid, s.gravity, precision,
                                                  totals, r.on_fluid);
    r.sum_solid =
        boundary_reaction<Dim>(s.boundary(), s.fluid.view(), solid_fluid, s.gravity, precision, totals, r.on_solid);
    boundary_continuity<Dim>(s.fluid.view(), s.boundary(), fluid_solid, precision, r.rate);
    return r;
}

/// Every pass against its twin, on all instruction sets. Double in either precision, and so is the tolerance.
template <int Dim>
void check_all_passes(const BoundaryScene<Dim>& s) {
    const auto force = twin::boundary_pressure<Dim>(s.fluid, s.solid, s.acceleration, s.gravity);
    const auto reaction = twin::boundary_reaction<Dim>(s.solid, s.fluid, s.acceleration, s.gravity);
    const auto rate = twin::boundary_continuity<Dim>(s.fluid, s.solid);
    const NeighborList fluid_solid = list_of(s.fluid, s.solid), solid_fluid = list_of(s.solid, s.fluid);
    in_all_variants([&](Precision precision) {
        const BoundaryResult<Dim> r = evaluate(s, fluid_solid, solid_fluid, precision);
        CHECK(worst_error(r.on_fluid, force) < twin_tolerance(Precision::full));
        CHECK(worst_error(r.on_solid, reaction) < twin_tolerance(Precision::full));
        CHECK(worst_error(r.rate, rate) < twin_tolerance(Precision::full));
    });
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("the passes of a moving boundary equal their twins", "[boundary]", ((int Dim), Dim), 2, 3) {
    for (const Scene scene : scenes)
        for (const Layout layout : layouts) {
            CAPTURE(static_cast<int>(scene), layout == Layout::sorted);
            check_all_passes(BoundaryScene<Dim>(scene, layout));
        }
}

TEMPLATE_TEST_CASE_SIG("the passes of a moving boundary far from the origin", "[boundary]", ((int Dim), Dim), 2, 3) {
    BoundaryScene<Dim> s(Scene::unequal);
    for (auto* set : {&s.fluid, &s.solid})
        for (auto& column : set->position.c)
            for (double& x : column) x -= 1e4;  // [m]
    check_all_passes(s);
}

TEMPLATE_TEST_CASE_SIG("the passes of a moving boundary at any scale", "[boundary]", ((int Dim), Dim), 2, 3) {
    for (const double scale : scales) {
        BoundaryScene<Dim> s(Scene::odd);
        rescale(s.fluid, scale);
        rescale(s.solid, scale);
        CAPTURE(scale);
        check_all_passes(s);
    }
}

TEMPLATE_TEST_CASE_SIG("force on the fluid and reaction on the boundary add up to nothing", "[boundary]",
                       ((int Dim), Dim), 2, 3) {
    for (const Scene scene : scenes) {
        const BoundaryScene<Dim> s(scene);
        CAPTURE(static_cast<int>(scene));
        const NeighborList fluid_solid = list_of(s.fluid, s.solid), solid_fluid = list_of(s.solid, s.fluid);
        in_all_variants([&](Precision precision) {
            const BoundaryResult<Dim> r = evaluate(s, fluid_solid, solid_fluid, precision);
            double exchanged = 0;
            Vec<Dim> of_fluid, of_solid;
            for (std::size_t i = 0; i < s.fluid.size(); ++i) of_fluid += s.fluid.mass[i] * r.on_fluid[i];
            for (std::size_t i = 0; i < s.solid.size(); ++i) {
                of_solid += r.on_solid[i];
                exchanged += norm(r.on_solid[i]);
            }
            REQUIRE(exchanged > 0);
            // Pairs are equal and opposite to a few roundings each; some thousand of them, of either sign.
            CHECK(norm(of_fluid + of_solid) < 1e-13 * exchanged);
            CHECK(norm(r.sum_fluid - of_fluid) < 1e-13 * exchanged);
            CHECK(norm(r.sum_solid - of_solid) < 1e-13 * exchanged);
        });
    }
}

TEMPLATE_TEST_CASE_SIG("a moving boundary adds to what it finds, and leaves dry particles alone", "[boundary]",
                       ((int Dim), Dim), 2, 3) {
    BoundaryScene<Dim> s(Scene::jittered);
    for (double& x : s.solid.position.c[0]) x += 50;
    const NeighborList fluid_solid = list_of(s.fluid, s.solid), solid_fluid = list_of(s.solid, s.fluid);
    in_all_variants([&](Precision precision) {
        auto a = zeros<Dim>(s.fluid.size()), force = zeros<Dim>(s.solid.size());
        for (auto* field : {&a, &force})
            for (auto& column : field->c) std::fill(column.begin(), column.end(), 7.0);
        const auto a_before = a, force_before = force;
        BlockTotals<Dim> totals;
        CHECK(boundary_pressure_on_fluid<Dim>(s.fluid.view(), s.boundary(), fluid_solid, s.gravity, precision, totals,
                                              a) == Vec<Dim>{});
        CHECK(boundary_reaction<Dim>(s.boundary(), s.fluid.view(), solid_fluid, s.gravity, precision, totals, force) ==
              Vec<Dim>{});
        CHECK(same_bits(a, a_before));
        CHECK(same_bits(force, force_before));
    });
}

TEMPLATE_TEST_CASE_SIG("a boundary under suction holds nothing", "[boundary]", ((int Dim), Dim), 2, 3) {
    BoundaryScene<Dim> s(Scene::jittered);
    for (double& p : s.fluid.pressure) p = -1e5;  // far below what ρ (g − a)·x can make up for, 1e4 Pa
    const NeighborList fluid_solid = list_of(s.fluid, s.solid), solid_fluid = list_of(s.solid, s.fluid);
    const BoundaryResult<Dim> r = evaluate(s, fluid_solid, solid_fluid, Precision::full);
    CHECK(same_bits(r.on_fluid, zeros<Dim>(s.fluid.size())));
    CHECK(same_bits(r.on_solid, zeros<Dim>(s.solid.size())));
}

TEMPLATE_TEST_CASE_SIG("the passes of a moving boundary have the same bits for any number of threads", "[boundary]",
                       ((int Dim), Dim), 2, 3) {
    const BoundaryScene<Dim> s(Scene::unequal);
    const NeighborList fluid_solid = list_of(s.fluid, s.solid), solid_fluid = list_of(s.solid, s.fluid);
    in_all_variants([&](Precision precision) {
        std::vector<BoundaryResult<Dim>> results;
        for (const int threads : {1, 2, 4}) {
            const ThreadScope scope(threads);
            results.push_back(evaluate(s, fluid_solid, solid_fluid, precision));
        }
        for (const std::size_t t : {1, 2}) {
            CHECK(same_bits(results[t].on_fluid, results[0].on_fluid));
            CHECK(same_bits(results[t].on_solid, results[0].on_solid));
            CHECK((results[t].rate == results[0].rate));
            CHECK(results[t].sum_fluid == results[0].sum_fluid);
            CHECK(results[t].sum_solid == results[0].sum_solid);
        }
    });
}

}  // namespace sluice::test_boundary_passes
