// How far a pass may be from its twin.
#pragma once

#include <algorithm>
#include <vector>

#include "tests/kernels/twins.hpp"
#include "tests/kernels/variants.hpp"

namespace sluice {

/// Allowed error of a sum, in units of Σ|term|.
/// full: the passes and the twins round each term some ten times in different order; the steepest place is the
///   slope of W at a small q, whose truncated powers cancel to 4e-16/(3q): 1e-13 has room down to q = 1e-2, where a
///   term is one of many. Seen: 2e-14.
/// mixed: eps = 6e-8 · (distance to the block's origin)/r ≈ 40 for the closest pairs, which are few among many, and
///   1e-7/(3q) from the slope. Seen: 5e-6.
constexpr double twin_tolerance(Precision precision) { return precision == Precision::full ? 1e-13 : 1e-5; }

/// Σ|term| of each particle, all components together (a component that happens to be small is no more accurate than the
/// vector), but no less than a hundredth of the mean: a particle whose only partners stand at the edge of the support
/// has a sum of next to nothing, (2 − q)² of a rounded q.
template <int N>
std::vector<double> error_scale(const twin::Sums<N>& sums) {
    std::vector<double> scale;
    double mean = 0;
    for (const Vec<N>& m : sums.magnitude) {
        double all = 0;
        for (int k = 0; k < N; ++k) all += m[k];
        scale.push_back(all);
        mean += all / static_cast<double>(sums.magnitude.size());
    }
    for (double& s : scale) s = std::max(s, 0.01 * mean);
    return scale;
}

/// The largest error over all particles and components, in units of error_scale.
template <int N>
double worst_error(const TupleField<N>& got, const twin::Sums<N>& want) {
    const auto scale = error_scale(want);
    double worst = 0;
    for (std::size_t i = 0; i < scale.size(); ++i)
        for (int k = 0; k < N; ++k) worst = std::max(worst, relative_error(got[i][k], want.value[i][k], scale[i]));
    return worst;
}

inline double worst_error(const ScalarField& got, const twin::Sums<1>& want) {
    const auto scale = error_scale(want);
    double worst = 0;
    for (std::size_t i = 0; i < scale.size(); ++i)
        worst = std::max(worst, relative_error(got[i], want.value[i][0], scale[i]));
    return worst;
}

template <int N>
bool same_bits(const TupleField<N>& a, const TupleField<N>& b) {
    return a.c == b.c;
}

}  // namespace sluice
