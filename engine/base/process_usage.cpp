#include "engine/base/process_usage.hpp"

#include <sys/resource.h>

namespace sluice {
namespace {

rusage usage() {
    rusage u{};
    ::getrusage(RUSAGE_SELF, &u);
    return u;
}

double seconds(const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); }

}  // namespace

double process_cpu_seconds() {
    const rusage u = usage();
    return seconds(u.ru_utime) + seconds(u.ru_stime);
}

std::size_t peak_memory_bytes() {
    return static_cast<std::size_t>(usage().ru_maxrss) * 1024;  // Linux counts in KiB
}

}  // namespace sluice
