// The passes of contact against their plain twins; their forces against the energy; what they keep.
#include "kernels/passes/contact_passes.hpp"

#include "tests/catch.hpp"
#include "tests/kernels/compare.hpp"
#include "tests/kernels/twins_contact.hpp"

namespace sluice::test_contact_passes {

namespace {

/// Two bodies side by side and partly through each other, both in a random state.
template <int Dim>
struct TwoBodies {
    Particles<Dim> a, b;

    explicit TwoBodies(Scene scene, Layout layout = Layout::shuffled)
        : a(make_scene<Dim>(scene, 1, layout)), b(make_scene<Dim>(scene, 2, layout)) {
        for (double& x : b.position.c[1]) x -= scene == Scene::crowded ? 0.03 : 0.5;
    }
    TwoBodies(const Particles<Dim>& one, const Particles<Dim>& other) : a(one), b(other) {}
};

/// The columns of one body that the passes write.
template <int Dim>
struct Results {
    ScalarField density;
    VectorField<Dim> gradient, force_density;

    explicit Results(const Particles<Dim>& p)
        : density(p.size(), 0.0), gradient(zeros<Dim>(p.size())), force_density(zeros<Dim>(p.size())) {}
};

template <int Dim>
void check_passes(const TwoBodies<Dim>& s) {
    const auto sums = twin::contact_sums<Dim>(s.a, s.b);
    const auto force = twin::contact_force<Dim>(s.a, s.b);
    const NeighborList list = list_of(s.a, s.b);
    in_all_variants([&](Precision precision) {
        Results<Dim> r(s.a);
        CHECK(contact_sums<Dim>(s.a.view(), s.b.view(), list, precision, r.density, r.gradient) == list.pairs());
        contact_force<Dim>(s.a.view(), s.b.view(), list, precision, r.force_density);
        TupleField<1 + Dim> both = zeros<1 + Dim>(s.a.size());
        both.c[0] = r.density;
        for (std::size_t k = 0; k < Dim; ++k) both.c[1 + k] = r.gradient.c[k];
        // In double in either precision.
        CHECK(worst_error(both, sums) < twin_tolerance(Precision::full));
        CHECK(worst_error(r.force_density, force) < twin_tolerance(Precision::full));
    });
}

constexpr double d = 0.1, k = 1e5;

/// Two blocks that overlap by `depth` spacings at a face, disordered by a tenth of a spacing.
template <int Dim>
TwoBodies<Dim> pressed_blocks(double depth, Random& random) {
    auto box = cube<Dim>(Dim == 2 ? 10 : 6, d, 1.3);
    Particles<Dim> below = lattice(box), above = lattice(box);
    const double lift = (box.hi[0] - depth) * d;
    for (double& y : above.position.c[1]) y += lift;
    for (auto* p : {&below, &above}) {
        jitter(*p, 0.1 * d, random);
        for (double& m : p->mass) m *= random.in(0.8, 1.2);
        p->derive();
        lay_out(*p, Layout::shuffled);
    }
    return {below, above};
}

/// Forces of both on each other at a threshold, by the passes; returns the energy by the twin.
template <int Dim>
struct Evaluation {
    Results<Dim> on_a, on_b;

