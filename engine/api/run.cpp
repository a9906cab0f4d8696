#include "engine/api/include/sluice/run.hpp"

#include <algorithm>
#include <filesystem>

#include "engine/base/errors.hpp"
#include "engine/base/version.hpp"
#include "engine/run/resume.hpp"
#include "engine/run/run.hpp"
#include "neighbor/isa.hpp"

namespace sluice::api {
namespace {

RunEnd end_of(RunState state) {
    switch (state) {
        case RunState::failed:
            return RunEnd::failed;
        case RunState::interrupted:
            return RunEnd::interrupted;
        case RunState::running:
        case RunState::done:
            break;
    }
    return RunEnd::done;
}

RunResult run_in(const sluice::Scene& scene, const sluice::RunOptions& options) {
    const RunStatus status = sluice::run(scene, options);
    return {end_of(status.state), status.message, status.report};
}

std::FILE* stream_of(Progress progress) { return progress == Progress::shown ? stderr : nullptr; }

/// The same bits need the same instructions, if this processor has them.
void use_isa_of(const CheckpointLabel& label) {
    for (const Isa isa : available_isas())
        if (name_of(isa) == label.instruction_set) use_isa(label.instruction_set);
}

}  // namespace

RunResult run(const Scene& scene, const std::string& directory, const RunOptions& options) {
    return run_in(scene.checked(), {directory, options.threads, options.until, {}, stream_of(options.progress)});
}

RunResult resume(const std::string& directory, const RunOptions& options) {
    const ResumePoint point = find_resume_point(directory);
    const std::string file = (std::filesystem::path(directory) / "scene.toml").string();
    sluice::Scene scene = load_scene(file);
    const std::string changes = scene_changes(point, scene);
    if (!changes.empty())
        throw CheckpointError(file + ": the scene is not that of " + point.checkpoint.string() + ":\n" + changes);
    scene.file = point.label.scene_file;  // as the run was given it
    use_isa_of(point.label);
    const double until = options.until.value_or(point.label.end_time);
    return run_in(scene, {directory, options.threads, until, point.checkpoint, stream_of(options.progress)});
}

std::string version() { return std::string(program_version()); }

}  // namespace sluice::api
