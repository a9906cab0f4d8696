#include "neighbor/isa.hpp"

#include <algorithm>
#include <stdexcept>

namespace sluice {
namespace {

std::vector<Isa> find_isas() {
    std::vector<Isa> found{Isa::baseline};
#ifdef SLUICE_ALL_ISAS
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
        found.push_back(Isa::avx2);
        if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
            __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
            found.push_back(Isa::avx512);
    }
#endif
    return found;
}

Isa& chosen() {
    static Isa isa = available_isas().back();
    return isa;
}

}  // namespace

std::string_view name_of(Isa isa) {
    switch (isa) {
        case Isa::baseline:
            return "baseline";
        case Isa::avx2:
            return "avx2";
        case Isa::avx512:
            return "avx512";
    }
    return {};
}

const std::vector<Isa>& available_isas() {
    static const std::vector<Isa> found = find_isas();
    return found;
}

Isa active_isa() { return chosen(); }

void use_isa(std::string_view name) {
    std::string known;
    for (const Isa isa : available_isas()) {
        if (name_of(isa) == name) {
            chosen() = isa;
            return;
        }
        known += (known.empty() ? "" : ", ") + std::string(name_of(isa));
    }
    throw std::invalid_argument("instruction set \"" + std::string(name) + "\": this processor runs " + known);
}

}  // namespace sluice
