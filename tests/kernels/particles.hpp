// Sets of particles for the tests of the pair passes: plain columns, the lists between them, and how results compare.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "kernels/pair.hpp"
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

enum class Scene { lattice, jittered, unequal, crowded };
inline constexpr std::array scenes{Scene::lattice, Scene::jittered, Scene::unequal, Scene::crowded};

/// A set of particles in a random state. `crowded` has far more candidates per group than a tile has lanes.
template <int Dim>
Particles<Dim> make_scene(Scene scene, unsigned seed = 1) {
    Random random(seed);
    const double d = 0.1;
    Particles<Dim> p = lattice(cube<Dim>(Dim == 2 ? 24 : 9, d, 1.3));
    if (scene != Scene::lattice) jitter(p, 0.3 * d, random);
    if (scene == Scene::unequal || scene == Scene::crowded) randomize_h(p, random);
    if (scene == Scene::crowded)
        for (std::size_t i = 0; i < p.size(); i += 2) p.position.set(i, random.vector<Dim>(0, Dim == 2 ? d : 2 * d));
    randomize_state(p, random);
    return p;
}

/// Cut-offs as the passes need them: the pair's mean support, or the particle's own towards points without h.
inline PairReach pair_reach(const ScalarField& query_h, const ScalarField& target_h, double skin = 0) {
    return {query_h, target_h, skin, query_h.empty() || target_h.empty() ? 2.0 : 1.0,
            query_h.empty() || target_h.empty() ? 2.0 : 1.0};
}

template <int Dim>
NeighborList list_between(const VectorField<Dim>& query, const ScalarField& query_h, const VectorField<Dim>& target,
                          const ScalarField& target_h, int group_size) {
    double smallest = std::numeric_limits<double>::max();
    for (const auto* h : {&query_h, &target_h})
        if (!h->empty()) smallest = std::min(smallest, *std::min_element(h->begin(), h->end()));
    CellGrid<Dim> query_grid, target_grid;
    query_grid.build(query, query.size(), 2.2 * smallest, query_h);
    const bool same = &query == &target;
    if (!same) target_grid.build(target, target.size(), 2.2 * smallest, target_h);
    NeighborList list;
    NeighborSearch<Dim>().build({query, query_grid}, query.size(), {target, same ? query_grid : target_grid},
                                pair_reach(query_h, target_h, 0.2 * smallest), group_size, list);
    return list;
}

template <int Dim>
NeighborList list_of(const Particles<Dim>& p, int group_size = max_group_size) {
    return list_between<Dim>(p.position, p.h, p.position, p.h, group_size);
}

template <int Dim>
NeighborList list_of(const Particles<Dim>& p, const Particles<Dim>& q, int group_size = max_group_size) {
    return list_between<Dim>(p.position, p.h, q.position, q.h, group_size);
}

template <int Dim>
std::size_t largest_group(const NeighborList& list) {
    std::size_t n = 0;
    for (std::size_t g = 0; g < list.groups(); ++g) n = std::max(n, list.candidates(g).size());
    return n;
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
