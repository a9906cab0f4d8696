#include "engine/step/couplings/boundary_coupling.hpp"

#include <algorithm>

#include "engine/files/state_visitors.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {

template <int Dim>
BoundaryCoupling<Dim>::BoundaryCoupling(StepContext<Dim>& context)
    : c_(context),
      of_fluid_(list(SetId::fluid, SetId::boundary, Targets::own)),
      ghosts_of_fluid_(list(SetId::fluid, SetId::boundary, Targets::ghosts)),
      of_boundary_(list(SetId::boundary, SetId::fluid, Targets::own)),
      ghosts_of_boundary_(list(SetId::boundary, SetId::fluid, Targets::ghosts)) {
    for (const Body& body : c_.scene.bodies) {
        const Material& material = c_.scene.materials[body.material];
        const bool solid = material.kind == MaterialKind::solid;
        relaxation_.push_back(solid ? light_solid(c_.scene, material).relaxation : 1);
        relaxes_ = relaxes_ || relaxation_.back() < 1;
    }
    c_.neighbors.place_before(SetId::boundary, [this] {
        auto& boundary = c_.state.boundary;
        const auto& index_of_id = c_.neighbors.solid_index_of_id();
        for (std::size_t i = 0; i < boundary.owned; ++i)
            boundary.position.set(i, c_.state.solid.position[index_of_id[boundary.solid_id[i]]]);
    });
}

template <int Dim>
const NeighborList& BoundaryCoupling<Dim>::list(SetId query, SetId target, Targets targets) {
    return c_.neighbors.pair({query, target, Upkeep::coupling, targets}).list;
}

template <int Dim>
void BoundaryCoupling<Dim>::forces() {
    const auto scope = c_.timer.measure(StepPhase::interface_pass);
    follow_acceleration();
    follow(c_.state.solid.position, c_.state.solid.velocity);
    auto& boundary = c_.state.boundary;
    auto& fluid = c_.state.fluid;
    const Vec<Dim> gravity = c_.state.gravity;
    const auto solid_view = view_of(boundary), fluid_view = view_of(fluid);
    for (auto& column : boundary.force.c) std::fill(column.begin(), column.end(), 0.0);
    Vec<Dim> on_solid =
        boundary_reaction<Dim>(solid_view, fluid_view, of_boundary_, gravity, c_.method, block_totals_, boundary.force);
    boundary_reaction<Dim>(solid_view, fluid_view, ghosts_of_boundary_, gravity, c_.method, block_totals_,
                           boundary.force);
    Vec<Dim> on_fluid = boundary_pressure_on_fluid<Dim>(fluid_view, solid_view, of_fluid_, gravity, c_.method,
                                                        block_totals_, fluid.acceleration);
    boundary_pressure_on_fluid<Dim>(fluid_view, solid_view, ghosts_of_fluid_, gravity, c_.method, block_totals_,
                                    fluid.acceleration);
    if (c_.has(Effect::no_slip_solid)) friction(on_solid, on_fluid);
    hand_over();
    record_balance(on_solid, on_fluid);
    count_pairs({&of_boundary_, &ghosts_of_boundary_, &of_fluid_, &ghosts_of_fluid_});
}

template <int Dim>
void BoundaryCoupling<Dim>::friction(Vec<Dim>& on_solid, Vec<Dim>& on_fluid) {
    auto& boundary = c_.state.boundary;
    auto& fluid = c_.state.fluid;
    const double viscosity = c_.state.fluid_materials.front().viscosity;
    parallel_for(boundary.owned, [&](std::size_t i) { boundary.ghost_velocity.set(i, boundary.velocity[i]); });
    const auto fluid_view = view_of(fluid);
    // Ghosts of the fluid behind a mirror wall have the same tangential velocity: so has the mean over the fluid alone.
    boundary_ghost_velocity<Dim>(view_of(boundary), fluid_view, of_boundary_, c_.method, boundary.ghost_velocity);
    c_.state.boundary.refresh_ghosts(column::ghost_velocity);
    ParticleView<Dim> ghosts = view_of(boundary);
    ghosts.velocity = columns_of(boundary.ghost_velocity);
    on_solid += boundary_friction_reaction<Dim>(ghosts, fluid_view, of_boundary_, viscosity, c_.method, block_totals_,
                                                boundary.force);
    boundary_friction_reaction<Dim>(ghosts, fluid_view, ghosts_of_boundary_, viscosity, c_.method, block_totals_,
                                    boundary.force);
    on_fluid +=
        boundary_friction<Dim>(fluid_view, ghosts, of_fluid_, viscosity, c_.method, block_totals_, fluid.acceleration);
    boundary_friction<Dim>(fluid_view, ghosts, ghosts_of_fluid_, viscosity, c_.method, block_totals_,
                           fluid.acceleration);
    count_pairs({&of_boundary_, &of_boundary_, &ghosts_of_boundary_, &of_fluid_, &ghosts_of_fluid_});
}

