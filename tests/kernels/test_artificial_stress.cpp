// Artificial stress: the correction of a tensor against its eigenvalues, and the pair term's power.
#include <Eigen/Geometry>

#include "kernels/materials/tensile_correction.hpp"
#include "kernels/principal.hpp"
#include "kernels/smoothing.hpp"
#include "kernels/terms/artificial_stress.hpp"
#include "tests/catch.hpp"
#include "tests/kernels/twins.hpp"

namespace sluice::test_artificial_stress {

namespace {

/// Eq. (14) read literally: find the principal stresses, take −e of the tensile ones, turn back.
template <int Dim>
Tensor<Dim> by_eigenvalues(const Tensor<Dim>& s, double e) {
    Tensor<Dim> r = Tensor<Dim>::Zero();
    const Eigen::Matrix<double, Dim, 1> values = principal_values<Dim>(s);
    for (int k = 0; k < Dim; ++k) {
        const double value = values[k];
        if (value <= 0) continue;
        // The projector on a principal direction is a product over the others, (σ − σ_l I)/(σ_k − σ_l).
        Tensor<Dim> projector = Tensor<Dim>::Identity();
        for (int l = 0; l < Dim; ++l)
            if (l != k)
                projector = projector * (s - values[l] * Tensor<Dim>::Identity()) /
                            (value - values[l]);
        r -= e * value * projector;
    }
    return r;
}

template <int Dim>
Vec<sym_components<Dim>> random_stress(Random& random) {
    return random.vector<sym_components<Dim>>(-1, 1);
}

template <int Dim>
Tensor<Dim> corrected(const Tensor<Dim>& s, double e) {
    return sym_to_tensor<Dim>(tensile_correction(tensor_to_sym<Dim>(s), e));
}

template <int Dim>
Tensor<Dim> random_rotation(Random& random) {
    if constexpr (Dim == 2)
        return Eigen::Rotation2Dd(random.in(0, 7)).toRotationMatrix();
    else
        return Eigen::AngleAxisd(random.in(0, 7),
                                 Eigen::Vector3d(random.in(-1, 1), random.in(-1, 1), random.in(0.1, 1)).normalized())
            .toRotationMatrix();
}

/// What the pair term reads, with a tensor that lets f^q through.
struct UnitPair {
    using Real = double;
    using Tensor = Vec<3>;
    double w;
    double shape() const { return w; }
    Tensor i(ColumnTag<Column::artificial_stress>) const { return {{1, 1, 0}}; }
    Tensor j(ColumnTag<Column::artificial_stress>) const { return {}; }
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("the correction is −e times the tensile part of the stress", "[artificial_stress]",
                       ((int Dim), Dim), 2, 3) {
    Random random(1);
    double worst = 0;
    int mixed = 0;
    for (int n = 0; n < 2000; ++n) {
        const Tensor<Dim> s = sym_to_tensor<Dim>(random_stress<Dim>(random));
        const auto values = principal_values<Dim>(s);
        double gap = values[Dim - 1] - values[0];
        for (int k = 1; k < Dim; ++k) gap = std::min(gap, values[k] - values[k - 1]);
        if (gap < 1e-2) continue;  // the twin divides by gaps, twice in 3D
        mixed += values[0] < 0 && values[Dim - 1] > 0;
        worst = std::max(worst, (corrected<Dim>(s, 0.3) - by_eigenvalues<Dim>(s, 0.3)).norm());
    }
    CHECK(mixed > 500);
    CHECK(worst < 1e-12);  // rounding over the squared gap: 1e-16/1e-4
}

TEMPLATE_TEST_CASE_SIG("compression is left alone", "[artificial_stress]", ((int Dim), Dim), 2, 3) {
    Random random(2);
    for (int n = 0; n < 200; ++n) {
        const Tensor<Dim> a = sym_to_tensor<Dim>(random_stress<Dim>(random));
        const Tensor<Dim> s = -a * a.transpose() - 1e-3 * Tensor<Dim>::Identity();
        REQUIRE(corrected<Dim>(s, 0.3) == Tensor<Dim>::Zero());
    }
    CHECK(corrected<Dim>(Tensor<Dim>::Zero(), 0.3) == Tensor<Dim>::Zero());
}

TEMPLATE_TEST_CASE_SIG("isotropic tension gives an isotropic correction", "[artificial_stress]", ((int Dim), Dim), 2,
                       3) {
    const Tensor<Dim> s = 5 * Tensor<Dim>::Identity();
    CHECK((corrected<Dim>(s, 0.3) + 1.5 * Tensor<Dim>::Identity()).norm() < 1e-15);  // one product
    CHECK(corrected<Dim>(-s, 0.3) == Tensor<Dim>::Zero());
    // Next to isotropic the directions are arbitrary, the result is not: eps · 5 from the eigenvalues.
    Tensor<Dim> nearly = s;
    nearly(0, 1) = nearly(1, 0) = 1e-15;
    CHECK((corrected<Dim>(nearly, 0.3) + 1.5 * Tensor<Dim>::Identity()).norm() < 1e-14);
}

TEMPLATE_TEST_CASE_SIG("uniaxial stress is corrected along its axis only", "[artificial_stress]", ((int Dim), Dim), 2,
                       3) {
    for (const double sigma : {2.0, -2.0})
        for (int axis = 0; axis < Dim; ++axis) {
            Tensor<Dim> s = Tensor<Dim>::Zero(), expected = Tensor<Dim>::Zero();
            s(axis, axis) = sigma;
            expected(axis, axis) = sigma > 0 ? -0.3 * sigma : 0;
            CHECK((corrected<Dim>(s, 0.3) - expected).norm() < 1e-15);  // a few roundings of 0.6
        }
}

TEMPLATE_TEST_CASE_SIG("the correction turns with the frame", "[artificial_stress]", ((int Dim), Dim), 2, 3) {
    Random random(3);
    double worst = 0;
    for (int n = 0; n < 500; ++n) {
        const Tensor<Dim> s = sym_to_tensor<Dim>(random_stress<Dim>(random)), q = random_rotation<Dim>(random);
        const Tensor<Dim> there = q * s * q.transpose();
        const Tensor<Dim> symmetric = 0.5 * (there + there.transpose());
        worst = std::max(worst, (corrected<Dim>(symmetric, 0.3) - q * corrected<Dim>(s, 0.3) * q.transpose()).norm());
    }
    CHECK(worst < 1e-14);  // two rotations and an eigensolver, each good to a few eps
}

TEST_CASE("f is raised to the q-th power", "[artificial_stress]") {
    const double h_over_d = 1.5;
    for (int q = 1; q <= 15; ++q) {
        const auto term = ArtificialStress::with<2>({}, h_over_d, q);
        for (const double r_over_h : {0.1, 1 / h_over_d, 1.3}) {
            const double f = twin::w(2, r_over_h, 1) / twin::w(2, 1 / h_over_d, 1);
            CAPTURE(q, r_over_h);
            // q ≤ 15 products of roundings 1e-16 each, on either side; w itself is good to 1e-15.
            CHECK(term(UnitPair{CubicSpline<2>::shape(r_over_h)})[0] == Approx(std::pow(f, q)).epsilon(2e-14));
        }
    }
}

TEST_CASE("f is one at the initial spacing", "[artificial_stress]") {
    for (const double h_over_d : {1.2, 1.5, 2.0})
        CHECK(ArtificialStress::with<2>({}, h_over_d, 4)(UnitPair{CubicSpline<2>::shape(1 / h_over_d)})[0] ==
              Approx(1).epsilon(1e-15));
}

}  // namespace sluice::test_artificial_stress
