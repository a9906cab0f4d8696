#include "engine/run/profile/profile.hpp"

#include <algorithm>
#include <numeric>

namespace sluice {
namespace {

using Kind = ProfileRow::Kind;
using Entries = std::vector<StepProfile::Entry>;

double seconds_of(Nanoseconds t) { return 1e-9 * static_cast<double>(t); }

ProfileRow row_of(const StepProfile::Entry& entry, Kind kind) {
    ProfileRow row;
    row.kind = kind;
    if (entry.section) row.name = entry.section->name;
    row.calls = entry.calls;
    row.seconds = seconds_of(entry.wall);
    for (const Nanoseconds t : entry.busy) row.busy.push_back(seconds_of(t));
    return row;
}

ProfileRow loop_row(const StepProfile::Entry& entry, const std::string& phase, const Effects& effects) {
    ProfileRow row = row_of(entry, Kind::loop);
    row.phase = phase;
    row.work = entry.work;
    row.number_bytes = entry.section->number_bytes;
    row.operations = static_cast<double>(entry.work.lanes) * entry.section->operations_per_lane();
    row.effects = effects_at(effects, phase, row.name);
    return row;
}

/// An entry without what was entered from it.
ProfileRow rest_row(const Entries& entries, std::size_t of) {
    StepProfile::Entry rest = entries[of];
    for (std::size_t e = of + 1; e < entries.size(); ++e) {
        if (entries[e].parent != of) continue;
        rest.wall -= entries[e].wall;
        for (std::size_t t = 0; t < rest.busy.size(); ++t) rest.busy[t] -= entries[e].busy[t];
    }
    return row_of(rest, Kind::rest);
}

/// A phase, its loops and its rest; of a phase without loops, only the phase.
std::vector<ProfileRow> rows_of_phase(const Entries& entries, std::size_t phase, const Effects& effects) {
    std::vector<ProfileRow> rows{row_of(entries[phase], Kind::phase)};
    const std::string name = rows.front().name;
    for (std::size_t e = phase + 1; e < entries.size(); ++e)
        if (entries[e].parent == phase && entries[e].section->number_bytes > 0)
            rows.push_back(loop_row(entries[e], name, effects));
    const auto longer = [](const ProfileRow& a, const ProfileRow& b) { return a.seconds > b.seconds; };
    std::sort(rows.begin() + 1, rows.end(), longer);
    const std::vector<Effect> in_rest = effects_at(effects, name, "");
    if (rows.size() == 1) {
        rows.front().effects = in_rest;
        return rows;
    }
    rows.push_back(rest_row(entries, phase));
    rows.back().name = "rest of it";
    rows.back().phase = name;
    rows.back().effects = in_rest;
    return rows;
}

void add_once(std::vector<Effect>& list, Effect e) {
    if (std::find(list.begin(), list.end(), e) == list.end()) list.push_back(e);
}

std::vector<EffectTime> times_of_effects(const std::vector<ProfileRow>& rows, const Effects& effects) {
    std::vector<EffectTime> times;
    for (const EffectChoice& choice : effects.all()) {
        if (!choice.on) continue;
        EffectTime time{choice.info.effect, 0, 0, {}, {}};
        for (const ProfileRow& row : rows) {
            if (std::find(row.effects.begin(), row.effects.end(), time.effect) == row.effects.end()) continue;
            (row.effects.size() == 1 ? time.alone : time.shared) += row.seconds;
            time.where.push_back(row.kind == Kind::rest ? row.phase : row.name);
            for (const Effect other : row.effects)
                if (other != time.effect) add_once(time.with, other);
        }
        times.push_back(std::move(time));
    }
    return times;
}

}  // namespace

const char* list_name(ProfileRow::Kind kind) {
    switch (kind) {
        case Kind::phase:
            return "phases";
        case Kind::loop:
            return "loops";
        case Kind::rest:
            return "rests";
    }
    return "";
}

double ProfileRow::busy_seconds() const { return std::accumulate(busy.begin(), busy.end(), 0.0); }

double ProfileRow::imbalance() const {
    const double mean = busy_seconds() / static_cast<double>(busy.size());
    return mean > 0 ? *std::max_element(busy.begin(), busy.end()) / mean : 1;
}

double ProfileRow::waiting() const {
    return seconds > 0 ? 1 - busy_seconds() / (seconds * static_cast<double>(busy.size())) : 0;
}

double ProfileRow::per_core(double count) const { return busy_seconds() > 0 ? count / busy_seconds() : 0; }

std::vector<Effect> effects_at(const Effects& effects, std::string_view phase, std::string_view loop) {
    std::vector<Effect> found;
    for (const EffectChoice& choice : effects.all())
        if (choice.on && choice.info.places.has(phase, loop)) found.push_back(choice.info.effect);
    return found;
}

const ProfileRow* find_row(const Profile& profile, const ProfileRow& like) {
    for (const ProfileRow& row : profile.rows)
        if (row.kind == like.kind && row.name == like.name && row.phase == like.phase) return &row;
    return nullptr;
}

Profile profile_of(const StepProfile& recorded, const Effects& effects) {
    const Entries entries = recorded.entries();
    Profile profile;
    profile.threads = recorded.threads();
    profile.steps = recorded.steps();
    profile.interrupted = recorded.interrupted();
    profile.seconds = seconds_of(entries.front().wall);
    std::vector<std::vector<ProfileRow>> phases;
    for (std::size_t e = 1; e < entries.size(); ++e)
        if (entries[e].section->number_bytes == 0) phases.push_back(rows_of_phase(entries, e, effects));
    std::sort(phases.begin(), phases.end(),
              [](const auto& a, const auto& b) { return a.front().seconds > b.front().seconds; });
    for (std::vector<ProfileRow>& rows : phases) std::move(rows.begin(), rows.end(), std::back_inserter(profile.rows));
    profile.rows.push_back(rest_row(entries, 0));
    profile.rows.back().name = "between the phases";
    profile.effects = times_of_effects(profile.rows, effects);
    return profile;
}

}  // namespace sluice
