#include <cmath>

#include "engine/scene/read/reader_parts.hpp"

namespace sluice {
namespace {

constexpr std::string_view moduli = "either youngs_modulus and poisson_ratio, or bulk_modulus and shear_modulus";

/// γ of the equation of state.
double pressure_exponent(PressureLaw law) {
    switch (law) {
        case PressureLaw::linear:
            return 1;
        case PressureLaw::tait:
            return 7;  // water's
    }
    return {};
}

/// What a preset makes of solids.
SolidModel model_of(Preset preset) {
    switch (preset) {
        case Preset::paper:
            return SolidModel::hypoelastic;
        case Preset::modern:
            return SolidModel::saint_venant_kirchhoff;
    }
    return {};
}

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

void read_fluid(TomlTable& table, Material& material) {
    material.sound_speed = table.get("sound_speed").number();
    if (const auto v = table.get("viscosity")) material.viscosity = v.number();
    if (const auto v = table.get("equation_of_state"))
        material.pressure_exponent = pressure_exponent(v.choice<PressureLaw>());
}

void read_solid(TomlTable& table, Material& material) {
    material.model = model_of(table.scene().method.preset);
    if (const auto v = table.get("model")) material.model = v.choice<SolidModel>();
    read_moduli(table, material);
}

Material read_material(TomlTable& table, const std::string& name) {
    check_name(table, name);
    Material material;
    material.name = name;
    material.kind = table.get("kind").choice<MaterialKind>();
    material.density = table.get("density").number();
    switch (material.kind) {
        case MaterialKind::fluid:
            read_fluid(table, material);
            break;
        case MaterialKind::solid:
            read_solid(table, material);
            break;
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
