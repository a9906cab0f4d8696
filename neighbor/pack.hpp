// Several numbers that are computed with at once: one vector register, with the operators of a number.
//
// Only for files that are compiled once per instruction set (neighbor/isa.hpp): all names stand in that level's
// namespace.
#pragma once

#include <cmath>
#include <cstring>

#if defined(SLUICE_ISA_avx2) || defined(SLUICE_ISA_avx512) || defined(__SSE2__)
#include <immintrin.h>
#endif

#define SLUICE_INLINE inline __attribute__((always_inline))

namespace sluice::SLUICE_ISA {

/// Lanes of the widest register that this level has for T.
#if defined(SLUICE_ISA_avx512)
template <class T>
inline constexpr int widest = 64 / static_cast<int>(sizeof(T));
#elif defined(SLUICE_ISA_avx2)
template <class T>
inline constexpr int widest = 32 / static_cast<int>(sizeof(T));
#else
template <class T>
inline constexpr int widest = 16 / static_cast<int>(sizeof(T));
#endif

template <class T, int Lanes>
struct VectorOf {
    typedef T type __attribute__((vector_size(Lanes * sizeof(T))));
};

template <class T, int Lanes = widest<T>>
struct Pack {
    using Vector = typename VectorOf<T, Lanes>::type;
    using Number = T;
    static constexpr int lanes = Lanes;
    /// Four particles against four: how many of the partners' lie side by side in a register, and of one's own.
    static constexpr int along_j = Lanes < 4 ? Lanes : 4, along_i = Lanes / along_j;

    Vector v{};

    Pack() = default;
    SLUICE_INLINE Pack(Vector a) : v(a) {}
    /// The same number in all lanes.
    SLUICE_INLINE explicit Pack(double s) : v(Vector{} + static_cast<T>(s)) {}

