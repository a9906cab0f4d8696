#include <nlohmann/json.hpp>

#include "engine/base/version.hpp"
#include "engine/run/profile/profile_text.hpp"
#include "neighbor/isa.hpp"

namespace sluice {
namespace {

using Json = nlohmann::ordered_json;
using Kind = ProfileRow::Kind;

Json keys_of(const std::vector<Effect>& list, const Effects& effects) {
    Json keys = Json::array();
    for (const Effect e : list) keys.push_back(std::string(effects[e].info.key));
    return keys;
}

Json times_of(const ProfileRow& row, const Profile& profile, const Effects& effects) {
    return {{"name", row.name},
            {"calls", row.calls},
            {"calls_per_step", static_cast<double>(row.calls) / static_cast<double>(profile.steps)},
            {"seconds", row.seconds},
            {"share", row.seconds / profile.seconds},
            {"busy_seconds", row.busy},
            {"imbalance", row.imbalance()},
            {"waiting", row.waiting()},
            {"effects", keys_of(row.effects, effects)}};
}

void add_work(Json& json, const ProfileRow& row) {
    const PairWork& work = row.work;
    const auto particles = static_cast<double>(work.particles);
    json["phase"] = row.phase;
    json["precision"] = row.number_bytes == sizeof(double) ? "double" : "single";
    json["particles"] = work.particles;
    json["pairs"] = work.pairs;
    json["lanes"] = work.lanes;
    json["pairs_per_second_per_core"] = row.per_core(static_cast<double>(work.pairs));
    json["bytes"] = work.list_bytes + work.column_bytes;
    json["bytes_per_particle"] = particles > 0 ? row.bytes() / particles : 0;
    json["bytes_per_second"] = row.seconds > 0 ? row.bytes() / row.seconds : 0;
    json["operations"] = row.operations;
    json["operations_per_second"] = row.seconds > 0 ? row.operations / row.seconds : 0;
}

}  // namespace

std::string profile_json(const Profile& profile, const Effects& effects, const TraceRecorder& trace) {
    Json json;
    json["program"] = "sluice";
    json["version"] = std::string(program_version());
    json["instruction_set"] = name_of(active_isa());
    json["threads"] = profile.threads;
    json["steps"] = profile.steps;
    json["seconds"] = profile.seconds;
    json["interruptions"] = profile.interrupted;
    json["particles"] = profile.particles;
    json["memory_bytes"] = profile.memory_bytes;
    json["phases"] = json["loops"] = json["rests"] = json["effects"] = Json::array();
    for (const ProfileRow& row : profile.rows) {
        Json one = times_of(row, profile, effects);
        if (row.kind == Kind::loop) add_work(one, row);
        if (row.kind == Kind::rest) one["phase"] = row.phase;
        json[list_name(row.kind)].push_back(one);
    }
    for (const EffectTime& time : profile.effects)
        json["effects"].push_back({{"key", std::string(effects[time.effect].info.key)},
                                   {"seconds_alone", time.alone},
                                   {"seconds_shared", time.shared},
                                   {"where", time.where},
                                   {"with", keys_of(time.with, effects)}});
    json["trace"] = {{"steps", trace.steps().size()}, {"cut", trace.is_cut()}};
    return json.dump(2) + "\n";
}

}  // namespace sluice
