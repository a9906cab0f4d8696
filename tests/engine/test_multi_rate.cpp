// Each medium at its own rate: what it must share with the single-rate scheme, and what it must keep.
#include <fmt/format.h>

#include "neighbor/isa.hpp"
#include "tests/catch.hpp"
#include "tests/engine/physics_scenes.hpp"
#include "tests/neighbor/clouds.hpp"

namespace sluice::test_multi_rate {
namespace {

const std::vector<std::string> multi_rate{"method.time_stepping=multi-rate"};

/// A free block of water that flies against a free elastic body.
const std::string with_disc = collision("{ circle = { centre = [0.017, 0.003], radius = 0.015 } }\n");

/// Mean displacement of the free end of the gate. [m]
double mean_deflection(const Simulation<2>& s) {
    double sum = 0;
    std::size_t n = 0;
    for (std::size_t i = 0; i < s.solid().owned; ++i)
        if (!s.solid().clamped[i] && s.solid().position[i][1] < 0.01) {
            sum += s.solid().position[i][0];
            ++n;
        }
    return sum / static_cast<double>(n) - 0.005;
}

void advance_to(Simulation<2>& s, double time) {
    while (s.time() < time) s.step();
}

}  // namespace

TEST_CASE("The step is the fluid's, cut into solid steps within the solid's limit") {
    const Simulation<2> simulation(scene_text::load(gate_in_basin(), multi_rate));
    const double of_fluid = simulation.courant_limits()[0].dt, of_solid = simulation.courant_limits()[1].dt;
    REQUIRE(of_fluid > of_solid);
    REQUIRE(simulation.time_step() == of_fluid);
    REQUIRE(simulation.solid_substeps() == static_cast<int>(std::ceil(of_fluid / of_solid)));
}

TEST_CASE("With one solid step per step, multi-rate is the single-rate scheme to the bit") {
    Simulation<2> single(scene_text::load(gate_in_basin()));
    const std::string step = fmt::format("method.time_step={:.17g}", single.time_step());
    Simulation<2> multi(scene_text::load(gate_in_basin(), {multi_rate[0], step}));
    REQUIRE(multi.solid_substeps() == 1);
    advance(single, 200);
    advance(multi, 200);
    REQUIRE(multi.solid().position.c == single.solid().position.c);
    REQUIRE(multi.fluid().velocity.c == single.fluid().velocity.c);
}

TEST_CASE("Multi-rate keeps momentum to rounding and hands over what it takes") {
    Simulation<2> simulation(scene_text::load(with_disc, multi_rate));
    REQUIRE(simulation.solid_substeps() > 1);
    const Vec<2> before = simulation.momentum();
    advance(simulation, 200);
    REQUIRE(norm(simulation.force_on(1)) * simulation.time() > 0.1 * norm(before));  // they do meet
    REQUIRE(norm(simulation.momentum() - before) < 1e-12 * norm(before));
    REQUIRE(simulation.interface_balance().residual < 1e-12);
}

TEST_CASE("Multi-rate follows the single-rate scheme in motion and energy") {
    Simulation<2> single(scene_text::load(gate_in_basin())), multi(scene_text::load(gate_in_basin(), multi_rate));
    const double end = 0.03, initial = single.energy().total();
    advance_to(single, end);
    advance_to(multi, end);
    // The interface's force is held over a step of the fluid, two hundredths of what the gate needs to answer.
    REQUIRE(mean_deflection(multi) == Approx(mean_deflection(single)).epsilon(0.03));
    // Kinetic energy stands half a step behind the potential one: what is compared is known to v · a Δt/2.
    const double moved = single.energy().kinetic;
    REQUIRE(multi.energy().kinetic == Approx(moved).epsilon(0.01));
    REQUIRE(std::abs(multi.energy().total() - single.energy().total()) < 0.01 * moved);
    REQUIRE(multi.energy().total() < initial);
}

TEST_CASE("A scene of one medium knows no sub-steps") {
    const Simulation<2> simulation(scene_text::load(preamble(0.002) + R"toml(
[bodies.water]
material = "water"
shape = { box = { min = [-0.02, -0.02], max = [0.0, 0.02] } }
)toml",
                                                    multi_rate));
    REQUIRE(simulation.solid_substeps() == 1);
    REQUIRE(simulation.time_step() == simulation.courant_limits()[0].dt);
}

TEST_CASE("Mixed precision keeps the interface's balance, and momentum to single rounding") {
    Simulation<2> simulation(scene_text::load(with_disc, {"method.precision=mixed"}));
    const Vec<2> before = simulation.momentum();
    advance(simulation, 300);
    REQUIRE(simulation.interface_balance().residual < 1e-12);
    WARN(norm(simulation.momentum() - before) / norm(before));
    REQUIRE(norm(simulation.momentum() - before) < 1e-6 * norm(before));
}

TEST_CASE("Every instruction set computes the same motion, and each the same bits on any number of threads") {
    const std::string precision = GENERATE("double", "mixed");
    std::vector<double> deflection;
    for (const Isa isa : available_isas()) {
        use_isa(name_of(isa));
        std::vector<VectorField<2>> position;
        for (const int threads : {1, 2, 3}) {
            const ThreadScope scope(threads);
            Simulation<2> simulation(
                scene_text::load(gate_in_basin(), {multi_rate[0], "method.precision=" + precision}));
            advance(simulation, 60);
            position.push_back(simulation.fluid().position);
            if (threads == 1) deflection.push_back(mean_deflection(simulation));
        }
        CAPTURE(name_of(isa));
        CHECK(position[1].c == position[0].c);
        CHECK(position[2].c == position[0].c);
    }
    use_isa(name_of(available_isas().back()));
    for (const double d : deflection) CHECK(d == Approx(deflection[0]).epsilon(precision == "mixed" ? 1e-4 : 1e-9));
}

}  // namespace sluice::test_multi_rate
