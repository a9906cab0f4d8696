// Hyperelastic laws: stress against energy, rotations, small strains, plane strain, and what happens inside out.
#include "kernels/materials/hyperelastic.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "tests/catch.hpp"
#include "tests/neighbor/clouds.hpp"

namespace sluice::test_hyperelastic {

namespace {

constexpr double young_modulus = 12e6, poisson_ratio = 0.4;

constexpr std::array laws = all_elastic_laws;

Hyperelastic rubber(ElasticLaw law) { return Hyperelastic::with(law, young_modulus, poisson_ratio); }

template <int Dim>
Tensor<Dim> random_tensor(Random& random, double size) {
    Tensor<Dim> t;
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j) t(i, j) = random.in(-size, size);
    return t;
}

/// I plus a random part; now and then with a negative determinant.
template <int Dim>
Tensor<Dim> random_deformation(Random& random, double size) {
    return Tensor<Dim>::Identity() + random_tensor<Dim>(random, size);
}

template <int Dim>
Tensor<Dim> random_rotation(Random& random) {
    if constexpr (Dim == 2)
        return Eigen::Rotation2Dd(random.in(-4, 4)).toRotationMatrix();
    else
        return Eigen::AngleAxisd(random.in(-4, 4), Eigen::Vector3d(random.in(-1, 1), 1, random.in(-1, 1)).normalized())
            .toRotationMatrix();
}

/// dψ/dF by central differences of fourth order.
template <int Dim>
Tensor<Dim> differentiated_energy(const Hyperelastic& material, const Tensor<Dim>& f, double step) {
    Tensor<Dim> p;
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j) {
            const auto psi = [&](double steps) {
                Tensor<Dim> moved = f;
                moved(i, j) += steps * step;
                return material.energy_density<Dim>(moved);
            };
            p(i, j) = (8 * (psi(1) - psi(-1)) - (psi(2) - psi(-2))) / (12 * step);
        }
    return p;
}

/// F stretched along x only, to the volume J.
template <int Dim>
Tensor<Dim> compressed(double j) {
    Tensor<Dim> f = Tensor<Dim>::Identity();
    f(0, 0) = j;
    return f;
}

}  // namespace

TEST_CASE("Young's modulus and Poisson's ratio give Lamé's constants", "[hyperelastic]") {
    const Hyperelastic material = rubber(ElasticLaw::neo_hookean);
    // Textbook relations, a few roundings.
    CHECK(material.mu == Approx(12e6 / 2.8).epsilon(1e-14));
    CHECK(material.lambda == Approx(12e6 * 0.4 / (1.4 * 0.2)).epsilon(1e-14));
    CHECK(material.young_modulus() == Approx(young_modulus).epsilon(1e-14));
    CHECK(material.wave_modulus() == Approx(12e6 * 0.6 / (1.4 * 0.2)).epsilon(1e-14));
}

TEMPLATE_TEST_CASE_SIG("the cofactor is that of the inverse", "[hyperelastic]", ((int Dim), Dim), 2, 3) {
    Random random(1);
    for (int n = 0; n < 100; ++n) {
        const Tensor<Dim> f = random_tensor<Dim>(random, 2);
        const Tensor<Dim> product = f.transpose() * cofactor(f);
        // cof F = det(F) F⁻ᵀ: products of three numbers up to 2.
        CHECK((product - f.determinant() * Tensor<Dim>::Identity()).norm() < 1e-14 * 24);
        CHECK(volume_change<Dim>(f - Tensor<Dim>::Identity()) == Approx(f.determinant() - 1).margin(1e-14 * 24));
    }
}

TEMPLATE_TEST_CASE_SIG("the stress is the derivative of the energy", "[hyperelastic]", ((int Dim), Dim), 2, 3) {
    for (const ElasticLaw law : laws) {
        const Hyperelastic material = rubber(law);
        Random random(2);
        int inverted = 0, expanded = 0;
        for (int n = 0; n < 300; ++n) {
            const Tensor<Dim> f = random_deformation<Dim>(random, n < 100 ? 0.1 : 1.5);
            const double j = f.determinant();
            if (std::abs(j - Hyperelastic::expansion_volume) < 0.02) continue;  // g'' is not smooth across J0
            inverted += j < 0;
            expanded += j > Hyperelastic::expansion_volume;
            const Tensor<Dim> p = material.first_piola_stress<Dim>(f);
            CAPTURE(static_cast<int>(law), j);
            // Fourth order: s⁴/30 · 4!/J⁵ |cof F|⁵ ≤ 1e-9 for a step s of 2e-4, J ≥ 0.3 and |cof F| ≤ 5; ψ rounded by
            // 1e-16 over the step is less.
            CHECK((p - differentiated_energy<Dim>(material, f, 2e-4)).norm() < 1e-9 * (p.norm() + young_modulus));
        }
        CHECK(inverted > 20);
        CHECK(expanded > 50);
    }
}