    SLUICE_INLINE Pack& operator+=(Pack b) { return v += b.v, *this; }
    SLUICE_INLINE Pack& operator-=(Pack b) { return v -= b.v, *this; }
    SLUICE_INLINE Pack& operator*=(Pack b) { return v *= b.v, *this; }
    friend SLUICE_INLINE Pack operator+(Pack a, Pack b) { return {a.v + b.v}; }
    friend SLUICE_INLINE Pack operator-(Pack a, Pack b) { return {a.v - b.v}; }
    friend SLUICE_INLINE Pack operator-(Pack a) { return {-a.v}; }
    friend SLUICE_INLINE Pack operator*(Pack a, Pack b) { return {a.v * b.v}; }
};

/// The larger of each two.
template <class T, int N>
SLUICE_INLINE Pack<T, N> larger(Pack<T, N> a, Pack<T, N> b) {
#if defined(SLUICE_ISA_avx512)
    if constexpr (sizeof(T) == 4 && N == 16) return {_mm512_max_ps(a.v, b.v)};
    if constexpr (sizeof(T) == 8 && N == 8) return {_mm512_max_pd(a.v, b.v)};
#elif defined(SLUICE_ISA_avx2)
    if constexpr (sizeof(T) == 4 && N == 8) return {_mm256_max_ps(a.v, b.v)};
    if constexpr (sizeof(T) == 8 && N == 4) return {_mm256_max_pd(a.v, b.v)};
#elif defined(__SSE2__)
    if constexpr (sizeof(T) == 4 && N == 4) return {_mm_max_ps(a.v, b.v)};
    if constexpr (sizeof(T) == 8 && N == 2) return {_mm_max_pd(a.v, b.v)};
#endif
    return {a.v > b.v ? a.v : b.v};
}

/// The smaller of each two.
template <class T, int N>
SLUICE_INLINE Pack<T, N> smaller(Pack<T, N> a, Pack<T, N> b) {
#if defined(SLUICE_ISA_avx512)
    if constexpr (sizeof(T) == 4 && N == 16) return {_mm512_min_ps(a.v, b.v)};
    if constexpr (sizeof(T) == 8 && N == 8) return {_mm512_min_pd(a.v, b.v)};
#elif defined(SLUICE_ISA_avx2)
    if constexpr (sizeof(T) == 4 && N == 8) return {_mm256_min_ps(a.v, b.v)};
    if constexpr (sizeof(T) == 8 && N == 4) return {_mm256_min_pd(a.v, b.v)};
#elif defined(__SSE2__)
    if constexpr (sizeof(T) == 4 && N == 4) return {_mm_min_ps(a.v, b.v)};
    if constexpr (sizeof(T) == 8 && N == 2) return {_mm_min_pd(a.v, b.v)};
#endif
    return {a.v < b.v ? a.v : b.v};
}

/// 1/a, to a unit or two in the last place: an estimate by the processor, then Newton's steps, wherever that is faster
/// than its divider.
template <class T, int N>
SLUICE_INLINE Pack<T, N> reciprocal(Pack<T, N> a) {
    using P = Pack<T, N>;
    const auto newton = [a](P y) __attribute__((always_inline)) { return y * (P(2) - a * y); };
    static_cast<void>(newton);
#if defined(SLUICE_ISA_avx512)
    if constexpr (sizeof(T) == 4 && N == 16) return newton({_mm512_rcp14_ps(a.v)});
    if constexpr (sizeof(T) == 8 && N == 8) return newton(newton({_mm512_rcp14_pd(a.v)}));
#elif defined(SLUICE_ISA_avx2)
    if constexpr (sizeof(T) == 4 && N == 8) return newton({_mm256_rcp_ps(a.v)});
#elif defined(__SSE2__)
    if constexpr (sizeof(T) == 4 && N == 4) return newton({_mm_rcp_ps(a.v)});
#endif
    return {T(1) / a.v};
}

/// 1/√a for a > 0, likewise.
template <class T, int N>
SLUICE_INLINE Pack<T, N> inverse_sqrt(Pack<T, N> a) {
    using P = Pack<T, N>;
    const auto newton = [a](P y) __attribute__((always_inline)) { return y * (P(1.5) - (P(0.5) * a * y) * y); };
    static_cast<void>(newton);
#if defined(SLUICE_ISA_avx512)
    if constexpr (sizeof(T) == 4 && N == 16) return newton({_mm512_rsqrt14_ps(a.v)});
    if constexpr (sizeof(T) == 8 && N == 8) return newton(newton({_mm512_rsqrt14_pd(a.v)}));
#elif defined(SLUICE_ISA_avx2)
    if constexpr (sizeof(T) == 4 && N == 8) return newton({_mm256_rsqrt_ps(a.v)});
    if constexpr (sizeof(T) == 8 && N == 4) return {T(1) / P{_mm256_sqrt_pd(a.v)}.v};
#elif defined(__SSE2__)
    if constexpr (sizeof(T) == 4 && N == 4) return newton({_mm_rsqrt_ps(a.v)});
    if constexpr (sizeof(T) == 8 && N == 2) return {T(1) / P{_mm_sqrt_pd(a.v)}.v};
#endif
    P root;
    for (int l = 0; l < N; ++l) root.v[l] = std::sqrt(a.v[l]);
    return {T(1) / root.v};
}

template <class T, int N>
SLUICE_INLINE Pack<T, N> operator/(Pack<T, N> a, Pack<T, N> b) {
    return a * reciprocal(b);
}

/// Bit l is set where a < b in lane l.
template <class T, int N>
SLUICE_INLINE unsigned mask_less(Pack<T, N> a, Pack<T, N> b) {
#if defined(SLUICE_ISA_avx512)
    if constexpr (sizeof(T) == 4 && N == 16) return _mm512_cmp_ps_mask(a.v, b.v, _CMP_LT_OQ);
    if constexpr (sizeof(T) == 8 && N == 8) return _mm512_cmp_pd_mask(a.v, b.v, _CMP_LT_OQ);
#elif defined(SLUICE_ISA_avx2)
    if constexpr (sizeof(T) == 4 && N == 8)
        return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)));
    if constexpr (sizeof(T) == 8 && N == 4)
        return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(a.v, b.v, _CMP_LT_OQ)));
#elif defined(__SSE2__)
    if constexpr (sizeof(T) == 4 && N == 4) return static_cast<unsigned>(_mm_movemask_ps(_mm_cmplt_ps(a.v, b.v)));
    if constexpr (sizeof(T) == 8 && N == 2) return static_cast<unsigned>(_mm_movemask_pd(_mm_cmplt_pd(a.v, b.v)));
