// The interface of the loop over a block's pairs, which is compiled per instruction set and precision.
#pragma once

#include "kernels/choices.hpp"
#include "kernels/pairs/particle_view.hpp"
#include "kernels/smoothing.hpp"
#include "neighbor/isa.hpp"
#include "neighbor/neighbor_list.hpp"

namespace sluice {

/// How the pairs of a run are computed: precision and smoothing function.
template <int Dim>
struct PairMethod {
    Precision precision = Precision::full;
    Smoothing<Dim> smoothing;

    PairMethod(Precision p = Precision::full, Smoothing<Dim> w = {}) : precision(p), smoothing(w) {}
};

template <int Dim>
struct BlockTask {
    ParticleView<Dim> a, b;  ///< queries, candidates
    ListView list;
    Smoothing<Dim> smoothing;
};

/// Particles in a block.
inline constexpr std::size_t block_particles = block_size * cluster_size;

// A pass is a set of terms with their constants:
//   dim
//   outputs            how many numbers it sums
//   reads_i, reads_j   columns (kernels/pairs/particle_view.hpp)
//   length             if not the mean
//   place              if distances are not those of `position`
//   always_full        if mixed precision will not do
//   operator()(pair)   returns Vec<outputs, Real>
//
// sum_block: sums[(cluster · outputs + k) · 4 + lane] = Σ_j pass(ij)[k] for the block's particles.
#define SLUICE_DECLARE_LOOP(level)                                                                                  \
    namespace level {                                                                                               \
    template <class Pass, class Number>                                                                             \
    void sum_block(const BlockTask<Pass::dim>& task, const ListView::Block& block, const Pass& pass, double* sums); \
    }
SLUICE_DECLARE_LOOP(baseline)
SLUICE_DECLARE_LOOP(avx2)
SLUICE_DECLARE_LOOP(avx512)
SLUICE_DECLARE_LOOP(counted)
#undef SLUICE_DECLARE_LOOP

namespace counted {
/// Additions, multiplications and so on for each pair that the loop goes over (kernels/pairs/operation_count.hpp).
template <class Pass>
double operations_per_lane();
}  // namespace counted

template <class Pass>
using BlockLoop = void (*)(const BlockTask<Pass::dim>&, const ListView::Block&, const Pass&, double*);

/// The column between whose values a pass measures distances.
template <class Pass>
constexpr auto place_of() {
    if constexpr (requires { Pass::place; })
        return Pass::place;
    else
        return column::position;
}

/// Whether a pass is computed in double: with `always_full`, whatever is asked for.
template <class Pass>
constexpr bool is_full(Precision precision) {
    return requires { Pass::always_full; }
    || precision == Precision::full;
}

/// The loop for the instruction set in use.
template <class Pass>
BlockLoop<Pass> block_loop(Precision precision) {
    if constexpr (!requires { Pass::always_full; }) {
        switch (precision) {
            case Precision::full:
                break;
            case Precision::mixed:
                return SLUICE_OF_ISA(active_isa(), sum_block<Pass, float>);
        }
    }
    return SLUICE_OF_ISA(active_isa(), sum_block<Pass, double>);
}

}  // namespace sluice
