// Registers of several numbers against the same operations one by one, on every instruction set.
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/catch.hpp"
#include "tests/neighbor/clouds.hpp"
#include "tests/neighbor/pack_operations.hpp"

namespace sluice::test_pack {

namespace {

template <class T>
PackOperations<T> operations(Isa isa) {
    constexpr const T* type = nullptr;
#ifdef SLUICE_ALL_ISAS
    if (isa == Isa::avx2) return avx2::operations_on(type);
    if (isa == Isa::avx512) return avx512::operations_on(type);
#endif
    static_cast<void>(isa);
    return baseline::operations_on(type);
}

constexpr int most_lanes = 16;

template <class T>
using Unary = void (*)(const T*, T*);

/// 1e±30 in float and 1e±300 in double: all that an estimate of the processor covers, short of denormal numbers.
template <class T>
constexpr double widest_exponent = sizeof(T) == 4 ? 30 : 300;

/// Numbers over the whole range, and a sweep through the mantissas at even and odd exponents.
template <class T>
std::vector<T> arguments() {
    Random random(1);
    std::vector<T> a;
    for (int n = 0; n < 100000; ++n)
        a.push_back(static_cast<T>(std::pow(10, random.in(-widest_exponent<T>, widest_exponent<T>))));
    for (int n = 0; n < 100000; ++n) a.push_back(static_cast<T>(random.in(1, 4)));
    for (const double x : {1.0, 2.0, 4.0, 0.25}) {
        a.push_back(static_cast<T>(x));
        a.push_back(std::nextafter(static_cast<T>(x), T(0)));
        a.push_back(std::nextafter(static_cast<T>(x), T(100)));
    }
    while (a.size() % most_lanes) a.push_back(T(1));
    return a;
}

/// The largest error of f over all arguments, in units of the last place of the exact value.
template <class T, class Exact>
double worst_ulps(const PackOperations<T>& op, Unary<T> f, Exact&& exact) {
    const auto a = arguments<T>();
    double worst = 0;
    for (std::size_t n = 0; n < a.size(); n += static_cast<std::size_t>(op.lanes)) {
        T out[most_lanes];
        f(&a[n], out);
        for (int l = 0; l < op.lanes; ++l) {
            const long double want = exact(static_cast<long double>(a[n + static_cast<std::size_t>(l)]));
            const T rounded = static_cast<T>(want);
            const T ulp = std::nextafter(rounded, std::numeric_limits<T>::max()) - rounded;
            const auto error = static_cast<double>(std::abs(static_cast<long double>(out[l]) - want) / ulp);
            worst = error <= worst ? worst : error;  // takes a NaN
        }
    }
    return worst;
}

/// Small whole numbers, so that ties are many; and what is not a number.
template <class T>
std::vector<T> numbers_with_ties(Random& random) {
    std::vector<T> a;
    for (int l = 0; l < most_lanes; ++l) a.push_back(static_cast<T>(random.bits() % 4));
    if (random.bits() % 4 == 0) a[random.bits() % most_lanes] = std::numeric_limits<T>::quiet_NaN();
    return a;
}

}  // namespace

TEMPLATE_TEST_CASE("reciprocal and inverse_sqrt are good to a few units in the last place", "[pack]", float, double) {
    for (const Isa isa : available_isas()) {
        const auto op = operations<TestType>(isa);
        CAPTURE(std::string(name_of(isa)));
        // The processor's estimate is good to e = 1.5/2¹² (float below AVX-512). Newton's step leaves e² = 2.3 units in
        // the last place of a reciprocal, 3/2 e² = 3.4 of an inverse root, and its own roundings, some 1.5.
        CHECK(worst_ulps(op, op.reciprocal, [](long double a) { return 1 / a; }) <= 4);
        CHECK(worst_ulps(op, op.inverse_sqrt, [](long double a) { return 1 / std::sqrt(a); }) <= 5);
    }
}

TEMPLATE_TEST_CASE("the smallest normal number has an inverse square root", "[pack]", float, double) {
    // What a particle's distance to itself is raised to: times zero it must give zero.
    for (const Isa isa : available_isas()) {
        const auto op = operations<TestType>(isa);
        const std::vector<TestType> a(most_lanes, std::numeric_limits<TestType>::min());
        TestType out[most_lanes];
        op.inverse_sqrt(a.data(), out);
        CAPTURE(std::string(name_of(isa)));
        for (int l = 0; l < op.lanes; ++l) {
            CHECK(std::isfinite(out[l]));
            CHECK(out[l] == Approx(1 / std::sqrt(a[0])).epsilon(1e-6));  // single precision
        }
    }
}

TEMPLATE_TEST_CASE("a quotient is a product with the reciprocal", "[pack]", float, double) {
    Random random(2);
    for (const Isa isa : available_isas()) {
        const auto op = operations<TestType>(isa);
        double worst = 0;
        for (int n = 0; n < 1000; ++n) {
            TestType a[most_lanes], b[most_lanes], out[most_lanes];
            for (int l = 0; l < most_lanes; ++l) {
                a[l] = static_cast<TestType>(random.in(-10, 10));
                b[l] = static_cast<TestType>(random.in(0.1, 10));
            }
            op.quotient(a, b, out);
            for (int l = 0; l < op.lanes; ++l)
                worst = std::max(worst, static_cast<double>(std::abs(out[l] * b[l] / a[l] - 1)));
        }
        CAPTURE(std::string(name_of(isa)));
        CHECK(worst <
              6 * std::numeric_limits<TestType>::epsilon());  // four units of the reciprocal, two roundings here
    }
}

TEMPLATE_TEST_CASE("comparisons of registers are those of their numbers", "[pack]", float, double) {
    Random random(3);
    for (const Isa isa : available_isas()) {
        const auto op = operations<TestType>(isa);
        std::size_t wrong = 0;
        for (int n = 0; n < 2000; ++n) {
            const auto a = numbers_with_ties<TestType>(random), b = numbers_with_ties<TestType>(random);
            unsigned less = 0;
            for (std::size_t l = 0; l < static_cast<std::size_t>(op.lanes); ++l) less |= (a[l] < b[l] ? 1U : 0U) << l;
            wrong += op.mask_less(a.data(), b.data()) != less;
            TestType high[most_lanes], low[most_lanes];
            op.larger(a.data(), b.data(), high);
            op.smaller(a.data(), b.data(), low);
            for (int l = 0; l < op.lanes; ++l) {
                const TestType x = a[static_cast<std::size_t>(l)], y = b[static_cast<std::size_t>(l)];
                if (x != x || y != y) continue;
                wrong += high[l] != std::max(x, y);
                wrong += low[l] != std::min(x, y);
            }
        }
        CAPTURE(std::string(name_of(isa)));
        CHECK(wrong == 0);
    }
}

TEMPLATE_TEST_CASE("numbers are repeated or spread over a register", "[pack]", float, double) {
    for (const Isa isa : available_isas()) {
        const auto op = operations<TestType>(isa);
        TestType from[most_lanes], out[most_lanes];
        for (int l = 0; l < most_lanes; ++l) from[l] = static_cast<TestType>(10 + l);
        std::size_t wrong = 0;
        op.load_repeated(from, out);
        for (int l = 0; l < op.lanes; ++l) wrong += out[l] != from[l % op.repeated];
        op.load_spread(from, out);
        for (int l = 0; l < op.lanes; ++l) wrong += out[l] != from[l / op.repeated];
        CAPTURE(std::string(name_of(isa)));
        CHECK(wrong == 0);
    }
}

}  // namespace sluice::test_pack
