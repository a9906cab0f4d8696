#include "engine/command/short_waits.hpp"

#include <unistd.h>

#include <cstdlib>

namespace sluice {

void use_short_waits([[maybe_unused]] char** argv) {
#if defined(__linux__) && defined(__GNUC__) && !defined(__clang__)
    constexpr const char* spins = "2000";  // tens of microseconds; virtual machines stop a processor after 3000
    if (std::getenv("GOMP_SPINCOUNT") || std::getenv("OMP_WAIT_POLICY")) return;
    if (setenv("GOMP_SPINCOUNT", spins, 0) == 0) execv("/proc/self/exe", argv);
#endif
}

}  // namespace sluice
