// An elastic body's forces are the exact gradient of its energy; what follows for momentum, angular momentum, rotations
// and zigzags.
#include <Eigen/Geometry>

#include "tests/catch.hpp"
#include "tests/kernels/elastic_body.hpp"
#include "tests/kernels/twins_total_lagrangian.hpp"

namespace sluice::test_total_lagrangian_energy {

namespace {

constexpr double young_modulus = 1e6, zeta = usual_hourglass_control, d = 0.1;

Hyperelastic rubber(ElasticLaw law) { return Hyperelastic::with(law, young_modulus, 0.4); }

/// A disordered body of unequal particles with a row of single ones sticking out, a pair and a lone one: the last have
/// too few neighbours, the row's root has some.
template <int Dim>
Particles<Dim> irregular_body(int across, Random& random) {
    Particles<Dim> p = lattice(cube<Dim>(across, d, 1.3));
    jitter(p, 0.2 * d, random);
    for (std::size_t i = 0; i < p.size(); ++i) {
        p.h[i] *= random.in(0.9, 1.1);
        p.mass[i] *= random.in(0.8, 1.2);
    }
    const double side = across * d, mass = 1000 * std::pow(d, Dim);
    const auto add = [&](double along, double up) {
        Vec<Dim> x;
        x[0] = along;
        x[1] = up;
        p.add(x, 1.3 * d, mass, 1000);
    };
    for (int i = 0; i < 5; ++i) add(side + (i + 0.5) * d, 0.5 * side);
    for (int i = 0; i < 2; ++i) add(side + i * d, 5 * side);
    add(9 * side, 0);
    p.derive();
    lay_out(p, Layout::shuffled);
    return p;
}

template <int Dim>
Tensor<Dim> rotation(double angle) {
    if constexpr (Dim == 2)
        return Eigen::Rotation2Dd(angle).toRotationMatrix();
    else
        return Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, -2) / 3).toRotationMatrix();
}

template <int Dim>
void jitter_positions(ElasticBody<Dim>& body, double amplitude, Random& random) {
    for (std::size_t i = 0; i < body.size(); ++i)
        body.position.set(i, body.position[i] + random.vector<Dim>(-amplitude, amplitude));
}

/// A turn, a stretch of some tens of per cent, and a disorder of a twentieth of the spacing.
template <int Dim>
void deform_at_random(ElasticBody<Dim>& body, Random& random) {
    Tensor<Dim> a = Tensor<Dim>::Identity();
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j) a(i, j) += random.in(-0.2, 0.2);
    body.deform(rotation<Dim>(2) * a);
    jitter_positions(body, 0.05 * d, random);
}

/// The largest difference between m a and −∂U/∂x by central differences of fourth order, over the mean |m a|.
template <int Dim>
double gradient_error(const ElasticBody<Dim>& body, const twin::ElasticEnergy<Dim>& energy, double step) {
    double worst = 0, size = 0;
    for (std::size_t i = 0; i < body.size(); ++i) {
        size += body.reference.mass[i] * norm(body.acceleration[i]) / static_cast<double>(body.size());
        for (int k = 0; k < Dim; ++k) {
            const auto at = [&](double steps) {
                VectorField<Dim> x = body.position;
                Vec<Dim> moved = x[i];
                moved[k] += steps * step;
                x.set(i, moved);
                return energy(x);
            };
            const double slope = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * step);
            worst = std::max(worst, std::abs(body.reference.mass[i] * body.acceleration[i][k] + slope));
        }
    }
    return worst / size;
}

template <int Dim>
twin::ElasticEnergy<Dim> energy_of(const ElasticBody<Dim>& body) {
    twin::ElasticEnergy<Dim> energy(body.reference);
    energy.neo_hookean = body.law.law == ElasticLaw::neo_hookean;
    energy.lambda = body.law.lambda;
    energy.mu = body.law.mu;
    energy.k = 2 * zeta * body.law.mu;
    return energy;
}

/// |Σ m a| / Σ m |a|, and |Σ x × m a| / Σ |x| m |a| in the plane of the first two axes.
template <int Dim>
std::array<double, 2> momentum_defects(const ElasticBody<Dim>& body) {
    Vec<Dim> sum;
    double size = 0, torque = 0, torque_size = 0;
    for (std::size_t i = 0; i < body.size(); ++i) {
        const Vec<Dim> f = body.reference.mass[i] * body.acceleration[i], x = body.position[i];
        sum += f;
        size += norm(f);
        torque += x[0] * f[1] - x[1] * f[0];
        torque_size += norm(x) * norm(f);
    }
    return {norm(sum) / size, std::abs(torque) / torque_size};
}

/// Moves every second particle by ±amplitude along y, as on a chessboard.
template <int Dim>
void zigzag(ElasticBody<Dim>& body, double amplitude) {
    for (std::size_t i = 0; i < body.size(); ++i) {
        int cells = 0;
        for (int k = 0; k < Dim; ++k) cells += static_cast<int>(std::floor(body.reference.position[i][k] / d));
        Vec<Dim> x = body.reference.position[i];
        x[1] += cells % 2 == 0 ? amplitude : -amplitude;
        body.position.set(i, x);
    }
}

