#include "engine/study/plan.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <map>
#include <numeric>

#include "engine/base/text_hash.hpp"
#include "engine/base/version.hpp"
#include "engine/study/matrix.hpp"
#include "neighbor/isa.hpp"

namespace sluice {
namespace {

std::string processor_name() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name")) return line.substr(std::min(line.find(':') + 2, line.size()));
    return "an unknown processor";
}

Machine this_machine() {
    Machine machine{processor_name(), static_cast<int>(::sysconf(_SC_NPROCESSORS_ONLN)),
                    std::string(name_of(active_isa())), 0};
    ::getloadavg(&machine.load, 1);
    return machine;
}

/// What all runs share. Frames would only measure the disk; probes are what errors come from.
std::vector<std::string> shared_settings(const StudyOptions& options) {
    std::vector<std::string> settings = options.settings;
    settings.emplace_back("output.frame_interval=0");
    return settings;
}

/// A study is read elsewhere, where the scene's folder means nothing.
std::string without_folder(const std::string& message, const std::string& scene) {
    if (!message.starts_with(scene)) return message;
    return std::filesystem::path(scene).filename().string() + message.substr(scene.size());
}

PlannedRun plan_run(const StudyOptions& options, const Study& study, StudyPoint& point) {
    PlannedRun run;
    run.overrides = study.settings;
    for (std::string& change : overrides_of(study.axes, point.values)) run.overrides.push_back(std::move(change));
    try {
        const Scene scene = load_scene(options.scene, run.overrides);
        point.spacing = scene.method.spacing;
        run.key = text_hash(scene.source + fmt::format("\n{} threads, {}", options.threads, program_version()));
    } catch (const SceneError& error) {
        run.refusal = without_folder(error.what(), options.scene);
    }
    return run;
}

/// The index of the method that these values belong to; new ones are added.
std::size_t method_index(Study& study, std::map<std::string, std::size_t>& known, const StudyPoint& point,
                         const Scene& scene) {
    std::string key;
    for (std::size_t k = 0; k < study.axes.size(); ++k)
        if (study.axes[k].key != spacing_key_name) key += study.axes[k].key + "=" + point.values[k] + "\n";
    const auto [place, is_new] = known.try_emplace(key, study.methods.size());
    if (is_new) study.methods.push_back(method_name(study.axes, point.values, scene));
    return place->second;
}

/// The spacing that a refused combination was to have, as its neighbours in the table have it.
double stated_spacing(const Study& study, const StudyPoint& point, const Scene& scene) {
    for (std::size_t k = 0; k < study.axes.size(); ++k)
        if (study.axes[k].key == spacing_key_name) return std::strtod(point.values[k].c_str(), nullptr);
    return scene.method.spacing;
}

void check_axes(const Study& study, const Scene& scene) {
    for (std::size_t a = 0; a < study.axes.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            if (study.axes[a].key == study.axes[b].key)
                throw SceneError(fmt::format("{}: --vary {}: found the key twice", scene.file, study.axes[a].key));
}

}  // namespace

Plan make_plan(const StudyOptions& options) {
    Plan plan;
    Study& study = plan.study;
    study.settings = shared_settings(options);
    plan.scene = load_scene(options.scene, study.settings);
    study.title = plan.scene.title;
    study.scene = std::filesystem::path(options.scene).filename().string();
    study.version = program_version();
    study.date = fmt::format("{:%Y-%m-%d}", fmt::localtime(std::time(nullptr)));
    study.machine = this_machine();
    study.dimension = plan.scene.dimension;
    study.threads = options.threads;
    study.repeats = options.repeats;
    for (const std::string& text : options.vary) study.axes.push_back(parse_axis(text, plan.scene));
    check_axes(study, plan.scene);
    study.fingerprint = fingerprint(plan.scene, study.axes);
    std::map<std::string, std::size_t> methods;
    for (auto& values : combinations(study.axes)) {
        StudyPoint point;
        point.values = std::move(values);
        plan.runs.push_back(plan_run(options, study, point));
        if (!plan.runs.back().refusal.empty()) point.spacing = stated_spacing(study, point, plan.scene);
        point.method = method_index(study, methods, point, plan.scene);
        study.points.push_back(std::move(point));
    }
    if (std::all_of(plan.runs.begin(), plan.runs.end(), [](const PlannedRun& r) { return !r.refusal.empty(); }))
        load_scene(options.scene, plan.runs.front().overrides);  // throws it in full
    return plan;
}

std::vector<std::size_t> run_order(const Study& study) {
    std::vector<std::size_t> order(study.points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return study.points[a].spacing > study.points[b].spacing; });
    return order;
}

}  // namespace sluice
