// How far a pass may be from its twin.
#pragma once

#include "tests/kernels/twins.hpp"

namespace sluice {

/// Allowed error of a sum, in units of Σ|term|.
/// double: the passes and the twins round each term some ten times in different order; the steepest place is the
///   slope of W at a small q, whose truncated powers cancel to 4e-16/(3q): 1e-12 has room down to q = 1e-3.
/// float: eps = 6e-8 · (distance to the group's origin)/r ≈ 40 for the closest pairs, 1e-7/(3q) from the slope, and the
///   lanes' sum of up to 128 terms: some 1e-5, with room for the few pairs that are still closer.
template <class Real>
inline constexpr double twin_tolerance = sizeof(Real) == 8 ? 1e-12 : 1e-4;

/// The largest error over all particles and components, in units of Σ|term| of the particle (all components: a
/// component that happens to be small is no more accurate than the vector).
template <int N>
double worst_error(const TupleField<N>& got, const twin::Sums<N>& want) {
    double worst = 0;
    for (std::size_t i = 0; i < want.value.size(); ++i) {
        double scale = 0;
        for (int k = 0; k < N; ++k) scale += want.magnitude[i][k];
        for (int k = 0; k < N; ++k) worst = std::max(worst, relative_error(got[i][k], want.value[i][k], scale));
    }
    return worst;
}

inline double worst_error(const ScalarField& got, const twin::Sums<1>& want) {
    double worst = 0;
    for (std::size_t i = 0; i < want.value.size(); ++i)
        worst = std::max(worst, relative_error(got[i], want.value[i][0], want.magnitude[i][0]));
    return worst;
}

template <int N>
bool same_bits(const TupleField<N>& a, const TupleField<N>& b) {
    return a.c == b.c;
}

}  // namespace sluice
