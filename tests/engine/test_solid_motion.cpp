// Solids: rigid motion, clamp, energy of free vibration.
#include <cmath>

#include "engine/step/neighborhood.hpp"
#include "kernels/materials/jaumann.hpp"
#include "kernels/passes/solid_passes.hpp"
#include "kernels/tensor.hpp"
#include "tests/catch.hpp"
#include "tests/engine/physics_scenes.hpp"

namespace sluice::test_solid_motion {
namespace {

std::string block(const std::string& velocity) {
    return preamble(0.002) + R"toml(
[bodies.block]
material = "rubber"
shape = { box = { min = [-0.02, -0.01], max = [0.02, 0.01] } }
velocity = )toml" +
           velocity;
}

double largest_stress(const ParticleSet<2>& solid) {
    double s = 0;
    for (std::size_t i = 0; i < solid.owned; ++i) {
        for (int k = 0; k < 3; ++k) s = std::max(s, std::abs(solid.deviatoric_stress[i][k]));
        s = std::max(s, std::abs(solid.pressure[i]));
    }
    return s;
}

}  // namespace

TEST_CASE("A rigidly translating body feels nothing") {
    Simulation<2> simulation(scene_text::load(block("[3.0, -2.0]")));
    advance(simulation, 500);
    // 1.2 MPa of stiffness; what is left is rounding of v_i − v_j = 0 and of positions.
    REQUIRE(largest_stress(simulation.solid()) < 1e-6);
    REQUIRE(simulation.momentum()[0] / simulation.momentum()[1] == Approx(-1.5).epsilon(1e-13));
}

TEST_CASE("A rigidly rotating stressed body keeps its stress in the co-rotating frame") {
    // One full turn in 400 steps, positions prescribed; gradient by the consistent sum (15), stress by the update (5).
    const Scene scene = scene_text::load(block("[\"0\", \"0\"]"));
    const Effects effects(scene);
    State<2> state = place_particles<2>(scene, effects);
    Neighborhood<2> neighbors(state, effects, scene.method.smoothing_length, Smoothing<2>().support);
    auto& solid = state.solid;
    const Pairing& all = neighbors.pair(
        {SetId::solid, SetId::solid, Upkeep::with_solid, Targets::own, Reach::mean, state.hypoelastic});
    neighbors.build();
    const Vec<3> initial{{3e4, -1e4, 2e4}};
    for (std::size_t i = 0; i < solid.owned; ++i) solid.deviatoric_stress.set(i, initial);
    const int steps = 400;
    const double omega = 50, dt = 2 * M_PI / omega / steps;
    VectorField<2> start;  // by id: the search may change the particles' places in memory
    start.resize(solid.owned);
    for (std::size_t i = 0; i < solid.owned; ++i) start.set(solid.id[i], solid.position[i]);
    const auto place = [&](double angle) {
        const double c = std::cos(angle), s = std::sin(angle);
        for (std::size_t i = 0; i < solid.owned; ++i) {
            const Vec<2> x = start[solid.id[i]];
            solid.position.set(i, {{c * x[0] - s * x[1], s * x[0] + c * x[1]}});
            solid.velocity.set(i, {{-omega * solid.position[i][1], omega * solid.position[i][0]}});
        }
    };
    for (int n = 0; n < steps; ++n) {
        place(omega * dt * (n + 0.5));
        neighbors.add_solid_motion(omega * dt * 0.025);
        neighbors.update_solid();
        std::fill(solid.density_rate.begin(), solid.density_rate.end(), 0.0);
        solid_rates<2>(view_of(solid), all.list, Precision::full, solid.density_rate,
                       solid.velocity_gradient);
        const double mu = state.solid_materials.front().shear_modulus;
        for (std::size_t i = 0; i < solid.owned; ++i) {
            const Tensor<2> stress = sym_to_tensor<2>(solid.deviatoric_stress[i]),
                            gradient = tensor_of<2>(solid.velocity_gradient[i]);
            solid.deviatoric_stress.set(
                i, tensor_to_sym<2>(advance_deviatoric_stress<2>(stress, gradient, mu, dt)));
        }
        for (std::size_t i = 0; i < solid.owned; ++i) {
            REQUIRE(std::abs(solid.density_rate[i]) < 1e-9 * 1100 * omega);  // rigid: no compression, to rounding
            REQUIRE(solid.velocity_gradient[i][2] == Approx(omega).epsilon(1e-9));
        }
        if (n + 1 == steps / 4) {     // after a quarter turn xx and yy have changed places and xy its sign
            const double lag = 1e-3;  // the midpoint rotation lags by (ωΔt)²/12 per radian: 3e-5 rad, times 2, here
            REQUIRE(solid.deviatoric_stress[7][0] == Approx(initial[1]).margin(lag * 4e4));
            REQUIRE(solid.deviatoric_stress[7][1] == Approx(initial[0]).margin(lag * 4e4));
            REQUIRE(solid.deviatoric_stress[7][2] == Approx(-initial[2]).margin(lag * 4e4));
        }
    }
    for (std::size_t i = 0; i < solid.owned; ++i) {
        const Tensor<2> s = sym_to_tensor<2>(solid.deviatoric_stress[i]), s0 = sym_to_tensor<2>(initial);
        REQUIRE(s.trace() == Approx(s0.trace()).epsilon(1e-9));
        REQUIRE(s.norm() == Approx(s0.norm()).epsilon(1e-9));  // rotation alone changes no principal stress
        REQUIRE((s - s0).norm() < 1e-3 * s0.norm());           // (ωΔt)²/12 · 2π · 2: the phase error of one turn
    }
}

