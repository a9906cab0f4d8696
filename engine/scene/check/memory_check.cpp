#include "engine/scene/check/memory_check.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>

namespace sluice {
namespace {

/// Columns, lists and cells of a particle, as gates and dam breaks take them, the least of them [bytes].
double bytes_per_particle(int dimension) { return dimension == 2 ? 250 : 600; }

/// A line of /proc/meminfo or /proc/self/status in bytes; `otherwise` if there is none.
double kilobytes_in(const char* file, const std::string& name, double otherwise) {
    std::ifstream lines(file);
    std::string word;
    while (lines >> word) {
        double kilobytes = 0;
        if (word == name && lines >> kilobytes) return 1024 * kilobytes;
        lines.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
    return otherwise;
}

}  // namespace

double available_memory() {
    const double unlimited = std::numeric_limits<double>::infinity();
    const double machine = kilobytes_in("/proc/meminfo", "MemAvailable:", unlimited);
    rlimit limit{};
    if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return machine;
    return std::min(machine, static_cast<double>(limit.rlim_cur) - kilobytes_in("/proc/self/status", "VmSize:", 0));
}

double particles_in(double bytes, int dimension) { return bytes / bytes_per_particle(dimension); }

void check_memory(const Scene& scene, const std::vector<Packing>& bodies, const std::vector<Packing>& walls,
                  double available) {
    double particles = 0;
    for (const auto* packings : {&bodies, &walls})
        for (const Packing& packing : *packings) particles += static_cast<double>(packing.position.size());
    const double needed = particles * bytes_per_particle(scene.dimension);
    if (needed <= available) return;
    // The spacing at which there are as many particles fewer as there is too little memory.
    const double enough = scene.method.spacing * std::pow(needed / available, 1.0 / scene.dimension);
    scene.fail(
        "method.spacing",
        fmt::format("found {} m, which makes {:.3g} particles; they take {:.2g} GB or more, of which {:.2g} GB are "
                    "free; expected {:.2g} m or more",
                    scene.method.spacing, particles, 1e-9 * needed, 1e-9 * std::max(0.0, available), enough));
}

}  // namespace sluice
