#include "engine/run/summary.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/base/process_usage.hpp"
#include "engine/base/text_hash.hpp"
#include "engine/base/version.hpp"
#include "engine/scene/rules/effects.hpp"
#include "engine/step/phase_timer.hpp"
#include "neighbor/isa.hpp"

namespace sluice {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const EnergyBalance& e) {
    return {{"kinetic", e.kinetic}, {"potential", e.potential}, {"compression", e.compression},
            {"elastic", e.elastic}, {"contact", e.contact},     {"total", e.total()}};
}

template <int Dim>
void add_scene(Json& json, const Simulation<Dim>& simulation) {
    const Scene& scene = simulation.scene();
    json["title"] = scene.title;
    json["scene"] = scene.file;
    json["scene_hash"] = text_hash(scene.source);
    json["dimension"] = Dim;
    json["particles"] = {{"fluid", simulation.fluid().owned},
                         {"solid", simulation.solid().owned},
                         {"wall", simulation.wall().owned},
                         {"interface_elements", simulation.interface().owned}};
}

template <int Dim>
void add_progress(Json& json, const Simulation<Dim>& simulation, const RunRecord& record) {
    json["steps"] = simulation.work().steps;
    json["dt"] = simulation.time_step();
    json["solid_substeps"] = simulation.solid_substeps();
    json["simulated_time"] = simulation.time();
    json["end_time"] = record.end_time;
}

template <int Dim>
void add_cost(Json& json, const Simulation<Dim>& simulation, const RunRecord& record) {
    const WorkCount work = simulation.work();
    json["wall_seconds"] = record.wall_seconds;
    json["cpu_seconds"] = record.cpu_seconds;
    json["setup_seconds"] = record.setup_seconds;
    json["step_seconds"] = record.step_seconds;
    json["checkpoints"] = {{"written", record.checkpoints}, {"seconds", record.checkpoint_seconds}};
    json["disk_wait_seconds"] = record.disk_wait_seconds;
    json["resumed_at_steps"] = record.resumed_at;
    const std::vector<double> seconds = seconds_per_phase(simulation.timer(), record);
    Json& phases = json["seconds_per_phase"];
    for (std::size_t k = 0; k < seconds.size(); ++k) phases[std::string(step_phase_names[k])] = seconds[k];
    json["particle_steps"] = work.particle_steps;
    json["pairs"] = work.pairs;
    json["neighbour_builds"] = work.neighbour_builds;
    json["particle_steps_per_second"] = record.rate(static_cast<double>(work.particle_steps));
    json["pairs_per_second"] = record.rate(static_cast<double>(work.pairs));
    json["threads"] = record.threads;
    json["precision"] = word_of(simulation.scene().method.precision);
    json["instruction_set"] = name_of(active_isa());
    json["peak_memory_bytes"] = peak_memory_bytes();
    json["memory_bytes"] = simulation.memory_bytes();
}

template <int Dim>
void add_quality(Json& json, const Simulation<Dim>& simulation, const RunRecord& record) {
    json["max_mach"] = simulation.max_mach();
    json["max_speed"] = simulation.max_speed();
    json["momentum_residual"] = simulation.interface_balance().residual;
    const EnergyBalance now = simulation.energy();
    json["energy"] = {{"initial", to_json(record.initial_energy)},
                      {"final", to_json(now)},
                      {"balance", now.total() - record.initial_energy.total()}};
}

void add_watch(Json& json, const Scene& scene, const RunRecord& record) {
    json = {{"policy", word_of(scene.watch)},  {"looks", record.looks},         {"snapshots", record.snapshots},
            {"seconds", record.watch_seconds}, {"retries", record.retry_count}, {"retried", Json::array()},
            {"warnings", Json::array()}};
    for (const Retry& r : record.retries)
        json["retried"].push_back({{"step", r.step}, {"time", r.time}, {"message", r.message}});
    for (const Warning& w : record.warnings)
        json["warnings"].push_back({{"name", w.name},
                                    {"looks", w.looks},
                                    {"first_time", w.first_time},
                                    {"worst", w.worst},
                                    {"worst_time", w.worst_time},
                                    {"message", w.message}});
}

void add_effects(Json& json, const Effects& effects) {
    for (const EffectChoice& choice : effects.all())
        json[std::string(choice.info.key)] = {{"on", choice.on},
                                              {"name", std::string(choice.info.name)},
                                              {"why", choice.why},
                                              {"equation", std::string(choice.info.equation)}};
}

void add_probes(Json& json, const RunRecord& record) {
    json = Json::object();
    for (std::size_t k = 0; k < record.probe_values.size(); ++k) json[record.probe_columns[k]] = record.probe_values[k];
}

}  // namespace

template <int Dim>
std::string summary_text(const Simulation<Dim>& simulation, const RunRecord& record) {
    Json json;
    json["program"] = "sluice";
    json["version"] = std::string(program_version());
    json["status"] = std::string(name_of(record.state));
    if (!record.message.empty()) json["message"] = record.message;
    add_scene(json, simulation);
    add_progress(json, simulation, record);
    add_cost(json, simulation, record);
    add_quality(json, simulation, record);
    add_watch(json["watch"], simulation.scene(), record);
    add_effects(json["effects"], simulation.effects());
    add_probes(json["probes"], record);
    // A title in a broken encoding must not cost the run its summary.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

template std::string summary_text<2>(const Simulation<2>&, const RunRecord&);
template std::string summary_text<3>(const Simulation<3>&, const RunRecord&);

}  // namespace sluice
