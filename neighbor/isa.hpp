// Instruction sets: the loops over pairs are compiled once per level, and the program takes the best that the processor
// has when it starts.
//
// A source file that holds such loops is compiled with -DSLUICE_ISA=LEVEL and that level's flags
// (neighbor/isa.cmake). What it defines stands in a namespace of that name, so that no function compiled for a newer
// processor can take the place of its namesake elsewhere.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sluice {

enum class Isa {
    baseline,  ///< what the compiler takes for granted: SSE2 on x86-64
    avx2,      ///< with FMA
    avx512,    ///< F, BW, DQ, VL
};

/// "baseline", "avx2", "avx512".
std::string_view name_of(Isa isa);

/// Levels that were compiled in and that this processor has, worst first.
const std::vector<Isa>& available_isas();

/// The level in use: the best available one unless use_isa() chose another.
Isa active_isa();

/// Chooses a level for all loops from now on. Not while loops run.
/// Throws std::invalid_argument, with the levels that there are, if the processor or the program lacks it.
void use_isa(std::string_view name);

/// One of the same for each level.
template <class T>
constexpr T of_isa(Isa isa, T of_baseline, T of_avx2, T of_avx512) {
    switch (isa) {
        case Isa::baseline:
            break;
        case Isa::avx2:
            return of_avx2;
        case Isa::avx512:
            return of_avx512;
    }
    return of_baseline;
}

// SLUICE_OF_ISA(isa, function): the function of that name in the level's namespace.
#ifdef SLUICE_ALL_ISAS
#define SLUICE_OF_ISA(isa, ...) ::sluice::of_isa(isa, &baseline::__VA_ARGS__, &avx2::__VA_ARGS__, &avx512::__VA_ARGS__)
#else
#define SLUICE_OF_ISA(isa, ...) &baseline::__VA_ARGS__
#endif

}  // namespace sluice
