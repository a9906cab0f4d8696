#include <nlohmann/json.hpp>

#include "engine/base/version.hpp"
#include "engine/run/profile/profile_text.hpp"
#include "engine/run/profile/scene_bench.hpp"

namespace sluice {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Limit& limit) { return {{"one_thread", limit.one_thread}, {"all_threads", limit.all_threads}}; }

Json to_json(const MachineLimits& machine) {
    Json json = {{"instruction_set", name_of(machine.isa)},
                 {"threads", machine.threads},
                 {"single_precision_operations_per_second", to_json(machine.single_precision)},
                 {"double_precision_operations_per_second", to_json(machine.double_precision)},
                 {"triad_bytes_per_second", Json::array()}};
    for (const MemoryLevel& level : machine.memory) {
        Json one = to_json(level.bandwidth);
        one["level"] = level.name;
        one["bytes"] = level.bytes;
        one["shared"] = level.shared;
        json["triad_bytes_per_second"].push_back(one);
    }
    return json;
}

Json to_json(const ThreadBench& bench) {
    return {{"threads", bench.profile.threads},
            {"steps", bench.profile.steps},
            {"interrupted_steps", bench.interrupted},
            {"seconds", bench.profile.seconds},
            {"steps_per_second", bench.steps_per_second()},
            {"particle_updates_per_second", bench.updates_per_second()}};
}

Json to_json(const ProfileRow& row, const SceneBench& bench, const Effects& effects) {
    const Profile& all = bench.all.profile;
    Json json = {{"name", row.name},
                 {"phase", row.phase},
                 {"seconds_per_step", row.seconds / static_cast<double>(all.steps)},
                 {"share", row.seconds / all.seconds},
                 {"efficiency", efficiency(row, bench)},
                 {"waiting", row.waiting()},
                 {"effects", keys_text(row.effects, effects)}};
    if (row.kind != ProfileRow::Kind::loop) return json;
    const Roof roof = roof_of(row, bench, all.threads);
    json["pairs_per_second_per_core"] = row.per_core(static_cast<double>(row.work.pairs));
    json["operations_per_byte"] = roof.intensity;
    json["of_arithmetic_peak"] = roof.arithmetic;
    json["of_bandwidth"] = roof.bandwidth;
    json["verdict"] = verdict(row, bench);
    return json;
}

}  // namespace

std::string bench_json(const SceneBench& bench, const Scene& scene, const Effects& effects) {
    const MemoryLevel& level = bench.machine.level_of(bench.field_bytes, bench.machine.threads);
    Json json;
    json["program"] = "sluice";
    json["version"] = std::string(program_version());
    json["title"] = scene.title;
    json["scene"] = scene.file;
    json["precision"] = word_of(scene.method.precision);
    json["particles"] = {{"fluid", bench.fluid}, {"solid", bench.solid}, {"wall", bench.wall}};
    json["memory_bytes"] = bench.field_bytes;
    json["memory_level"] = level.name;
    json["machine"] = to_json(bench.machine);
    json["one_thread"] = to_json(bench.one);
    json["all_threads"] = to_json(bench.all);
    for (const char* kind : {"phases", "loops", "rests"}) json[kind] = Json::array();
    for (const ProfileRow& row : bench.all.profile.rows)
        json[list_name(row.kind)].push_back(to_json(row, bench, effects));
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace sluice
