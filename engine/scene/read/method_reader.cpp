#include <optional>
#include <type_traits>

#include "engine/scene/effects/effect_table.hpp"
#include "engine/scene/method_keys.hpp"
#include "engine/scene/read/reader_parts.hpp"

namespace sluice {
namespace {

/// The paper to the letter [Antoci2007]: eq. (16) in place of viscosity in the fluid; eqs. (11, 12, 14) in the solid.
Method paper_method() {
    Method m;
    m.preset = Preset::paper;
    m.fluid = {.velocity_filter = 0.92, .artificial_viscosity = 0};
    m.solid = {
        .velocity_filter = 1, .artificial_viscosity = 1.0, .artificial_stress = 0.3, .artificial_stress_exponent = 4};
    return m;
}

/// The best that we know (README: presets).
Method modern_method() {
    Method m;
    m.preset = Preset::modern;
    m.smoothing_function = SmoothingFunction::wendland_c2;
    m.integrator = Integrator::kick_drift_kick;
    m.step_size = StepSize::adaptive;
    m.courant = 0.75;  // with the acoustic damping: 0.5 and 0.9 together are unstable in thin films
    m.coupling = CouplingScheme::moving_boundary;
    m.precision = Precision::mixed;
    m.time_stepping = TimeStepping::multi_rate;
    m.fluid = {.velocity_filter = 1,
               .density_diffusion = DensityDiffusion::fourtakas,
               .acoustic_damping = 0.3,
               .shifting = 2,  // 8 is better without a free surface; beside elastic walls it adds energy
               .artificial_viscosity = 0.02};
    // Without it the fluid's impulses resonate with waves through the body's thickness once their period is two steps.
    m.solid = {.velocity_filter = 1, .artificial_viscosity = 0.1};
    return m;
}

Method method_of(Preset preset) {
    switch (preset) {
        case Preset::paper:
            return paper_method();
        case Preset::modern:
            return modern_method();
    }
    return {};
}

void assign(const TomlValue& value, double& to) { to = value.number(); }
void assign(const TomlValue& value, int& to) { to = value.whole(); }
void assign(const TomlValue& value, std::optional<double>& to) { to = value.number(); }
template <class Enum>
requires std::is_enum_v<Enum>
void assign(const TomlValue& value, Enum& to) { to = value.choice<Enum>(); }

/// For keys of this table: what is absent stays as it is, unless it is required.
auto reader_of(TomlTable& table) {
    return [&table](const char* key, auto& to) {
        const TomlValue value = table.get(key);
        if (value || value.key().otherwise.kind == Otherwise::Kind::required) assign(value, to);
    };
}

}  // namespace

void read_method(TomlTable& root) {
    TomlTable table(root.get("method"));
    // A preset sets every choice; each can then be changed by itself.
    const TomlValue preset = table.get("preset");
    Method& method = root.scene().method;
    method = method_of(preset ? preset.choice<Preset>() : Preset::modern);
    for_each_method_key(method, reader_of(table));
    if (const TomlValue fluid = table.get("fluid")) {
        TomlTable keys(fluid);
        for_each_fluid_key(method.fluid, reader_of(keys));
        keys.finish();
    }
    if (const TomlValue solid = table.get("solid")) {
        TomlTable keys(solid);
        for_each_solid_key(method.solid, reader_of(keys));
        keys.finish();
    }
    table.finish();
}

void read_effects(TomlTable& root) {
    const TomlValue value = root.get("effects");
    if (!value) return;
    TomlTable table(value);
    for (const EffectInfo& info : effect_table)
        if (const auto v = table.get(std::string(info.key))) root.scene().switches[info.effect] = v.choice<Switch>();
    table.finish();
}

}  // namespace sluice
