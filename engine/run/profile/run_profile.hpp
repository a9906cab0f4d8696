// The profile of a run, written beside its results.
#pragma once

#include <filesystem>
#include <string>

#include "engine/run/profile/step_profile.hpp"
#include "engine/simulation/simulation.hpp"

namespace sluice {

/// Writes profile.json and trace.json into the folder; returns the tables for people. Throws OutputError.
template <int Dim>
std::string write_profile(const StepProfile& recorded, const Simulation<Dim>& simulation,
                          const std::filesystem::path& directory);

}  // namespace sluice
