// Small scenes of the tests.
#pragma once

#include <string>

namespace sluice {

inline std::string test_scene(const std::string& name) { return std::string(SLUICE_TEST_SCENES) + "/" + name; }

}  // namespace sluice
