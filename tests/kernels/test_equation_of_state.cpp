// The linear equation of state and its energy.
#include "kernels/terms/equation_of_state.hpp"
#include "tests/catch.hpp"

using namespace sluice;

TEST_CASE("pressure and density invert each other", "[equation_of_state]") {
    for (const LinearEquationOfState eos : {LinearEquationOfState{1000, 30}, LinearEquationOfState{1100, 134.8}}) {
        CHECK(eos.pressure(eos.density) == 0);
        CHECK(eos.density_at(0) == eos.density);
        for (const double p : {-2e4, -1.0, 1e-3, 1400.0, 1e6}) {
            CAPTURE(eos.density, p);
            // ρ carries a rounding of ρ0 eps, which c0² magnifies: 1000 · 1.1e-16 · c0².
            const double rounding = 2.3e-16 * (eos.density + std::abs(p) / (eos.sound_speed * eos.sound_speed)) *
                                    eos.sound_speed * eos.sound_speed;
            CHECK(eos.pressure(eos.density_at(p)) == Approx(p).margin(2 * rounding).epsilon(1e-15));
        }
    }
}

TEST_CASE("pressure grows with c0 squared per density", "[equation_of_state]") {
    const LinearEquationOfState eos{1000, 30};
    CHECK(eos.pressure(1001) == 900);  // small whole numbers: exact
    CHECK(eos.pressure(998) == -1800);
}

TEST_CASE("the energy's derivative is p over rho squared", "[equation_of_state]") {
    const LinearEquationOfState eos{1000, 30};
    CHECK(eos.energy(eos.density) == 0);
    for (const double rho : {700.0, 950.0, 999.0, 1001.0, 1020.0, 1500.0}) {
        const double step = 1e-3 * rho;
        const double slope = (eos.energy(rho - 2 * step) - 8 * eos.energy(rho - step) + 8 * eos.energy(rho + step) -
                              eos.energy(rho + 2 * step)) /
                             (12 * step);
        CAPTURE(rho);
        // Fourth-order differences: e⁽⁵⁾ step⁴/30 ≈ c0²/ρ · 24 · 1e-12/30, and rounding of c0² 1e-16/step ≈ 1e-13.
        CHECK(slope == Approx(eos.pressure(rho) / (rho * rho)).margin(30 * 30 / rho * 1e-11 + 1e-12));
        CHECK(eos.energy(rho) > 0);
    }
}

TEST_CASE("near rest the energy is that of a spring, without cancellation", "[equation_of_state]") {
    const LinearEquationOfState eos{1000, 30};
    for (const double x : {1e-3, 1e-6}) {
        const double rho = eos.density * (1 + x);
        // c0² (x²/2 − 2x³/3 + …): the next term is 4x/3 of the first; log1p and x/(1+x) cancel to eps/x.
        CHECK(eos.energy(rho) == Approx(0.5 * 900 * x * x).epsilon(2 * x + 1e-15 / x));
    }
}
