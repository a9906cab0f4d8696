// Sets of particles to run passes on: slightly disturbed lattices, sorted, with every column that a pass can read.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <random>

#include "kernels/pairs/particle_view.hpp"
#include "neighbor/cluster_grid.hpp"
#include "neighbor/neighbor_list.hpp"

namespace sluice::bench {

/// Particle distance d [m].
inline constexpr double spacing = 1e-3;
/// Edge of the search's cells, as in the engine: 64 particles to a cell, which is a block.
template <int Dim>
inline constexpr double cell_size = (Dim == 2 ? 8 : 4) * spacing;

/// Particles of one kind, in the order of their clusters.
template <int Dim>
struct Medium {
    VectorField<Dim> position, velocity, acceleration, area_normal, shared_force, density_gradient;
    ScalarField h, mass, volume, density, pressure, pressure_over_rho2, hourglass_stiffness;
    SymTensorField<Dim> stress, artificial, gradient_correction;
    TupleField<Dim * Dim> deformation, corrected_stress;
    Array<std::uint16_t> body;
    ClusterGrid<Dim> grid;

    Medium(const VectorField<Dim>& places, double h_over_d) {
        const std::size_t n = places.size();
        h.assign(n, h_over_d * spacing);
        grid.build(places, 0, n, cell_size<Dim>, h);
        for (const Index i : grid.order()) position.push_back(places[i]);
        grid.particles_were_sorted(0);
        velocity.resize(n);
        std::mt19937 random(2);
        std::uniform_real_distribution<double> speed(-1, 1);
        for (ScalarField& column : velocity.c)
            for (double& v : column) v = speed(random);
        acceleration.resize(n);
        area_normal.resize(n);
        shared_force.resize(n);
        density_gradient.resize(n);
        stress.resize(n);
        artificial.resize(n);
        deformation.resize(n);
        corrected_stress.resize(n);
        // An elastic body that is not deformed, L = I: F = I, but for the lattice's disorder.
        gradient_correction.resize(n);
        for (std::size_t k = 0; k < Dim; ++k) gradient_correction.c[k].assign(n, 1);
        hourglass_stiffness.assign(n, 1e6);
        body.assign(n, 0);
        volume.assign(n, std::pow(spacing, Dim));
        mass.assign(n, 1000 * volume[0]);
        density.assign(n, 1000);
        pressure.assign(n, 100);
        pressure_over_rho2.assign(n, 1e-4);
    }

    std::size_t size() const { return position.size(); }
    typename NeighborSearch<Dim>::Set set() const { return {position, h}; }

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
        v.stress_over_rho2 = columns_of(stress);
        v.artificial_stress = columns_of(artificial);
        v.mean_acceleration = columns_of(acceleration);
        v.area_normal = columns_of(area_normal);
        v.shared_force = columns_of(shared_force);
        v.density_gradient = columns_of(density_gradient);
        v.reference_position = v.position;
        v.deformation = columns_of(deformation);
        v.corrected_stress = columns_of(corrected_stress);
        v.hourglass_stiffness = hourglass_stiffness.data();
        v.gradient_correction = columns_of(gradient_correction);
        return v;
    }
};

/// Lattice points, moved by up to a tenth of the spacing at random, from a corner on.
template <int Dim>
VectorField<Dim> disturbed_lattice(const std::array<long, Dim>& sides, const Vec<Dim>& corner) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> shift(-0.1 * spacing, 0.1 * spacing);
    long count = 1;
    for (const long side : sides) count *= side;
    VectorField<Dim> places;
    for (long n = 0; n < count; ++n) {
        Vec<Dim> x = corner;
        long rest = n;
        for (int k = 0; k < Dim; ++k) {
            const long side = sides[static_cast<std::size_t>(k)];
            x[k] += static_cast<double>(rest % side) * spacing + shift(random);
            rest /= side;
        }
        places.push_back(x);
    }
    return places;
}

/// Skins over h: lists are built with the engine's, then pruned to about what it prunes to while water flows.
inline constexpr double build_skin = 0.25, pruned_skin = 0.1;

/// Builds and prunes a's list of b. `scales`: whose reach counts how much.
template <int Dim>
void list_neighbours(const Medium<Dim>& a, const Medium<Dim>& b, CutOff scales, NeighborList& list) {
    NeighborSearch<Dim> search;
    const ClusterGrid<Dim>* const target = &b.grid;
    scales.skin = build_skin * b.h[0];
    search.build(a.grid, {&target, 1}, scales, list);
    scales.skin = pruned_skin * b.h[0];
    search.prune(a.set(), b.set(), scales, list);
}

/// A cube (square) of about n particles of one medium.
template <int Dim>
struct Cube {
    static constexpr int dim = Dim;
    Medium<Dim> medium;
    NeighborList list;

    Cube(std::size_t n, double h_over_d) : medium(places(n), h_over_d) { list_neighbours(medium, medium, {}, list); }

    static VectorField<Dim> places(std::size_t n) {
        std::array<long, Dim> sides;
        sides.fill(std::lround(std::pow(static_cast<double>(n), 1.0 / Dim)));
        return disturbed_lattice<Dim>(sides, {});
    }
};

/// Four layers of fluid on four layers of wall or solid, about n particles in all, and interface elements between them,
/// one per spacing.
template <int Dim>
struct Boundary {
    static constexpr int dim = Dim;
    Medium<Dim> fluid, backing, elements;
    NeighborList fluid_backing, backing_fluid, element_fluid, fluid_element, element_backing, backing_element;

    Boundary(std::size_t n, double h_over_d)
        : fluid(layers(n, 4, 0.5), h_over_d),
          backing(layers(n, 4, -3.5), h_over_d),
          elements(layers(n, 1, 0), h_over_d) {
        list_neighbours(fluid, backing, {}, fluid_backing);
        list_neighbours(backing, fluid, {}, backing_fluid);
        // Between an element and a particle, the particle's support counts alone.
        const CutOff of_query{0, 2, 0}, of_target{0, 0, 2};
        list_neighbours(elements, fluid, of_target, element_fluid);
        list_neighbours(fluid, elements, of_query, fluid_element);
        list_neighbours(elements, backing, of_target, element_backing);
        list_neighbours(backing, elements, of_query, backing_element);
    }

    /// Across the last axis, the first at `height` spacings above the interface.
    static VectorField<Dim> layers(std::size_t n, long count, double height) {
        std::array<long, Dim> sides;
        sides.fill(std::lround(std::pow(static_cast<double>(n) / 8, 1.0 / (Dim - 1))));
        sides.back() = count;
        Vec<Dim> corner;
        corner[Dim - 1] = height * spacing;
        return disturbed_lattice<Dim>(sides, corner);
    }
};

/// A Cube or Boundary, kept until another one is asked for: benchmarks that follow each other mostly share it.
template <class Sample>
Sample& cached(std::size_t particles, double h_over_d) {
    static std::unique_ptr<Sample> sample;
    static std::size_t cached_particles;
    static double cached_h;
    if (!sample || particles != cached_particles || h_over_d != cached_h) {
        sample.reset();  // before the next one takes its memory
        sample = std::make_unique<Sample>(particles, h_over_d);
        cached_particles = particles;
        cached_h = h_over_d;
    }
    return *sample;
}

}  // namespace sluice::bench
