#include "engine/step/parts/particle_shifting.hpp"

#include <algorithm>
#include <cmath>

#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

/// The most steps between two shifts. Disorder grows over several h; at Mach 0.1 particles move 0.1 h in a step.
constexpr std::uint64_t longest_interval = 4;

/// δx = −D ∇C of all particles at once overshoots if D is too large: on a square lattice with Wendland C2 and h = 1.5 d
/// the shortest waves grow beyond D = 0.51 h² (validation/taylor_green). A particle is shifted no
/// farther than that.
constexpr double largest_diffusivity = 0.4;  // over h²

}  // namespace

template <int Dim>
ParticleShifting<Dim>::ParticleShifting(StepContext<Dim>& context)
    : c_(context), fluid_(context.neighbors.pair({SetId::fluid, SetId::fluid}).list) {
    const auto boundary = [&](Targets targets) {
        return &c_.neighbors.pair({SetId::fluid, SetId::boundary, Upkeep::coupling, targets}).list;
    };
    if (c_.has(Effect::fixed_wall)) at_walls_ = &c_.neighbors.pair({SetId::fluid, SetId::wall}).list;
    if (c_.has(Effect::moving_boundary))
        at_solids_ = boundary(Targets::own), at_solid_ghosts_ = boundary(Targets::ghosts);
    terms_.h_over_d = c_.scene.method.smoothing_length;
    terms_.strength = c_.scene.method.fluid.shifting;
}

template <int Dim>
double ParticleShifting<Dim>::shift(std::uint64_t step) {
    if (!c_.has(Effect::particle_shifting) || step < next_) return 0;
    const auto scope = c_.timer.measure(StepPhase::shift_pass);
    look_around();
    auto& fluid = c_.state.fluid;
    const double duration = static_cast<double>(step + 1 - last_) * c_.plan.dt;
    const double longest = std::sqrt(nonnegative_max(fluid.owned, [&](std::size_t i) {
        const double h = fluid.smoothing_length[i];
        const double path = std::min(duration * norm(fluid.velocity[i]), largest_diffusivity * h / terms_.strength);
        const Vec<Dim> displacement = particle_shift<Dim>(terms_, surroundings_of<Dim>(fluid, i), h, path);
        fluid.position.set(i, fluid.position[i] + displacement);
        return norm2(displacement);
    }));
    const double fastest = c_.plan.dt * nonnegative_max(fluid.owned, [&](std::size_t i) {
                               return norm(fluid.velocity[i]) / fluid.smoothing_length[i];
                           });
    last_ = step + 1;
    next_ = step + interval_for(fastest);
    return longest;
}

/// The number of steps after which the fastest particles would overshoot.
template <int Dim>
std::uint64_t ParticleShifting<Dim>::interval_for(double path_over_h) const {
    const double steps = largest_diffusivity / std::max(terms_.strength * path_over_h, 1e-3);
    return std::clamp<std::uint64_t>(static_cast<std::uint64_t>(steps), 1, longest_interval);
}

template <int Dim>
void ParticleShifting<Dim>::look_around() {
    auto& fluid = c_.state.fluid;
    clear_surroundings<Dim>(fluid, fluid.owned, fluid.size());
    const auto view = view_of(fluid);
    c_.pairs += shift_sums<Dim>(view, fluid_, terms_, c_.method, fluid);
    const auto add = [&](const ParticleSet<Dim>& boundary, const NeighborList& list) {
        c_.pairs += boundary_shift_sums<Dim>(view, view_of(boundary), list, terms_, c_.method, fluid);
    };
    if (at_walls_) add(c_.state.wall, *at_walls_);
    if (at_solids_) add(c_.state.boundary, *at_solids_), add(c_.state.boundary, *at_solid_ghosts_);
    mark_free_surface<Dim>(view, fluid.owned, fluid);
    c_.state.fluid.refresh_ghosts(column::surface_volume);
    c_.pairs += surface_normals<Dim>(view, fluid_, c_.method, fluid);
}

template class ParticleShifting<2>;
template class ParticleShifting<3>;

}  // namespace sluice
