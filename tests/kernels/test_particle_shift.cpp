// Particle shifting: its sums against their twins, the free surface, and what shifting does to an arrangement.
#include "kernels/passes/shift_passes.hpp"

#include "tests/catch.hpp"
#include "tests/kernels/compare.hpp"
#include "tests/kernels/twins_fluid.hpp"

namespace sluice::test_particle_shift {

namespace {

constexpr double d = 0.1;  ///< spacing of the lattices [m]

/// The three sums of both passes.
template <int Dim>
struct SumTwins {
    twin::Sums<Dim> gradient;
    twin::Sums<1> divergence, concentration;

    SumTwins(const Particles<Dim>& p, const Particles<Dim>& others, const ShiftTerms& terms)
        : gradient(twin::concentration_gradient<Dim>(p, others, terms.repulsion, terms.h_over_d)),
          divergence(twin::position_divergence<Dim>(p, others)),
          concentration(twin::concentration<Dim>(p, others)) {}

    void check(const Columns<Dim>& fields, double tolerance) const {
        CHECK(worst_error(fields.concentration_gradient, gradient) < tolerance);
        CHECK(worst_error(fields.position_divergence, divergence) < tolerance);
        CHECK(worst_error(fields.concentration, concentration) < tolerance);
    }
};

/// All that shifting needs, of a fluid alone.
template <int Dim>
Columns<Dim> surroundings(const Particles<Dim>& p, const ShiftTerms& terms) {
    const ThreadScope one_thread(1);
    const NeighborList list = list_of(p);
    Columns<Dim> fields;
    clear_surroundings<Dim>(fields, p.size(), p.size());
    shift_sums<Dim>(p.view(), list, terms, Precision::full, fields);
    mark_free_surface<Dim>(p.view(), p.size(), fields);
    surface_normals<Dim>(p.view(), list, Precision::full, fields);
    return fields;
}

/// Particles of a lattice around the origin that `inside` takes.
template <int Dim, class Inside>
Particles<Dim> cut_out(int half, double h_over_d, const Inside& inside) {
    auto box = cube<Dim>(half, d, h_over_d);
    box.lo.fill(-half);
    const auto all = lattice(box);
    Particles<Dim> p;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (inside(all.position[i])) p.add(all.position[i], all.h[i], all.mass[i], all.density[i]);
    return p;
}

/// How many of the 3^D − 1 places around a particle of a lattice are empty.
template <int Dim>
int empty_places(const Particles<Dim>& p, std::size_t i) {
    int taken = 0;
    for (std::size_t j = 0; j < p.size(); ++j) {
        double farthest = 0;
        for (int k = 0; k < Dim; ++k) farthest = std::max(farthest, std::abs(p.position[i][k] - p.position[j][k]));
        taken += farthest < 1.5 * d;
    }
    return (Dim == 2 ? 9 : 27) - taken;
}

/// Root of the mean square of |∇C| h over the given particles.
template <int Dim>
double unevenness(const Columns<Dim>& fields, const std::vector<std::size_t>& which, double h) {
    double sum = 0;
    for (const std::size_t i : which) sum += norm2(h * fields.concentration_gradient[i]);
    return std::sqrt(sum / static_cast<double>(which.size()));
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("shift_sums equal their twins", "[shift]", ((int Dim), Dim), 2, 3) {
    in_all_scenes<Dim>(1, [](const auto& p, const NeighborList& list) {
        const ShiftTerms terms{1.3};
        const SumTwins<Dim> expected(p, p, terms);
        in_all_variants([&](Precision precision) {
            Columns<Dim> fields;
            clear_surroundings<Dim>(fields, p.size(), p.size());
            CHECK(shift_sums<Dim>(p.view(), list, terms, precision, fields) == list.pairs());
            expected.check(fields, twin_tolerance(precision));
        });
    });
}

TEMPLATE_TEST_CASE_SIG("boundary_shift_sums equal their twins and add to the fluid's", "[shift]", ((int Dim), Dim), 2,
                       3) {
    for (const Layout layout : layouts) {
        const auto fluid = make_scene<Dim>(Scene::unequal, 1, layout);
        auto boundary = make_scene<Dim>(Scene::jittered, 2, layout);
        for (double& x : boundary.position.c[0]) x += 0.3;  // reaches into the fluid, and beyond it
        const NeighborList list = list_of(fluid, boundary);
        const ShiftTerms terms{1.5, 2, 0.5};
        const SumTwins<Dim> expected(fluid, boundary, terms);
        in_all_variants([&](Precision precision) {
            Columns<Dim> fields;
            clear_surroundings<Dim>(fields, fluid.size(), fluid.size());
            CHECK(boundary_shift_sums<Dim>(fluid.view(), boundary.view(), list, terms, precision, fields) ==
                  list.pairs());
            expected.check(fields, twin_tolerance(Precision::full));
            const auto once = fields.concentration_gradient;
            boundary_shift_sums<Dim>(fluid.view(), boundary.view(), list, terms, precision, fields);
            for (std::size_t i = 0; i < fluid.size(); ++i) REQUIRE(fields.concentration_gradient[i] == 2.0 * once[i]);
        });
    }
}

TEMPLATE_TEST_CASE_SIG("surface_normals equal their twin", "[shift]", ((int Dim), Dim), 2, 3) {
    in_all_scenes<Dim>(1, [](const auto& p, const NeighborList& list) {
        Random random(4);
        auto surface = p;
        for (double& v : surface.volume) v = random.in(-1, 1) < 0 ? v : 0.0;
        const auto expected = twin::concentration_gradient<Dim>(p, surface, 0, 1.3);
        in_all_variants([&](Precision precision) {
            Columns<Dim> fields;
            clear_surroundings<Dim>(fields, p.size(), p.size());
            fields.surface_volume = surface.volume;
            CHECK(surface_normals<Dim>(p.view(), list, precision, fields) == list.pairs());
            CHECK(worst_error(fields.surface_normal, expected) < twin_tolerance(precision));
            clear_surroundings<Dim>(fields, p.size(), p.size());
            surface_normals<Dim>(p.view(), list, precision, fields);
            for (std::size_t i = 0; i < p.size(); ++i) REQUIRE(norm2(fields.surface_normal[i]) == 0);  // no surface
        });
    });
}

TEMPLATE_TEST_CASE_SIG("the passes of shifting far from the origin, at any scale, on any number of threads", "[shift]",
                       ((int Dim), Dim), 2, 3) {
    const ShiftTerms terms{1.3};
    const auto check = [&](const Particles<Dim>& p) {
        const NeighborList list = list_of(p);
        const SumTwins<Dim> expected(p, p, terms);
        in_all_variants([&](Precision precision) {
            const auto run = [&](int threads) {
                const ThreadScope scope(threads);
                Columns<Dim> fields;
                clear_surroundings<Dim>(fields, p.size(), p.size());
                shift_sums<Dim>(p.view(), list, terms, precision, fields);
                mark_free_surface<Dim>(p.view(), p.size(), fields);
                surface_normals<Dim>(p.view(), list, precision, fields);
                return fields;
            };
            const auto fields = run(1), again = run(2);
            expected.check(fields, twin_tolerance(precision));
            CHECK(same_bits(fields.concentration_gradient, again.concentration_gradient));
            CHECK(same_bits(fields.surface_normal, again.surface_normal));
            CHECK((fields.position_divergence == again.position_divergence));
            CHECK((fields.concentration == again.concentration));
        });
    };
    auto far = make_scene<Dim>(Scene::unequal);
    for (auto& column : far.position.c)
        for (double& x : column) x += 1e4;  // [m]; a float's grid there is 1e-3 m, a spacing is 0.1 m
    check(far);
    for (const double scale : scales) {
        auto p = make_scene<Dim>(Scene::odd);
        rescale(p, scale);
        CAPTURE(scale);
        check(p);
    }
}

TEMPLATE_TEST_CASE_SIG("particle_shift keeps to its rule", "[shift]", ((int Dim), Dim), 2, 3) {
    const ShiftTerms terms{1.5};
    const double h = 0.15;
    Surroundings<Dim> inside;
    inside.position_divergence = Dim;
    inside.concentration_gradient[0] = 0.1;
    inside.concentration_gradient[1] = -0.2;
    // −A h |v|Δt ∇C by hand; one rounding per factor.
    CHECK(particle_shift<Dim>(terms, inside, h, 0.01)[0] == Approx(-2 * 0.15 * 0.01 * 0.1).epsilon(1e-15));
    CHECK(particle_shift<Dim>(terms, inside, h, 0.01)[1] == Approx(2 * 0.15 * 0.01 * 0.2).epsilon(1e-15));
    CHECK(particle_shift<Dim>(terms, inside, h, 0) == Vec<Dim>{});
    CHECK(norm(particle_shift<Dim>(terms, inside, h, 1e3)) == Approx(0.2 * 0.1).epsilon(1e-15));  // of d

    auto near = inside;
    near.surface_normal[1] = 1e-3;
    const Vec<Dim> along = particle_shift<Dim>(terms, near, h, 0.01);
    CHECK(along[0] == particle_shift<Dim>(terms, inside, h, 0.01)[0]);
    CHECK(std::abs(along[1]) < 1e-19);  // a rounding of 6e-4

    auto at_surface = inside;
    at_surface.position_divergence = Dim == 2 ? 1.49 : 2.39;
    CHECK(particle_shift<Dim>(terms, at_surface, h, 0.01) == Vec<Dim>{});
}

TEMPLATE_TEST_CASE_SIG("the free surface is the outermost layer of a disc or ball", "[shift]", ((int Dim), Dim), 2, 3) {
    for (const double h_over_d : {1.2, 1.3, 1.5, 1.8}) {
        const double radius = (Dim == 2 ? 12.2 : 6.2) * d;
        const auto p =
            cut_out<Dim>(Dim == 2 ? 13 : 7, h_over_d, [&](const Vec<Dim>& x) { return norm2(x) < radius * radius; });
        const auto fields = surroundings<Dim>(p, {h_over_d});
        std::size_t too_deep = 0, missed = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const int empty = empty_places(p, i);
            const bool is_marked = fields.surface_volume[i] > 0;
            too_deep += is_marked && empty == 0;
            missed += !is_marked && empty >= (Dim == 2 ? 3 : 9);  // a flat surface's
            if (is_marked) CHECK(fields.surface_volume[i] == p.volume[i]);
        }
        CAPTURE(h_over_d);
        CHECK(too_deep == 0);
        CHECK(missed == 0);
    }
}

TEMPLATE_TEST_CASE_SIG("every particle of a thin film is at the free surface", "[shift]", ((int Dim), Dim), 2, 3) {
    for (const double h_over_d : {1.2, 1.5, 1.8}) {
        const auto p = cut_out<Dim>(8, h_over_d, [](const Vec<Dim>& x) { return x[1] > 0 && x[1] < d; });
        const auto fields = surroundings<Dim>(p, {h_over_d});
        CAPTURE(h_over_d);
        CHECK(std::count(fields.surface_volume.begin(), fields.surface_volume.end(), 0.0) == 0);
    }
}

TEMPLATE_TEST_CASE_SIG("a wall of boundary particles is no free surface", "[shift]", ((int Dim), Dim), 2, 3) {
    // One lattice, fluid above y = 0 and wall below it.
    const ShiftTerms terms{1.5};
    const int half = Dim == 2 ? 8 : 6;
    const auto fluid = cut_out<Dim>(half, 1.5, [](const Vec<Dim>&x) { return x[1] > 0; }),
               wall = cut_out<Dim>(half, 1.5, [](const Vec<Dim>&x) { return x[1] < 0; });
    Columns<Dim> fields;
    clear_surroundings<Dim>(fields, fluid.size(), fluid.size());
    shift_sums<Dim>(fluid.view(), list_of(fluid), terms, Precision::full, fields);
    boundary_shift_sums<Dim>(fluid.view(), wall.view(), list_of(fluid, wall), terms, Precision::full, fields);
    mark_free_surface<Dim>(fluid.view(), fluid.size(), fields);
    std::size_t checked = 0;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        bool deep = true;
        for (int k = 0; k < Dim; ++k) deep = deep && std::abs(fluid.position[i][k]) < half * d - 2 * fluid.h[i];
        if (!deep) continue;
        ++checked;
        REQUIRE(norm(fields.concentration_gradient[i]) < 1e-12 / d);  // terms of some 1/d cancel
        // The lattice's own errors at h/d = 1.5 (test_accuracy, test_smoothing).
        REQUIRE(fields.position_divergence[i] == Approx(Dim).epsilon(0.02));
        REQUIRE(fields.concentration[i] == Approx(1).epsilon(0.02));
        REQUIRE(fields.surface_volume[i] == 0);
    }
    CHECK(checked > 0);
}

TEMPLATE_TEST_CASE_SIG("a lattice is not shifted, nor across its free surface", "[shift]", ((int Dim), Dim), 2, 3) {
    for (const double h_over_d : {1.2, 1.3, 1.5, 1.8}) {
        const ShiftTerms terms{h_over_d};
        const int half = Dim == 2 ? 10 : 8;
        const auto p = cut_out<Dim>(half, h_over_d, [](const Vec<Dim>&) { return true; });
        const auto fields = surroundings<Dim>(p, terms);
        double worst = 0;
        std::size_t checked = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            // All but those near two faces at once, up to a particle at the surface of the one that is near.
            int faces = 0;
            for (int k = 0; k < Dim; ++k) faces += std::abs(p.position[i][k]) > half * d - (2 * h_over_d + 1) * d;
            if (faces > 1) continue;
            ++checked;
            worst = std::max(worst, norm(particle_shift<Dim>(terms, surroundings_of<Dim>(fields, i), p.h[i], 0.1 * d)));
        }
        CAPTURE(h_over_d);
        CHECK(checked > 0);
        CHECK(worst < 1e-13 * d);  // terms of A h |v| Δt ΔV ∇W ≈ 0.1 d cancel
    }
}