#endif
    unsigned mask = 0;
    for (int l = 0; l < N; ++l) mask |= (a.v[l] < b.v[l] ? 1U : 0U) << l;
    return mask;
}

/// `block` consecutive numbers, repeated until the register is full.
template <class P, int Block>
SLUICE_INLINE P load_repeated(const typename P::Number* p) {
    if constexpr (P::lanes == Block) {
        P r;
        std::memcpy(&r.v, p, sizeof r.v);
        return r;
    }
#if defined(SLUICE_ISA_avx512)
    if constexpr (Block == 4 && P::lanes == 16) return {_mm512_broadcast_f32x4(_mm_loadu_ps(p))};
    if constexpr (Block == 4 && P::lanes == 8 && sizeof(*p) == 8) return {_mm512_broadcast_f64x4(_mm256_loadu_pd(p))};
#elif defined(SLUICE_ISA_avx2)
    if constexpr (Block == 4 && P::lanes == 8) return {_mm256_broadcast_ps(reinterpret_cast<const __m128*>(p))};
#endif
    P r;
    for (int l = 0; l < P::lanes; ++l) r.v[l] = p[l % Block];
    return r;
}

/// Consecutive numbers, each on `block` lanes.
template <class P, int Block>
SLUICE_INLINE P load_spread(const typename P::Number* p) {
    if constexpr (P::lanes == Block) return P(static_cast<double>(*p));
#if defined(SLUICE_ISA_avx512)
    if constexpr (Block == 4 && P::lanes == 16) {
        const __m512i which = _mm512_setr_epi32(0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3);
        return {_mm512_permutexvar_ps(which, _mm512_castps128_ps512(_mm_loadu_ps(p)))};
    }
    if constexpr (Block == 4 && P::lanes == 8 && sizeof(*p) == 8) {
        const __m512i which = _mm512_setr_epi64(0, 0, 0, 0, 1, 1, 1, 1);
        return {_mm512_permutexvar_pd(which, _mm512_castpd128_pd512(_mm_loadu_pd(p)))};
    }
#endif
    P r;
    for (int l = 0; l < P::lanes; ++l) r.v[l] = p[l / Block];
    return r;
}

/// Adds up each `Block` consecutive lanes, as (0 + 1) + (2 + 3) for four, and adds the sums to out[0], out[1], ….
template <int Block, class T, int N>
SLUICE_INLINE void add_block_sums(Pack<T, N> a, double* out) {
#if defined(SLUICE_ISA_avx512)
    if constexpr (Block == 4 && sizeof(T) == 4 && N == 16) {
        __m512 s = _mm512_add_ps(a.v, _mm512_permute_ps(a.v, 0xB1));
        s = _mm512_add_ps(s, _mm512_permute_ps(s, 0x4E));
        const __m512i first_lanes = _mm512_setr_epi32(0, 4, 8, 12, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
        const __m256d sums = _mm256_cvtps_pd(_mm512_castps512_ps128(_mm512_permutexvar_ps(first_lanes, s)));
        _mm256_storeu_pd(out, _mm256_add_pd(_mm256_loadu_pd(out), sums));
        return;
    }
    if constexpr (Block == 4 && sizeof(T) == 8 && N == 8) {
        __m512d s = _mm512_add_pd(a.v, _mm512_permute_pd(a.v, 0x55));
        s = _mm512_add_pd(s, _mm512_permutex_pd(s, 0x4E));
        const __m512i first_lanes = _mm512_setr_epi64(0, 4, 0, 0, 0, 0, 0, 0);
        const __m128d sums = _mm512_castpd512_pd128(_mm512_permutexvar_pd(first_lanes, s));
        _mm_storeu_pd(out, _mm_add_pd(_mm_loadu_pd(out), sums));
        return;
    }
#endif
    for (int b = 0; b < N / Block; ++b) {
        double sum = 0;
        if constexpr (Block == 4)
            sum = static_cast<double>((a.v[4 * b] + a.v[4 * b + 1]) + (a.v[4 * b + 2] + a.v[4 * b + 3]));
        else
            for (int l = 0; l < Block; ++l) sum += static_cast<double>(a.v[Block * b + l]);
        out[b] += sum;
    }
}

}  // namespace sluice::SLUICE_ISA
