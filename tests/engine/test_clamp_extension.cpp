// The displacement behind a clamp's surface: gradients are exact up to it, forces are those of an energy, and a clamped
// plate swings as it should.
#include <fmt/format.h>

#include <numbers>

#include "engine/particles/state.hpp"
#include "engine/step/neighborhood.hpp"
#include "engine/step/parts/clamp_extension.hpp"
#include "engine/step/parts/largest_eigenvalue.hpp"
#include "kernels/passes/total_lagrangian_passes.hpp"
#include "tests/catch.hpp"
#include "tests/engine/physics_scenes.hpp"

namespace sluice::test_clamp_extension {
namespace {

/// A beam of square section along x, from 0 to 0.03 m, at a spacing of 2 mm; `clamp` is a shape.
template <int Dim>
std::string beam(const std::string& clamp) {
    return fmt::format(R"toml(
dimension = {}
[method]
preset = "modern"
spacing = 0.002
[materials.rubber]
kind = "solid"
density = 1100.0
youngs_modulus = 1.2e6
poisson_ratio = 0.4
[bodies.beam]
material = "rubber"
shape = {{ box = {{ min = [0.0, 0.0{}], max = [0.03, 0.01{}] }} }}
clamp = {}
[output]
end = 1.0
)toml",
                       Dim, Dim == 2 ? "" : ", 0.0", Dim == 2 ? "" : ", 0.01", clamp);
}

/// Holds what lies left of a plane across x.
template <int Dim>
std::string left_of(double x) {
    return Dim == 2 ? fmt::format("{{ box = {{ min = [-1.0, -1.0], max = [{}, 1.0] }} }}", x)
                    : fmt::format("{{ box = {{ min = [-1.0, -1.0, -1.0], max = [{}, 1.0, 1.0] }} }}", x);
}

/// A clamped solid and its passes over all particles, without steps.
template <int Dim>
struct ClampedSolid {
    explicit ClampedSolid(const std::string& text)
        : scene(scene_text::load(text)),
          effects(scene),
          state(place_particles<Dim>(scene, effects)),
          smoothing(scene.method.smoothing_function),
          neighbors(state, effects, scene.method.smoothing_length, smoothing.support),
          method(Precision::full, smoothing),
          list(built_list()),
          behind(scene, solid(), list, smoothing.support * state.max_h) {
        const double stiffness = 2e5;
        elastic_correction<Dim>(view_of(solid()), list, {&stiffness, 1}, method,
                                solid().gradient_correction, solid().hourglass_stiffness);
        behind.share_energy(solid());
    }

    ParticleSet<Dim>& solid() { return state.solid; }

    const NeighborList& built_list() {
        const Pairing& all = neighbors.pair(
            {SetId::solid, SetId::solid, Upkeep::for_good, Targets::own, Reach::mean, state.hyperelastic});
        neighbors.build();
        return all.list;
    }

    /// Free particles go to x + u(x), those behind the clamp's surface follow; forces are left to be handed over.
    template <class Displacement>
    void deform(const Displacement& u) {
        auto& s = solid();
        for (std::size_t i = 0; i < s.owned; ++i)
            if (!s.clamped[i]) s.position.set(i, s.reference_position[i] + u(s.reference_position[i]));
        behind.displace(s);
        const auto view = view_of(s);
        const Hyperelastic law = state.solid_materials.front().law;
        elastic_deformation<Dim>(view, list, {&law, 1}, method, s.deformation, s.corrected_stress);
        for (auto& column : s.acceleration.c) std::fill(column.begin(), column.end(), 0.0);
        elastic_momentum<Dim>(view, list, {}, method, s.acceleration);
    }

    double energy() {
        auto& s = solid();
        ScalarField hourglass(s.owned);
        hourglass_energy<Dim>(view_of(s), list, method, hourglass);
        double sum = 0;
        for (std::size_t i = 0; i < s.owned; ++i)
            sum += s.elastic_share[i] * s.volume[i] *
                       state.solid_materials.front().law.template energy_density<Dim>(tensor_of<Dim>(s.deformation[i])) +
                   hourglass[i];
        return sum;
    }

