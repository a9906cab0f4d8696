// Contact of total-Lagrangian solids: collisions, walls, rest; what it keeps, and what it costs where nothing is near.
#include "engine/step/couplings/contact.hpp"

#include "tests/catch.hpp"
#include "tests/engine/contact_scenes.hpp"

namespace sluice::test_contact {
namespace {

using namespace contact_scenes;

constexpr double d = 0.001;

/// What a collision of two bodies has gone through.
struct Collision {
    double least_energy = 0, most_energy = 0;  ///< worst relative change of the total
    double contact = 0;                        ///< largest share of the energy in the contact
    double momentum = 0;                       ///< worst |Σ m v| over one body's at the start
    double spin = 0;                           ///< worst |Σ m x × v| over Σ m |x| |v| of the start
    double before = 0, after = 0;              ///< speed of the first body along x
    std::array<double, 2> left{}, right{};     ///< ranges at the end
};

template <int Dim>
double angular_momentum(const Simulation<Dim>& s) {
    double sum = 0;
    for (std::size_t i = 0; i < s.solid().owned; ++i) {
        const Vec<Dim> x = s.solid().position[i], v = s.solid().velocity[i];
        sum += s.solid().mass[i] * (x[0] * v[1] - x[1] * v[0]);
    }
    return sum;
}

template <int Dim>
Collision collide(const std::string& text, double end, const std::vector<std::string>& overrides = {}) {
    Simulation<Dim> s(scene_text::load(text, overrides));
    Collision c;
    const double start = s.energy().total(), one = norm(contact_scenes::momentum_of(s, 0)), spin = angular_momentum(s);
    double spin_size = 0;
    for (std::size_t i = 0; i < s.solid().owned; ++i)
        spin_size += s.solid().mass[i] * norm(s.solid().position[i]) * norm(s.solid().velocity[i]);
    c.before = contact_scenes::momentum_of(s, 0)[0] / mass_of(s, 0);
    while (s.time() < end) {
        s.step();
        const EnergyBalance e = s.energy();
        c.least_energy = std::min(c.least_energy, e.total() / start - 1);
        c.most_energy = std::max(c.most_energy, e.total() / start - 1);
        c.contact = std::max(c.contact, e.contact / start);
        c.momentum = std::max(c.momentum, norm(s.momentum()) / one);
        c.spin = std::max(c.spin, std::abs(angular_momentum(s) - spin) / spin_size);
    }
    c.after = contact_scenes::momentum_of(s, 0)[0] / mass_of(s, 0);
    c.left = range_of(s, 0);
    c.right = range_of(s, 1);
    return c;
}

/// 0.05 c0 of relative speed, half a spacing off the axis.
const std::string discs = rubber(d) + body("left", disc(-0.012, 0, 0.01), "[1.066, 0]") +
                          body("right", disc(0.012, 0.0005, 0.01), "[-1.066, 0]");
const std::string rings = rubber(d) + body("left", ring(-0.0125, 0.01, 0.006), "[1.066, 0]") +
                          body("right", ring(0.0125, 0.01, 0.006), "[-1.066, 0]");

}  // namespace

TEST_CASE("Discs collide and rebound, and keep energy, momentum and angular momentum") {
    const Collision c = collide<2>(discs, 0.006);
    CAPTURE(c.least_energy, c.most_energy, c.contact, c.momentum, c.spin, c.before, c.after);
    CHECK(c.contact > 0.01);
    CHECK(c.after < -0.5 * c.before);  // the rest vibrates in them
    CHECK(c.left[1] + 0.5 * d < c.right[0]);
    // Verlet's own: (ωΔt)²/8 of what is in the waves of a few spacings.
    CHECK(c.least_energy > -0.01);
    CHECK(c.most_energy < 0.01);
    CHECK(c.momentum < 1e-12);  // rounding of some hundred steps
    CHECK(c.spin < 1e-12);
}

namespace {

/// The energy (b) of kernels/passes/contact_passes.hpp by all pairs, of bodies that start apart.
template <int Dim>
double contact_energy(const Simulation<Dim>& s) {
    const Smoothing<Dim> w(s.scene().method.smoothing_function);
    const double threshold = flat_contact<Dim>(w, s.scene().method.smoothing_length).density;
    const auto& solid = s.solid();
    double energy = 0;
    for (std::size_t i = 0; i < solid.owned; ++i) {
        double sigma = 0;
        for (std::size_t j = 0; j < solid.owned; ++j)
            if (solid.body[i] != solid.body[j])
                sigma += solid.volume[j] * w(norm(solid.position[i] - solid.position[j]), solid.smoothing_length[i]);
        const double excess = std::max(sigma - threshold, 0.0);
        energy += 0.5 * contact_stiffness * s.solid_materials().front().law.wave_modulus() * solid.volume[i] * excess * excess;
    }
    return energy;
}

}  // namespace

TEST_CASE("Whatever touches is found, all through a collision") {
    Simulation<2> s(scene_text::load(discs));
    int touching = 0;
    while (s.time() < 0.004) {
        advance(s, 3);
        const double expected = contact_energy(s), got = s.energy().contact;
        touching += expected > 0;
        REQUIRE(std::abs(got - expected) <= 1e-9 * expected);  // rounding of σ − σ_0, which may be small
    }
    CHECK(touching > 10);
}

TEST_CASE("Rings collide and rebound; without contact they pass through each other") {
    const Collision with = collide<2>(rings, 0.024), without = collide<2>(rings, 0.024, {"effects.contact=off"});
    CAPTURE(with.least_energy, with.most_energy, with.contact, with.momentum, with.after, without.after);
    CHECK(with.after < -0.3 * with.before);
    CHECK(with.left[1] + 0.5 * d < with.right[0]);
    CHECK(with.least_energy > -0.01);  // as for discs
    CHECK(with.most_energy < 0.01);
    CHECK(with.momentum < 1e-12);
    CHECK(without.after == Approx(without.before).epsilon(1e-9));
    CHECK(without.left[0] > without.right[1]);
}

TEST_CASE("Blocks collide in 3D") {
    const std::string text = "dimension = 3\n" + rubber(0.002) +
                             body("left", box("[-0.013, -0.008, -0.008]", "[-0.003, 0.008, 0.008]"), "[1.0, 0, 0]") +
                             body("right", box("[0.003, -0.006, -0.004]", "[0.013, 0.01, 0.012]"), "[-1.0, 0, 0]");
    const Collision c = collide<3>(text, 0.006);
    CAPTURE(c.least_energy, c.most_energy, c.contact, c.momentum, c.spin, c.after);
    CHECK(c.after < -0.5 * c.before);
    // Flat faces that meet at once: more in the shortest waves than with discs, and the pressure sets in with a kink.
    // It is the step's: 1.8 %, and 0.2 % with half the step.
    CHECK(c.least_energy > -0.03);
    CHECK(c.most_energy < 0.03);
    CHECK(c.momentum < 1e-12);
    CHECK(c.spin < 1e-12);
}

namespace {

/// A block falls on a floor at y = 0 with 2 m/s.
template <int Dim>
void check_drop(const std::string& text, double spacing) {
    Simulation<Dim> s(scene_text::load(text));
    const double start = s.energy().total();
    double least = 0, most = 0, deepest = 1, up = 0;
    while (s.time() < 0.01) {
        s.step();
        least = std::min(least, s.energy().total() / start - 1);
        most = std::max(most, s.energy().total() / start - 1);
        deepest = std::min(deepest, lowest(s));
        up = std::max(up, contact_scenes::momentum_of(s, 0)[1] / mass_of(s));
    }
    CAPTURE(least, most, deepest / spacing, up);
    CHECK(up > 1);                   // the rest vibrates in it
    CHECK(deepest < 0.5 * spacing);  // it touched: its lowest particles stood at half a spacing
    CHECK(deepest > 0);              // and entered by less than half of one
    // Flat faces that meet at once: some in the shortest waves, whose energy Verlet's scheme sees up to a third wrong.
    CHECK(least > -0.03);
    CHECK(most < 0.03);
}

}  // namespace

TEST_CASE("A block dropped on a floor rebounds, and does not enter it by half a spacing") {
    const std::string floor = GENERATE(as<std::string>{}, mirror_floor, fixed_floor);
    check_drop<2>(rubber(d, "gravity = [0.0, -9.81]\n") +
                      body("block", box("[-0.01, 0.003]", "[0.01, 0.013]"), "[0, -2.0]") + floor,
                  d);
}

TEST_CASE("A block dropped on a floor rebounds in 3D") {
    const std::string mirror = "[walls.floor]\nkind = \"mirror\"\npoint = [0.0, 0.0, 0.0]\nnormal = [0.0, 1.0, 0.0]\n";
    const std::string fixed =
        "[walls.floor]\nkind = \"fixed\"\nshape = " + box("[-0.016, -0.008, -0.016]", "[0.016, 0.0, 0.016]") + "\n";
    const std::string floor = GENERATE_COPY(mirror, fixed);
    check_drop<3>("dimension = 3\n" + rubber(0.002, "gravity = [0.0, -9.81, 0.0]\n") +
                      body("block", box("[-0.008, 0.003, -0.006]", "[0.008, 0.015, 0.006]"), "[0, -2.0, 0]") + floor,
                  0.002);
}

namespace {

/// A block, or one on another, that comes to rest on a floor by its viscosity: contact forces on each body, averaged
/// over the second half of the run.
std::vector<Vec<2>> mean_forces(const std::string& bodies, std::size_t count, const std::string& floor, double end) {
    Simulation<2> s(scene_text::load(rubber(d, "gravity = [0.0, -9.81]\n") + bodies + floor,
                                     {"method.solid.artificial_viscosity=1"}));
    std::vector<Vec<2>> sum(count);
    double weight = 0;
    while (s.time() < end) {
        s.step();
        if (s.time() < 0.5 * end) continue;
        weight += s.time_step();
        for (std::size_t b = 0; b < count; ++b) sum[b] += s.time_step() * s.contact_force_on(b);
    }
    for (std::size_t b = 0; b < count; ++b) sum[b] = (1 / (weight * mass_of(s, b) * 9.81)) * sum[b];
    return sum;
}

}  // namespace

TEST_CASE("A block at rest on a floor carries its weight") {
    const std::string floor = GENERATE(as<std::string>{}, mirror_floor, fixed_floor);
    const auto force = mean_forces(body("block", box("[-0.01, 0.0]", "[0.01, 0.01]"), "[0, 0]"), 1, floor, 0.1);
    CAPTURE(force[0][0], force[0][1]);
    CHECK(force[0][1] == Approx(1).epsilon(0.01));
    CHECK(std::abs(force[0][0]) < 1e-6);  // symmetric to rounding, which grows
}

TEST_CASE("A block on another hands its weight down") {
    const std::string blocks = body("lower", box("[-0.01, 0.0]", "[0.01, 0.01]"), "[0, 0]") +
                               body("upper", box("[-0.01, 0.0105]", "[0.01, 0.0205]"), "[0, 0]");
    const auto force = mean_forces(blocks, 2, mirror_floor, 0.2);
    CAPTURE(force[0][1], force[1][1]);
    CHECK(force[0][1] == Approx(1).epsilon(0.01));
    CHECK(force[1][1] == Approx(1).epsilon(0.01));
}

TEST_CASE("Where nothing is near, contact looks once and holds nothing") {
    const std::string text = rubber(d) + body("left", disc(-0.1, 0, 0.01), "[0.5, 0]") +
                             body("right", disc(0.1, 0, 0.01), "[-0.5, 0]") + mirror_floor;
    const std::string high = scene_text::with(text, "point = [0.0, 0.0]", "point = [0.0, -0.1]");
    // Contact shortens the step that a scene does not state.
    const std::string step = "method.time_step=1e-5";
    Simulation<2> with(scene_text::load(high, {step})), without(scene_text::load(high, {step, "effects.contact=off"}));
    advance(with, 200);
    advance(without, 200);
    CHECK((with.solid().position.c == without.solid().position.c));
    CHECK(with.work().neighbour_builds - without.work().neighbour_builds == 1);
    CHECK(with.work().pairs == without.work().pairs);
    // Three thresholds for each particle, its number in its body's group, and room to grow.
    CHECK(with.memory_bytes() - without.memory_bytes() < 50 * with.solid().owned);
}

TEST_CASE("Bodies that touch at the start are one; those apart are not, however near") {
    const auto apart_after = [](double gap) {
        const std::string text =
            rubber(d) + body("left", box("[-0.01, -0.005]", "[0.0, 0.005]"), "[-1, 0]") +
            body("right", box(fmt::format("[{}, -0.005]", gap), fmt::format("[{}, 0.005]", 0.01 + gap)), "[1, 0]");
        Simulation<2> s(scene_text::load(text));
        advance(s, 100);
        return range_of(s, 1)[0] - range_of(s, 0)[1] - s.time() * 2;
    };
    CHECK(apart_after(0) < 0);                                 // held together
    CHECK(apart_after(0.001) == Approx(0.002).epsilon(1e-9));  // flown apart, from two spacings between the layers
}

TEST_CASE("No particle feels a force at the start, however close bodies and walls are") {
    // A ring and a disc in it: their lattices leave gaps of between one and two spacings.
    const std::string text = rubber(d) + body("ring", ring(0, 0.02, 0.0105), "[0, 0]") +
                             body("disc", disc(0, 0, 0.01), "[0, 0]") + mirror_floor;
    Simulation<2> s(scene_text::load(text));
    advance(s, 10);
    CHECK(s.energy().contact < 1e-25);  // what rounding of F moves
    // What is left is rounding of reference positions, 1e-16 of a length over d, in a stress of ρ c².
    CHECK(s.energy().kinetic < 1e-20 * mass_of(s) * sound_speed * sound_speed);
}

TEST_CASE("A moving wall pushes a block") {
    const std::string text = rubber(d) + body("block", box("[-0.01, 0.0]", "[0.01, 0.01]"), "[0, 0]") + fixed_floor +
                             "motion = { displacement = [\"0\", \"0.5*t\"] }\n";
    Simulation<2> s(scene_text::load(text));
    const double mass = mass_of(s);
    while (s.time() < 0.02) s.step();
    // Twice the wall's speed if the block is rigid; what vibrates in it is missing.
    const double speed = s.momentum()[1] / mass;
    CHECK(speed > 0.5);
    CHECK(speed < 1.0001);
}

TEST_CASE("Contact is on where something can touch, and says why it is not elsewhere") {
    const std::string block = body("block", box("[0.0, 0.0]", "[0.01, 0.01]"), "[0, 0]"),
                      other = body("other", box("[0.02, 0.0]", "[0.03, 0.01]"), "[0, 0]"),
                      held = "clamp = " + box("[-0.001, -0.001]", "[0.011, 0.011]") + "\n";
    const auto choice = [](const std::string& content, const std::vector<std::string>& overrides = {}) {
        return Effects(scene_text::load(rubber(d) + content, overrides))[Effect::contact];
    };
    const std::string hypoelastic = "materials.rubber.model=hypoelastic";
    CHECK(choice(block + other).on);
    CHECK(choice(block + held + other).on);
    CHECK(choice(block + mirror_floor).on);
    CHECK(choice(block + fixed_floor).on);
    CHECK(choice(block).why == "one solid body and no wall");
    CHECK(choice(block + held + mirror_floor).why == "all solid bodies are clamped");
    CHECK(choice(block + other, {hypoelastic}).why == "no wall, and the solids are hypoelastic");
    CHECK_FALSE(choice(block + mirror_floor, {hypoelastic}).on);
    CHECK(choice(block + mirror_floor, {hypoelastic, "effects.contact=on"}).on);
    CHECK_FALSE(choice(block + mirror_floor, {"effects.contact=off"}).on);
}

TEST_CASE("A hypoelastic block meets walls on request") {
    const std::string text = rubber(d) + body("block", box("[-0.01, 0.002]", "[0.01, 0.012]"), "[0, -1.0]");
    const std::string floor = GENERATE(as<std::string>{}, mirror_floor, fixed_floor);
    const std::vector<std::string> model{"materials.rubber.model=hypoelastic", "effects.contact=on"};
    Simulation<2> s(scene_text::load(text + floor, model));
    const double start = s.energy().total();
    while (s.time() < 0.008) s.step();
    CHECK(contact_scenes::momentum_of(s, 0)[1] > 0.25 * mass_of(s));
    CHECK(lowest(s) > 0.5 * d);
    CHECK(s.energy().total() == Approx(start).epsilon(0.1));  // the model's own (test_solid_motion.cpp)
}

}  // namespace sluice::test_contact
