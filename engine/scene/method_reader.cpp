#include "engine/effects/names/effect_table.hpp"
#include "engine/scene/reader_parts.hpp"

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
    m.precision = "mixed";
    m.multi_rate = true;
    m.fluid = {.velocity_filter = 1,
               .density_diffusion = DensityDiffusion::fourtakas,
               .acoustic_damping = 0.3,
               .shifting = 2,  // 8 is better without a free surface; beside elastic walls it adds energy
               .artificial_viscosity = 0.02};
    // Without it the fluid's impulses resonate with waves through the body's thickness once their period is two steps.
    m.solid = {.velocity_filter = 1, .artificial_viscosity = 0.1};
    return m;
}

/// A word, of which the table of keys has one for each of an enumeration's values, in their order; `to` is kept if the
/// key is absent.
template <class Enum>
void read_choice(TomlTable& table, const std::string& key, Enum& to) {
    if (const auto v = table.get(key)) to = static_cast<Enum>(v.word());
}

void read_fluid(TomlTable& method, MediumMethod& fluid) {
    const TomlValue value = method.get("fluid");
    if (!value) return;
    TomlTable table(value);
    if (const auto v = table.get("velocity_filter")) fluid.velocity_filter = v.number();
    if (const auto v = table.get("artificial_viscosity")) fluid.artificial_viscosity = v.number();
    if (const auto v = table.get("viscous_form"))
        fluid.viscous_form = v.word() == 0 ? Viscosity::morris : Viscosity::monaghan_gingold;
    read_choice(table, "density_diffusion", fluid.density_diffusion);
    if (const auto v = table.get("acoustic_damping")) fluid.acoustic_damping = v.number();
    if (const auto v = table.get("particle_shifting")) fluid.shifting = v.number();
    if (const auto v = table.get("diffusion_coefficient")) fluid.diffusion_coefficient = v.number();
    table.finish();
}

void read_solid(TomlTable& method, MediumMethod& solid) {
    const TomlValue value = method.get("solid");
    if (!value) return;
    TomlTable table(value);
    if (const auto v = table.get("velocity_filter")) solid.velocity_filter = v.number();
    if (const auto v = table.get("artificial_viscosity")) solid.artificial_viscosity = v.number();
    if (const auto v = table.get("artificial_stress")) solid.artificial_stress = v.number();
    if (const auto v = table.get("artificial_stress_exponent")) solid.artificial_stress_exponent = v.whole();
    if (const auto v = table.get("hourglass_control")) solid.hourglass_control = v.number();
    table.finish();
}

void read_time(TomlTable& table, Method& method) {
    read_choice(table, "integrator", method.integrator);
    read_choice(table, "step_size", method.step_size);
    if (const auto v = table.get("courant")) method.courant = v.number();
    if (const auto v = table.get("time_step")) method.time_step = v.number();
    if (const auto v = table.get("time_stepping")) method.multi_rate = v.word() == 1;
}

}  // namespace

void read_method(TomlTable& root) {
    TomlTable table(root.get("method"));
    Method& method = root.scene().method;
    // A preset sets every choice; each can then be changed by itself.
    Preset preset = Preset::modern;
    read_choice(table, "preset", preset);
    method = preset == Preset::paper ? paper_method() : modern_method();
    method.spacing = table.get("spacing").number();
    read_choice(table, "smoothing_function", method.smoothing_function);
    if (const auto v = table.get("smoothing_length")) method.smoothing_length = v.number();
    read_choice(table, "coupling", method.coupling);
    if (const auto v = table.get("precision")) method.precision = v.word() == 0 ? "double" : "mixed";
    read_time(table, method);
    if (const auto v = table.get("mach_limit")) method.mach_limit = v.number();
    if (const auto v = table.get("expected_speed")) method.expected_speed = v.number();
    read_fluid(table, method.fluid);
    read_solid(table, method.solid);
    table.finish();
}

void read_effects(TomlTable& root) {
    const TomlValue value = root.get("effects");
    if (!value) return;
    TomlTable table(value);
    for (const EffectInfo& info : effect_table)
        if (const auto v = table.get(std::string(info.key)))
            root.scene().switches[info.effect] = static_cast<Switch>(v.word());
    table.finish();
}

}  // namespace sluice
