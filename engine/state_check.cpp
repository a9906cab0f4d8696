#include "engine/state_check.hpp"

#include <fmt/format.h>

#include <cmath>

#include "engine/errors.hpp"

namespace sluice {
namespace {

/// Why a state is meaningless; empty if it is not. The comparisons are written such that NaN fails them.
///
/// Weak compressibility wants Mach numbers below 0.1 and densities within 1 %. What is ten times as fast crosses its
/// own smoothing length within a step (dt ≈ h/c0), and a torn body flies apart with finite numbers: without these
/// bounds such a run would end as a success.
template <int Dim>
std::string fault(const PhaseBase<Dim>& phase, std::size_t i, const Material& material) {
    const double speed = norm(phase.velocity[i]), density = phase.density[i];
    if (!std::isfinite(norm2(phase.position[i]))) return "has no finite position";
    if (!std::isfinite(speed)) return "has no finite velocity";
    if (!(speed <= material.sound_speed))
        return fmt::format("moves at {:.4g} m/s, faster than sound in {} ({:.4g} m/s)", speed, material.name,
                           material.sound_speed);
    if (!(density > material.density / 2 && density < material.density * 2))
        return fmt::format("has a density of {:.4g} kg/m³, far from the {:.4g} of {}", density, material.density,
                           material.name);
    return "";
}

template <int Dim>
void check_phase(const PhaseBase<Dim>& phase, const Simulation<Dim>& simulation) {
    const Scene& scene = simulation.scene();
    for (std::size_t i = 0; i < phase.owned; ++i) {
        const Body& body = scene.bodies[phase.body[i]];
        const std::string what = fault(phase, i, scene.materials[body.material]);
        if (what.empty()) continue;
        throw NumericalError(
            fmt::format("the computation broke down: after step {} (t = {:.6g} s) particle {} of body "
                        "{}, at ({:.4g}), {}; a smaller time step or spacing, or another sound speed "
                        "may help",
                        simulation.work().steps, simulation.time(), phase.id[i], body.name,
                        fmt::join(phase.position[i].c, ", "), what));
    }
}

}  // namespace

template <int Dim>
void check_state(const Simulation<Dim>& simulation) {
    check_phase<Dim>(simulation.fluid(), simulation);
    check_phase<Dim>(simulation.solid(), simulation);
}

template void check_state<2>(const Simulation<2>&);
template void check_state<3>(const Simulation<3>&);

}  // namespace sluice
