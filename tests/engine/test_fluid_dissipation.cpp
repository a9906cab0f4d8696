// What dissipates in the fluid does so at the rate that its formula promises.
#include "tests/catch.hpp"
#include "tests/engine/wave_scenes.hpp"

namespace sluice::test_fluid_dissipation {
namespace {

constexpr double spacing = 0.0025, h = 1.5 * spacing, width = 16 * spacing;

/// Amplitude of the alternating part of a quantity that started as ±1 by the particles' ids.
template <class Value>
double alternating(const ParticleSet<2>& fluid, const std::vector<double>& sign, Value&& value) {
    double sum = 0;
    for (std::size_t i = 0; i < fluid.owned; ++i) sum += sign[fluid.id[i]] * value(i);
    return sum / static_cast<double>(fluid.owned);
}

/// +1 and −1 in turn along both axes, by id.
std::vector<double> checkerboard(const ParticleSet<2>& fluid) {
    std::vector<double> sign(fluid.owned);
    for (std::size_t i = 0; i < fluid.owned; ++i) {
        const Vec<2> x = fluid.position[i];
        const int column = static_cast<int>(x[0] / spacing), row = static_cast<int>(x[1] / spacing);
        sign[fluid.id[i]] = (column + row) % 2 == 0 ? 1 : -1;
    }
    return sign;
}

}  // namespace

TEST_CASE("A sound wave without dissipation keeps its energy") {
    Simulation<2> s(scene_text::load(waves::box(spacing, width, waves::standing_sound(0.01)), waves::plain()));
    // Kick-drift-kick with (ω Δt)² = 0.04: the energy swings by a fraction of that.
    CHECK(std::abs(waves::fading_rate(s, 0.02)) * 0.02 < 0.01);
}

TEST_CASE("Acoustic damping takes sound away at the rate alpha c0 h k^2/2, and leaves shear alone") {
    const double alpha = GENERATE(0.2, 0.5);
    const auto overrides = waves::plain({fmt::format("method.fluid.acoustic_damping={}", alpha)});
    const double expected = alpha * waves::sound_speed * h * waves::wave_number * waves::wave_number / 2;
    Simulation<2> sound(scene_text::load(waves::box(spacing, width, waves::standing_sound(0.01)), overrides));
    const double rate = waves::fading_rate(sound, 3 * 2 * std::numbers::pi / (waves::wave_number * waves::sound_speed));
    CAPTURE(alpha, rate / expected);
    CHECK(rate == Approx(expected).epsilon(0.1));  // (kh)² = 0.06 of the sums, (ωΔt)² of the step
    Simulation<2> shear(scene_text::load(
        waves::box(spacing, width, fmt::format("velocity = [\"0\", \"0.01 * sin({} * x)\"]", waves::wave_number)),
        overrides));
    // The lattice is sheared by a tenth of a spacing only: next to no density changes.
    CHECK(std::abs(waves::fading_rate(shear, 0.01)) < 0.01 * expected);
}

TEST_CASE("A shear wave decays by laminar viscosity at the rate nu k^2, in either form") {
    const std::string form = GENERATE("morris", "monaghan-gingold");
    const double nu = 0.01;
    Simulation<2> s(scene_text::load(
        waves::box(spacing, width, fmt::format("velocity = [\"0\", \"0.01 * sin({} * x)\"]", waves::wave_number)),
        waves::plain({"materials.water.viscosity=10.0", "method.fluid.viscous_form=" + form})));
    const double expected = nu * waves::wave_number * waves::wave_number, start = waves::amplitude(s, 1, 0);
    waves::advance_to(s, 1 / expected);
    const double rate = std::log(start / waves::amplitude(s, 1, 0)) / s.time();
    CAPTURE(form, rate / expected);
    // On a square lattice with h/d = 1.5 the terms' sums over this wave are so much of their integrals: one along the
    // line between particles depends on where the few neighbours stand.
    const double share = form == "morris" ? 1.0024 : 0.9435;
    CHECK(rate == Approx(share * expected).epsilon(0.01));  // Δt/2 times the rate, 0.2 %, and the lattice's shear
}

TEST_CASE("Artificial viscosity damps a sound wave as a viscosity that acts half of the time") {
    const double alpha = 0.5;
    Simulation<2> s(scene_text::load(waves::box(spacing, width, waves::standing_sound(0.01)),
                                     waves::plain({fmt::format("method.fluid.artificial_viscosity={}", alpha)})));
    // Along the line between two particles it is ν (∇²v + 2 ∇(∇·v)) with ν = α h c/8 in 2D: 3ν for a sound wave. All
    // pairs approach where the fluid is compressed, none elsewhere: half of it, and amplitudes fade by half the rate.
    const double nu = alpha * h * waves::sound_speed / 8;
    const double expected = 3 * nu * waves::wave_number * waves::wave_number / 4;
    const double rate = waves::fading_rate(s, 3 * 2 * std::numbers::pi / (waves::wave_number * waves::sound_speed));
    CAPTURE(rate / expected);
    CHECK(rate == Approx(expected).epsilon(0.15));  // (kh)², and the softening 0.01 h² in its divisor
}

TEST_CASE("Density diffusion smoothes a checkerboard of densities that pressure cannot see") {
    const std::string kind = GENERATE("none", "molteni-colagrossi", "fourtakas", "antuono");
    CAPTURE(kind);
    // Half-way between the zeros of sin(pi x/d) stand the particles.
    const std::string pressure = fmt::format("pressure = \"100 * sin(pi*x/{0}) * sin(pi*y/{0})\"", spacing);
    Simulation<2> s(scene_text::load(waves::box(spacing, width, pressure),
                                     waves::plain({"method.fluid.density_diffusion=" + kind})));
    const auto& fluid = s.fluid();
    const std::vector<double> sign = checkerboard(fluid);
    const auto noise = [&] { return alternating(fluid, sign, [&](std::size_t i) { return fluid.density[i] - 1000; }); };
    const double start = noise();
    REQUIRE(start == Approx(100.0 / 900).epsilon(1e-6));  // p/c0², to the digits that ρ − ρ0 leaves
    advance(s, 60);
    // The slowest of the three, δ c0 h Σ V 4 ∇W/x, takes less than ten steps to halve it.
    if (kind == "none")
        CHECK(std::abs(noise()) > 0.5 * start);
    else
        CHECK(std::abs(noise()) < 0.02 * start);
}

TEST_CASE("The velocity filter takes the checkerboard out of velocities and leaves a long wave") {
    const auto remaining = [](const char* theta, bool noise) {
        const std::string text =
            noise ? fmt::format("velocity = [\"0.01 * sin(pi*x/{0}) * sin(pi*y/{0})\", \"0\"]", spacing)
                  : fmt::format("velocity = [\"0\", \"0.01 * sin({} * x)\"]", waves::wave_number);
        Simulation<2> s(
            scene_text::load(waves::box(spacing, width, text), {std::string("method.fluid.velocity_filter=") + theta}));
        const auto& fluid = s.fluid();
        const std::vector<double> sign = checkerboard(fluid);
        const auto measure = [&] {
            return noise ? alternating(fluid, sign, [&](std::size_t i) { return fluid.velocity[i][0]; })
                         : waves::amplitude(s, 1, 0);
        };
        const double start = measure();
        advance(s, 30);
        return std::abs(measure()) / start;
    };
    // A step takes 1 − θ = 8 % of what differs from the surroundings: 0.92³⁰ = 0.08 of the noise is left, while a long
    // wave differs from its surroundings by (kh)² = 0.06 at the most.
    CHECK(remaining("0.92", true) < 0.12);
    CHECK(remaining("1.0", true) > 0.5);
    CHECK(remaining("0.92", false) > 0.9);
    CHECK(remaining("1.0", false) > 0.999);
}

}  // namespace sluice::test_fluid_dissipation
