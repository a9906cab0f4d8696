#include "engine/run/profile/run_profile.hpp"

#include <fmt/format.h>

#include "engine/files/atomic_file.hpp"
#include "engine/run/profile/profile_text.hpp"

namespace sluice {

template <int Dim>
std::string write_profile(const StepProfile& recorded, const Simulation<Dim>& simulation,
                          const std::filesystem::path& directory) {
    if (recorded.steps() == 0) return "\nno profile: no step was taken\n";
    const Effects& effects = simulation.effects();
    Profile profile = profile_of(recorded, effects);
    profile.particles = static_cast<double>(simulation.fluid().owned + simulation.solid().owned);
    profile.memory_bytes = static_cast<double>(simulation.memory_bytes());
    const TraceRecorder& trace = recorded.trace();
    write_atomically(directory / "profile.json", profile_json(profile, effects, trace));
    write_atomically(directory / "trace.json", trace_json(recorded, effects, "sluice: " + simulation.scene().title));
    return fmt::format(
        "\n{}\ntrace.json: {} of the steps{}; open it at ui.perfetto.dev, speedscope.app or chrome://tracing\n",
        profile_text(profile, effects), trace.steps().size(),
        trace.is_cut() ? fmt::format(", as many as fit into {} events per thread", TraceRecorder::most_events) : "");
}

template std::string write_profile<2>(const StepProfile&, const Simulation<2>&, const std::filesystem::path&);
template std::string write_profile<3>(const StepProfile&, const Simulation<3>&, const std::filesystem::path&);

}  // namespace sluice
