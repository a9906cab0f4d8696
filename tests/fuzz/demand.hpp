// What must hold for any input; what does not ends the program, so that fuzzer and replay notice.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace sluice {

inline void demand(bool holds, const std::string& what) {
    if (holds) return;
    std::fprintf(stderr, "broken: %s\n", what.c_str());
    std::abort();
}

}  // namespace sluice
