#include "engine/run/watch/state_check.hpp"

#include <fmt/format.h>

#include <cmath>

#include "engine/base/errors.hpp"

namespace sluice {
namespace {

/// Why a state is meaningless; empty if it is not. The comparisons are written such that NaN fails them.
///
/// Weak compressibility wants Mach numbers below 0.1 and densities within 1 %. What is ten times as fast crosses its
/// own smoothing length within a step (dt ≈ h/c0), and a torn body flies apart with finite numbers: without these
/// bounds such a run would end as a success.
template <int Dim>
std::string fault(const ParticleSet<Dim>& phase, std::size_t i, const Material& material, bool finite_only) {
    const double speed = norm(phase.velocity[i]), density = phase.density[i];
    if (!std::isfinite(norm2(phase.position[i]))) return "has no finite position";
    if (!std::isfinite(speed)) return "has no finite velocity";
    if (!std::isfinite(density)) return "has no finite density";
    if (finite_only) return "";
    if (!(speed <= material.sound_speed))
        return fmt::format("moves at {:.4g} m/s, faster than sound in {} ({:.4g} m/s)", speed, material.name,
                           material.sound_speed);
    if (!(density > material.density / 2 && density < material.density * 2))
        return fmt::format("has a density of {:.4g} kg/m³, far from the {:.4g} of {}", density, material.density,
                           material.name);
    return "";
}

/// The likely cause, the first that applies, and what to do about it.
template <int Dim>
std::string remedy(const Simulation<Dim>& simulation, const Body& body) {
    const Scene& scene = simulation.scene();
    const Material& material = scene.materials[body.material];
    for (const CourantLimit& limit : simulation.courant_limits())
        if (scene.method.courant > 1 || scene.method.time_step.value_or(0) * (1 - 1e-9) > limit.dt)
            return fmt::format(
                "the step is longer than {:.3g} s, what {} bears at a courant of {:.3g}: lower "
                "method.{}",
                limit.dt, limit.medium, scene.method.courant, scene.method.time_step ? "time_step" : "courant");
    if (material.kind == MaterialKind::solid) {
        const auto& solid = simulation.solid();
        const auto number = static_cast<std::size_t>(&body - scene.bodies.data());
        for (std::size_t i = 0; i < solid.owned && i < solid.hourglass_stiffness.size(); ++i)
            if (solid.body[i] == number && !solid.clamped[i] && solid.gradient_correction.c[0][i] == 0)
                return "the body is a single row of particles somewhere, which has no stiffness: two spacings at least";
        return "the step may be too long for how far the body is strained (lower method.courant), or the body too "
               "thin: "
               "four spacings and more are safe";
    }
    if (simulation.max_mach() > 0.3)
        return fmt::format(
            "the flow is too fast for its sound speed: raise materials.{}.sound_speed to {:.3g}, ten "
            "times the highest speed",
            material.name, 10 * simulation.max_speed());
    return "the step may be too long for an impact (lower method.courant), or a wall or solid too thin to hold the "
           "fluid";
}

template <int Dim>
void check_phase(const ParticleSet<Dim>& phase, const Simulation<Dim>& simulation, bool finite_only) {
    const Scene& scene = simulation.scene();
    for (std::size_t i = 0; i < phase.owned; ++i) {
        const Body& body = scene.bodies[phase.body[i]];
        const std::string what = fault(phase, i, scene.materials[body.material], finite_only);
        if (what.empty()) continue;
        throw NumericalError(
            fmt::format("the computation broke down: after step {} (t = {:.6g} s) particle {} of body "
                        "{}, at ({:.4g}), {}; {}",
                        simulation.work().steps, simulation.time(), phase.id[i], body.name,
                        fmt::join(phase.position[i].c, ", "), what, remedy<Dim>(simulation, body)));
    }
}

}  // namespace

template <int Dim>
void check_state(const Simulation<Dim>& simulation) {
    check_phase<Dim>(simulation.fluid(), simulation, false);
    check_phase<Dim>(simulation.solid(), simulation, false);
}

template <int Dim>
void check_finite(const Simulation<Dim>& simulation) {
    check_phase<Dim>(simulation.fluid(), simulation, true);
    check_phase<Dim>(simulation.solid(), simulation, true);
}

template void check_finite<2>(const Simulation<2>&);
template void check_finite<3>(const Simulation<3>&);

template void check_state<2>(const Simulation<2>&);
template void check_state<3>(const Simulation<3>&);

}  // namespace sluice
