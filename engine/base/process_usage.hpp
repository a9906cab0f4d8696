// What this process has used.
#pragma once

#include <cstddef>

namespace sluice {

/// CPU time of this process so far, all threads [s].
double process_cpu_seconds();
/// The most memory that this process has held so far.
std::size_t peak_memory_bytes();

}  // namespace sluice
