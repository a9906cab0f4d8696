// The loops that measure a machine, compiled once per instruction set. One multiplication and one addition are one
// instruction where the level has FMA, two where it has not.
#include "engine/run/profile/roofline_loops.hpp"

#include "neighbor/pack.hpp"
#include "neighbor/vec.hpp"

namespace sluice::SLUICE_ISA {

template <class Number>
std::uint64_t multiply_add(std::uint64_t rounds) {
    using Real = Pack<Number>;
    // x → b/(1 − a) = 1: neither overflow nor denormals, however many rounds.
    volatile double a_given = 0.999, b_given = 0.001;
    const Real a(a_given), b(b_given);
    Real x[accumulators];
    for (int k = 0; k < accumulators; ++k) x[k] = Real(k);
    for (std::uint64_t r = 0; r < rounds; ++r)
        unroll<accumulators>([&](int k) __attribute__((always_inline)) { x[k] = x[k] * a + b; });
    Real sum(0);
    for (const Real& value : x) sum += value;
    volatile Number kept = sum.v[0];
    static_cast<void>(kept);
    return rounds * accumulators * Real::lanes * 2;
}

std::uint64_t triad(double* __restrict a, const double* __restrict b, const double* __restrict c, std::size_t n) {
    constexpr double s = 3;
    for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + s * c[i];
    return 3 * sizeof(double) * n;
}

template std::uint64_t multiply_add<float>(std::uint64_t);
template std::uint64_t multiply_add<double>(std::uint64_t);

}  // namespace sluice::SLUICE_ISA