    Evaluation(TwoBodies<Dim>& s, double threshold) : on_a(s.a), on_b(s.b) {
        const NeighborList ab = list_of(s.a, s.b), ba = list_of(s.b, s.a);
        contact_sums<Dim>(s.a.view(), s.b.view(), ab, Precision::full, on_a.density, on_a.gradient);
        contact_sums<Dim>(s.b.view(), s.a.view(), ba, Precision::full, on_b.density, on_b.gradient);
        const auto set = [&](Particles<Dim>& p, const Results<Dim>& r) {
            for (std::size_t i = 0; i < p.size(); ++i) p.pressure[i] = k * std::max(r.density[i] - threshold, 0.0);
        };
        set(s.a, on_a);
        set(s.b, on_b);
        contact_force<Dim>(s.a.view(), s.b.view(), ab, Precision::full, on_a.force_density);
        contact_force<Dim>(s.b.view(), s.a.view(), ba, Precision::full, on_b.force_density);
    }
};

template <int Dim>
double energy_of(const TwoBodies<Dim>& s, double threshold) {
    return twin::contact_energy(s.a, s.b, k, threshold) + twin::contact_energy(s.b, s.a, k, threshold);
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("the passes of contact equal their twins", "[contact]", ((int Dim), Dim), 2, 3) {
    for (const Scene scene : scenes)
        for (const Layout layout : layouts) {
            CAPTURE(static_cast<int>(scene), layout == Layout::sorted);
            check_passes(TwoBodies<Dim>(scene, layout));
        }
}

TEMPLATE_TEST_CASE_SIG("the passes of contact far from the origin and at any scale", "[contact]", ((int Dim), Dim), 2,
                       3) {
    TwoBodies<Dim> far(Scene::unequal);
    for (auto* set : {&far.a, &far.b})
        for (auto& column : set->position.c)
            for (double& x : column) x -= 1e4;  // [m]
    check_passes(far);
    for (const double scale : scales) {
        TwoBodies<Dim> s(Scene::odd);
        rescale(s.a, scale);
        rescale(s.b, scale);
        CAPTURE(scale);
        check_passes(s);
    }
}

TEMPLATE_TEST_CASE_SIG("contact passes have the same bits for any number of threads", "[contact]", ((int Dim), Dim), 2,
                       3) {
    const TwoBodies<Dim> s(Scene::unequal);
    const NeighborList list = list_of(s.a, s.b);
    in_all_variants([&](Precision precision) {
        std::vector<Results<Dim>> results;
        for (const int threads : {1, 2, 4}) {
            const ThreadScope scope(threads);
            Results<Dim>& r = results.emplace_back(s.a);
            contact_sums<Dim>(s.a.view(), s.b.view(), list, precision, r.density, r.gradient);
            contact_force<Dim>(s.a.view(), s.b.view(), list, precision, r.force_density);
        }
        for (const std::size_t t : {1, 2}) {
            CHECK((results[t].density == results[0].density));
            CHECK(same_bits(results[t].gradient, results[0].gradient));
            CHECK(same_bits(results[t].force_density, results[0].force_density));
        }
    });
}

TEMPLATE_TEST_CASE_SIG("contact forces are minus the gradient of the contact energy", "[contact]", ((int Dim), Dim), 2,
                       3) {
    Random random(5);
    auto s = pressed_blocks<Dim>(0.7, random);
    const double threshold = flat_contact<Dim>({}, 1.3).density;
    const Evaluation<Dim> forces(s, threshold);
    // Differences of fourth order over 1e-3 d: the energy's second derivative jumps where σ passes σ_0, which a stencil
    // seldom straddles, and then by 1e-3 of a force; the rest is (1e-3)⁴.
    const double step = 1e-3 * d;
    double worst = 0, size = 0;
    for (std::size_t i = 0; i < s.a.size(); i += 3) {
        const Vec<Dim> f = s.a.volume[i] * forces.on_a.force_density[i], x = s.a.position[i];
        size = std::max(size, norm(f));
        for (int c = 0; c < Dim; ++c) {
            const auto at = [&](double steps) {
                Vec<Dim> moved = x;
                moved[c] += steps * step;
                s.a.position.set(i, moved);
                return energy_of(s, threshold);
            };
            const double slope = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * step);
            worst = std::max(worst, std::abs(f[c] + slope));
        }
        s.a.position.set(i, x);
    }
    CAPTURE(worst, size);
    REQUIRE(size > 0);
    CHECK(worst < 2e-3 * size);
}

TEMPLATE_TEST_CASE_SIG("contact keeps momentum and angular momentum", "[contact]", ((int Dim), Dim), 2, 3) {
    Random random(6);
    auto s = pressed_blocks<Dim>(0.7, random);
    const Evaluation<Dim> forces(s, flat_contact<Dim>({}, 1.3).density);
    Vec<Dim> sum;
    double size = 0, torque = 0, torque_size = 0;
    const auto add = [&](const Particles<Dim>& p, const Results<Dim>& r) {
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Vec<Dim> f = p.volume[i] * r.force_density[i], x = p.position[i];
            sum += f;
            size += norm(f);
            torque += x[0] * f[1] - x[1] * f[0];
            torque_size += norm(x) * norm(f);
        }
    };
    add(s.a, forces.on_a);
    add(s.b, forces.on_b);
    REQUIRE(size > 0);
    CHECK(norm(sum) < 1e-14 * size);                // rounding of a few dozen terms each
    CHECK(std::abs(torque) < 1e-14 * torque_size);  // and of as many moments
}

TEMPLATE_TEST_CASE_SIG("flat bodies in line begin to press when they touch", "[contact]", ((int Dim), Dim), 2, 3) {
    const double h_over_d = GENERATE(1.2, 1.5, 2.0);
    const int n = Dim == 2 ? 16 : 12;  // wide enough for a middle without edges at h/d = 2
    Particles<Dim> below = lattice(cube<Dim>(n, d, h_over_d)), above = below;
    const FlatContact flat = flat_contact<Dim>({}, h_over_d);
    const auto force_at = [&](double closer) {
        TwoBodies<Dim> s(below, above);
        for (double& y : s.b.position.c[1]) y += (n - closer) * d;
        const Evaluation<Dim> forces(s, flat.density);
        // On the column in the middle: pressure over its area.
        double force = 0;
        for (std::size_t i = 0; i < s.a.size(); ++i) {
            bool middle = true;
            for (int c = 0; c < Dim; ++c)
                middle = middle && (c == 1 || std::lround(s.a.position[i][c] / d - 0.5) == n / 2);
            if (middle) force -= s.a.volume[i] * forces.on_a.force_density[i][1];
        }
        return force / std::pow(d, Dim - 1);
    };
    CHECK(std::abs(force_at(0)) < 1e-12 * k);  // the same sum in another order
    CHECK(force_at(-0.5) == 0);
    // 1e-3 of a spacing closer: (d) to first order, to which W's curvature adds some per mille.
    CHECK(force_at(1e-3) == Approx(2 * k * flat.slope * flat.slope * 1e-3).epsilon(0.01));
    CHECK(force_at(0.5) > force_at(0.25));
}

}  // namespace sluice::test_contact_passes
