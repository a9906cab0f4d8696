#include "engine/scene/light_solid.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/scene/scene.hpp"

namespace sluice {
namespace {

/// ρ_f/ρ_s from which a solid is light. The floor of tests/hard makes energy at 1.25 to 1.4 and does not at 1.11.
constexpr double light_from = 1.15;
/// m_s = rows ρ_s d, of the thinnest plate that has a strain.
constexpr double rows = 2;
/// α = 0.4 ρ_f/ρ_s holds the waves of that floor, and 1 still does at ρ_f/ρ_s = 20; with 2 and more the solid's own
/// steps come near their limit.
constexpr double viscosity_per_lightness = 0.4, most_viscosity = 1;

/// The bodies' material of a kind that has the most, or the least, density; null if no body has one.
template <class Beats>
const Material* extreme(const Scene& scene, MaterialKind kind, Beats&& beats) {
    const Material* found = nullptr;
    for (const Body& body : scene.bodies) {
        const Material& material = scene.materials[body.material];
        if (material.kind == kind && (!found || beats(material.density, found->density))) found = &material;
    }
    return found;
}

/// Whether the solid, if it meets a fluid, takes steps of its own: the effect solid_substeps before effects are chosen.
bool has_own_rate(const Scene& scene) {
    switch (scene.switches[Effect::solid_substeps]) {
        case Switch::automatic:
            return scene.method.time_stepping == TimeStepping::multi_rate;
        case Switch::on:
            return true;
        case Switch::off:
            return false;
    }
    return {};
}

}  // namespace

LightSolid light_solid(const Scene& scene, const Material& solid) {
    const Material* fluid = extreme(scene, MaterialKind::fluid, std::greater<>());
    const double q = fluid ? fluid->density / solid.density : 0;
    if (scene.method.coupling != CouplingScheme::moving_boundary || q <= light_from) return {};
    return {1 / (1 + q), 1 / std::sqrt(1 + (q - light_from) / rows),
            std::min(viscosity_per_lightness * q, most_viscosity)};
}

LightSolid light_solid(const Scene& scene) {
    const Material* solid = extreme(scene, MaterialKind::solid, std::less<>());
    return solid ? light_solid(scene, *solid) : LightSolid{};
}

void damp_light_solid(Scene& scene) {
    if (!has_own_rate(scene) || scene.lines.contains("method.solid.artificial_viscosity")) return;
    const bool hypoelastic = std::any_of(scene.materials.begin(), scene.materials.end(), [](const Material& m) {
        return m.kind == MaterialKind::solid && m.model == SolidModel::hypoelastic;
    });
    double& alpha = scene.method.solid.artificial_viscosity;
    if (!hypoelastic) alpha = std::max(alpha, light_solid(scene).viscosity);
}

}  // namespace sluice
