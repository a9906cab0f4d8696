// summary.json: what was run, what it cost, and how it ended; for scripts.
#pragma once

#include <string>

#include "engine/run/run_record.hpp"
#include "engine/simulation/simulation.hpp"

namespace sluice {

/// The summary as JSON. Numbers that are not finite become null.
template <int Dim>
std::string summary_text(const Simulation<Dim>& simulation, const RunRecord& record);

}  // namespace sluice
