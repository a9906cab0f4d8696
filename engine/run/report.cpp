#include "engine/run/report.hpp"

#include <fmt/format.h>

#include <numeric>

#include "engine/base/number_text.hpp"
#include "engine/base/process_usage.hpp"
#include "engine/step/phase_timer.hpp"
#include "neighbor/isa.hpp"

namespace sluice {
namespace {

std::string row(std::string_view name, const std::string& value) { return fmt::format("{:<28}{}\n", name, value); }

/// Shares below this would show as 0.0 %: phases that the scene has no use for.
constexpr double least_share = 0.0005;

std::string phase_table(const std::vector<double>& seconds) {
    const double total = std::accumulate(seconds.begin(), seconds.end(), 0.0);
    std::string text = fmt::format("{:<28}{:>12}{:>9}\n", "phase", "seconds", "share");
    for (std::size_t k = 0; k < seconds.size(); ++k)
        if (seconds[k] > least_share * total)
            text +=
                fmt::format("{:<28}{:>12.3f}{:>7.1f} %\n", step_phase_names[k], seconds[k], 100 * seconds[k] / total);
    return text;
}

/// Where steps have waited for a slow disk, what they take is not what the run takes.
std::string disk_wait(const RunRecord& record) {
    if (!(record.disk_wait_seconds > 0.01 * record.wall_seconds)) return "";
    return fmt::format(", waiting for the disk {:.2f} s", record.disk_wait_seconds);
}

/// Weak compressibility: the density error goes with the square of the Mach number.
std::string mach_warning(double max_mach, const Method& method) {
    if (!(max_mach > method.mach_limit)) return "";
    return fmt::format(
        "warning: the flow reached Mach {:.3g}, above the limit of {:.3g}: density errors of {:.2g} %; "
        "raise the fluid's sound speed\n",
        max_mach, method.mach_limit, 100 * max_mach * max_mach);
}

/// What the watch saw, but for Mach numbers, which have their own line.
std::string warnings_text(const RunRecord& record) {
    std::string text;
    for (const Warning& w : record.warnings)
        if (w.name != "mach")
            text += fmt::format("warning: {}: at {} of {} looks, from t = {:.4g} s on, worst {:.3g} at {:.4g} s\n",
                                w.name, w.looks, record.looks, w.first_time, w.worst, w.worst_time);
    if (record.retry_count > 0)
        text +=
            fmt::format("warning: the run broke down {} times and went on with shorter steps\n", record.retry_count);
    return text;
}

}  // namespace

template <int Dim>
std::string report_text(const Simulation<Dim>& simulation, const RunRecord& record) {
    const WorkCount work = simulation.work();
    const double particle_steps = static_cast<double>(work.particle_steps);
    const double pairs = static_cast<double>(work.pairs);
    std::string text = phase_table(seconds_per_phase(simulation.timer(), record)) + "\n";
    text += row("status", std::string(name_of(record.state)));
    text += row("simulated time", fmt::format("{:.6g} of {:.6g} s", simulation.time(), record.end_time));
    const int substeps = simulation.solid_substeps();
    text += row("steps", fmt::format("{} of {:.4g} s{}", work.steps, simulation.time_step(),
                                     substeps > 1 ? fmt::format(", {} of the solid in each", substeps) : ""));
    text += row("neighbour builds", fmt::format("{}", work.neighbour_builds));
    text += row("particle-steps/s", short_number(record.rate(particle_steps)));
    text += row("pairs/s", short_number(record.rate(pairs)));
    text += row("wall time", fmt::format("{:.2f} s, of which set-up {:.2f} s{}", record.wall_seconds,
                                         record.setup_seconds, disk_wait(record)));
    text += row("CPU time", fmt::format("{:.2f} s, {} threads, {}, {} precision", record.cpu_seconds, record.threads,
                                        name_of(active_isa()), word_of(simulation.scene().method.precision)));
    text += row("peak memory", memory_text(static_cast<double>(peak_memory_bytes())));
    if (simulation.fluid().owned > 0)
        text += row("highest fluid speed",
                    fmt::format("{:.4g} m/s, Mach {:.3g}", simulation.max_speed(), simulation.max_mach()));
    return text + mach_warning(simulation.max_mach(), simulation.scene().method) + warnings_text(record);
}

template std::string report_text<2>(const Simulation<2>&, const RunRecord&);
template std::string report_text<3>(const Simulation<3>&, const RunRecord&);

}  // namespace sluice