TEMPLATE_TEST_CASE_SIG("a rotation turns the stress and leaves the energy", "[hyperelastic]", ((int Dim), Dim), 2, 3) {
    for (const ElasticLaw law : laws) {
        const Hyperelastic material = rubber(law);
        Random random(3);
        for (int n = 0; n < 100; ++n) {
            const Tensor<Dim> f = random_deformation<Dim>(random, 1), q = random_rotation<Dim>(random);
            const Tensor<Dim> p = material.first_piola_stress<Dim>(f);
            const double psi = material.energy_density<Dim>(f);
            CAPTURE(static_cast<int>(law), f.determinant());
            // A few dozen roundings of E F³.
            CHECK((material.first_piola_stress<Dim>(q * f) - q * p).norm() < 1e-13 * (p.norm() + young_modulus));
            CHECK(material.energy_density<Dim>(q * f) == Approx(psi).margin(1e-13 * (psi + young_modulus)));
            // Isotropy: the same from the right.
            CHECK((material.first_piola_stress<Dim>(f * q) - p * q).norm() < 1e-13 * (p.norm() + young_modulus));
            // σ J = P Fᵀ is symmetric: no torque.
            const Tensor<Dim> kirchhoff = p * f.transpose();
            CHECK((kirchhoff - kirchhoff.transpose()).norm() < 1e-13 * (kirchhoff.norm() + young_modulus));
        }
    }
}

TEMPLATE_TEST_CASE_SIG("small strains are Hooke's", "[hyperelastic]", ((int Dim), Dim), 2, 3) {
    for (const ElasticLaw law : laws) {
        const Hyperelastic material = rubber(law);
        Random random(4);
        for (int n = 0; n < 20; ++n) {
            const Tensor<Dim> h = random_tensor<Dim>(random, 1), e = 0.5 * (h + h.transpose());
            const Tensor<Dim> hooke = material.lambda * e.trace() * Tensor<Dim>::Identity() + 2 * material.mu * e;
            double last = 0;
            for (const double size : {1e-2, 1e-3, 1e-4}) {
                const Tensor<Dim> p = material.first_piola_stress<Dim>(Tensor<Dim>::Identity() + size * h) / size;
                const double error = (p - hooke).norm() / hooke.norm();
                CAPTURE(static_cast<int>(law), size, error);
                // First order in the strain: ten times less each time, but for the next order, some per cent at 1e-2.
                if (last > 0) CHECK(last / error == Approx(10).epsilon(0.2));
                last = error;
            }
            // ψ = ½ ε:σ at a strain of 1e-6, exact to the strain itself: no digits are lost in ψ ~ 1e-12 E. F holds the
            // strain to 1e-16/1e-6.
            const double psi = material.energy_density<Dim>(Tensor<Dim>::Identity() + 1e-6 * h) / 1e-12;
            CHECK(psi == Approx(0.5 * (hooke.array() * e.array()).sum()).epsilon(2e-5));
        }
    }
}

TEST_CASE("plane strain is the same as space with a thickness that stays", "[hyperelastic]") {
    for (const ElasticLaw law : laws) {
        const Hyperelastic material = rubber(law);
        Random random(5);
        for (int n = 0; n < 100; ++n) {
            const Tensor<2> flat = random_deformation<2>(random, 0.8);
            Tensor<3> full = Tensor<3>::Identity();
            full.topLeftCorner<2, 2>() = flat;
            const Tensor<2> p2 = material.first_piola_stress<2>(flat);
            const Tensor<3> p3 = material.first_piola_stress<3>(full);
            CAPTURE(static_cast<int>(law), flat.determinant());
            // The same sums with a few zeros and a one more.
            CHECK((p3.topLeftCorner<2, 2>() - p2).norm() < 1e-13 * (p3.norm() + young_modulus));
            CHECK(std::abs(p3(0, 2)) + std::abs(p3(1, 2)) + std::abs(p3(2, 0)) + std::abs(p3(2, 1)) == 0);
            CHECK(material.energy_density<3>(full) ==
                  Approx(material.energy_density<2>(flat)).margin(1e-13 * young_modulus));
            CHECK(cauchy_stress<2>(material, flat) == cauchy_stress<3>(material, full));
        }
    }
}