TEMPLATE_TEST_CASE_SIG("shifting evens out a disturbed lattice and keeps it in its place", "[shift]", ((int Dim), Dim),
                       2, 3) {
    const ShiftTerms terms{1.5};
    const int half = Dim == 2 ? 10 : 7;
    auto p = cut_out<Dim>(half, 1.5, [](const Vec<Dim>&) { return true; });
    const auto start = p.position;
    Random random(8);
    std::vector<std::size_t> inside;  // the others hold still: a full support all around
    for (std::size_t i = 0; i < p.size(); ++i) {
        bool deep = true;
        for (int k = 0; k < Dim; ++k) deep = deep && std::abs(p.position[i][k]) < half * d - 2 * p.h[i];
        if (!deep) continue;
        inside.push_back(i);
        p.position.set(i, p.position[i] + random.vector<Dim>(-0.2 * d, 0.2 * d));
    }
    const double before = unevenness(surroundings<Dim>(p, terms), inside, p.h[0]);
    for (int step = 0; step < 20; ++step) {
        const auto fields = surroundings<Dim>(p, terms);
        for (const std::size_t i : inside)
            p.position.set(i, p.position[i] + particle_shift<Dim>(terms, surroundings_of<Dim>(fields, i), p.h[i], 0.1 * d));
    }
    Vec<Dim> mean;
    for (const std::size_t i : inside) mean += (1.0 / static_cast<double>(inside.size())) * (p.position[i] - start[i]);
    // Short waves go within a few steps; those as long as the box take longer, by the square of their length.
    CHECK(unevenness(surroundings<Dim>(p, terms), inside, p.h[0]) < before / 3);
    CHECK(norm(mean) < 0.05 * d);  // 0.2 d/√3 over the root of 200 or more particles is 0.01 d
}

