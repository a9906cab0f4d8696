// The parts of the suite. Each registers its benchmarks under names of the form what/argument:value/…; those under
// large/ take seconds per iteration and gigabytes.
#pragma once

namespace sluice::bench {

void register_roofline();
void register_search();
void register_smoothing();
void register_passes();
void register_equations_of_state();
void register_steps();

}  // namespace sluice::bench
