// Sets of particles for the tests of the pair passes: plain columns, the lists between them, and how results compare.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "kernels/pairs/particle_view.hpp"
#include "neighbor/neighbor_list.hpp"
#include "tests/neighbor/clouds.hpp"

namespace sluice {

/// Every column that some pass reads. Stress σ stands beside σ/ρ², p beside p/ρ².
template <int Dim>
struct Particles {
    VectorField<Dim> position, velocity;
    ScalarField h, mass, volume, density, pressure, pressure_over_rho2;
    SymTensorField<Dim> stress, stress_over_rho2, artificial_stress;

    std::size_t size() const { return position.size(); }

    void add(const Vec<Dim>& x, double smoothing_length, double m, double rho) {
        position.push_back(x);
        velocity.push_back({});
        h.push_back(smoothing_length);
        mass.push_back(m);
        density.push_back(rho);
        volume.push_back(m / rho);
        pressure.push_back(0);
        pressure_over_rho2.push_back(0);
        stress.push_back({});
        stress_over_rho2.push_back({});
        artificial_stress.push_back({});
    }
    /// Brings volume, p/ρ² and σ/ρ² in line with the other columns.
    void derive() {
        for (std::size_t i = 0; i < size(); ++i) {
            const double rho2 = density[i] * density[i];
            volume[i] = mass[i] / density[i];
            pressure_over_rho2[i] = pressure[i] / rho2;
            stress_over_rho2.set(i, (1 / rho2) * stress[i]);
        }
    }
    ParticleView<Dim> view() const {
        ParticleView<Dim> v;
        v.position = columns_of(position);
        v.velocity = columns_of(velocity);
        v.smoothing_length = h.data();
        v.mass = mass.data();
        v.volume = volume.data();
        v.density = density.data();
        v.pressure = pressure.data();
        v.pressure_over_rho2 = pressure_over_rho2.data();
        v.stress_over_rho2 = columns_of(stress_over_rho2);
        v.artificial_stress = columns_of(artificial_stress);
        return v;
    }
};

/// Cells of a lattice: those whose index lies in [lo, hi) along every axis, centres at (i + ½) d.
template <int Dim>
struct LatticeBox {
    std::array<int, Dim> lo, hi;
    double d = 0.1;  ///< spacing [m]
    double h_over_d = 1.5;
    double density = 1000;  ///< [kg/m³]
};

/// A cube of n cells along each axis.
template <int Dim>
LatticeBox<Dim> cube(int n, double d, double h_over_d) {
    LatticeBox<Dim> box;
    box.lo.fill(0);
    box.hi.fill(n);
    box.d = d;
    box.h_over_d = h_over_d;
    return box;
}

template <int Dim>
Particles<Dim> lattice(const LatticeBox<Dim>& box) {
    Particles<Dim> p;
    std::array<int, Dim> at = box.lo;
    const double mass = box.density * std::pow(box.d, Dim);
    for (;;) {
        Vec<Dim> x;
        for (int k = 0; k < Dim; ++k) x[k] = (at[static_cast<std::size_t>(k)] + 0.5) * box.d;
        p.add(x, box.h_over_d * box.d, mass, box.density);
        std::size_t k = 0;
        while (k < Dim && ++at[k] == box.hi[k]) {
            at[k] = box.lo[k];
            ++k;
        }
        if (k == Dim) return p;
    }
}

/// Moves every particle by up to ±amplitude along each axis.
template <int Dim>
void jitter(Particles<Dim>& p, double amplitude, Random& random) {
    for (std::size_t i = 0; i < p.size(); ++i)
        p.position.set(i, p.position[i] + random.vector<Dim>(-amplitude, amplitude));
}

/// Random velocity, density, mass, pressure, stress and R; negative pressures and tension among them.
template <int Dim>
void randomize_state(Particles<Dim>& p, Random& random) {
    for (std::size_t i = 0; i < p.size(); ++i) {
        p.velocity.set(i, random.vector<Dim>(-2, 2));
        p.density[i] = random.in(800, 1200);
        p.mass[i] *= random.in(0.5, 2);
        p.pressure[i] = random.in(-1e4, 3e4);
        p.stress.set(i, random.vector<sym_components<Dim>>(-1e5, 1e5));
        p.artificial_stress.set(i, random.vector<sym_components<Dim>>(-0.1, 0.1));
    }
    p.derive();
}

/// h in the ratio 1 : 4.
template <int Dim>
void randomize_h(Particles<Dim>& p, Random& random) {
    for (double& h : p.h) h *= random.in(0.5, 2);
}

/// Brings the particles into another order.
template <int Dim, class Order>
void reorder(Particles<Dim>& p, const Order& order) {
    p.position = reordered(p.position, order);
    p.velocity = reordered(p.velocity, order);
    for (ScalarField* column : {&p.h, &p.mass, &p.volume, &p.density, &p.pressure, &p.pressure_over_rho2})
        *column = reordered(*column, order);
    for (auto* tensors : {&p.stress, &p.stress_over_rho2, &p.artificial_stress}) *tensors = reordered(*tensors, order);
}

/// Edge of the cells that lists are searched with: between a few particles each, so that many clusters are not full,
/// and several blocks.
inline double cell_for(const ScalarField& h) { return h.empty() ? 1.0 : 4 * *std::min_element(h.begin(), h.end()); }

/// What a set of particles looks like. `odd`: several at one place, and some without any neighbour.
enum class Scene { lattice, jittered, unequal, crowded, odd };
inline constexpr std::array scenes{Scene::lattice, Scene::jittered, Scene::unequal, Scene::crowded, Scene::odd};

/// The same set at another size, of the same densities and smoothing lengths per spacing.
template <int Dim>
void rescale(Particles<Dim>& p, double factor) {
    for (auto& column : p.position.c)
        for (double& x : column) x *= factor;
    for (double& h : p.h) h *= factor;
    for (double& m : p.mass) m *= std::pow(factor, Dim);
    p.derive();
}

/// Powers of h leave the range of a float long before lengths do. From the scenes' spacing of 0.1 m to 1 mm, 1 µm, 1
/// km.
inline constexpr std::array scales{1e-2, 1e-5, 1e4};

/// How a set of particles stands in memory: in an order of chance, where loops go through indices, or in the grid's,
/// where they run along memory.
enum class Layout { shuffled, sorted };
inline constexpr std::array layouts{Layout::shuffled, Layout::sorted};

template <int Dim>
void lay_out(Particles<Dim>& p, Layout layout) {
    Random random(99);
    reorder(p, shuffled(p.size(), random));
    if (layout == Layout::shuffled) return;
    const ThreadScope scope(1);
    ClusterGrid<Dim> grid;
    grid.build(p.position, 0, p.size(), cell_for(p.h), p.h);
    reorder(p, grid.order());
}

/// A set of particles in a random state.
template <int Dim>
Particles<Dim> make_scene(Scene scene, unsigned seed = 1, Layout layout = Layout::shuffled) {
    Random random(seed);
    const double d = 0.1;
    Particles<Dim> p = lattice(cube<Dim>(Dim == 2 ? 24 : 9, d, 1.3));
    if (scene != Scene::lattice) jitter(p, 0.3 * d, random);
    if (scene != Scene::lattice && scene != Scene::jittered) randomize_h(p, random);
    if (scene == Scene::crowded)
        for (std::size_t i = 0; i < p.size(); i += 2) p.position.set(i, random.vector<Dim>(0, Dim == 2 ? d : 2 * d));
    if (scene == Scene::odd)
        for (std::size_t i = 5; i + 1 < p.size(); i += 7) {
            for (std::size_t k = 1; k <= i % 5; ++k) p.position.set(i - k, p.position[i]);
            if (i % 11 == 0) p.position.set(i, 10.0 * p.position[i]);
        }
    randomize_state(p, random);
    lay_out(p, layout);
    return p;
}

/// Lists of all queries as the passes need them, pruned, with a skin that leaves pairs outside the support in. Points
/// without h see twice the particles' own.
template <int Dim>
NeighborList list_between(const VectorField<Dim>& query, const ScalarField& query_h, const VectorField<Dim>& target,
                          const ScalarField& target_h) {
    const ThreadScope scope(1);
    const double h_scale = query_h.empty() || target_h.empty() ? 2 : 1,
                 cell = cell_for(query_h.empty() ? target_h : query_h);
    const ScalarField none(std::max(query.size(), target.size()), 0.0);
    const auto &query_reach = query_h.empty() ? none : query_h, &target_reach = target_h.empty() ? none : target_h;
    const CutOff cut{0.05 * cell, h_scale, h_scale};
    ClusterGrid<Dim> query_grid, target_grid;
    query_grid.build(query, 0, query.size(), cell, query_reach);
    const bool same = &query == &target;
    if (!same) target_grid.build(target, 0, target.size(), cell, target_reach);
    const ClusterGrid<Dim>* const targets = same ? &query_grid : &target_grid;
    NeighborList list;
    NeighborSearch<Dim> searcher;
    searcher.build(query_grid, {&targets, 1}, cut, list);
    searcher.prune({query, query_reach}, {target, target_reach}, cut, list);
    return list;
}

template <int Dim>
NeighborList list_of(const Particles<Dim>& p) {
    return list_between<Dim>(p.position, p.h, p.position, p.h);
}

template <int Dim>
NeighborList list_of(const Particles<Dim>& p, const Particles<Dim>& q) {
    return list_between<Dim>(p.position, p.h, q.position, q.h);
}

template <int N>
TupleField<N> zeros(std::size_t n) {
    TupleField<N> f;
    f.resize(n);
    return f;
}

/// Distance of two numbers in units of `scale`; infinite for a NaN.
inline double relative_error(double got, double want, double scale) {
    const double e = std::abs(got - want);
    if (e == 0) return 0;
    return e / scale < std::numeric_limits<double>::infinity() ? e / scale : std::numeric_limits<double>::infinity();
}

}  // namespace sluice
