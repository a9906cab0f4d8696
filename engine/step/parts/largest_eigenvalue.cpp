#include "engine/step/parts/largest_eigenvalue.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

using Vector = std::vector<double>;

double dot_of(const Vector& a, const Vector& b) {
    return ordered_sum<double>(a.size(), [&](std::size_t i) { return a[i] * b[i]; });
}

/// A start vector without symmetry, so that every mode is in it: the fractional parts of multiples of the golden ratio.
Vector start_vector(std::size_t size) {
    constexpr double golden = 0.6180339887498949;
    Vector v(size);
    for (std::size_t i = 0; i < size; ++i) {
        const double multiple = golden * static_cast<double>(i + 1);
        v[i] = multiple - std::floor(multiple) - 0.5;
    }
    return v;
}

/// Of a symmetric tridiagonal matrix: bisection by the signs of the pivots [Golub & Van Loan, section 8.4].
double largest_of(const Vector& diagonal, const Vector& beside) {
    const auto exceeds_all = [&](double value) {
        double pivot = diagonal[0] - value;
        for (std::size_t i = 1; i < diagonal.size() && pivot < 0; ++i)
            pivot = diagonal[i] - value - beside[i - 1] * beside[i - 1] / pivot;
        return pivot < 0;
    };
    double low = *std::max_element(diagonal.begin(), diagonal.end());
    double high = low + 2 * (beside.empty() ? 0 : *std::max_element(beside.begin(), beside.end()));
    constexpr int halvings = 40;  // to a part in 10^12
    for (int n = 0; n < halvings; ++n) {
        const double middle = 0.5 * (low + high);
        (exceeds_all(middle) ? high : low) = middle;
    }
    return high;
}

}  // namespace

double largest_eigenvalue(std::size_t size,
                          const std::function<void(std::span<const double>, std::span<double>)>& apply) {
    constexpr std::size_t most_steps = 100, settled_steps = 8;
    constexpr double settled = 1e-4, nothing = 1e-12;
    Vector q = start_vector(size), before(size), r(size), diagonal, beside, found;
    apply(q, r);  // removes what the operator maps to zero
    double norm = std::sqrt(dot_of(r, r));
    if (!(norm > 0)) return 0;
    for (std::size_t i = 0; i < size; ++i) q[i] = r[i] / norm;
    while (diagonal.size() < most_steps) {
        apply(q, r);
        const double on = dot_of(q, r), last = beside.empty() ? 0 : beside.back();
        for (std::size_t i = 0; i < size; ++i) r[i] -= on * q[i] + last * before[i];
        norm = std::sqrt(dot_of(r, r));
        diagonal.push_back(on);
        found.push_back(largest_of(diagonal, beside));
        const std::size_t n = found.size();
        if (norm <= nothing * found.back()) break;
        if (n > settled_steps && found.back() - found[n - 1 - settled_steps] < settled * found.back()) break;
        beside.push_back(norm);
        for (std::size_t i = 0; i < size; ++i) before[i] = q[i], q[i] = r[i] / norm;
    }
    return found.back();
}

}  // namespace sluice
