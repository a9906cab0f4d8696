#include "engine/run/watch/watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/errors.hpp"
#include "engine/run/watch/inside_walls.hpp"
#include "engine/run/watch/state_check.hpp"

namespace sluice {
namespace {

/// From the middle of a cube of eight particles to each of them. [spacings]
constexpr double any_place_in_wall = 0.87;
constexpr double density_over_mach2 = 10, nearest_fluid = 0.2, nearest_solid = 0.35, crowded_share = 0.01,
                 energy_margin = 0.05, energy_broken = 10;

template <int Dim>
std::string place_of(const ParticleSet<Dim>& phase, std::size_t i, const Scene& scene) {
    return fmt::format("particle {} of body {}, at ({:.4g})", phase.id[i], scene.bodies[phase.body[i]].name,
                       fmt::join(phase.position[i].c, ", "));
}

/// What moves, presses and strains: all but potential energy.
double lively(const EnergyBalance& e) { return e.total() - e.potential; }

/// How far all that can fall may still fall, to the lowest particle. [J; J/m in 2D]
template <int Dim>
double fall_of(const ParticleSet<Dim>& phase, const Scene& scene) {
    double g2 = 0;
    for (int k = 0; k < Dim; ++k)
        g2 += scene.gravity[static_cast<std::size_t>(k)] * scene.gravity[static_cast<std::size_t>(k)];
    if (g2 == 0 || phase.owned == 0) return 0;
    const auto height = [&](std::size_t i) {  // times g [m²/s²]
        double sum = 0;
        for (int k = 0; k < Dim; ++k) sum -= scene.gravity[static_cast<std::size_t>(k)] * phase.position[i][k];
        return sum;
    };
    double lowest = height(0), sum = 0, mass = 0;
    for (std::size_t i = 0; i < phase.owned; ++i) {
        lowest = std::min(lowest, height(i));
        sum += phase.mass[i] * height(i);
        mass += phase.mass[i];
    }
    return sum - mass * lowest;
}

/// Of a strain of 1e-5 everywhere, ½ m (1e-5 c0)²: what rounding makes of a state at rest, 1e8 m from the origin too,
/// is no growth. [J; J/m in 2D]
template <int Dim>
double sound_energy(const ParticleSet<Dim>& phase, const Scene& scene) {
    double sum = 0;
    for (std::size_t i = 0; i < phase.owned; ++i) {
        const double speed = 1e-5 * scene.materials[scene.bodies[phase.body[i]].material].sound_speed;
        sum += 0.5 * phase.mass[i] * speed * speed;
    }
    return sum;
}

bool is_closed(const Scene& scene) {
    return scene.acceleration == std::array<Formula, 3>{} &&
           std::none_of(scene.walls.begin(), scene.walls.end(), [](const Wall& w) { return w.motion.moves(); });
}

}  // namespace

template <int Dim>
Watch<Dim>::Watch(const Simulation<Dim>& initial)
    : forgiving_(initial.scene().watch == WatchPolicy::warn), energy_is_closed_(is_closed(initial.scene())) {
    for (std::size_t k = 0; k < warnings_.size(); ++k) warnings_[k].name = suspicion_names[k];
    const EnergyBalance e = initial.energy();
    start_energy_ = e.total();
    for (const ParticleSet<Dim>* phase :
         {static_cast<const ParticleSet<Dim>*>(&initial.fluid()), static_cast<const ParticleSet<Dim>*>(&initial.solid())})
        available_ += fall_of(*phase, initial.scene()) + sound_energy(*phase, initial.scene());
    available_ += lively(e);
}

template <int Dim>
void Watch<Dim>::check(const Simulation<Dim>& simulation) const {
    if (forgiving_)
        check_finite(simulation);
    else
        check_state(simulation);
}

template <int Dim>
std::vector<Warning> Watch<Dim>::warnings() const {
    std::vector<Warning> seen;
    std::copy_if(warnings_.begin(), warnings_.end(), std::back_inserter(seen),
                 [](const Warning& w) { return w.looks > 0; });
    return seen;
}

template <int Dim>
void Watch<Dim>::look(const Simulation<Dim>& simulation) {
    ++looks_;
    check(simulation);
    if (forgiving_) forgive(simulation);
    if (simulation.fluid().owned > 0) {
        look_at_speed(simulation);
        look_at_density(simulation);
        look_at_crowds(simulation);
        look_at_walls(simulation);
        look_at_solids(simulation);
    }
    if (energy_is_closed_) look_at_energy(simulation);
}

template <int Dim>
void Watch<Dim>::suspect(Suspicion what, double value, bool worse, double time, const std::string& message) {
    Warning& w = warnings_[static_cast<std::size_t>(what)];
    if (w.looks == 0) {
        w.first_time = time;
        w.message = message;
        news_.push_back(message);
    }
    if (w.looks == 0 || worse) w.worst = value, w.worst_time = time;
    ++w.looks;
}

/// What would have broken the run.
template <int Dim>
void Watch<Dim>::forgive(const Simulation<Dim>& simulation) {
    try {
        check_state(simulation);
    } catch (const NumericalError& failure) {
        suspect(Suspicion::breakdown, 1, false, simulation.time(), failure.what());
    }
}

template <int Dim>
void Watch<Dim>::look_at_speed(const Simulation<Dim>& simulation) {
    const auto& fluid = simulation.fluid();
    const Scene& scene = simulation.scene();
    std::size_t fastest = 0;
    for (std::size_t i = 1; i < fluid.owned; ++i)
        if (norm2(fluid.velocity[i]) > norm2(fluid.velocity[fastest])) fastest = i;
    const double speed = norm(fluid.velocity[fastest]), limit = scene.method.mach_limit;
    const Material& material = scene.materials[scene.bodies[fluid.body[fastest]].material];
    const double mach = speed / material.sound_speed;
    if (!(mach > limit)) return;
    const double worst = warnings_[static_cast<std::size_t>(Suspicion::mach)].worst;
    suspect(Suspicion::mach, mach, mach > worst, simulation.time(),
            fmt::format("{} moves at {:.3g} m/s: Mach {:.2g} > {:.2g}, so that densities are off by {:.1g} %; if that "
                        "matters, raise materials.{}.sound_speed to {:.3g}",
                        place_of<Dim>(fluid, fastest, scene), speed, mach, limit, 100 * mach * mach, material.name,
                        speed / limit));
}

template <int Dim>
void Watch<Dim>::look_at_density(const Simulation<Dim>& simulation) {
    const auto& fluid = simulation.fluid();
    const Scene& scene = simulation.scene();
    const auto change = [&](std::size_t i) {
        return fluid.density[i] / scene.materials[scene.bodies[fluid.body[i]].material].density - 1;
    };
    std::size_t farthest = 0;
    for (std::size_t i = 1; i < fluid.owned; ++i)
        if (std::abs(change(i)) > std::abs(change(farthest))) farthest = i;
    const double found = change(farthest),
                 limit = density_over_mach2 * scene.method.mach_limit * scene.method.mach_limit;
    if (!(std::abs(found) > limit)) return;
    const double worst = warnings_[static_cast<std::size_t>(Suspicion::density)].worst;
    suspect(
        Suspicion::density, found, std::abs(found) > std::abs(worst), simulation.time(),
        fmt::format("{} is {:.2g} % {} than at rest; an impact, or water without room: raise sound_speed, or look "
                    "whether bodies or walls press it together",
                    place_of<Dim>(fluid, farthest, scene), 100 * std::abs(found), found > 0 ? "denser" : "less dense"));
}

template <int Dim>
void Watch<Dim>::look_at_crowds(const Simulation<Dim>& simulation) {
    const ClosestPair closest = simulation.closest_pair(Neighbor::fluid, nearest_fluid);
    const double share = static_cast<double>(closest.count) / static_cast<double>(simulation.fluid().owned);
    if (!(share >= crowded_share)) return;
    const double worst = warnings_[static_cast<std::size_t>(Suspicion::crowding)].worst;
    suspect(Suspicion::crowding, closest.spacings, closest.spacings < worst, simulation.time(),
            fmt::format("{:.2g} % of the fluid's particles pair, {} most, {:.2g} spacings from its neighbour; "
                        "particle_shifting, a Wendland smoothing function or a smaller courant keep them apart",
                        100 * share, place_of<Dim>(simulation.fluid(), closest.particle, simulation.scene()),
                        closest.spacings));
}

template <int Dim>
void Watch<Dim>::look_at_walls(const Simulation<Dim>& simulation) {
    const InsideWalls<Dim> inside(simulation);
    const auto gone_through = [&](Index i) { return inside(simulation.fluid().position[i]); };
    const ClosestPair closest = simulation.closest_pair(Neighbor::wall, any_place_in_wall, gone_through);
    if (closest.count == 0) return;
    const double worst = warnings_[static_cast<std::size_t>(Suspicion::entry)].worst;
    suspect(
        Suspicion::entry, closest.spacings, closest.spacings < worst, simulation.time(),
        fmt::format("{} is inside a wall, behind its first layer: it goes through; a wall thinner than two spacings, "
                    "one whose first layer is less than a third of a spacing behind its face, or a courant or "
                    "sound_speed too small for the impact",
                    place_of<Dim>(simulation.fluid(), closest.particle, simulation.scene())));
}

template <int Dim>
void Watch<Dim>::look_at_solids(const Simulation<Dim>& simulation) {
    const ClosestPair closest = simulation.closest_pair(Neighbor::solid, nearest_solid);
    if (closest.count == 0) return;
    const double worst = warnings_[static_cast<std::size_t>(Suspicion::entry)].worst;
    suspect(
        Suspicion::entry, closest.spacings, closest.spacings < worst, simulation.time(),
        fmt::format("{} is {:.2g} spacings from a solid's: it goes through; a solid thinner than two spacings, or a "
                    "courant or sound_speed too small for the impact",
                    place_of<Dim>(simulation.fluid(), closest.particle, simulation.scene()), closest.spacings));
}

template <int Dim>
void Watch<Dim>::look_at_energy(const Simulation<Dim>& simulation) {
    const EnergyBalance e = simulation.energy();
    if (!(available_ > 0)) return;
    const double gained = (e.total() - start_energy_) / available_;
    if (!(gained > energy_margin)) return;
    const std::string message = fmt::format(
        "energy has grown by {:.3g} % of all that there was, without work from outside; the step is too "
        "long (lower courant), or a solid is under two spacings thick",
        100 * gained);
    if (gained > energy_broken && !forgiving_)
        throw NumericalError(fmt::format("the computation broke down: after step {} (t = {:.6g} s) {}",
                                         simulation.work().steps, simulation.time(), message));
    const double worst = warnings_[static_cast<std::size_t>(Suspicion::energy)].worst;
    suspect(Suspicion::energy, gained, gained > worst, simulation.time(), message);
}

template <int Dim>
std::vector<std::string> Watch<Dim>::take_news() {
    return std::exchange(news_, {});
}

template class Watch<2>;
template class Watch<3>;

}  // namespace sluice
