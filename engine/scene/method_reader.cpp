#include "engine/scene/reader_parts.hpp"

namespace sluice {
namespace {

constexpr NumberRule filter_rule{"a number in (0, 1]", [](double v) { return v > 0 && v <= 1; }};

// Antoci, Gallati & Sibilla 2007: eq. (16) in place of viscosity in the fluid; eqs. (11, 12, 14) in the solid.
constexpr MediumMethod paper_fluid{.velocity_filter = 0.92, .artificial_viscosity = 0};
constexpr MediumMethod paper_solid{
    .velocity_filter = 1, .artificial_viscosity = 1.0, .artificial_stress = 0.3, .artificial_stress_exponent = 4};

void read_fluid(TomlTable& method, MediumMethod& fluid) {
    const TomlValue value = method.get("fluid");
    if (!value) return;
    TomlTable table(value);
    if (const auto v = table.get("velocity_filter")) fluid.velocity_filter = v.number(filter_rule);
    if (const auto v = table.get("artificial_viscosity")) fluid.artificial_viscosity = v.number(not_negative);
    table.finish();
}

void read_solid(TomlTable& method, MediumMethod& solid) {
    const TomlValue value = method.get("solid");
    if (!value) return;
    TomlTable table(value);
    if (const auto v = table.get("velocity_filter")) solid.velocity_filter = v.number(filter_rule);
    if (const auto v = table.get("artificial_viscosity")) solid.artificial_viscosity = v.number(not_negative);
    if (const auto v = table.get("artificial_stress")) solid.artificial_stress = v.number(not_negative);
    if (const auto v = table.get("artificial_stress_exponent")) solid.artificial_stress_exponent = v.integer({1, 8});
    table.finish();
}

}  // namespace

void read_method(TomlTable& root) {
    TomlTable table(root.get("method"));
    Method& method = root.scene().method;
    // The one preset there is; its constants can be changed one by one.
    if (const auto v = table.get("preset")) v.choice({"paper"});
    method.fluid = paper_fluid;
    method.solid = paper_solid;
    method.spacing = table.get("spacing").number(positive);
    if (const auto v = table.get("smoothing_length"))
        method.smoothing_length = v.number({"a number in [1, 3]", [](double s) { return s >= 1 && s <= 3; }});
    if (const auto v = table.get("courant"))
        method.courant = v.number({"a number in (0, 2]", [](double c) { return c > 0 && c <= 2; }});
    if (const auto v = table.get("time_step")) method.time_step = v.number(positive);
    const std::vector<std::string> precisions{"double", "mixed"};
    if (const auto v = table.get("precision")) method.precision = precisions[v.choice(precisions)];
    if (const auto v = table.get("time_stepping")) method.multi_rate = v.choice({"single-rate", "multi-rate"}) == 1;
    if (const auto v = table.get("mach_limit")) method.mach_limit = v.number(positive);
    if (const auto v = table.get("expected_speed")) method.expected_speed = v.number(positive);
    read_fluid(table, method.fluid);
    read_solid(table, method.solid);
    table.finish();
}

}  // namespace sluice