/// The particle next to a lattice's middle.
template <int Dim>
std::size_t middle_of(const Particles<Dim>& p, int across) {
    std::size_t nearest = 0;
    Vec<Dim> middle;
    middle.c.fill(0.5 * across * d);
    for (std::size_t i = 0; i < p.size(); ++i)
        if (norm2(p.position[i] - middle) < norm2(p.position[nearest] - middle)) nearest = i;
    return nearest;
}

constexpr std::array laws{ElasticLaw::saint_venant_kirchhoff, ElasticLaw::neo_hookean};

}  // namespace

TEMPLATE_TEST_CASE_SIG("the force is the gradient of the discrete energy", "[elastic][energy]", ((int Dim), Dim), 2,
                       3) {
    for (const ElasticLaw law : laws) {
        Random random(1);
        ElasticBody<Dim> body(irregular_body<Dim>(Dim == 2 ? 6 : 3, random), rubber(law), zeta);
        const auto energy = energy_of(body);
        // The row's outer end, the pair and the lone one, but not its root.
        const auto without = std::count(body.hourglass_stiffness.begin(), body.hourglass_stiffness.end(), 0.0);
        REQUIRE(without >= 5);
        REQUIRE(without < 8);
        deform_at_random(body, random);
        body.evaluate();
        CAPTURE(static_cast<int>(law));
        // The same energy, added up in another order.
        CHECK(body.elastic_energy() == Approx(energy(body.position)).epsilon(1e-12));
        // St. Venant-Kirchhoff: U is a polynomial of fourth degree in every coordinate, for which the differences are
        // exact at any step; U of a hundred particles is rounded by 1e-14 of a force times a step of d/10.
        // Neo-Hookean: (s/d)⁴ = 1e-12 of the higher derivatives, and ten thousand times less step to divide by.
        const bool polynomial = law == ElasticLaw::saint_venant_kirchhoff;
        CHECK(gradient_error(body, energy, (polynomial ? 1e-1 : 1e-3) * d) < (polynomial ? 1e-12 : 1e-9));
    }
}

TEMPLATE_TEST_CASE_SIG("elastic forces are equal and opposite in every pair", "[elastic][energy]", ((int Dim), Dim), 2,
                       3) {
    Random random(2);
    for (int n = 0; n < 50; ++n) {
        Particles<Dim> p;
        for (int i = 0; i < 2; ++i)
            p.add(random.vector<Dim>(0, d), random.in(0.13, 0.2), random.in(1, 3), random.in(800, 1200));
        for (int i = 0; i < 2; ++i) p.velocity.set(static_cast<std::size_t>(i), random.vector<Dim>(-1, 1));
        ElasticBody<Dim> body(p, rubber(ElasticLaw::neo_hookean), zeta);
        for (std::size_t i = 0; i < 2; ++i) {
            body.corrected_stress.set(i, random.vector<Dim * Dim>(-1e6, 1e6));
            body.hourglass_stiffness[i] = random.in(0, 1e6);
            body.position.set(i, random.vector<Dim>(0, d));
        }
        elastic_momentum<Dim>(body.view(), body.list, {0.5, 30, 1000}, body.method, body.acceleration);
        REQUIRE(norm(body.acceleration[0]) > 0);
        CHECK(momentum_defects(body)[0] < 1e-15);  // each rounds the same products once in another order
    }
}

TEMPLATE_TEST_CASE_SIG("an elastic body keeps momentum and angular momentum", "[elastic][energy]", ((int Dim), Dim), 2,
                       3) {
    const ThreadScope one_thread(1);
    for (const ElasticLaw law : laws)
        for (const double disorder : {0.01, 0.5}) {  // of the spacing; half of it turns particles inside out
            Random random(3);
            ElasticBody<Dim> body(irregular_body<Dim>(Dim == 2 ? 12 : 6, random), rubber(law), zeta);
            deform_at_random(body, random);
            jitter_positions(body, disorder * d, random);
            for (std::size_t i = 0; i < body.size(); ++i) body.reference.velocity.set(i, random.vector<Dim>(-9, 9));
            for (const double alpha : {0.0, 1.0}) {
                body.evaluate({alpha, 30, 1000});
                CAPTURE(static_cast<int>(law), disorder, alpha);
                // Momentum: pair by pair. Angular momentum: by all pairs together. Rounding of a few thousand pairs.
                CHECK(momentum_defects(body)[0] < 1e-15);
                CHECK(momentum_defects(body)[1] < 1e-15);
            }
        }
}