TEST_CASE("Clamped particles stay where they are while their density and stress follow the body") {
    Simulation<2> simulation(scene_text::load(preamble(0.002) + R"toml(
[bodies.plate]
material = "rubber"
shape = { box = { min = [-0.01, -0.005], max = [0.05, 0.005] } }
clamp = { box = { min = [-0.01, -0.005], max = [0.0, 0.005] } }
velocity = ["0", "x > 0 ? 2*x/0.05 : 0"]
)toml"));
    std::vector<Vec<2>> before(simulation.solid().owned);
    for (std::size_t i = 0; i < before.size(); ++i) before[simulation.solid().id[i]] = simulation.solid().position[i];
    advance(simulation, 400);
    const auto& solid = simulation.solid();
    double clamped_stress = 0, free_motion = 0;
    for (std::size_t i = 0; i < solid.owned; ++i) {
        const Vec<2> moved = solid.position[i] - before[solid.id[i]];
        if (solid.clamped[i]) {
            REQUIRE(moved == Vec<2>{});
            clamped_stress = std::max(clamped_stress, std::abs(solid.deviatoric_stress[i][0]));
        } else {
            free_motion = std::max(free_motion, norm(moved));
        }
    }
    REQUIRE(free_motion > 1e-3);
    REQUIRE(clamped_stress > 1e3);
}

TEST_CASE("A freely vibrating plate without dissipation keeps its energy") {
    // The scheme is not variational: strains come from the consistent gradient (15), forces from the plain one (11), so
    // that the bent plate's stored energy is overestimated by what the two differ, some 15 %, slowly less with the
    // spacing: the same shortfall of stiffness that makes the paper's plate slow. It must come back in full, period
    // after period.
    struct Balance {
        double straight = 0;  ///< worst relative change of the total while less than a tenth of it is stored
        double bent = 0;      ///< largest excess
    };
    const auto measure = [](const char* spacing) {
        Simulation<2> simulation(scene_text::load(preamble(0.002) + R"toml(
[method.solid]
artificial_viscosity = 0.0
artificial_stress = 0.0
[bodies.plate]
material = "rubber"
shape = { box = { min = [0.0, -0.005], max = [0.06, 0.005] } }
velocity = ["0", "0.2*cos(2*pi*x/0.06)"]
)toml",
                                                  {std::string("method.spacing=") + spacing}));
        const double start = simulation.energy().total();
        Balance b;
        while (simulation.time() < 0.03) {  // four periods
            simulation.step();
            const EnergyBalance e = simulation.energy();
            const double change = e.total() / start - 1;
            if (e.elastic + e.compression < 0.1 * start) b.straight = std::max(b.straight, std::abs(change));
            b.bent = std::max(b.bent, change);
        }
        return b;
    };
    const Balance coarse = measure("0.002"), fine = measure("0.001");
    CAPTURE(coarse.straight, coarse.bent, fine.straight, fine.bent);
    // Straight: a tenth of the bent plate's excess counts while a tenth is stored, 1.5 %, and sound in the plate.
    REQUIRE(coarse.straight < 0.04);
    REQUIRE(fine.straight < 0.02);
    REQUIRE(coarse.bent < 0.2);
    REQUIRE(fine.bent < coarse.bent);
}

}  // namespace sluice::test_solid_motion
