#include "engine/scene/light_solid.hpp"

#include <algorithm>
#include <cmath>

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

/// ρ_f/ρ_s of the bodies' materials; 0 if one of the two is missing.
double lightness(const Scene& scene) {
    double fluid = 0, solid = 0;
    for (const Body& body : scene.bodies) {
        const Material& material = scene.materials[body.material];
        (material.kind == MaterialKind::fluid ? fluid : solid) = material.density;
    }
    return solid > 0 ? fluid / solid : 0;
}

}  // namespace

LightSolid light_solid(const Scene& scene) {
    const double q = lightness(scene);
    if (scene.method.coupling != CouplingScheme::moving_boundary || q <= light_from) return {};
    return {1 / (1 + q), 1 / std::sqrt(1 + (q - light_from) / rows),
            std::min(viscosity_per_lightness * q, most_viscosity)};
}

void damp_light_solid(Scene& scene) {
    if (!scene.method.multi_rate || scene.lines.contains("method.solid.artificial_viscosity")) return;
    const bool hypoelastic = std::any_of(scene.materials.begin(), scene.materials.end(), [](const Material& m) {
        return m.kind == MaterialKind::solid && m.model == SolidModel::hypoelastic;
    });
    double& alpha = scene.method.solid.artificial_viscosity;
    if (!hypoelastic) alpha = std::max(alpha, light_solid(scene).viscosity);
}

}  // namespace sluice
