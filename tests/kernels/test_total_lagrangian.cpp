// The passes in the reference configuration against their plain twins, and what the deformation gradient is exact for.

#include "kernels/pairs/pair_sum.hpp"
#include "kernels/principal.hpp"
#include "kernels/tensor.hpp"
#include "tests/catch.hpp"
#include "tests/kernels/compare.hpp"
#include "tests/kernels/elastic_body.hpp"
#include "tests/kernels/twins_total_lagrangian.hpp"

namespace sluice::test_total_lagrangian {

namespace {

const Hyperelastic rubber = Hyperelastic::with(ElasticLaw::neo_hookean, 1e6, 0.4);
const double stiffness = usual_hourglass_control * 2 * rubber.mu;

/// The first (0) or second (1) of two tensors.
template <int Dim>
Tensor<Dim> one_of(const Vec<2 * Dim * Dim>& two, int which) {
    Tensor<Dim> t;
    for (int k = 0; k < Dim * Dim; ++k) t(k / Dim, k % Dim) = two[which * Dim * Dim + k];
    return t;
}

/// Any linear map: a large turn, stretch and shear, not turned inside out.
template <int Dim>
Tensor<Dim> linear_map() {
    Tensor<Dim> a = Tensor<Dim>::Identity();
    a.template topLeftCorner<2, 2>() << 0.3, -1.1, 1.2, 0.4;
    if constexpr (Dim == 3) a.row(2) << 0.2, -0.3, 0.8;
    return a;
}

template <int Dim>
Vec<Dim> filled(double value) {
    Vec<Dim> v;
    v.c.fill(value);
    return v;
}

/// Current positions far from any linear map: X moved by up to 0.3 of a smoothing length at random.
template <int Dim>
VectorField<Dim> moved(const Particles<Dim>& p, Random& random) {
    VectorField<Dim> x = p.position;
    for (std::size_t i = 0; i < p.size(); ++i) x.set(i, x[i] + (0.3 * p.h[i]) * random.vector<Dim>(-1, 1));
    return x;
}

/// L held against M: |L M − I| in units of what rounding M and its inversion may cost. Infinity if the rule for
/// particles with too few neighbours is broken.
template <int Dim>
double correction_residual(const SymTensorField<Dim>& l, const ScalarField& k, const twin::Sums<2 * Dim * Dim>& sums) {
    double worst = 0;
    for (std::size_t i = 0; i < l.size(); ++i) {
        const Tensor<Dim> m = one_of<Dim>(sums.value[i], 0), inverse = sym_to_tensor<Dim>(l[i]);
        const double smallest = principal_values<Dim>(m)[0];
        if (std::abs(smallest - 0.01) < 1e-10) continue;  // on the threshold rounding decides
        if ((smallest < 0.01) != (inverse == Tensor<Dim>::Zero()) || (smallest < 0.01) != (k[i] == 0))
            return std::numeric_limits<double>::infinity();
        if (smallest < 0.01) continue;
        const double scale = inverse.norm() * one_of<Dim>(sums.magnitude[i], 0).norm();
        worst = std::max(worst, relative_error((inverse * m - Tensor<Dim>::Identity()).norm(), 0, scale));
    }
    return worst;
}

/// F held against the sums times L, and T against P L − k F, both in units of their terms.
template <int Dim>
double deformation_residual(const ElasticBody<Dim>& body, const twin::Sums<2 * Dim * Dim>& sums) {
    double worst = 0;
    for (std::size_t i = 0; i < body.size(); ++i) {
        const Tensor<Dim> l = sym_to_tensor<Dim>(body.gradient_correction[i]), f = body.deformation_of(i);
        const Tensor<Dim> p = body.law.template first_piola_stress<Dim>(f);
        const double k = body.hourglass_stiffness[i];
        Tensor<Dim> expected = one_of<Dim>(sums.value[i], 1) * l;
        if (l == Tensor<Dim>::Zero()) expected = Tensor<Dim>::Identity();
        const Tensor<Dim> t = tensor_of<Dim>(body.corrected_stress[i]);
        worst = std::max(
            worst, relative_error((f - expected).norm(), 0, 1 + one_of<Dim>(sums.magnitude[i], 1).norm() * l.norm()));
        worst = std::max(worst, relative_error((t - (p * l - k * f)).norm(), 0, p.norm() * l.norm() + k * f.norm()));
    }
    return worst;
}

/// Any T, k and x, as they need not follow from each other.
template <int Dim>
twin::ElasticColumns<Dim> random_columns(const Particles<Dim>& p, Random& random) {
    twin::ElasticColumns<Dim> c{moved(p, random), {}, {}};
    for (std::size_t i = 0; i < p.size(); ++i) {
        c.t.push_back(random.vector<Dim * Dim>(-1e6, 1e6));
        c.k.push_back(random.in(0, 1e6));
    }
    return c;
}

template <int Dim>
ParticleView<Dim> view_of(const Particles<Dim>& p, const twin::ElasticColumns<Dim>& c) {
    ParticleView<Dim> v = p.view();
    v.reference_position = v.position;
    v.position = columns_of(c.x);
    v.corrected_stress = columns_of(c.t);
    v.hourglass_stiffness = c.k.data();
    return v;
}

constexpr ElasticViscosity viscous{0.5, 30, 1100};
constexpr double eta = 0.5 * 30 * 1100;

/// All passes on one set against their twins.
template <int Dim>
void check_all_passes(const Particles<Dim>& p, const NeighborList& list) {
    Random random(17);
    const auto columns = random_columns(p, random);
    const auto sums = twin::deformation_sums<Dim>(p, columns.x);
    const auto inviscid = twin::elastic_momentum<Dim>(p, columns, 0),
               damped = twin::elastic_momentum<Dim>(p, columns, eta);
    in_all_variants([&](Precision precision) {
        ElasticBody<Dim> body(p, list, rubber, usual_hourglass_control, precision);
        body.position = columns.x;
        body.evaluate();
        auto a = zeros<Dim>(p.size()), b = zeros<Dim>(p.size());
        const auto pairs = elastic_momentum<Dim>(view_of(p, columns), list, {}, precision, a);
        elastic_momentum<Dim>(view_of(p, columns), list, viscous, precision, b);
        // Double whatever is asked for.
        CHECK(correction_residual<Dim>(body.gradient_correction, body.hourglass_stiffness, sums) <
              twin_tolerance(Precision::full));
        CHECK(deformation_residual<Dim>(body, sums) < twin_tolerance(Precision::full));
        CHECK(worst_error(a, inviscid) < twin_tolerance(Precision::full));
        CHECK(worst_error(b, damped) < twin_tolerance(Precision::full));
        CHECK(pairs == list.pairs());
    });
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("the elastic passes equal their twins", "[elastic]", ((int Dim), Dim), 2, 3) {
    in_all_scenes<Dim>(1, [](const auto& p, const NeighborList& list) { check_all_passes<Dim>(p, list); });
}

TEMPLATE_TEST_CASE_SIG("the elastic passes over rows of several parts", "[elastic]", ((int Dim), Dim), 2, 3) {
    // More clusters within one support than a byte can number.
    Random random(5);
    Particles<Dim> p;
    for (int i = 0; i < 1100; ++i) p.add(random.vector<Dim>(0, 0.1), random.in(0.1, 0.15), 1e-3, 1000);
    randomize_state(p, random);
    check_all_passes<Dim>(p, list_of(p));
}

TEMPLATE_TEST_CASE_SIG("the elastic passes at any scale", "[elastic]", ((int Dim), Dim), 2, 3) {
    for (const double scale : scales) {
        auto p = make_scene<Dim>(Scene::odd);
        rescale(p, scale);
        CAPTURE(scale);
        check_all_passes<Dim>(p, list_of(p));
    }
}

TEMPLATE_TEST_CASE_SIG("elastic passes have the same bits for any number of threads", "[elastic]", ((int Dim), Dim), 2,
                       3) {
    const auto p = make_scene<Dim>(Scene::unequal);
    const NeighborList list = list_of(p);
    REQUIRE(list.cluster_pairs() > parallel_cluster_pairs);
    in_all_variants([&](Precision precision) {
        std::vector<ElasticBody<Dim>> bodies;
        for (const int threads : {1, 2, 4}) {
            const ThreadScope scope(threads);
            Random random(3);
            bodies.emplace_back(p, list, rubber, usual_hourglass_control, precision);
            bodies.back().position = moved(p, random);
            bodies.back().evaluate(viscous);
            bodies.back().elastic_energy();
        }
        for (const std::size_t t : {1, 2}) {
            CHECK(same_bits(bodies[t].gradient_correction, bodies[0].gradient_correction));
            CHECK(same_bits(bodies[t].deformation, bodies[0].deformation));
            CHECK(same_bits(bodies[t].corrected_stress, bodies[0].corrected_stress));
            CHECK(same_bits(bodies[t].acceleration, bodies[0].acceleration));
            CHECK((bodies[t].hourglass_energies == bodies[0].hourglass_energies));
        }
    });
}

TEMPLATE_TEST_CASE_SIG("the deformation gradient is exact for every linear map, at corners and edges too", "[elastic]",
                       ((int Dim), Dim), 2, 3) {
    for (const auto function : {SmoothingFunction::cubic_spline, SmoothingFunction::wendland_c2,
                                SmoothingFunction::wendland_c4, SmoothingFunction::quintic_spline})
        for (const bool disturbed : {false, true}) {
            auto p = lattice(cube<Dim>(7, 0.1, 1.3));
            Random random(8);
            if (disturbed) {
                jitter(p, 0.03, random);
                for (double& h : p.h) h *= random.in(0.8, 1.25);
                for (double& v : p.volume) v *= random.in(0.8, 1.25);
            }
            ElasticBody<Dim> body(p, rubber, usual_hourglass_control, {Precision::mixed, Smoothing<Dim>(function)});
            const Tensor<Dim> a = linear_map<Dim>();
            body.deform(a, filled<Dim>(5));
            body.evaluate();
            double worst = 0, hourglass = 0;
            for (std::size_t i = 0; i < p.size(); ++i) worst = std::max(worst, (body.deformation_of(i) - a).norm());
            body.elastic_energy();
            for (const double e : body.hourglass_energies) hourglass = std::max(hourglass, e);
            CAPTURE(static_cast<int>(function), disturbed);
            // Positions of 5 m, a distance of 0.1 m: 50 eps for each pair, times |L| ≤ 10 at the corners.
            CHECK(worst < 1e-13);
            // Their squares: nothing is left of the hourglass energy, of k V · (strain of 1)² otherwise.
            CHECK(hourglass < 1e-26 * stiffness * p.volume[0]);
        }
}

TEMPLATE_TEST_CASE_SIG("a linear map far from the origin", "[elastic]", ((int Dim), Dim), 2, 3) {
    auto p = lattice(cube<Dim>(5, 0.1, 1.3));
    for (auto& column : p.position.c)
        for (double& x : column) x += 1e4;
    ElasticBody<Dim> body(p, rubber, usual_hourglass_control);
    body.deform(linear_map<Dim>());
    body.evaluate();
    double worst = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
        worst = std::max(worst, (body.deformation_of(i) - linear_map<Dim>()).norm());
    CHECK(worst < 3e-10);  // the grid of a double at 10 km is 2e-12 m, a spacing is 0.1 m; times |L| ≤ 10
}

TEMPLATE_TEST_CASE_SIG("two layers of particles are enough to define the deformation", "[elastic]", ((int Dim), Dim), 2,
                       3) {
    for (const auto function : {SmoothingFunction::cubic_spline, SmoothingFunction::wendland_c2,
                                SmoothingFunction::wendland_c4, SmoothingFunction::quintic_spline})
        for (const double h_over_d : {1.0, 1.3, 1.5, 2.0})
            for (const int width : {2, 9}) {
                LatticeBox<Dim> plate = cube<Dim>(width, 0.1, h_over_d);
                plate.hi.back() = 2;
                const ElasticBody<Dim> body(lattice(plate), rubber, usual_hourglass_control,
                                            {Precision::full, Smoothing<Dim>(function)});
                CAPTURE(static_cast<int>(function), h_over_d, width);
                CHECK(std::count(body.hourglass_stiffness.begin(), body.hourglass_stiffness.end(), 0.0) == 0);
            }
}

TEMPLATE_TEST_CASE_SIG("too few neighbours: no stress, whatever the positions", "[elastic]", ((int Dim), Dim), 2, 3) {
    // One, a pair, and a row: M is singular.
    for (const int n : {1, 2, 6}) {
        Particles<Dim> p;
        for (int i = 0; i < n; ++i) {
            Vec<Dim> x;
            x[0] = 0.1 * i;
            p.add(x, 0.15, 1000 * std::pow(0.1, Dim), 1000);
        }
        const NeighborList list = list_of(p);
        in_all_variants([&](Precision precision) {
            Random random(4);
            ElasticBody<Dim> body(p, list, rubber, usual_hourglass_control, precision);
            body.position = moved(p, random);
            for (auto& column : body.deformation.c) column.assign(p.size(), 9.0);
            body.evaluate();
            for (std::size_t i = 0; i < p.size(); ++i) CHECK(body.deformation_of(i) == Tensor<Dim>::Identity());
            CHECK(same_bits(body.gradient_correction, zeros<sym_components<Dim>>(p.size())));
            CHECK(same_bits(body.corrected_stress, zeros<Dim * Dim>(p.size())));
            CHECK(same_bits(body.acceleration, zeros<Dim>(p.size())));
            CHECK(body.elastic_energy() == 0);
        });
    }
}

TEMPLATE_TEST_CASE_SIG("a lone particle has no correction of an earlier list", "[elastic]", ((int Dim), Dim), 2, 3) {
    auto p = lattice(cube<Dim>(3, 0.1, 1.5));
    Vec<Dim> away;
    away[0] = 50;
    p.add(away, 0.15, 1, 1000);
    const NeighborList list = list_of(p);
    in_all_variants([&](Precision precision) {
        auto l = zeros<sym_components<Dim>>(p.size());
        for (auto& column : l.c) column.assign(p.size(), 9.0);
        ScalarField k(p.size(), 9.0);
        ParticleView<Dim> view = p.view();
        view.reference_position = view.position;
        elastic_correction<Dim>(view, list, {&stiffness, 1}, precision, l, k);
        CHECK(l[p.size() - 1] == Vec<sym_components<Dim>>{});
        CHECK(k[p.size() - 1] == 0);
        CHECK(k[0] == stiffness);
    });
}

}  // namespace sluice::test_total_lagrangian
