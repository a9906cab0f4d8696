// A profile as it is told: sections, loops over pairs with what they moved, and the effects that ran in them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/run/profile/step_profile.hpp"
#include "engine/scene/rules/effects.hpp"

namespace sluice {

struct ProfileRow {
    enum class Kind { phase, loop, rest };  ///< rest: of a phase or of the step, what is none of the others
    Kind kind = Kind::phase;
    std::string name;
    std::string phase;  ///< of a loop or a rest; empty: of the rest of the step
    std::uint64_t calls = 0;
    double seconds = 0;           ///< wall time
    std::vector<double> busy;     ///< of each thread [s]
    PairWork work;                ///< of a loop
    int number_bytes = 0;         ///< of a loop: of its arithmetic, 8 or 4
    double operations = 0;        ///< of a loop: additions, multiplications … over all lanes
    std::vector<Effect> effects;  ///< that ran in it and are on; empty for a phase that has loops

    double busy_seconds() const;  ///< of all threads
    double imbalance() const;     ///< longest over mean busy time of the threads
    double waiting() const;       ///< part of all threads' time in which they had nothing to do
    double bytes() const { return static_cast<double>(work.list_bytes + work.column_bytes); }
    /// `count` per second in which a core was busy with it.
    double per_core(double count) const;
};

/// The list of a profile's file that rows of a kind stand in.
const char* list_name(ProfileRow::Kind kind);

/// What an effect took: the loops over pairs, and the rests of phases, that ran for it.
struct EffectTime {
    Effect effect;
    double alone = 0;                ///< where no other effect ran [s]
    double shared = 0;               ///< where others ran in the same loop: all of it, not this effect's part [s]
    std::vector<std::string> where;  ///< names of loops and phases
    std::vector<Effect> with;        ///< others in them
};

struct Profile {
    int threads = 1;
    std::uint64_t steps = 0;
    double seconds = 0;            ///< wall time of the steps
    long interrupted = 0;          ///< how often the system took a processor from one of the threads
    double memory_bytes = 0;       ///< of particles and lists; set by the caller
    double particles = 0;          ///< those that move; set by the caller
    std::vector<ProfileRow> rows;  ///< phases, longest first, each with its loops and its rest behind it
    std::vector<EffectTime> effects;
};

Profile profile_of(const StepProfile& recorded, const Effects& effects);

/// The same phase, loop or rest in another profile; null if it did not run there.
const ProfileRow* find_row(const Profile& profile, const ProfileRow& like);

/// Effects that are on and have a part in this loop of this phase; with no loop: in the rest of the phase.
std::vector<Effect> effects_at(const Effects& effects, std::string_view phase, std::string_view loop);

}  // namespace sluice
