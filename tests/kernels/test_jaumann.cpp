// Hypoelastic stress with the Jaumann rate: rotation, translation, shear, and what plane strain leaves out.
#include <Eigen/Geometry>
#include <numbers>

#include "kernels/materials/jaumann.hpp"
#include "kernels/principal.hpp"
#include "tests/catch.hpp"
#include "tests/neighbor/clouds.hpp"

namespace sluice::test_jaumann {

namespace {

template <int Dim>
Tensor<Dim> random_tensor(Random& random, double size) {
    Tensor<Dim> t;
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j) t(i, j) = random.in(-size, size);
    return t;
}

/// Symmetric; traceless in 3D. In 2D any trace is that of plane strain.
template <int Dim>
Tensor<Dim> random_deviator(Random& random) {
    const Tensor<Dim> t = random_tensor<Dim>(random, 1e5);
    Tensor<Dim> s = 0.5 * (t + t.transpose());
    if (Dim == 3) s -= s.trace() / 3 * Tensor<Dim>::Identity();
    return s;
}

/// The velocity gradient of a spin ω about z (2D) or an oblique axis (3D).
template <int Dim>
Tensor<Dim> spin(double omega) {
    Tensor<Dim> l = Tensor<Dim>::Zero();
    if constexpr (Dim == 2) {
        l << 0, -omega, omega, 0;
    } else {
        const Eigen::Vector3d a = omega * Eigen::Vector3d(1, 2, -2) / 3;
        l << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
    }
    return l;
}

/// The rotation by an angle about the same axis.
template <int Dim>
Tensor<Dim> rotation(double angle) {
    if constexpr (Dim == 2)
        return Eigen::Rotation2Dd(angle).toRotationMatrix();
    else
        return Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, -2) / 3).toRotationMatrix();
}

constexpr double shear_modulus = 4.27e6;

}  // namespace

TEMPLATE_TEST_CASE_SIG("a spin of any step keeps the principal stresses", "[jaumann]", ((int Dim), Dim), 2, 3) {
    Random random(1);
    for (const double turn_per_step : {1e-6, 0.01, 0.5, 2.0, 50.0}) {  // ω Δt
        const Tensor<Dim> before = random_deviator<Dim>(random);
        Tensor<Dim> s = before;
        for (int n = 0; n < 1000; ++n)
            s = advance_deviatoric_stress<Dim>(s, spin<Dim>(turn_per_step / 0.1), shear_modulus, 0.1);
        CAPTURE(turn_per_step);
        // A thousand products of matrices that are orthogonal to 2e-16 each.
        CHECK((principal_values<Dim>(s) - principal_values<Dim>(before)).norm() < 1e-12 * before.norm());
        CHECK((s - s.transpose()).norm() < 1e-12 * before.norm());
    }
}

TEMPLATE_TEST_CASE_SIG("a full turn brings the stress back in the frame that turns with the body", "[jaumann]",
                       ((int Dim), Dim), 2, 3) {
    Random random(2);
    const Tensor<Dim> before = random_deviator<Dim>(random);
    const int steps = 100;
    // The midpoint rule turns by 2 atan(ωΔt/2): with this ω Δt exactly 2π after all steps.
    const double per_step = 2 * std::tan(std::numbers::pi / steps);
    Tensor<Dim> s = before;
    for (int n = 1; n <= steps; ++n) {
        s = advance_deviatoric_stress<Dim>(s, spin<Dim>(per_step), shear_modulus, 1.0);
        const Tensor<Dim> q = rotation<Dim>(2 * std::numbers::pi * n / steps);
        REQUIRE((q.transpose() * s * q - before).norm() < 1e-13 * before.norm());  // up to 100 rotations of 2e-16 each
    }
    CHECK((s - before).norm() < 1e-13 * before.norm());
}

TEMPLATE_TEST_CASE_SIG("the angle of rotation is second order in the step", "[jaumann]", ((int Dim), Dim), 2, 3) {
    Random random(3);
    const Tensor<Dim> before = random_deviator<Dim>(random);
    const double angle = 2;
    const Tensor<Dim> q = rotation<Dim>(angle);
    const Tensor<Dim> exact = q * before * q.transpose();
    double last = 0;
    for (const int steps : {10, 20, 40, 80}) {
        Tensor<Dim> s = before;
        for (int n = 0; n < steps; ++n)
            s = advance_deviatoric_stress<Dim>(s, spin<Dim>(angle), shear_modulus, 1.0 / steps);
        const double error = (s - exact).norm() / exact.norm();
        CAPTURE(steps, error);
        // Angle error φ³/(12 N²), which turns the stress by as much, twice at the most.
        CHECK(error < 2.1 * angle * angle * angle / (12 * steps * steps));
        if (last > 0) CHECK(last / error == Approx(4).epsilon(0.03));  // the next order is N⁻⁴: 1/400 · φ² at N = 10
        last = error;
    }
}