template <int Dim>
void BoundaryCoupling<Dim>::rates() {
    const auto scope = c_.timer.measure(StepPhase::interface_pass);
    follow(c_.state.solid.halfway_position, c_.state.solid.mean_velocity);
    auto& fluid = c_.state.fluid;
    const auto fluid_view = view_of(fluid), solid_view = view_of(c_.state.boundary);
    boundary_continuity<Dim>(fluid_view, solid_view, of_fluid_, c_.method, fluid.density_rate);
    boundary_continuity<Dim>(fluid_view, solid_view, ghosts_of_fluid_, c_.method, fluid.density_rate);
    count_pairs({&of_fluid_, &ghosts_of_fluid_});
}

template <int Dim>
void BoundaryCoupling<Dim>::follow(const VectorField<Dim>& position, const VectorField<Dim>& velocity) {
    auto& boundary = c_.state.boundary;
    const auto& solid = c_.state.solid;
    const auto& index_of_id = c_.neighbors.solid_index_of_id();
    parallel_for(boundary.owned, [&](std::size_t i) {
        const Index s = index_of_id[boundary.solid_id[i]];
        boundary.position.set(i, position[s]);
        boundary.velocity.set(i, velocity[s]);
        boundary.volume[i] = solid.mass[s] / solid.density[s];
    });
    c_.state.boundary.refresh_ghosts(column::position, column::velocity, column::mean_acceleration, column::volume);
}

template <int Dim>
void BoundaryCoupling<Dim>::follow_acceleration() {
    auto& boundary = c_.state.boundary;
    const auto& solid = c_.state.solid;
    const auto& index_of_id = c_.neighbors.solid_index_of_id();
    const bool relaxes = relaxes_;
    parallel_for(boundary.owned, [&](std::size_t i) {
        const Vec<Dim> a_s = solid.mean_acceleration[index_of_id[boundary.solid_id[i]]],
                       last = boundary.mean_acceleration[i];
        const double beta = relaxes ? relaxation_[boundary.body[i]] : 1;
        boundary.mean_acceleration.set(i, beta < 1 ? last + beta * (a_s - last) : a_s);
    });
}

template <int Dim>
void BoundaryCoupling<Dim>::hand_over() {
    const auto& boundary = c_.state.boundary;
    auto& solid = c_.state.solid;
    const auto& index_of_id = c_.neighbors.solid_index_of_id();
    parallel_for(boundary.owned, [&](std::size_t i) {
        const Index s = index_of_id[boundary.solid_id[i]];
        solid.interface_acceleration.set(s, (1 / solid.mass[s]) * boundary.force[i]);
    });
}

/// Ghosts of the fluid and of the boundary belong to mirror walls, and do not count.
template <int Dim>
void BoundaryCoupling<Dim>::record_balance(const Vec<Dim>& on_solid, const Vec<Dim>& on_fluid) {
    const auto& boundary = c_.state.boundary;
    const double magnitude =
        ordered_sum<double>(boundary.owned, [&](std::size_t i) { return norm(boundary.force[i]); });
    balance_.record(magnitude, norm(on_solid + on_fluid));
}

template <int Dim>
void BoundaryCoupling<Dim>::count_pairs(std::initializer_list<const NeighborList*> lists) {
    for (const NeighborList* list : lists) c_.pairs += list->pairs();
}

template <int Dim>
Vec<Dim> BoundaryCoupling<Dim>::fluid_force_on(std::size_t body) const {
    const auto& boundary = c_.state.boundary;
    Vec<Dim> sum;
    for (std::size_t k = 0; k < boundary.owned; ++k)
        if (boundary.body[k] == body) sum += boundary.force[k];
    return sum;
}

template <int Dim>
void BoundaryCoupling<Dim>::save(const StateWriter& writer) {
    writer("boundary_balance", balance_);
}
template <int Dim>
void BoundaryCoupling<Dim>::restore(const StateReader& reader) {
    reader("boundary_balance", balance_);
}

template class BoundaryCoupling<2>;
template class BoundaryCoupling<3>;

}  // namespace sluice
