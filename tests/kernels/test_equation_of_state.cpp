// The equations of state and their energy.
#include "kernels/materials/equation_of_state.hpp"
#include "tests/catch.hpp"

namespace sluice::test_equation_of_state {

namespace {

/// Water and rubber, linear; Tait's with water's γ, with that of a gas, and between the two.
const EquationOfState equations[] = {
    {1000, 30}, {1100, 134.8}, EquationOfState::tait(1000, 30), {1000, 30, 1.4}, {1000, 30, 3}};

/// Density carries a rounding of ρ0 eps, which c² magnifies: ρ · 1.1e-16 · c², twice.
double pressure_rounding(const EquationOfState& eos, double rho) {
    const double c = eos.sound_speed_at(rho);
    return 4.5e-16 * rho * c * c;
}

}  // namespace

TEST_CASE("pressure and density invert each other", "[equation_of_state]") {
    for (const EquationOfState& eos : equations) {
        CHECK(eos.pressure(eos.density) == 0);
        CHECK(eos.density_at(0) == eos.density);
        for (const double p : {-2e4, -1.0, 1e-3, 1400.0, 1e6}) {
            const double rho = eos.density_at(p);
            CAPTURE(eos.density, eos.exponent, p);
            CHECK(eos.pressure(rho) == Approx(p).margin(pressure_rounding(eos, rho)).epsilon(2e-15));
        }
    }
}

TEST_CASE("linear pressure grows with c0 squared per density", "[equation_of_state]") {
    const LinearEquationOfState eos{1000, 30};
    CHECK(eos.pressure(1001) == 900);  // small whole numbers: exact
    CHECK(eos.pressure(998) == -1800);
}

TEST_CASE("Tait's equation has its printed form", "[equation_of_state]") {
    for (const double gamma : {7.0, 1.4, 3.0, 6.5})
        for (const double rho : {500.0, 930.0, 999.9, 1000.0, 1003.0, 1400.0}) {
            const EquationOfState eos = EquationOfState::tait(1000, 30, gamma);
            const double stiffness = 1000 * 30 * 30 / gamma, power = std::pow(rho / 1000, gamma);
            CAPTURE(gamma, rho);
            // The printed form rounds (ρ/ρ0)^γ to eps, γ roundings of ρ/ρ0 among them, before it takes 1 away.
            CHECK(eos.pressure(rho) == Approx(stiffness * (power - 1)).margin(stiffness * power * 2e-15));
            CHECK(eos.sound_speed_at(rho) == Approx(30 * std::sqrt(power * 1000 / rho)).epsilon(1e-14));
        }
}

TEST_CASE("seven by multiplication is seven by logarithms", "[equation_of_state]") {
    const EquationOfState seven = EquationOfState::tait(1000, 30), nearly = EquationOfState::tait(1000, 30, 7 + 1e-12);
    for (const double rho : {700.0, 990.0, 1000.0 + 1e-6, 1010.0, 1300.0}) {
        CAPTURE(rho);
        // The exponents' difference, times ln(ρ/ρ0) and the like: below 1e-12 of p.
        CHECK(seven.pressure(rho) == Approx(nearly.pressure(rho)).epsilon(3e-12));
    }
}

TEST_CASE("at rest every equation of state has the slope c0 squared", "[equation_of_state]") {
    for (const EquationOfState& eos : equations) {
        const double step = 1e-4 * eos.density, c2 = eos.sound_speed * eos.sound_speed;
        CAPTURE(eos.density, eos.exponent);
        CHECK(eos.sound_speed_at(eos.density) == eos.sound_speed);
        // Central differences: p''' step²/6 = c0² (γ−1)(γ−2) 1e-8/6, 5e-8 for γ = 7.
        CHECK((eos.pressure(eos.density + step) - eos.pressure(eos.density - step)) / (2 * step) ==
              Approx(c2).epsilon(6e-8));
    }
}

TEST_CASE("sound travels at the root of the pressure's slope", "[equation_of_state]") {
    for (const EquationOfState& eos : equations)
        for (const double x : {0.8, 0.99, 1.02, 1.3}) {
            const double rho = x * eos.density, step = 1e-4 * rho, c = eos.sound_speed_at(rho);
            CAPTURE(eos.density, eos.exponent, x);
            // As above, with some roundings of p/step.
            CHECK((eos.pressure(rho + step) - eos.pressure(rho - step)) / (2 * step) == Approx(c * c).epsilon(6e-8));
        }
}

TEST_CASE("the energy's derivative is p over rho squared", "[equation_of_state]") {
    for (const EquationOfState& eos : equations) {
        CHECK(eos.energy(eos.density) == 0);
        for (const double x : {0.7, 0.95, 0.999, 1.001, 1.02, 1.5}) {
            const double rho = x * eos.density, step = 1e-3 * rho;
            const double slope = (eos.energy(rho - 2 * step) - 8 * eos.energy(rho - step) + 8 * eos.energy(rho + step) -
                                  eos.energy(rho + 2 * step)) /
                                 (12 * step);
            const double c0 = eos.sound_speed, c = eos.sound_speed_at(rho), stiffest = c0 * c0 + c * c;
            CAPTURE(eos.density, eos.exponent, x);
            // Fourth-order differences: e⁽⁵⁾ step⁴/30 ≤ c²/ρ · 120 · 1e-12/30, and rounding of c0² 1e-16/step.
            CHECK(slope == Approx(eos.pressure(rho) / (rho * rho)).margin(stiffest / rho * (4e-12 + 1e-12)));
            CHECK(eos.energy(rho) > 0);
        }
    }
}

TEST_CASE("near rest the energy is that of a spring, without cancellation", "[equation_of_state]") {
    for (const EquationOfState& eos : equations)
        for (const double x : {1e-3, 1e-6}) {
            const double rho = eos.density * (1 + x), c2 = eos.sound_speed * eos.sound_speed;
            CAPTURE(eos.density, eos.exponent, x);
            // c0² (x²/2 + (γ − 5) x³/6 + …): the next term is at most 4x/3 of the first; the two parts cancel to eps/x.
            CHECK(eos.energy(rho) == Approx(0.5 * c2 * x * x).epsilon(2 * x + 1e-15 / x));
        }
}

}  // namespace sluice::test_equation_of_state
