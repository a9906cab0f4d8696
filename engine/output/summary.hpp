// summary.json: what was run, what it cost, and how it ended; for scripts.
#pragma once

#include <string>
#include <string_view>

#include "engine/output/run_record.hpp"
#include "engine/step/simulation.hpp"

namespace sluice {

/// FNV-1a, 64 bits, as 16 hexadecimal digits [Fowler, Noll & Vo]: tells scenes apart, keeps no secrets.
std::string text_hash(std::string_view text);

/// The summary as JSON. Numbers that are not finite become null.
template <int Dim>
std::string summary_text(const Simulation<Dim>& simulation, const RunRecord& record);

}  // namespace sluice