    Scene scene;
    Effects effects;
    State<Dim> state;
    Smoothing<Dim> smoothing;
    Neighborhood<Dim> neighbors;
    PairMethod<Dim> method;
    const NeighborList& list;
    ClampExtension<Dim> behind;
};

/// First period of a plate in plane strain, ν = 0.4, ten times as long as thick, clamped at one end, in its thickness
/// over √(E/ρ): finite elements with 120 x 16 biquadratic elements (validation/oscillating_plate/plane_elasticity.py).
constexpr double plate_period = 569.943;

/// The same from a run: twice the time between the first two zeros of the deflection. The clamp's surface is `longer`
/// spacings behind a face of the lattice, which makes the plate as much longer; its period, as the square of its
/// length, is taken back to the length of before.
double period_of_plate(int across, double longer = 0, const std::vector<std::string>& overrides = {}) {
    const double thickness = 0.01, d = thickness / across, youngs = 1.2e6, density = 1100;
    // The first mode of a thin beam, k L = 1.8751, slow: 1e-4 of its length.
    const std::string shape = "(cosh(18.751*x) - cos(18.751*x) - 0.73410*(sinh(18.751*x) - sin(18.751*x)))";
    Simulation<2> s(scene_text::load(fmt::format(R"toml(
[method]
preset = "modern"
spacing = {}
smoothing_length = 1.2
[materials.rubber]
kind = "solid"
density = {}
youngs_modulus = {}
poisson_ratio = 0.4
[bodies.plate]
material = "rubber"
shape = {{ box = {{ min = [{}, 0.0], max = [0.1, 0.01] }} }}
clamp = {{ box = {{ min = [-1.0, 0.0], max = [{}, 0.01] }} }}
velocity = ["0", "1e-3*{}"]
[output]
end = 1.0
)toml",
                                                 d, density, youngs, -4 * d, -longer * d, shape),
                                     overrides));
    const double scale = thickness / std::sqrt(youngs / density);
    // Projected on the mode, so that others do not show.
    std::vector<double> mode;
    for (std::size_t i = 0; i < s.solid().owned; ++i) {
        const double x = 18.751 * s.solid().reference_position[i][0];
        mode.push_back(std::cosh(x) - std::cos(x) - 0.73410 * (std::sinh(x) - std::sin(x)));
    }
    double zeros[2] = {}, before = 0;
    for (int found = 0; found < 2;) {
        s.step();
        REQUIRE(s.time() < 2 * plate_period * scale);
        double now = 0;
        for (std::size_t i = 0; i < mode.size(); ++i)
            if (!s.solid().clamped[i]) now += mode[i] * (s.solid().position[i][1] - s.solid().reference_position[i][1]);
        if (before * now < 0) zeros[found++] = s.time() - s.time_step() * now / (now - before);
        before = now;
    }
    const double length = 0.1 + longer * d;
    return 2 * (zeros[1] - zeros[0]) / scale * std::pow(0.1 / length, 2);
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("Next to a clamp a linear displacement has its gradient", "", ((int Dim), Dim), 2, 3) {
    // Half-way between two layers, and nearer to either of them: particles stand at odd multiples of 1 mm.
    const double plane = GENERATE(0.012, 0.0112, 0.01285);
    ClampedSolid<Dim> c(beam<Dim>(left_of<Dim>(plane)));
    Vec<Dim> slope;
    for (int k = 0; k < Dim; ++k) slope[k] = 0.1 * (k + 1);
    c.deform([&](const Vec<Dim>& x) { return (x[0] - plane) * slope; });
    double worst = 0;
    for (std::size_t i = 0; i < c.solid().owned; ++i) {
        if (c.solid().clamped[i]) continue;
        Tensor<Dim> expected = Tensor<Dim>::Identity();
        for (int k = 0; k < Dim; ++k) expected(k, 0) += slope[k];
        worst = std::max(worst, (tensor_of<Dim>(c.solid().deformation[i]) - expected).norm());
    }
    CAPTURE(plane);
    CHECK(worst < 1e-6);  // shapes are closed with a slack of 1e-9 of their size
}

TEMPLATE_TEST_CASE_SIG("Forces next to a clamp are the slope of the energy", "", ((int Dim), Dim), 2, 3) {
    const std::string ball = Dim == 2 ? "{ circle = { centre = [0.0, 0.005], radius = 0.0123 } }"
                                      : "{ sphere = { centre = [0.0, 0.005, 0.005], radius = 0.0123 } }";
    const std::string clamp = GENERATE_REF(values<std::string>({left_of<Dim>(0.012), left_of<Dim>(0.0112), ball}));
    ClampedSolid<Dim> c(beam<Dim>(clamp));
    REQUIRE(!c.behind.empty());
    const auto wave = [](const Vec<Dim>& x, double phase) {
        Vec<Dim> u;
        for (int k = 0; k < Dim; ++k) u[k] = 1e-4 * std::sin(700 * x[0] + 900 * x[Dim - 1] + phase + k);
        return u;
    };
    const auto shape = [&](double along) {
        return [&wave, along](const Vec<Dim>& x) { return wave(x, 0.3) + along * wave(x, 1.9); };
    };
    constexpr double step = 1e-3;
    c.deform(shape(step));
    const double above = c.energy();
    c.behind.hand_over(c.solid());
    c.deform(shape(-step));
    const double below = c.energy();
    c.behind.hand_over(c.solid());
    c.deform(shape(0));
    c.behind.hand_over(c.solid());
    double power = 0, size = 0;
    const auto& s = c.solid();
    for (std::size_t i = 0; i < s.owned; ++i) {
        if (s.clamped[i]) continue;
        const double p = s.mass[i] * dot(s.acceleration[i], wave(s.reference_position[i], 1.9));
        power += p;
        size += std::abs(p);
    }
    CAPTURE(clamp, power, (above - below) / (2 * step));
    // The energy's third derivative leaves step² = 1e-6.
    CHECK(std::abs((above - below) / (2 * step) + power) < 1e-5 * size);
}

TEST_CASE("A body clamped in its middle only is held there, and follows neither side") {
    ClampedSolid<2> c(beam<2>("{ box = { min = [0.014, 0.0], max = [0.018, 0.01] } }"));
    CHECK(c.behind.empty());
    c.deform([](const Vec<2>& x) { return Vec<2>{{1e-4 * x[1] / 0.01, 0}}; });
    for (std::size_t i = 0; i < c.solid().owned; ++i)
        if (c.solid().clamped[i]) CHECK(norm(c.solid().position[i] - c.solid().reference_position[i]) == 0);
}

TEST_CASE("A clamped plate swings at the period of plane elasticity, with an error of second order") {
    const double coarse = period_of_plate(4) / plate_period - 1, fine = period_of_plate(8) / plate_period - 1;
    CAPTURE(coarse, fine);
    CHECK(std::abs(coarse) < 0.02);
    CHECK(std::abs(fine) < 0.01);
    // Beside held particles that stand still strain is half of what it should be: 4.1 % instead of 1.8 %.
    const double off = period_of_plate(4, 0, {"effects.clamp_extension=off"}) / plate_period - 1;
    CAPTURE(off);
    CHECK(off > coarse + 0.02);
}

TEST_CASE("A clamped plate swings as long as it should wherever the clamp cuts its lattice") {
    const double whole = period_of_plate(6);
    for (const double longer : {-0.4, -0.2, 0.2, 0.4}) {
        CAPTURE(longer);
        // 0.5 to 0.6 % at six across, a quarter of that at twelve. Cells that count whole or not at all make it 2 %, as
        // do cut ones that do not follow.
        CHECK(period_of_plate(6, longer) / whole == Approx(1).margin(0.008));
    }
}

TEST_CASE("A clamped beam keeps its energy, what hourglass control holds behind the clamp included") {
    Simulation<2> s(
        scene_text::load(beam<2>(left_of<2>(0.0112)), {"method.solid.artificial_viscosity=0", "method.courant=0.2",
                                                       "bodies.beam.velocity=[\"0\", \"100*(x-0.0112)^2\"]"}));
    const double start = s.energy().total();
    double worst = 0, elastic = 0;
    while (s.time() < 0.01) {
        s.step();
        worst = std::max(worst, std::abs(s.energy().total() / start - 1));
        elastic = std::max(elastic, s.energy().elastic / start);
    }
    CAPTURE(worst, elastic);
    CHECK(elastic > 0.5);  // it does swing
    // (ω dt/2)² of modes up to a fifth of the limit: 4 % of those at the limit, of which a smooth start has little.
    CHECK(worst < 0.01);
}

TEST_CASE("The largest eigenvalue of a chain of springs is that of theory") {
    // 2 − 2 cos(nπ/(n + 1)) for n masses between two walls.
    for (const std::size_t n : {1U, 2U, 7U, 400U}) {
        const double found = largest_eigenvalue(n, [&](std::span<const double> x, std::span<double> y) {
            for (std::size_t i = 0; i < n; ++i) y[i] = 2 * x[i] - (i > 0 ? x[i - 1] : 0) - (i + 1 < n ? x[i + 1] : 0);
        });
        const auto size = static_cast<double>(n);
        const double exact = 2 - 2 * std::cos(size * std::numbers::pi / (size + 1));
        CHECK(found <= exact * (1 + 1e-10));
        CHECK(found >= exact * (1 - 0.01));
    }
    CHECK(largest_eigenvalue(
              3, [](std::span<const double>, std::span<double> y) { std::fill(y.begin(), y.end(), 0.0); }) == 0);
}

TEST_CASE("A total-Lagrangian solid is stable up to its step's limit and not far beyond") {
    const auto energy_after = [](double courant, double poisson) {
        Simulation<2> s(scene_text::load(
            beam<2>(left_of<2>(0.012)),
            {fmt::format("method.courant={}", courant), fmt::format("materials.rubber.poisson_ratio={}", poisson),
             "method.solid.artificial_viscosity=0", "bodies.beam.velocity=[\"1e-3*sin(2000*x+3000*y)\", \"0\"]"}));
        const double start = s.energy().total();
        advance(s, 3000);
        return s.energy().total() / start;
    };
    for (const double poisson : {0.0, 0.3, 0.45}) {
        CAPTURE(poisson);
        // Near the limit Verlet's energy of the fastest mode is off by up to 1/(1 − (ωΔt/2)²), 11 at 0.95 times 1.01².
        CHECK(energy_after(0.95, poisson) < 11);
        CHECK(!(energy_after(1.03, poisson) < 1e3));
    }
}

}  // namespace sluice::test_clamp_extension
