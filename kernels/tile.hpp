// A block of possible partners, gathered once for a group of particles and then read lane by lane.
#pragma once

#include <span>

#include "kernels/pair.hpp"

namespace sluice {

/// Columns that a term reads besides position and smoothing length. Each term names its own in `reads_i` and `reads_j`;
/// only those of the pack's terms are gathered.
namespace column {
inline constexpr unsigned velocity = 1, mass = 2, volume = 4, density = 8, pressure = 16, pressure_over_rho2 = 32,
                          stress_over_rho2 = 64, artificial_stress = 128;
}

/// Lanes of a tile: few enough that all columns of the widest pass stay in the first-level cache.
inline constexpr int tile_capacity = 128;
/// Tiles are filled up to a multiple of this, the lanes of the widest vectors, so that no loop has a remainder.
template <class Real>
inline constexpr int lane_multiple = 64 / static_cast<int>(sizeof(Real));

/// i's own values.
template <int Dim, class Real, unsigned Reads>
struct Self {
    Vec<Dim, Real> position;  ///< relative to the tile's origin
    Real smoothing_length;
    Vec<Dim, Real> velocity;
    Real density{}, pressure{}, pressure_over_rho2{};
    Vec<sym_components<Dim>, Real> stress_over_rho2, artificial_stress;

    Self(const ParticleView<Dim>& a, Index i, const Vec<Dim>& origin)
        : position(vec_cast<Real>(at<double>(a.position, i) - origin)),
          smoothing_length(static_cast<Real>(a.smoothing_length[i])) {
        if constexpr (Reads & column::velocity) velocity = at<Real>(a.velocity, i);
        if constexpr (Reads & column::density) density = static_cast<Real>(a.density[i]);
        if constexpr (Reads & column::pressure) pressure = static_cast<Real>(a.pressure[i]);
        if constexpr (Reads & column::pressure_over_rho2)
            pressure_over_rho2 = static_cast<Real>(a.pressure_over_rho2[i]);
        if constexpr (Reads & column::stress_over_rho2) stress_over_rho2 = at<Real>(a.stress_over_rho2, i);
        if constexpr (Reads & column::artificial_stress) artificial_stress = at<Real>(a.artificial_stress, i);
    }
};

/// Positions are kept relative to an origin near the group, formed in double and then rounded: single precision stays
/// accurate far from the scene's origin.
template <int Dim, class Real, unsigned Reads>
struct alignas(64) Tile {
    static constexpr int lanes_if(unsigned c) { return Reads & c ? tile_capacity : lane_multiple<Real>; }

    alignas(64) Real position[Dim][tile_capacity];
    alignas(64) Real smoothing_length[tile_capacity];
    alignas(64) Real velocity[Dim][lanes_if(column::velocity)];
    alignas(64) Real mass[lanes_if(column::mass)];
    alignas(64) Real volume[lanes_if(column::volume)];
    alignas(64) Real density[lanes_if(column::density)];
    alignas(64) Real pressure[lanes_if(column::pressure)];
    alignas(64) Real pressure_over_rho2[lanes_if(column::pressure_over_rho2)];
    alignas(64) Real stress_over_rho2[sym_components<Dim>][lanes_if(column::stress_over_rho2)];
    alignas(64) Real artificial_stress[sym_components<Dim>][lanes_if(column::artificial_stress)];
    template <int N, int Lanes>
    static Vec<N, Real> tuple(const Real (&columns)[N][Lanes], int j) {
        Vec<N, Real> v;
        unroll<N>([&](int k) { v[k] = columns[k][j]; });
        return v;
    }

    /// Gathers the candidates (at most tile_capacity) and fills up with partners out of every support and of no mass.
    /// Smoothing lengths are left out if all are known to equal i's. Returns the lanes to go over, a multiple of
    /// lane_multiple.
    template <bool EqualH>
    int gather(const ParticleView<Dim>& b, std::span<const Index> candidates, const Vec<Dim>& origin) {
        const int n = static_cast<int>(candidates.size());
        for (int k = 0; k < Dim; ++k)
            fill(position[k], candidates,
                 [&, column = b.position[static_cast<std::size_t>(k)]](Index j) { return column[j] - origin[k]; });
        if constexpr (!EqualH) fill_scalar(smoothing_length, candidates, b.smoothing_length);
        if constexpr (Reads & column::velocity) fill_tuple(velocity, candidates, b.velocity);
        if constexpr (Reads & column::mass) fill_scalar(mass, candidates, b.mass);
        if constexpr (Reads & column::volume) fill_scalar(volume, candidates, b.volume);
        if constexpr (Reads & column::density) fill_scalar(density, candidates, b.density);
        if constexpr (Reads & column::pressure) fill_scalar(pressure, candidates, b.pressure);
        if constexpr (Reads & column::pressure_over_rho2)
            fill_scalar(pressure_over_rho2, candidates, b.pressure_over_rho2);
        if constexpr (Reads & column::stress_over_rho2) fill_tuple(stress_over_rho2, candidates, b.stress_over_rho2);
        if constexpr (Reads & column::artificial_stress) fill_tuple(artificial_stress, candidates, b.artificial_stress);
        return pad<EqualH>(n, static_cast<Real>(b.smoothing_length[candidates[0]]));
    }

  private:
    template <class F>
    static void fill(Real* lanes, std::span<const Index> candidates, F&& value) {
        for (std::size_t l = 0; l < candidates.size(); ++l) lanes[l] = static_cast<Real>(value(candidates[l]));
    }
    static void fill_scalar(Real* lanes, std::span<const Index> candidates, const double* column) {
        fill(lanes, candidates, [column](Index j) { return column[j]; });
    }
    template <int N, int Lanes, std::size_t M>
    static void fill_tuple(Real (&lanes)[N][Lanes], std::span<const Index> candidates,
                           const std::array<const double*, M>& columns) {
        for (std::size_t k = 0; k < M; ++k) fill_scalar(lanes[k], candidates, columns[k]);
    }

    /// Copies of the first partner, moved out of every support and without mass or volume: every term is zero there,
    /// and finite.
    template <bool EqualH>
    int pad(int n, Real h) {
        const int padded = (n + lane_multiple<Real> - 1) & -lane_multiple<Real>;
        const auto repeat = [&](Real* lanes) {
            for (int l = n; l < padded; ++l) lanes[l] = lanes[0];
        };
        if constexpr (!EqualH) repeat(smoothing_length);
        for (int l = n; l < padded; ++l) position[0][l] = position[0][0] + far * h;
        for (int k = 1; k < Dim; ++k) repeat(position[k]);
        if constexpr (Reads & column::velocity)
            for (auto& lanes : velocity) repeat(lanes);
        if constexpr (Reads & column::mass)
            for (int l = n; l < padded; ++l) mass[l] = 0;
        if constexpr (Reads & column::volume)
            for (int l = n; l < padded; ++l) volume[l] = 0;
        if constexpr (Reads & column::density) repeat(density);
        if constexpr (Reads & column::pressure) repeat(pressure);
        if constexpr (Reads & column::pressure_over_rho2) repeat(pressure_over_rho2);
        if constexpr (Reads & column::stress_over_rho2)
            for (auto& lanes : stress_over_rho2) repeat(lanes);
        if constexpr (Reads & column::artificial_stress)
            for (auto& lanes : artificial_stress) repeat(lanes);
        return padded;
    }

    static constexpr Real far = Real(1e4);  ///< in smoothing lengths
};

}  // namespace sluice
