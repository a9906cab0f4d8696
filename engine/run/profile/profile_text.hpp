// A profile for people and for programs.
#pragma once

#include <string>

#include "engine/run/profile/profile.hpp"
#include "engine/scene/rules/effects.hpp"

namespace sluice {

/// Two tables: phases with their loops, and effects.
std::string profile_text(const Profile& profile, const Effects& effects);

/// profile.json (engine/run/profile/profile.schema.json). `traced`, `trace_is_cut`: of trace.json.
std::string profile_json(const Profile& profile, const Effects& effects, const TraceRecorder& trace);

/// trace.json, in Chrome's trace format: a row per thread; the time between traced steps is left out. In pieces, as it
/// may be large.
std::string trace_json(const StepProfile& recorded, const Effects& effects, const std::string& title);

/// "a + b", keys as in [effects]
std::string keys_text(const std::vector<Effect>& list, const Effects& effects);

}  // namespace sluice
