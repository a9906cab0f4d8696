// The table that ends a run: where the time went and how fast it was; for people.
#pragma once

#include <string>

#include "engine/output/run_record.hpp"
#include "engine/step/simulation.hpp"

namespace sluice {

/// 950 B, 12.3 kB, 8.10 MB
std::string memory_text(double bytes);

template <int Dim>
std::string report_text(const Simulation<Dim>& simulation, const RunRecord& record);

}  // namespace sluice
