#include "engine/run/profile/profile_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/number_text.hpp"
#include "neighbor/isa.hpp"

namespace sluice {
namespace {

using Kind = ProfileRow::Kind;

/// Shares below this would show as 0.0 %.
constexpr double least_listed = 0.0005;
constexpr const char* profile_layout = "{:<27}{:>9}{:>8}{:>8}{:>7}{:>7}{:>10}{:>10}{:>7}{:>7}  {}\n";

std::string percent_in_tenths(double part) { return fmt::format("{:.1f} %", 100 * part); }

std::string row_text(const Profile& p, const ProfileRow& row, const Effects& effects) {
    const double steps = static_cast<double>(p.steps);
    const std::string name = (row.kind == Kind::loop || !row.phase.empty() ? "  " : "") + row.name;
    const std::string balance = p.threads > 1 ? fmt::format("{:.2f}", row.imbalance()) : "";
    const std::string waiting = p.threads > 1 ? fmt::format("{:.0f} %", 100 * row.waiting()) : "";
    const std::string calls =
        row.kind == Kind::rest ? "" : fmt::format("{:.3g}", static_cast<double>(row.calls) / steps);
    std::string pairs, per_particle, rate, operations;
    if (row.kind == Kind::loop && row.work.particles > 0) {
        pairs = short_number(row.per_core(static_cast<double>(row.work.pairs)));
        per_particle = fmt::format("{:.0f}", row.bytes() / static_cast<double>(row.work.particles));
        rate = fmt::format("{:.2f}", 1e-9 * row.bytes() / row.seconds);
        operations = fmt::format("{:.1f}", 1e-9 * row.operations / row.seconds);
    }
    return fmt::format(profile_layout, name, fmt::format("{:.3f}", 1e3 * row.seconds / steps), percent_in_tenths(row.seconds / p.seconds),
                       calls, balance, waiting, pairs, per_particle, rate, operations, keys_text(row.effects, effects));
}

std::string effect_text(const Profile& p, const EffectTime& time, const Effects& effects) {
    const EffectInfo& info = effects[time.effect].info;
    if (time.where.empty()) return fmt::format("{:<24}{:>9}{:>9}  in the loops of others\n", info.key, "", "");
    const auto share = [&](double seconds) { return seconds > 0 ? percent_in_tenths(seconds / p.seconds) : std::string(); };
    std::vector<std::string> where = time.where;
    where.erase(std::unique(where.begin(), where.end()), where.end());
    const std::string with = time.with.empty() ? "" : fmt::format("; with {}", keys_text(time.with, effects));
    return fmt::format("{:<24}{:>9}{:>9}  {}{}\n", info.key, share(time.alone), share(time.shared),
                       fmt::join(where, ", "), with);
}

}  // namespace

std::string keys_text(const std::vector<Effect>& list, const Effects& effects) {
    std::string text;
    for (const Effect e : list) text += fmt::format("{}{}", text.empty() ? "" : " + ", effects[e].info.key);
    return text;
}

std::string profile_text(const Profile& p, const Effects& effects) {
    std::string text =
        fmt::format("profile of {} steps, {} threads, {}; {:.0f} particles, {:.0f} bytes each\n\n", p.steps, p.threads,
                    name_of(active_isa()), p.particles, p.memory_bytes / std::max(p.particles, 1.0));
    text += fmt::format(profile_layout, "phase, loops over pairs", "ms/step", "share", "calls/", "max/", "waits", "pairs/s",
                        "bytes/", "GB/s", "Gop/s", "effects");
    text += fmt::format(profile_layout, "", "", "", "step", "mean", "", "per core", "particle", "", "", "");
    for (const ProfileRow& row : p.rows)
        if (row.seconds > least_listed * p.seconds) text += row_text(p, row, effects);
    // More often than the system's own housekeeping does.
    if (static_cast<double>(p.interrupted) > 20 * p.seconds)
        text +=
            fmt::format("\nother programs took a processor away {} times: what they did counts as work or as waiting\n",
                        p.interrupted);
    text += fmt::format("\n{:<24}{:>9}{:>9}  {}\n", "effect", "alone", "shared", "where, with which others");
    for (const EffectTime& time : p.effects) text += effect_text(p, time, effects);
    text +=
        "\nshared: effects in one loop cannot be told apart by a clock; the loop's whole time counts for each of them\n"
        "(sluice check --cost measures what one costs by itself). `sluice help profiling` explains the columns.\n";
    return text;
}

}  // namespace sluice