TEMPLATE_TEST_CASE_SIG("a body that only turns feels no force", "[elastic][energy]", ((int Dim), Dim), 2, 3) {
    const ThreadScope one_thread(1);
    for (const ElasticLaw law : laws) {
        Random random(4);
        ElasticBody<Dim> body(irregular_body<Dim>(Dim == 2 ? 8 : 4, random), rubber(law), zeta);
        for (const double angle : {0.1, 1.5, 3.0}) {
            Vec<Dim> somewhere;
            somewhere[0] = 3;
            body.deform(rotation<Dim>(angle), somewhere);
            body.evaluate();
            double largest = 0;
            for (std::size_t i = 0; i < body.size(); ++i) largest = std::max(largest, norm(body.acceleration[i]));
            CAPTURE(static_cast<int>(law), angle);
            // A strain of 1 would give E/(ρ d) = 1e4 m/s². Positions of some metres are rounded to 1e-15 of that, over
            // d/|L|: strains of 1e-13, and E |L|/(ρ d) before them.
            CHECK(largest < 1e-9);
            CHECK(body.elastic_energy() < 1e-24 * young_modulus);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("hourglass control does nothing to linear deformations", "[elastic][energy]", ((int Dim), Dim),
                       2, 3) {
    const ThreadScope one_thread(1);
    Random random(5);
    const auto p = irregular_body<Dim>(Dim == 2 ? 10 : 5, random);
    ElasticBody<Dim> controlled(p, rubber(ElasticLaw::neo_hookean), zeta), free(p, rubber(ElasticLaw::neo_hookean), 0);
    Tensor<Dim> a = 1.1 * rotation<Dim>(1);
    a(0, 1) += 0.2;
    controlled.deform(a);
    free.deform(a);
    controlled.evaluate();
    free.evaluate();
    double difference = 0, size = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        difference = std::max(difference, norm(controlled.acceleration[i] - free.acceleration[i]));
        size = std::max(size, norm(free.acceleration[i]));
    }
    CHECK(size > 1e3);                 // the free surface is not in balance
    CHECK(difference < 1e-12 * size);  // k (x − F X), a few dozen neighbours
}

TEMPLATE_TEST_CASE_SIG("hourglass control holds zigzags that stress does not see", "[elastic][energy]",
                       ((int Dim), Dim), 2, 3) {
    const ThreadScope one_thread(1);
    // Amid a lattice the neighbours of a zigzag cancel in F: F = I, and (c) leaves a pull of 2 k V w from each
    // neighbour of the other colour, two amplitudes away. ω² = 4 k/ρ Σ V_b w_ab over them.
    const int across = Dim == 2 ? 15 : 11;
    const auto p = lattice(cube<Dim>(across, d, 1.3));
    const std::size_t middle = middle_of(p, across);
    const double amplitude = 1e-4 * d;
    double weights = 0;
    ElasticBody<Dim> body(p, rubber(ElasticLaw::saint_venant_kirchhoff), zeta);
    zigzag(body, amplitude);
    for (std::size_t b = 0; b < p.size(); ++b) {
        const twin::PairOf<Dim> pair(p.position[middle], p.position[b], p.h[b]);
        const bool other = std::abs(body.position[b][1] - p.position[b][1] + body.position[middle][1] -
                                    p.position[middle][1]) < amplitude;
        if (other && pair.r < 2 * pair.h) weights -= p.volume[b] * twin::dw_dr(Dim, pair.r, pair.h) / pair.r;
    }
    for (const double control : {0.0, zeta}) {
        ElasticBody<Dim> held(p, body.law, control);
        held.position = body.position;
        held.evaluate();
        const double displacement = held.position[middle][1] - p.position[middle][1];
        const double rate2 = -held.acceleration[middle][1] / displacement;
        const double expected = 4 * control * 2 * body.law.mu / 1000 * weights;
        CAPTURE(control, rate2, expected);
        // Rounding of d by 1e-16 over the amplitude of 1e-4 d, in units of c²/d² = 2e5/s².
        CHECK(std::abs(rate2 - expected) < 1e-10 * 2e5);
    }
    // Not far from the fastest waves, ω d/c = 1.5.
    CHECK(4 * zeta * young_modulus / 1000 * weights * d * d > 0.9 * body.law.wave_modulus() / 1000);
}

TEMPLATE_TEST_CASE_SIG("reference viscosity takes energy from approaching pairs only", "[elastic][energy]",
                       ((int Dim), Dim), 2, 3) {
    const ThreadScope one_thread(1);
    Random random(6);
    ElasticBody<Dim> body(irregular_body<Dim>(Dim == 2 ? 10 : 5, random), rubber(ElasticLaw::neo_hookean), zeta);
    body.deform(rotation<Dim>(2));
    const auto power = [&] {
        ElasticBody<Dim> elastic = body;
        elastic.evaluate();
        body.evaluate({1, 30, 1000});
        double sum = 0;
        for (std::size_t i = 0; i < body.size(); ++i)
            sum += body.reference.mass[i] *
                   dot(body.acceleration[i] - elastic.acceleration[i], body.reference.velocity[i]);
        return sum;
    };
    const auto set_velocities = [&](auto&& of) {
        for (std::size_t i = 0; i < body.size(); ++i) body.reference.velocity.set(i, of(body.position[i]));
    };
    set_velocities([&](const Vec<Dim>&) { return random.vector<Dim>(-1, 1); });
    CHECK(power() < 0);
    set_velocities([](const Vec<Dim>& x) { return x; });
    CHECK(power() == 0);  // all part
    set_velocities([](const Vec<Dim>& x) { return -x; });
    CHECK(power() < 0);
}

}  // namespace sluice::test_total_lagrangian_energy