TEST_CASE("the Cauchy stress of simple deformations", "[hyperelastic]") {
    const double s = 1.2, e = 0.5 * (s * s - 1);
    for (const ElasticLaw law : laws) {
        const Hyperelastic m = rubber(law);
        // Stretch along x with the sides held: σ_xx = P_xx and σ_yy = σ_zz = P_yy/s by the laws' own formulas.
        const bool svk = law == ElasticLaw::saint_venant_kirchhoff;
        const double along = svk ? s * (m.lambda + 2 * m.mu) * e : m.mu * (s - 1 / s) + m.lambda * std::log(s) / s;
        const double across = (svk ? m.lambda * e : m.lambda * std::log(s)) / s;
        const Tensor<3> in_plane = cauchy_stress<2>(m, compressed<2>(s)),
                        in_space = cauchy_stress<3>(m, compressed<3>(s));
        Tensor<3> expected = Tensor<3>::Zero();
        expected.diagonal() << along, across, across;
        // Hand-made formulas in another order.
        CHECK((in_plane - expected).norm() < 1e-14 * expected.norm() * 10);
        CHECK((in_space - expected).norm() < 1e-14 * expected.norm() * 10);
        CHECK(von_mises_stress(in_plane) == Approx(std::abs(along - across)).epsilon(1e-13));
    }
    Tensor<3> shear = Tensor<3>::Zero();
    shear(0, 1) = shear(1, 0) = 5;
    CHECK(von_mises_stress(shear) == Approx(5 * std::sqrt(3.0)).epsilon(1e-15));
    CHECK(von_mises_stress(7 * Tensor<3>::Identity()) == 0);
}

TEMPLATE_TEST_CASE_SIG("neo-Hookean energy and stress go on across J0 and through zero volume", "[hyperelastic]",
                       ((int Dim), Dim), 2, 3) {
    const Hyperelastic material = rubber(ElasticLaw::neo_hookean);
    const double j0 = Hyperelastic::expansion_volume, tiny = 1e-9;
    const auto psi = [&](double j) { return material.energy_density<Dim>(compressed<Dim>(j)); };
    const auto stress = [&](double j) { return material.first_piola_stress<Dim>(compressed<Dim>(j)); };
    // Two points 2e-9 apart: differences of 2e-9 · P and 2e-9 · dP/dF, a dozen E each; of g'', that of g''' ~ 100 E.
    CHECK(psi(j0 + tiny) == Approx(psi(j0 - tiny)).epsilon(1e-7));
    CHECK((stress(j0 + tiny) - stress(j0 - tiny)).norm() < 1e-7 * stress(j0).norm());
    const double above = stress(j0 + 1e-4)(0, 0) - stress(j0)(0, 0), below = stress(j0)(0, 0) - stress(j0 - 1e-4)(0, 0);
    CHECK(above == Approx(below).epsilon(1e-2));  // g'''/g'' · 1e-4 is about 1e-3

    // From compressed to inside out: finite, and ever more push back.
    for (double j = j0; j > -3; j -= 0.1) {
        CAPTURE(j);
        CHECK(std::isfinite(psi(j)));
        CHECK(stress(j).allFinite());
        CHECK(stress(j - 0.1)(0, 0) < stress(j)(0, 0));
        CHECK(stress(j)(0, 0) < 0);
    }
    // No longer stiffer than at J0.
    const auto slope = [&](double j) { return (stress(j + 1e-3)(0, 0) - stress(j - 1e-3)(0, 0)) / 2e-3; };
    CHECK(slope(-1) == Approx(slope(0.29)).epsilon(1e-9));  // rounding of P by 1e-16 over the step of 2e-3

    // All to a point, where nothing has a direction any more.
    CHECK(std::isfinite(material.energy_density<Dim>(Tensor<Dim>::Zero())));
    CHECK(material.first_piola_stress<Dim>(Tensor<Dim>::Zero()).allFinite());
}

TEMPLATE_TEST_CASE_SIG("a particle turned inside out has finite stress and no Cauchy stress", "[hyperelastic]",
                       ((int Dim), Dim), 2, 3) {
    Random random(6);
    for (const ElasticLaw law : laws) {
        const Hyperelastic material = rubber(law);
        for (int n = 0; n < 100; ++n) {
            Tensor<Dim> f = random_deformation<Dim>(random, 1);
            f.col(0) *= -std::copysign(1.0, f.determinant());
            CAPTURE(static_cast<int>(law), f.determinant());
            REQUIRE(f.determinant() <= 0);
            CHECK(material.first_piola_stress<Dim>(f).allFinite());
            CHECK(std::isfinite(material.energy_density<Dim>(f)));
            CHECK(cauchy_stress<Dim>(material, f) == Tensor<3>::Zero());
        }
        // A number that is none is not hidden.
        Tensor<Dim> f = Tensor<Dim>::Identity();
        f(0, 1) = std::numeric_limits<double>::quiet_NaN();
        CHECK_FALSE(material.first_piola_stress<Dim>(f).allFinite());
        CHECK(std::isnan(material.energy_density<Dim>(f)));
        CHECK_FALSE(cauchy_stress<Dim>(material, f).allFinite());
    }
}

}  // namespace sluice::test_hyperelastic
