// A block of particles on a slightly disturbed lattice, with every column that a pass can read.
#pragma once

#include <cmath>
#include <random>

#include "kernels/pair.hpp"
#include "neighbor/neighbor_list.hpp"

namespace sluice::bench {

template <int Dim>
struct Block {
    VectorField<Dim> position, velocity;
    ScalarField h, mass, density, pressure, pressure_over_rho2;
    SymTensorField<Dim> stress, artificial;
    CellGrid<Dim> grid;
    NeighborList list;

    /// About n particles of spacing 1 mm, sorted, with their list.
    Block(std::size_t n, double h_over_d, int group_size = max_group_size) {
        const double d = 1e-3;
        const auto side = static_cast<int>(std::lround(std::pow(static_cast<double>(n), 1.0 / Dim)));
        std::mt19937 random(1);
        std::uniform_real_distribution<double> jitter(-0.1 * d, 0.1 * d);
        VectorField<Dim> lattice;
        for (long k = 0; k < std::lround(std::pow(side, Dim)); ++k) {
            Vec<Dim> x;
            long rest = k;
            for (int c = 0; c < Dim; ++c, rest /= side) x[c] = static_cast<double>(rest % side) * d + jitter(random);
            lattice.push_back(x);
        }
        const std::size_t count = lattice.size();
        grid.build(lattice, count, 0.5 * h_over_d * d);
        for (std::size_t i = 0; i < count; ++i) position.push_back(lattice[grid.order()[i]]);
        velocity.resize(count);
        stress.resize(count);
        artificial.resize(count);
        for (auto& column : velocity.c)
            for (double& v : column) v = jitter(random);
        h.assign(count, h_over_d * d);
        mass.assign(count, 1000 * std::pow(d, Dim));
        density.assign(count, 1000);
        pressure.assign(count, 100);
        pressure_over_rho2.assign(count, 1e-4);
        search(group_size);
    }

    void search(int group_size) {
        const double skin = 0.25 * h[0];
        grid.build(position, position.size(), 2 * h[0] + skin, h);
        const typename NeighborSearch<Dim>::Set set{position, grid};
        NeighborSearch<Dim>().build(set, position.size(), set, {h, h, skin}, group_size, list);
    }

    ParticleView<Dim> view() const {
        ParticleView<Dim> v;
        v.position = columns_of(position);
        v.velocity = columns_of(velocity);
        v.smoothing_length = h.data();
        v.mass = mass.data();
        v.density = density.data();
        v.pressure = pressure.data();
        v.pressure_over_rho2 = pressure_over_rho2.data();
        v.stress_over_rho2 = columns_of(stress);
        v.artificial_stress = columns_of(artificial);
        return v;
    }
};

}  // namespace sluice::bench
