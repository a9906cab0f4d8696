// A fixed-size vector for pair arithmetic: plain components, no expression templates, trivially copyable.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace sluice {

/// f(0), f(1), … f(N−1), written out. A compiler does not turn a loop over pairs into vector code as long as there are
/// loops over components in it.
template <int N, class F>
[[gnu::always_inline]] constexpr void unroll(F&& f) {
    [&]<int... K>(std::integer_sequence<int, K...>) [[gnu::always_inline]] { (f(K), ...); }
    (std::make_integer_sequence<int, N>{});
}

/// The larger of two values; unlike std::max it takes no references, which would keep a loop from being vectorised.
template <class T>
[[gnu::always_inline]] constexpr T larger(T a, T b) {
    return a > b ? a : b;
}

template <class T>
[[gnu::always_inline]] constexpr T smaller(T a, T b) {
    return a < b ? a : b;
}

template <int Dim, class T = double>
struct Vec {
    std::array<T, Dim> c{};

    [[gnu::always_inline]] constexpr T& operator[](int k) { return c[static_cast<std::size_t>(k)]; }
    [[gnu::always_inline]] constexpr T operator[](int k) const { return c[static_cast<std::size_t>(k)]; }

    [[gnu::always_inline]] constexpr Vec& operator+=(const Vec& o) {
        unroll<Dim>([&](int k) __attribute__((always_inline)) { (*this)[k] += o[k]; });
        return *this;
    }
    [[gnu::always_inline]] constexpr Vec& operator-=(const Vec& o) {
        unroll<Dim>([&](int k) __attribute__((always_inline)) { (*this)[k] -= o[k]; });
        return *this;
    }
    [[gnu::always_inline]] constexpr Vec& operator*=(T s) {
        unroll<Dim>([&](int k) __attribute__((always_inline)) { (*this)[k] *= s; });
        return *this;
    }
    [[gnu::always_inline]] friend constexpr Vec operator+(Vec a, const Vec& b) { return a += b; }
    [[gnu::always_inline]] friend constexpr Vec operator-(Vec a, const Vec& b) { return a -= b; }
    [[gnu::always_inline]] friend constexpr Vec operator-(Vec a) { return a *= T(-1); }
    [[gnu::always_inline]] friend constexpr Vec operator*(Vec a, T s) { return a *= s; }
    [[gnu::always_inline]] friend constexpr Vec operator*(T s, Vec a) { return a *= s; }
    friend constexpr bool operator==(const Vec& a, const Vec& b) { return a.c == b.c; }
};

template <int Dim, class T>
[[gnu::always_inline]] constexpr T dot(const Vec<Dim, T>& a, const Vec<Dim, T>& b) {
    T s = a[0] * b[0];
    unroll<Dim - 1>([&](int k) __attribute__((always_inline)) { s += a[k + 1] * b[k + 1]; });
    return s;
}

template <int Dim, class T>
[[gnu::always_inline]] constexpr T norm2(const Vec<Dim, T>& a) {
    return dot(a, a);
}

template <int Dim, class T>
T norm(const Vec<Dim, T>& a) {
    return std::sqrt(norm2(a));
}

/// The same vector in another real type.
template <class To, int Dim, class T>
constexpr Vec<Dim, To> vec_cast(const Vec<Dim, T>& a) {
    Vec<Dim, To> r;
    unroll<Dim>([&](int k) __attribute__((always_inline)) { r[k] = static_cast<To>(a[k]); });
    return r;
}

}  // namespace sluice
