#include "engine/scene/rules/effect_help.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/scene/rules/effect_fields.hpp"

namespace sluice {
namespace {

std::string bytes_text(std::size_t plane, std::size_t space) {
    return plane == space ? fmt::format("{}", plane) : fmt::format("{}/{}", plane, space);
}

/// "fluid 16/24, wall 8": bytes per particle of each phase, in 2D/3D where they differ.
std::string phases_text(const EffectInfo& effect) {
    const auto plane = field_bytes<2>(effect), space = field_bytes<3>(effect);
    std::string text;
    for (std::size_t k = 0; k < plane.size(); ++k)
        text += fmt::format("{}{} {}", k == 0 ? "" : ", ", plane[k].phase, bytes_text(plane[k].bytes, space[k].bytes));
    return text.empty() ? "none" : text;
}

/// A line for each phase: "fluid: density 8, velocity 16/24". Empty if no field is needed.
std::vector<std::string> column_lines(const EffectInfo& effect) {
    const auto plane = column_bytes_of<2>(effect), space = column_bytes_of<3>(effect);
    std::vector<std::string> lines;
    for (std::size_t k = 0; k < plane.size(); ++k) {
        const bool new_phase = k == 0 || plane[k].phase != plane[k - 1].phase;
        if (new_phase) lines.push_back(fmt::format("{}: ", plane[k].phase));
        lines.back() +=
            fmt::format("{}{} {}", new_phase ? "" : ", ", plane[k].column, bytes_text(plane[k].bytes, space[k].bytes));
    }
    return lines;
}

std::string row(std::string_view name, std::string_view value) { return fmt::format("  {:<10}{}\n", name, value); }

}  // namespace

std::string effect_list() {
    std::size_t key = 0, name = 0;
    for (const EffectInfo& effect : effect_table) {
        key = std::max(key, effect.key.size());
        name = std::max(name, effect.name.size());
    }
    std::string text = fmt::format("{:<{}}  {:<{}}  {}\n", "key", key, "effect", name, "\"auto\"");
    for (const EffectInfo& effect : effect_table)
        text += fmt::format("{:<{}}  {:<{}}  {}\n", effect.key, key, effect.name, name, effect.automatic);
    return text +
           "\nA scene says `KEY = \"auto\"`, \"on\" or \"off\" under [effects]; `sluice help effects KEY` shows "
           "formula,\n"
           "source and memory, `sluice check SCENE` what a scene has on and why, with --cost what each one costs.\n";
}

std::string effect_page(const EffectInfo& effect) {
    std::string text = fmt::format("{}\n", effect.key) + row("effect", effect.name) + row("auto", effect.automatic) +
                       row("formula", effect.formula) + row("source", effect.equation);
    text += row("memory", phases_text(effect) + (effect.columns.none() ? "" : " bytes per particle (2D/3D)"));
    for (const std::string& line : column_lines(effect)) text += row("", line);
    return text;
}

std::string effects_document() {
    std::string text =
        "# Effects\n\n"
        "Printed by `sluice help effects --markdown` from the table of effects (`engine/scene/effects/effects.def`); a "
        "test "
        "checks\n"
        "that it is up to date.\n\n"
        "`sluice check SCENE` says which of them a scene has on, and why. `[effects] KEY = \"on\"` or `\"off\"` takes "
        "the\n"
        "place of the rule where that can be. Memory is in bytes per particle of the phase, in 2D/3D.\n\n"
        "| key | effect | `\"auto\"` | memory |\n| --- | --- | --- | --- |\n";
    for (const EffectInfo& effect : effect_table)
        text +=
            fmt::format("| `{}` | {} | {} | {} |\n", effect.key, effect.name, effect.automatic, phases_text(effect));
    text += "\n## Formulas, sources, fields\n\nSymbols are those of the headers in `kernels/terms/`.\n";
    for (const EffectInfo& effect : effect_table) {
        text += fmt::format("\n**`{}`** ({})\n\n    {}\n", effect.key, effect.equation, effect.formula);
        const std::vector<std::string> lines = column_lines(effect);
        if (!lines.empty()) text += fmt::format("\nFields: {}.\n", fmt::join(lines, "; "));
    }
    return text;
}

}  // namespace sluice
