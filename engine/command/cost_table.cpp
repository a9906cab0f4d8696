#include "engine/command/cost_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/number_text.hpp"

namespace sluice {
namespace {

constexpr const char* layout = "{:<{}}  {:<3}  {:>8}  {:>16}  {:>16}  {:<24}  {}\n";

std::string percent(double part) { return fmt::format("{:.1f} %", 100 * part); }

bool stands_out(const EffectCost& e) { return !e.uncertainty || std::abs(e.change) > *e.uncertainty; }

std::string share_text(const EffectCost& e) {
    switch (e.basis) {
        case CostBasis::switched:
            if (!e.choice.on) return "";
            return !stands_out(e) ? "~ 0" : e.share < 0 ? "saves" : percent(e.share);
        case CostBasis::phases:
            return fmt::format("{}*", percent(e.share));
        case CostBasis::shared:
        case CostBasis::impossible:
        case CostBasis::failed:
            break;
    }
    return "";
}

std::string change_text(const EffectCost& e) {
    switch (e.basis) {
        case CostBasis::switched:
            if (!e.uncertainty) return fmt::format("{:+.1f} +- ? %", 100 * e.change);
            return fmt::format("{:+.1f} +- {:.1f} %", 100 * e.change, 100 * *e.uncertainty);
        case CostBasis::phases:
        case CostBasis::shared:
            return "cannot be left out";
        case CostBasis::impossible:
            return "cannot be on";
        case CostBasis::failed:
            break;
    }
    return "not measured";
}

/// `rate`: of the scene as it is
std::string rate_text(const EffectCost& e, double rate) {
    if (e.basis != CostBasis::switched) return "";
    const double uncertainty = (rate + e.rate_change) * e.uncertainty.value_or(0) / (1 + e.change);
    if (std::abs(e.rate_change) <= uncertainty) return "~ 0";
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

std::string effect_rows(const SceneCost& cost) {
    std::size_t name = 0;
    for (const EffectCost& e : cost.effects) name = std::max(name, e.choice.info.name.size());
    std::string text = fmt::format(layout, "effect", name, "", "share", "if switched", "particle-steps/s",
                                   "bytes per particle", "why");
    for (const EffectCost& e : cost.effects)
        text += fmt::format(layout, e.choice.info.name, name, e.choice.on ? "on" : "off", share_text(e), change_text(e),
                            rate_text(e, cost.rate), memory_of(e), reason(e));
    return text;
}

std::string phases_text(const SceneCost& cost) {
    std::string text;
    for (std::size_t k = 0; k < cost.phases.size(); ++k)
        if (cost.phases[k] >= 0.0005)  // less would show as 0.0 %
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", step_phase_names[k], percent(cost.phases[k]));
    return text;
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
    return fmt::format("{} effects switched, compared {} each", compared,
                       most == 1       ? "once"
                       : least == most ? fmt::format("{} times", least)
                                       : fmt::format("{} to {} times", least, most));
}

std::string run_text(const SceneCost& cost, double end) {
    const std::string one = duration_text(cost.cpu_per_second * end);
    if (cost.threads == 1) return fmt::format("about {} on one thread", one);
    if (cost.wall_per_second >= cost.cpu_per_second)
        return fmt::format("about {} on one thread; {} threads were slower just now", one, cost.threads);
    return fmt::format("about {} on {} threads, {} on one", duration_text(cost.wall_per_second * end), cost.threads,
                       one);
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
        "  the whole scene:    {}, without output, if it goes on as it starts\n",
        duration_text(cost.seconds), cost.steps, turns_text(cost), 1e3 * cost.cpu_per_step, cost.cpu_per_second,
        short_number(cost.rate), run_text(cost, end));
    if (cost.load > 1)
        text += fmt::format("  other programs ran: load average {:.1f}; a run takes longer while they do\n", cost.load);
    text += "  phases of a step:   " + phases_text(cost) + "\n\n" + effect_rows(cost);
    text +=
        "\nshare, if switched: of the CPU time per simulated second on one thread, with the 95 % interval;\n"
        "  * = of the step's phases that run for it, whatever else runs in them included;\n"
        "  ~ 0 = not to be told from nothing\n";
    return text;
}

}  // namespace sluice
