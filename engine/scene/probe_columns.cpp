#include "engine/scene/probe_columns.hpp"

#include <stdexcept>

namespace sluice {
namespace {

std::vector<std::string> parts_of(ProbeKind kind, int dimension) {
    switch (kind) {
        case ProbeKind::displacement:
        case ProbeKind::momentum:
        case ProbeKind::force:
            return dimension == 2 ? std::vector<std::string>{"x", "y"} : std::vector<std::string>{"x", "y", "z"};
        case ProbeKind::pressure:
            return {"p"};
        case ProbeKind::water_level:
            return {"level"};
        case ProbeKind::energy:
            return {"kinetic", "potential", "compression", "elastic", "total"};
        case ProbeKind::velocity_error:
            return {"rms"};
    }
    throw std::logic_error("a probe of unknown kind");
}

}  // namespace

std::vector<std::string> probe_columns(const Probe& probe, int dimension) {
    std::vector<std::string> columns;
    for (const std::string& part : parts_of(probe.kind, dimension)) columns.push_back(probe.name + "." + part);
    return columns;
}

}  // namespace sluice
