#include "engine/base/version.hpp"

namespace sluice {

std::string_view program_version() { return SLUICE_VERSION; }

}  // namespace sluice
