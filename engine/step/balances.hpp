// Energy, momentum and highest speed of particles. Sums do not depend on the number of threads.
#pragma once

#include <cmath>

#include "engine/particles/materials.hpp"
#include "engine/particles/part_range.hpp"
#include "engine/particles/particle_set.hpp"
#include "engine/step/energy_balance.hpp"

namespace sluice {

/// Adds kinetic energy and potential energy −m g·x.
template <int Dim>
void add_motion(const ParticleSet<Dim>& set, const PartRange& part, const Vec<Dim>& gravity, EnergyBalance& e) {
    e.kinetic += ordered_sum<double>(part, [&](std::size_t i) { return 0.5 * set.mass[i] * norm2(set.velocity[i]); });
    e.potential -=
        ordered_sum<double>(part, [&](std::size_t i) { return set.mass[i] * dot(gravity, set.position[i]); });
}

/// Adds the energy of compression, m ∫ p/ρ² dρ.
template <int Dim>
void add_compression(const ParticleSet<Dim>& set, const PartRange& part, const MaterialList& materials,
                     EnergyBalance& e) {
    e.compression += with_materials(materials, set.body, [&](const auto& material) {
        return ordered_sum<double>(part,
                                   [&](std::size_t i) { return set.mass[i] * material(i).eos.energy(set.density[i]); });
    });
}

/// Σ m v
template <int Dim>
Vec<Dim> momentum_of(const ParticleSet<Dim>& set, const PartRange& part) {
    return ordered_sum<Vec<Dim>>(part, [&](std::size_t i) { return set.mass[i] * set.velocity[i]; });
}

/// Highest |v| of a set [m/s]; NaN if any is not finite.
template <int Dim>
double highest_speed(const ParticleSet<Dim>& set) {
    return std::sqrt(nonnegative_max(set.owned, [&](std::size_t i) { return norm2(set.velocity[i]); }));
}

}  // namespace sluice
