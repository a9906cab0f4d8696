// The smoothing function: its form, integral, slope and support.
#include <numbers>

#include "kernels/smoothing.hpp"
#include "tests/catch.hpp"
#include "tests/kernels/twins.hpp"

using namespace sluice;

TEMPLATE_TEST_CASE_SIG("the cubic spline is the paper's", "[smoothing]", ((int Dim), Dim), 2, 3) {
    using W = CubicSpline<Dim>;
    double worst_shape = 0, worst_slope = 0;
    for (int n = 0; n <= 3000; ++n) {
        const double q = n * 1e-3, scale = W::sigma;
        worst_shape = std::max(worst_shape, std::abs(scale * W::shape(q) - twin::w(Dim, q, 1)));
        worst_slope = std::max(worst_slope, std::abs(scale * W::slope(q) - twin::dw_dr(Dim, q, 1)));
    }
    CHECK(worst_shape < 4e-16);  // values up to 1 from a handful of roundings, of which the first powers are up to 2
    CHECK(worst_slope < 1e-15);  // the same with powers up to 3
}

TEMPLATE_TEST_CASE_SIG("W integrates to one", "[smoothing]", ((int Dim), Dim), 2, 3) {
    using W = CubicSpline<Dim>;
    const int n = 2000;  // even in [0, 1] and [1, 2] each
    double integral = 0;
    for (int i = 0; i < n; ++i) {  // Simpson's rule per interval of q
        const double a = 2.0 * i / n, b = 2.0 * (i + 1) / n;
        const auto f = [](double q) {
            return W::shape(q) * (Dim == 2 ? 2 * std::numbers::pi * q : 4 * std::numbers::pi * q * q);
        };
        integral += (b - a) / 6 * (f(a) + 4 * f(0.5 * (a + b)) + f(b));
    }
    // Simpson's error is (b−a)^4/2880 · |f''''| ≈ 1e-12/2880 · 400 per unit of q: below 1e-12.
    CHECK(W::sigma * integral == Approx(1).margin(1e-12));
}

TEMPLATE_TEST_CASE_SIG("slope is the derivative of shape", "[smoothing]", ((int Dim), Dim), 2, 3) {
    using W = CubicSpline<Dim>;
    double worst = 0;
    const double step = 1e-5;
    for (double q = step; q < 2.5; q += 0.00917)
        worst = std::max(worst, std::abs((W::shape(q + step) - W::shape(q - step)) / (2 * step) - W::slope(q)));
    // Central differences: w''' step²/6 ≤ 4.5 · 1e-10/6, and rounding eps/step ≈ 2e-11.
    CHECK(worst < 2e-10);
}

TEMPLATE_TEST_CASE_SIG("the slope is its constant times the reduced slope", "[smoothing]", ((int Dim), Dim), 2, 3) {
    using W = CubicSpline<Dim>;
    for (int n = 0; n <= 300; ++n) {
        const double q = 0.01 * n;
        CHECK(W::slope(q) == W::slope_scale * W::reduced_slope(q));
        CHECK(W::sigma * W::slope_scale * W::reduced_slope(q) == Approx(twin::dw_dr(Dim, q, 1)).margin(1e-15));
    }
    CHECK(W::reduced_slope(0.0) == 0);  // what keeps a particle from acting on itself
    CHECK(W::reduced_slope(0.0F) == 0);
}

TEMPLATE_TEST_CASE_SIG("W ends at 2h and its slope with it", "[smoothing]", ((int Dim, class Real), Dim, Real),
                       (2, double), (3, double), (2, float), (3, float)) {
    using W = CubicSpline<Dim>;
    CHECK(W::support == 2);
    for (const double q : {2.0, 2.0000002, 3.0, 1e4, 1e30}) {
        CHECK(W::shape(static_cast<Real>(q)) == 0);
        CHECK(W::slope(static_cast<Real>(q)) == 0);
    }
    CHECK(W::shape(Real(1.99)) > 0);
    CHECK(W::shape(Real(0)) == 1);
    CHECK(W::slope(Real(0)) == 0);
    CHECK(W::shape(Real(1)) == Real(0.25));
    CHECK(W::slope(Real(1)) == Real(-0.75));
}

TEMPLATE_TEST_CASE_SIG("kernel_scale is sigma over h^Dim", "[smoothing]", ((int Dim), Dim), 2, 3) {
    for (const double h : {1e-3, 0.7, 12.0})  // two or three products: a few units in the last place
        CHECK(kernel_scale<CubicSpline<Dim>, Dim>(1 / h) * std::pow(h, Dim) ==
              Approx(CubicSpline<Dim>::sigma).epsilon(1e-15));
}

TEMPLATE_TEST_CASE_SIG("a lattice sums to one", "[smoothing]", ((int Dim), Dim), 2, 3) {
    Random random(1);
    for (const double h_over_d : {1.2, 1.3, 1.5, 1.8, 2.0}) {
        double worst = 0;
        for (int sample = 0; sample < 50; ++sample) {  // points anywhere between the particles
            const auto at = random.vector<Dim>(0, 1);
            double sum = 0;
            for (int i = -5; i <= 5; ++i)
                for (int j = -5; j <= 5; ++j)
                    for (int k = Dim == 3 ? -5 : 0; k <= (Dim == 3 ? 5 : 0); ++k) {
                        Vec<Dim> x = at;
                        x[0] -= i;
                        x[1] -= j;
                        if (Dim == 3) x[Dim - 1] -= k;
                        sum += kernel_scale<CubicSpline<Dim>, Dim>(1 / h_over_d) *
                               CubicSpline<Dim>::shape(norm(x) / h_over_d);
                    }
            worst = std::max(worst, std::abs(sum - 1));
        }
        CAPTURE(h_over_d, worst);
        // The kernel's transform at the lattice's shortest wave number, 2·Dim of them, decays like (h/d)^-4 and
        // oscillates; the largest error is that of the narrowest kernel.
        CHECK(worst < (h_over_d < 1.5 ? 0.02 : 0.01));
    }
}
