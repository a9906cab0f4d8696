#include "engine/command/cost_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/output/progress.hpp"

namespace sluice {
namespace {

constexpr const char* layout = "{:<{}}  {:<3}  {:>8}  {:>16}  {:>16}  {:<24}  {}\n";

std::string percent(double part) { return fmt::format("{:.1f} %", 100 * part); }

/// Whether a difference stands out of the scatter: twice the standard error leaves one in twenty to chance.
bool stands_out(const EffectCost& e) { return !e.error || std::abs(e.change) > 2 * *e.error; }

std::string share_text(const EffectCost& e) {
    switch (e.basis) {
        case CostBasis::switched:
            if (!e.choice.on) return "";
            return !stands_out(e) ? "~ 0" : e.share < 0 ? "saves" : percent(e.share);
        case CostBasis::phases:
            return fmt::format("{}*", percent(e.share));
        default:
            return "";
    }
}

std::string change_text(const EffectCost& e) {
    switch (e.basis) {
        case CostBasis::switched:
            if (!e.error) return fmt::format("{:+.1f} %", 100 * e.change);
            return fmt::format("{:+.1f} +- {:.1f} %", 100 * e.change, 100 * *e.error);
        case CostBasis::phases:
        case CostBasis::shared:
            return "cannot be left out";
        case CostBasis::impossible:
            return "cannot be on";
        default:
            return "not measured";
    }
}

std::string rate_text(const EffectCost& e) {
    if (e.basis != CostBasis::switched) return "";
    if (!stands_out(e) && e.step_ratio == 1) return "~ 0";
    return fmt::format("{}{}", e.rate_change < 0 ? '-' : '+', short_number(std::abs(e.rate_change)));
}

std::string memory_of(const EffectCost& e) {
    std::string text;
    if (e.basis == CostBasis::impossible) return text;
    for (const FieldBytes& f : e.memory) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", f.phase, f.bytes);
    return text;
}

std::string reason(const EffectCost& e) {
    std::string text = e.choice.why;
    if (std::abs(e.step_ratio - 1) > 0.005)  // less would show as 1
        text += fmt::format("; switched, steps are {:.3g} times as long", e.step_ratio);
    if (!e.note.empty()) text += "; not measured: " + e.note;
    return text;
}

std::string effect_rows(const std::vector<EffectCost>& effects) {
    std::size_t name = 0;
    for (const EffectCost& e : effects) name = std::max(name, e.choice.info.name.size());
    std::string text = fmt::format(layout, "effect", name, "", "share", "if switched", "particle-steps/s",
                                   "bytes per particle", "why");
    for (const EffectCost& e : effects)
        text += fmt::format(layout, e.choice.info.name, name, e.choice.on ? "on" : "off", share_text(e), change_text(e),
                            rate_text(e), memory_of(e), reason(e));
    return text;
}

/// The parts of a step that run for no effect in particular.
std::string other_phases(const SceneCost& cost) {
    std::string text;
    double named = 0;
    for (std::size_t k = 0; k < cost.phases.size(); ++k) {
        named += cost.phases[k];
        if (cost.phases[k] < 0.0005) continue;  // would show as 0.0 %
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", step_phase_names[k], percent(cost.phases[k]));
    }
    return fmt::format("{}, between them {}", text, percent(std::max(1 - named, 0.0)));
}

std::string turns_text(const SceneCost& cost) {
    std::size_t least = 0, most = 0, compared = 0;
    for (const EffectCost& e : cost.effects) {
        if (e.basis != CostBasis::switched) continue;
        least = compared == 0 ? e.rounds : std::min(least, e.rounds);
        most = std::max(most, e.rounds);
        ++compared;
    }
    if (compared == 0) return "none of the effects can be switched";
    return fmt::format("{} effects switched, each compared {} times", compared,
                       least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most));
}

}  // namespace

std::string duration_text(double seconds) {
    if (seconds < 90) return fmt::format("{:.2g} s", seconds);
    if (seconds < 90 * 60) return fmt::format("{:.2g} min", seconds / 60);
    if (seconds < 36 * 3600) return fmt::format("{:.2g} h", seconds / 3600);
    return fmt::format("{:.3g} days", seconds / 86400);
}

std::string cost_text(const SceneCost& cost, double end) {
    std::string text = fmt::format(
        "cost, measured in {}: {} steps on one thread; {}\n"
        "  one thread:         {:.3g} ms CPU time per step, {:.3g} s per simulated second, {} particle-steps/s\n"
        "  the whole scene:    about {} on {} thread{}",
        duration_text(cost.seconds), cost.steps, turns_text(cost), 1e3 * cost.cpu_per_step, cost.cpu_per_second,
        short_number(cost.rate), duration_text(cost.wall_per_second * end), cost.threads, cost.threads > 1 ? "s" : "");
    if (cost.threads > 1) text += fmt::format(", {} on one", duration_text(cost.cpu_per_second * end));
    text += ", output not counted, if it goes on as it starts\n";
    if (cost.load > 1)
        text += fmt::format("  other programs ran:  load average {:.1f}; what is given for {} threads holds for that\n",
                            cost.load, cost.threads);
    text += "  phases of a step:   " + other_phases(cost) + "\n\n" + effect_rows(cost.effects);
    text +=
        "\nshare, if switched: of the CPU time per simulated second on one thread, with the standard error;\n"
        "  * = of the step's phases that run for it, whatever else runs in them included;\n"
        "  ~ 0 = within two standard errors\n";
    return text;
}

}  // namespace sluice
