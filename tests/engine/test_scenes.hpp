// Small scenes of the tests.
#pragma once

#include <string>

namespace sluice {

inline std::string test_scene(const std::string& name) {
    std::string path(SLUICE_TEST_SCENES "/");
    path += name;
    return path;
}

}  // namespace sluice
