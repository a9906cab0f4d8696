#include <cmath>

#include "engine/scene/reader_parts.hpp"

namespace sluice {
namespace {

constexpr std::string_view moduli = "either youngs_modulus and poisson_ratio, or bulk_modulus and shear_modulus";

/// Two elastic constants fix an isotropic solid; both pairs in use lead to K and μ.
void read_moduli(TomlTable& table, Material& material) {
    const TomlValue youngs = table.get("youngs_modulus"), poisson = table.get("poisson_ratio");
    const TomlValue bulk = table.get("bulk_modulus"), shear = table.get("shear_modulus");
    if (!youngs && !poisson && !bulk && !shear) {
        table.finish();  // a slip in one of the four names explains more than their absence
        table.fail("found no elastic constants, expected " + std::string(moduli));
    }
    if ((youngs || poisson) && (bulk || shear)) {
        const TomlValue& extra = bulk ? bulk : shear;
        extra.fail("found it beside " + std::string(youngs ? "youngs_modulus" : "poisson_ratio") + ", expected " +
                   std::string(moduli));
    }
    double bulk_modulus = 0;
    if (youngs || poisson) {
        const double e = youngs.number(), nu = poisson.number();
        bulk_modulus = e / (3 * (1 - 2 * nu));
        material.shear_modulus = e / (2 * (1 + nu));
    } else {
        bulk_modulus = bulk.number();
        material.shear_modulus = shear.number();
    }
    material.sound_speed = std::sqrt(bulk_modulus / material.density);
}

Material read_material(TomlTable& table, const std::string& name) {
    check_name(table, name);
    Material material;
    material.name = name;
    material.kind = table.get("kind").word() == 0 ? MaterialKind::fluid : MaterialKind::solid;
    material.density = table.get("density").number();
    if (material.kind == MaterialKind::fluid) {
        material.sound_speed = table.get("sound_speed").number();
        if (const auto v = table.get("viscosity")) material.viscosity = v.number();
        if (const auto v = table.get("equation_of_state"))
            material.pressure_exponent = v.word() == 0 ? 1 : 7;  // water's exponent
    } else {
        material.model =
            table.scene().method.preset == Preset::paper ? SolidModel::hypoelastic : SolidModel::saint_venant_kirchhoff;
        if (const auto v = table.get("model")) material.model = static_cast<SolidModel>(v.word());
        read_moduli(table, material);
    }
    table.finish();
    return material;
}

}  // namespace

void read_materials(TomlTable& root) {
    TomlTable all(root.get("materials"));
    for (const std::string& name : all.keys()) {
        TomlTable table(all.get(name));
        root.scene().materials.push_back(read_material(table, name));
    }
}

}  // namespace sluice
