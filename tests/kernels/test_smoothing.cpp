// The smoothing functions: their form, integral, slope and support.
#include <numbers>

#include "kernels/smoothing.hpp"
#include "tests/catch.hpp"
#include "tests/kernels/twins.hpp"

namespace sluice::test_smoothing {

namespace {

constexpr SmoothingFunction all_functions[] = {SmoothingFunction::cubic_spline, SmoothingFunction::wendland_c2,
                                               SmoothingFunction::wendland_c4, SmoothingFunction::quintic_spline};

template <int Dim>
double slope(const Smoothing<Dim>& w, double q) {
    return w.slope_scale * w.reduced_slope(q);
}

/// w(q)/w(0), as the literature prints it.
double printed_shape(SmoothingFunction f, double q) {
    const auto power = [](double base, int n) { return base > 0 ? std::pow(base, n) : 0.0; };
    switch (f) {
        case SmoothingFunction::wendland_c2:
            return power(1 - q / 2, 4) * (1 + 2 * q);
        case SmoothingFunction::wendland_c4:
            return power(1 - q / 2, 6) * (1 + 3 * q + 35.0 / 12 * q * q);
        case SmoothingFunction::quintic_spline:
            return (power(3 - q, 5) - 6 * power(2 - q, 5) + 15 * power(1 - q, 5)) / 66;
        default:
            return q <= 1 ? 1 - 1.5 * q * q + 0.75 * q * q * q : power(2 - q, 3) / 4;
    }
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("the cubic spline is the paper's", "[smoothing]", ((int Dim), Dim), 2, 3) {
    const Smoothing<Dim> w;
    double worst_shape = 0, worst_slope = 0;
    for (int n = 0; n <= 3000; ++n) {
        const double q = n * 1e-3;
        worst_shape = std::max(worst_shape, std::abs(w.sigma * w.shape(q) - twin::w(Dim, q, 1)));
        worst_slope = std::max(worst_slope, std::abs(w.sigma * slope(w, q) - twin::dw_dr(Dim, q, 1)));
    }
    CHECK(worst_shape < 4e-16);  // values up to 1 from a handful of roundings, of which the first powers are up to 2
    CHECK(worst_slope < 1e-15);  // the same with powers up to 3
}

TEMPLATE_TEST_CASE_SIG("smoothing functions have their printed form", "[smoothing]", ((int Dim), Dim), 2, 3) {
    for (const SmoothingFunction f : all_functions) {
        const Smoothing<Dim> w(f);
        double worst = 0;
        for (double q = 0; q < 3.5; q += 0.00831)
            worst = std::max(worst, std::abs(w.shape(q) / w.shape(0.0) - printed_shape(f, q)));
        CHECK(worst < 2e-15);  // some ten roundings of numbers up to 4 (the quintic's: 243/66)
    }
}

TEMPLATE_TEST_CASE_SIG("W integrates to one", "[smoothing]", ((int Dim), Dim), 2, 3) {
    for (const SmoothingFunction function : all_functions) {
        const Smoothing<Dim> w(function);
        const int n = 6000;  // a multiple of six: pieces end at whole numbers
        double integral = 0;
        for (int i = 0; i < n; ++i) {  // Simpson's rule per interval of q
            const double a = w.support * i / n, b = w.support * (i + 1) / n;
            const auto f = [&](double q) {
                return w.shape(q) * (Dim == 2 ? 2 * std::numbers::pi * q : 4 * std::numbers::pi * q * q);
            };
            integral += (b - a) / 6 * (f(a) + 4 * f(0.5 * (a + b)) + f(b));
        }
        // Simpson's error is (b−a)^4/2880 · |f''''| per unit of q, below 1e-12 for all.
        CHECK(w.sigma * integral == Approx(1).margin(1e-12));
    }
}

TEMPLATE_TEST_CASE_SIG("slope is the derivative of shape", "[smoothing]", ((int Dim), Dim), 2, 3) {
    for (const SmoothingFunction function : all_functions) {
        const Smoothing<Dim> w(function);
        double worst = 0;
        const double step = 1e-5, unit = w.shape(0.0);
        for (double q = step; q < 3.5; q += 0.00917)
            worst =
                std::max(worst, std::abs((w.shape(q + step) - w.shape(q - step)) / (2 * step) - slope(w, q)) / unit);
        // Central differences: w''' step²/6 ≤ 20 · 1e-10/6, and rounding eps/step ≈ 2e-11 times 243/66.
        CHECK(worst < 5e-10);
    }
}

TEMPLATE_TEST_CASE_SIG("W ends at its support and its slope with it", "[smoothing]", ((int Dim, class Real), Dim, Real),
                       (2, double), (3, double), (2, float), (3, float)) {
    for (const SmoothingFunction function : all_functions) {
        const Smoothing<Dim> w(function);
        CHECK(w.support == (function == SmoothingFunction::quintic_spline ? 3 : 2));
        for (const double beyond : {0.0, 2e-7, 1.0, 1e4, 1e30}) {
            const Real q = static_cast<Real>(w.support + beyond);
            CHECK(w.shape(q) == 0);
            CHECK(w.reduced_slope(q) == 0);
        }
        CHECK(w.shape(Real(0.95 * w.support)) > 0);
        CHECK(slope<Dim>(w, 1.0) < 0);
    }
}

TEMPLATE_TEST_CASE_SIG("no smoothing function lets a particle act on itself", "[smoothing]",
                       ((int Dim, class Real), Dim, Real), (2, double), (3, double), (2, float), (3, float)) {
    for (const SmoothingFunction function : all_functions) {
        const Smoothing<Dim> w(function);
        CHECK(w.reduced_slope(Real(0)) == 0);
    }
}

TEMPLATE_TEST_CASE_SIG("the scale is sigma over h^Dim", "[smoothing]", ((int Dim), Dim), 2, 3) {
    for (const SmoothingFunction function : all_functions) {
        const Smoothing<Dim> w(function);
        for (const double h : {1e-3, 0.7, 12.0}) {  // two or three products: a few units in the last place
            CHECK(w.scale(1 / h) * std::pow(h, Dim) == Approx(w.sigma).epsilon(1e-15));
            CHECK(w(0.3 * h, h) == Approx(w.sigma / std::pow(h, Dim) * w.shape(0.3)).epsilon(1e-14));
        }
    }
}

TEMPLATE_TEST_CASE_SIG("a lattice sums to one", "[smoothing]", ((int Dim), Dim), 2, 3) {
    Random random(1);
    for (const SmoothingFunction function : all_functions)
        for (const double h_over_d : {1.2, 1.3, 1.5, 1.8, 2.0}) {
            const Smoothing<Dim> w(function);
            double worst = 0;
            const int reach = static_cast<int>(w.support * h_over_d) + 1;
            for (int sample = 0; sample < 20; ++sample) {  // points anywhere between the particles
                const auto at = random.vector<Dim>(0, 1);
                double sum = 0;
                for (int i = -reach; i <= reach; ++i)
                    for (int j = -reach; j <= reach; ++j)
                        for (int k = Dim == 3 ? -reach : 0; k <= (Dim == 3 ? reach : 0); ++k) {
                            Vec<Dim> x = at;
                            x[0] -= i;
                            x[1] -= j;
                            if (Dim == 3) x[Dim - 1] -= k;
                            sum += w(norm(x), h_over_d);
                        }
                worst = std::max(worst, std::abs(sum - 1));
            }
            CAPTURE(static_cast<int>(function), h_over_d, worst);
            // The kernel's transform at the lattice's shortest wave number, 2·Dim of them. A spline's oscillates and
            // decays like (h/d)^-4 or faster; Wendland's functions are narrower for the same support, and need more.
            const bool wendland =
                function == SmoothingFunction::wendland_c2 || function == SmoothingFunction::wendland_c4;
            const double bound = wendland ? (function == SmoothingFunction::wendland_c4 ? 0.25 : 0.06) : 0.02;
            CHECK(worst < bound * std::pow(1.2 / h_over_d, 2));
        }
}

}  // namespace sluice::test_smoothing
