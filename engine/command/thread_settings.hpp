// How OpenMP's threads wait for each other, and where they run.
#pragma once

namespace sluice {

/// More threads than any one machine has; a typing error, not a wish.
inline constexpr int most_threads = 1024;

/// Starts the program anew with settings of OpenMP's runtime for this number of threads (0 = all), unless the user has
/// set some: the runtime reads them before main() runs. Returns if there is nothing to do, or if it cannot be done.
///
/// A step of a small scene has some thirty barriers, tens of microseconds apart. GCC's runtime lets a waiting thread
/// spin for about a millisecond. Where another program takes part of a processor, the system then tends to put both
/// threads on one: the one that spins keeps the other, for which it waits, from running, and the run takes ten times
/// as long as with one thread (measured: 27 s against 1.1 s). So waits are short; and if the threads are as many as the
/// processors, each is bound to its own: 1.7 to 2.8 s with the other program running, and nothing lost without it.
/// Fewer threads are not bound, since two programs would be bound to the same processors.
void use_thread_settings(int threads);

}  // namespace sluice
