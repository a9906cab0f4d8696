#include <fmt/format.h>

#include <algorithm>

#include "engine/base/number_text.hpp"
#include "engine/run/profile/profile_text.hpp"
#include "engine/run/profile/scene_bench.hpp"

namespace sluice {
namespace {

using Kind = ProfileRow::Kind;

/// Rows below this part of a step are left out of the table; loops below the second, of the verdicts.
constexpr double least_share = 0.005, least_verdict = 0.03;

constexpr const char* layout = "{:<27}{:>10}{:>11}{:>8}{:>7}{:>9}{:>9}{:>10}{:>11}{:>9}{:>9}  {}\n";

std::string percent(double part) { return part > 0 ? fmt::format("{:.0f} %", 100 * part) : ""; }

std::string limit_row(const std::string& name, const Limit& limit, const char* unit, int threads,
                      const std::string& note) {
    const std::string all = threads > 1 ? fmt::format("{:>10.1f} {}", 1e-9 * limit.all_threads, unit) : "";
    return fmt::format("{:<30}{:>10.1f} {} {:>16}   {}\n", name, 1e-9 * limit.one_thread, unit, all, note);
}

std::string machine_text(const SceneBench& b) {
    const MachineLimits& m = b.machine;
    std::string text = fmt::format("{:<30}{:>16} {:>16}\n", "this machine", "one thread",
                                   m.threads > 1 ? fmt::format("{} threads", m.threads) : "");
    text += limit_row("arithmetic, single precision", m.single_precision, "Gop/s", m.threads,
                      fmt::format("{}; fused multiply-add = 2", name_of(m.isa)));
    text += limit_row("arithmetic, double precision", m.double_precision, "Gop/s", m.threads, "");
    for (const MemoryLevel& level : m.memory) {
        const std::string size = level.bytes == 0 ? "arrays far beyond the caches"
                                                  : fmt::format("{}{}", memory_text(static_cast<double>(level.bytes)),
                                                                level.shared ? " for all cores" : " per core");
        text += limit_row(fmt::format("triad, {}", level.name), level.bandwidth, "GB/s ", m.threads, size);
    }
    return text;
}

std::string rate_row(const char* name, double one, double all, int threads) {
    if (threads == 1) return fmt::format("{:<30}{:>16}\n", name, short_number(one));
    return fmt::format("{:<30}{:>16} {:>16}   {:.0f} % of the ideal gain\n", name, short_number(one), short_number(all),
                       100 * all / one / threads);
}

std::string speed_text(const SceneBench& b) {
    const int threads = b.machine.threads;
    return rate_row("steps/s", b.one.steps_per_second(), b.all.steps_per_second(), threads) +
           rate_row("particle updates/s", b.one.updates_per_second(), b.all.updates_per_second(), threads);
}

std::string row_text(const ProfileRow& row, const SceneBench& b, const Effects& effects) {
    const Profile& all = b.all.profile;
    const double per_step = 1e3 / static_cast<double>(all.steps);
    const double gain = efficiency(row, b);
    const double one = gain * all.threads * row.seconds * per_step;
    std::string pairs, intensity, alone, arithmetic, bandwidth;
    if (row.kind == Kind::loop && row.work.pairs > 0) {
        const Roof roof = roof_of(row, b, all.threads);
        const ProfileRow* of_one = find_row(b.one.profile, row);
        alone = of_one ? percent(roof_of(*of_one, b, 1).arithmetic) : "";
        pairs = short_number(row.per_core(static_cast<double>(row.work.pairs)));
        intensity = fmt::format("{:.1f}", roof.intensity);
        arithmetic = percent(roof.arithmetic);
        bandwidth = percent(roof.bandwidth);
    }
    const bool inner = row.kind == Kind::loop || !row.phase.empty();
    return fmt::format(layout, (inner ? "  " : "") + row.name, fmt::format("{:.3f}", one),
                       fmt::format("{:.3f}", row.seconds * per_step), percent(row.seconds / all.seconds), percent(gain),
                       pairs, intensity, alone, arithmetic, bandwidth, percent(row.waiting()),
                       keys_text(row.effects, effects));
}

std::string table_text(const SceneBench& b, const Effects& effects) {
    const Profile& all = b.all.profile;
    const std::string threads = all.threads > 1 ? fmt::format("{} threads", all.threads) : "again";
    std::string text = fmt::format(layout, "phase, loops over pairs", "1 thread", threads, "of a", "gain", "pairs/s",
                                   "op/byte", "of peak,", "of peak,", "of band-", "threads", "effects");
    text += fmt::format(layout, "", "[ms/step]", "[ms/step]", "step", "", "per core", "", "1 thread", threads, "width",
                        "wait", "");
    for (const ProfileRow& row : all.rows)
        if (row.seconds > least_share * all.seconds) text += row_text(row, b, effects);
    return text;
}

std::string home_text(const SceneBench& b) {
    const MemoryLevel& level = b.machine.level_of(b.field_bytes, b.machine.threads);
    const double moving = std::max(b.fluid + b.solid, 1.0);
    return fmt::format(
        "{:.0f} fluid, {:.0f} solid, {:.0f} wall particles; particles and lists take {}, {:.0f} bytes each: {}\n",
        b.fluid, b.solid, b.wall, memory_text(b.field_bytes), b.field_bytes / moving,
        level.bytes == 0 ? "more than the caches hold, so each loop reads them from memory"
                         : fmt::format("they stay in the caches ({}) from loop to loop", level.name));
}

std::string verdicts_text(const SceneBench& b) {
    const Profile& all = b.all.profile;
    std::vector<const ProfileRow*> loops;
    double in_loops = 0;
    for (const ProfileRow& row : all.rows) {
        if (row.kind != Kind::loop) continue;
        in_loops += row.seconds;
        if (row.seconds > least_verdict * all.seconds) loops.push_back(&row);
    }
    std::sort(loops.begin(), loops.end(), [](const auto* x, const auto* y) { return x->seconds > y->seconds; });
    std::string text;
    for (const ProfileRow* row : loops)
        text +=
            fmt::format("{} ({:.0f} % of a step): {}\n", row->name, 100 * row->seconds / all.seconds, verdict(*row, b));
    return text +
           fmt::format("loops over pairs: {:.0f} % of a step; the rest is update, search and what runs between them\n",
                       100 * in_loops / all.seconds);
}

std::string interruption_text(const SceneBench& b) {
    const std::uint64_t interrupted = b.one.interrupted + (b.machine.threads > 1 ? b.all.interrupted : 0);
    if (interrupted == 0) return "";
    return fmt::format("; other programs interrupted {} more, which are left out", interrupted);
}

}  // namespace

std::string bench_text(const SceneBench& b, const Scene& scene, const Effects& effects) {
    std::string text = fmt::format("{}: {}\n{}\n", scene.file, scene.title, home_text(b));
    text += machine_text(b) + "\n" + speed_text(b) + "\n" + table_text(b, effects) + "\n" + verdicts_text(b);
    if (b.load > 1)
        text += fmt::format("\nother programs ran: load average {:.1f}; threads wait longer while they do\n", b.load);
    return text +
           fmt::format(
               "\n{} steps on one thread, {} on all, from the scene's start to {:.3g} s{}\n"
               "Operations are counted by the loops themselves, on all pairs that they go over; bytes as if each "
               "were moved\nonce. `sluice help profiling` says more.\n",
               b.one.profile.steps, b.all.profile.steps, b.simulated, interruption_text(b));
}

}  // namespace sluice
