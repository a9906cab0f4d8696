#include "engine/step/balances.hpp"

#include <cmath>

#include "kernels/materials/jaumann.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

template <int Dim>
void add_motion(const ParticleSet<Dim>& phase, const Vec<Dim>& gravity, EnergyBalance& e) {
    e.kinetic +=
        ordered_sum<double>(phase.owned, [&](std::size_t i) { return 0.5 * phase.mass[i] * norm2(phase.velocity[i]); });
    e.potential -= ordered_sum<double>(phase.owned,
                                       [&](std::size_t i) { return phase.mass[i] * dot(gravity, phase.position[i]); });
}

/// Energies that both media of the paper have.
template <int Dim>
void add_common(const ParticleSet<Dim>& phase, const LinearEquationOfState& eos, const Vec<Dim>& gravity,
                EnergyBalance& e) {
    add_motion(phase, gravity, e);
    e.compression +=
        ordered_sum<double>(phase.owned, [&](std::size_t i) { return phase.mass[i] * eos.energy(phase.density[i]); });
}

}  // namespace

template <int Dim>
EnergyBalance energy_of(const State<Dim>& state) {
    EnergyBalance e;
    if (state.water) add_common<Dim>(state.fluid, state.water->eos, state.gravity, e);
    if (!state.rubber) return e;
    const auto& solid = state.solid;
    if (solid.deformation.size() > 0) {
        add_motion<Dim>(solid, state.gravity, e);
        e.elastic = ordered_sum<double>(solid.owned, [&](std::size_t i) {
            const double share = solid.elastic_share.size() > 0 ? solid.elastic_share[i] : 1.0;
            return share * solid.volume[i] *
                   state.rubber->law.template energy_density<Dim>(tensor_of<Dim>(solid.deformation[i]));
        });
        return e;
    }
    add_common<Dim>(solid, state.rubber->eos, state.gravity, e);
    e.elastic = ordered_sum<double>(solid.owned, [&](std::size_t i) {
        const double s2 = contract_deviator<Dim>(sym_to_tensor<Dim>(solid.deviatoric_stress[i]));
        return s2 / (4 * state.rubber->shear_modulus) * solid.mass[i] / solid.density[i];
    });
    return e;
}

template <int Dim>
Vec<Dim> momentum_of(const State<Dim>& state) {
    const auto of = [](const ParticleSet<Dim>& phase) {
        return ordered_sum<Vec<Dim>>(phase.owned, [&](std::size_t i) { return phase.mass[i] * phase.velocity[i]; });
    };
    return of(state.fluid) + of(state.solid);
}

template <int Dim>
double highest_speed(const ParticleSet<Dim>& phase) {
    return std::sqrt(nonnegative_max(phase.owned, [&](std::size_t i) { return norm2(phase.velocity[i]); }));
}

#define SLUICE_INSTANTIATE(Dim)                               \
    template EnergyBalance energy_of<Dim>(const State<Dim>&); \
    template Vec<Dim> momentum_of<Dim>(const State<Dim>&);    \
    template double highest_speed<Dim>(const ParticleSet<Dim>&);
SLUICE_INSTANTIATE(2)
SLUICE_INSTANTIATE(3)
#undef SLUICE_INSTANTIATE

}  // namespace sluice
