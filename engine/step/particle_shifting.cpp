#include "engine/step/particle_shifting.hpp"

#include <cmath>

#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

/// Steps between two shifts. Particles go 0.1 h in a step at the most (Mach 0.1), and disorder grows over several h.
constexpr int shift_interval = 4;

}  // namespace

template <int Dim>
ParticleShifting<Dim>::ParticleShifting(StepContext<Dim>& context) : c_(context) {
    terms_.h_over_d = c_.scene.method.smoothing_length;
    terms_.strength = c_.scene.method.fluid.shifting;
}

template <int Dim>
double ParticleShifting<Dim>::find(std::uint64_t step) {
    if (!c_.has(Effect::particle_shifting) || step % shift_interval != 0) return 0;
    const auto scope = c_.timer.measure(StepPhase::shift_pass);
    look_around();
    auto& fluid = c_.state.fluid;
    const double duration = shift_interval * c_.plan.dt;
    return std::sqrt(nonnegative_max(fluid.owned, [&](std::size_t i) {
        const Vec<Dim> shift = particle_shift<Dim>(terms_, fluid.surroundings[i], fluid.smoothing_length[i],
                                                   duration * norm(fluid.velocity[i]));
        fluid.position.set(i, fluid.position[i] + shift);
        return norm2(shift);
    }));
}

template <int Dim>
void ParticleShifting<Dim>::look_around() {
    auto& fluid = c_.state.fluid;
    auto& around = fluid.surroundings;
    around.reset(fluid.position.size());
    const auto view = view_of(fluid);
    c_.pairs += shift_sums<Dim>(view, c_.neighbors.fluid_fluid, terms_, c_.method, around);
    if (c_.has(Effect::fixed_wall))
        c_.pairs +=
            boundary_shift_sums<Dim>(view, view_of(c_.state.wall), c_.neighbors.fluid_wall, terms_, c_.method, around);
    if (c_.has(Effect::moving_boundary))
        for (const NeighborList* list : {&c_.neighbors.fluid_boundary, &c_.neighbors.image_boundary})
            c_.pairs += boundary_shift_sums<Dim>(view, view_of(c_.state.boundary), *list, terms_, c_.method, around);
    mark_free_surface<Dim>(view, fluid.owned, around);
    c_.neighbors.refresh_fluid_surface();
    c_.pairs += surface_normals<Dim>(view, c_.neighbors.fluid_fluid, c_.method, around);
}

template class ParticleShifting<2>;
template class ParticleShifting<3>;

}  // namespace sluice
