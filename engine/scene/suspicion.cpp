#include "engine/scene/suspicion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/scene/place.hpp"

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
    doubt_output(scene, told);
    return told;
}

}  // namespace sluice