TEMPLATE_TEST_CASE_SIG("the stress turns the way the body does", "[jaumann]", ((int Dim), Dim), 2, 3) {
    Tensor<Dim> s = Tensor<Dim>::Zero();
    s(0, 0) = 1e5;
    s(1, 1) = -1e5;
    // Anticlockwise by a little: tension along x tilts towards +y, S_xy > 0.
    Tensor<Dim> l = Tensor<Dim>::Zero();
    l(0, 1) = -1;
    l(1, 0) = 1;
    const Tensor<Dim> turned = advance_deviatoric_stress<Dim>(s, l, shear_modulus, 0.01);
    CHECK(turned(0, 1) == Approx(2e5 * 0.01).epsilon(1e-3));  // sin(2·0.01)·10⁵: third order in the angle
}

TEMPLATE_TEST_CASE_SIG("translation and a uniform velocity give nothing", "[jaumann]", ((int Dim), Dim), 2, 3) {
    Random random(4);
    const Tensor<Dim> s = random_deviator<Dim>(random);
    CHECK(advance_deviatoric_stress<Dim>(s, Tensor<Dim>::Zero(), shear_modulus, 0.1) == s);
}

TEMPLATE_TEST_CASE_SIG("a small shear gives twice the shear modulus times the strain", "[jaumann]", ((int Dim), Dim), 2,
                       3) {
    Tensor<Dim> l = Tensor<Dim>::Zero();
    l(0, 1) = 3;  // dv_x/dy: D_xy = 1.5
    const double dt = 1e-5;
    const Tensor<Dim> s = advance_deviatoric_stress<Dim>(Tensor<Dim>::Zero(), l, shear_modulus, dt);
    Tensor<Dim> expected = Tensor<Dim>::Zero();
    expected(0, 1) = expected(1, 0) = 2 * shear_modulus * 1.5 * dt;
    CHECK((s - expected).norm() <= 1e-15 * expected.norm());  // one product in another order

    // From a stressed state the rate is that of eq. (5), written with indices; the midpoint rule adds O(Δt²).
    Random random(5);
    const Tensor<Dim> start = random_deviator<Dim>(random), g = random_tensor<Dim>(random, 2);
    const Tensor<Dim> after = advance_deviatoric_stress<Dim>(start, g, shear_modulus, dt);
    double trace = 0;
    for (int i = 0; i < Dim; ++i) trace += g(i, i);
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j) {
            double rate = 2 * shear_modulus * (0.5 * (g(i, j) + g(j, i)) - (i == j ? trace / 3 : 0));
            for (int k = 0; k < Dim; ++k)
                rate += start(i, k) * 0.5 * (g(j, k) - g(k, j)) + 0.5 * (g(i, k) - g(k, i)) * start(k, j);
            // S ω² Δt per time: 1e5 · (2·2)² · 2 · 1e-5, with rounding of S eps/Δt far below.
            CHECK((after(i, j) - start(i, j)) / dt == Approx(rate).margin(32));
        }
}

TEST_CASE("a deviator stays traceless in space", "[jaumann]") {
    Random random(6);
    Tensor<3> s = random_deviator<3>(random);
    for (int n = 0; n < 100; ++n)
        s = advance_deviatoric_stress<3>(s, random_tensor<3>(random, 10), shear_modulus, 1e-3);
    CHECK(std::abs(s.trace()) < 1e-13 * s.norm());  // a hundred steps of a few roundings each
    CHECK(contract_deviator<3>(s) == Approx((s * s).trace()).epsilon(1e-14));  // nine squares, added in another order
}

TEST_CASE("plane strain is the same as space without motion along z", "[jaumann]") {
    Random random(7);
    Tensor<2> flat = random_deviator<2>(random);
    Tensor<3> full = Tensor<3>::Zero();
    full.topLeftCorner<2, 2>() = flat;
    full(2, 2) = -flat.trace();
    for (int n = 0; n < 50; ++n) {
        const Tensor<2> l2 = random_tensor<2>(random, 10);
        Tensor<3> l3 = Tensor<3>::Zero();
        l3.topLeftCorner<2, 2>() = l2;
        flat = advance_deviatoric_stress<2>(flat, l2, shear_modulus, 1e-2);
        full = advance_deviatoric_stress<3>(full, l3, shear_modulus, 1e-2);
        // Two ways to invert a matrix, fifty times over.
        REQUIRE((full.topLeftCorner<2, 2>() - flat).norm() < 1e-13 * full.norm());
        REQUIRE(std::abs(full(2, 2) + flat.trace()) < 1e-13 * full.norm());
        REQUIRE(std::abs(full(0, 2)) + std::abs(full(1, 2)) < 1e-13 * full.norm());
        REQUIRE(contract_deviator<2>(flat) == Approx(contract_deviator<3>(full)).epsilon(1e-12));
    }
}

}  // namespace sluice::test_jaumann