TEMPLATE_TEST_CASE_SIG("shifting evens out the particles under a free surface along it, and does not draw them to it",
                       "[shift]", ((int Dim), Dim), 2) {
    for (const double h_over_d : {1.3, 1.5}) {
        const ShiftTerms terms{h_over_d};
        const int half = 14;
        auto p = cut_out<Dim>(half, h_over_d, [](const Vec<Dim>& x) { return x[1] < 0; });  // surface at y = 0
        const auto start = p.position;
        Random random(9);
        for (std::size_t i = 0; i < p.size(); ++i)
            p.position.set(i, p.position[i] + random.vector<Dim>(-0.15 * d, 0.15 * d));
        const auto disturbed = p.position;
        std::vector<std::size_t> second;
        for (std::size_t i = 0; i < p.size(); ++i)
            if (std::abs(start[i][0]) < 0.5 * half * d && std::abs(start[i][1] + 1.5 * d) < 0.1 * d)
                second.push_back(i);
        const auto along = [&] {
            const auto fields = surroundings<Dim>(p, terms);
            double sum = 0;
            for (const std::size_t i : second) sum += std::pow(p.h[i] * fields.concentration_gradient[i][0], 2);
            return std::sqrt(sum / static_cast<double>(second.size()));
        };
        const double before = along();
        for (int step = 0; step < 200; ++step) {
            const auto fields = surroundings<Dim>(p, terms);
            for (std::size_t i = 0; i < p.size(); ++i)
                p.position.set(i, p.position[i] + particle_shift<Dim>(terms, surroundings_of<Dim>(fields, i), p.h[i], 0.05 * d));
        }
        double rise = 0;
        for (const std::size_t i : second)
            rise += (p.position[i][1] - disturbed[i][1]) / static_cast<double>(second.size());
        CAPTURE(h_over_d, before, rise);
        CHECK(along() < before / 4);
        CHECK(std::abs(rise) < 0.02 * d);  // without N 0.02 to 0.3 d (kernels/terms/particle_shift.hpp)
    }
}

}  // namespace sluice::test_particle_shift
