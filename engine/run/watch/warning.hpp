#pragma once

#include <cstdint>
#include <string>

namespace sluice {

/// Something that looked wrong, over a whole run (watch.hpp).
struct Warning {
    std::string name;
    std::uint64_t looks = 0;  ///< how often it was seen
    double first_time = 0;    ///< [s]
    double worst = 0;         ///< what it measures, at its worst
    double worst_time = 0;    ///< [s]
    std::string message;      ///< of the first time: what, where, likely cause and remedy

    /// visit(name, member) for what changes during a run.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("looks", looks), visit("first_time", first_time), visit("worst", worst), visit("worst_time", worst_time);
        visit("message", message);
    }
};

/// A breakdown that a run went on from, at an earlier state, with shorter steps.
struct Retry {
    std::uint64_t step = 0;  ///< of the breakdown
    double time = 0;         ///< [s]
    std::string message;
};

}  // namespace sluice
