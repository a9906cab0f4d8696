// How long threads wait for each other before they sleep.
#pragma once

namespace sluice {

/// Starts the program anew with a short spinning time for OpenMP's threads, unless the user has set one.
///
/// GCC's runtime lets a thread that waits at a barrier spin for about a millisecond. A step of a small scene has some
/// thirty barriers; where other programs share the processor, each costs that millisecond whenever one of the threads
/// is not running, and twice the CPU time is burnt (measured: the elastic gate with a load average of 4, 6.8 s of CPU
/// time against 3.1). The runtime reads its settings before main() runs; hence the new start. Returns if there is
/// nothing to do, or if it cannot be done.
void use_short_waits(char** argv);

}  // namespace sluice
