// The table that ends a run: where the time went and how fast it was; for people.
#pragma once

#include <string>

#include "engine/run/run_record.hpp"
#include "engine/simulation/simulation.hpp"

namespace sluice {

template <int Dim>
std::string report_text(const Simulation<Dim>& simulation, const RunRecord& record);

}  // namespace sluice
