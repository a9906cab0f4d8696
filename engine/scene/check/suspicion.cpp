#include "engine/scene/check/suspicion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/scene/describe.hpp"

namespace sluice {
namespace {

double size_of(const Point& p) { return std::hypot(p[0], p[1], p[2]); }

bool has_earth_gravity(const Scene& scene) {
    constexpr double earth = 9.81, tolerance = 0.05;  // poles and equator differ by 0.5 %; "10" is common
    return std::abs(size_of(scene.gravity) - earth) < tolerance * earth;
}

/// Foams begin at 20 kg/m³; metals and liquids in g/cm³ end there.
void doubt_density(const Scene& scene, const Material& material, std::vector<std::string>& told) {
    constexpr double least = 20, gram_per_cubic_centimetre = 1000;
    if (material.density >= least) return;
    told.push_back(located(scene, "materials." + material.name + ".density",
                           fmt::format("found {} kg/m³, less than foam has; {} g/cm³ are {} kg/m³", material.density,
                                       material.density, gram_per_cubic_centimetre * material.density)));
}

/// Extent of the largest body of a material [m].
double largest_extent(const Scene& scene, std::size_t material) {
    double largest = 0;
    for (const Body& body : scene.bodies) {
        if (body.material != material) continue;
        const Bounds b = body.shape->bounds();
        for (int k = 0; k < scene.dimension; ++k)
            largest = std::max(largest, b.max[static_cast<std::size_t>(k)] - b.min[static_cast<std::size_t>(k)]);
    }
    return largest;
}

/// A solid whose weight alone compresses it by its own height.
void doubt_stiffness(const Scene& scene, std::size_t index, std::vector<std::string>& told) {
    const Material& material = scene.materials[index];
    const double bulk = material.bulk_modulus(), shear = material.shear_modulus;
    const double youngs = 9 * bulk * shear / (3 * bulk + shear);
    const double weight = material.density * size_of(scene.gravity) * largest_extent(scene, index);
    if (youngs > weight) return;
    const std::string table = "materials." + material.name;
    const bool by_youngs = scene.lines.contains(table + ".youngs_modulus");
    told.push_back(located(
        scene, table + (by_youngs ? ".youngs_modulus" : ".bulk_modulus"),
        fmt::format(
            "found a Young's modulus of {:.3g} Pa, too soft to bear its own weight of {:.3g} Pa; 1 MPa is 1e6 Pa",
            youngs, weight)));
}

/// Sums over fine neighbours on one side and coarse ones on the other do not cancel at rest: a tank of two spacings
/// moves with 6e-4 of its energy at 1:2, with 1e-2 at 1:4 (tests/hard).
void doubt_spacings(const Scene& scene, std::vector<std::string>& told) {
    constexpr double most = 2 * (1 + 1e-9);
    const Body* finest = nullptr;
    for (const Body& body : scene.bodies)
        if (scene.materials[body.material].kind == MaterialKind::fluid && (!finest || body.spacing < finest->spacing))
            finest = &body;
    for (const Body& body : scene.bodies) {
        if (scene.materials[body.material].kind != MaterialKind::fluid) continue;
        if (body.spacing <= most * finest->spacing) continue;
        told.push_back(located(scene, spacing_key(scene, "bodies." + body.name),
                               fmt::format("found {:.3g} times the spacing of bodies.{}; where fluid of so unlike "
                                           "spacings meets, it is not at rest, expected 2 times at the most",
                                           body.spacing / finest->spacing, finest->name)));
    }
}

/// A free lid of 0.05 of the water's density is quiet, one of 0.02 is thrown up (tests/hard).
void doubt_lightness(const Scene& scene, std::vector<std::string>& told) {
    constexpr double least = 0.05;
    if (scene.method.coupling != CouplingScheme::moving_boundary) return;
    const Material *fluid = nullptr, *solid = nullptr;
    for (const Body& body : scene.bodies) {
        const Material& material = scene.materials[body.material];
        (material.kind == MaterialKind::fluid ? fluid : solid) = &material;
    }
    if (!fluid || !solid || solid->density >= least * fluid->density) return;
    told.push_back(
        located(scene, "materials." + solid->name + ".density",
                fmt::format("found {} kg/m³, {:.2g} of {}'s {} kg/m³; solids that the fluid moves are stable "
                            "from {} of its density",
                            solid->density, solid->density / fluid->density, fluid->name, fluid->density, least)));
}

void doubt_output(const Scene& scene, std::vector<std::string>& told) {
    if (!scene.probes.empty() && !scene.lines.contains("output.probe_interval"))
        told.push_back(located(scene, "output.probe_interval", "found nothing, so that probes are not written"));
}

}  // namespace

std::vector<std::string> suspicious_values(const Scene& scene) {
    std::vector<std::string> told;
    for (std::size_t k = 0; k < scene.materials.size() && has_earth_gravity(scene); ++k) {
        doubt_density(scene, scene.materials[k], told);
        if (scene.materials[k].kind == MaterialKind::solid) doubt_stiffness(scene, k, told);
    }
    doubt_spacings(scene, told);
    doubt_lightness(scene, told);
    doubt_output(scene, told);
    return told;
}

}  // namespace sluice
