#include "engine/step/couplings/interface_coupling.hpp"

#include <algorithm>

#include "engine/files/state_visitors.hpp"

namespace sluice {

// The cut-off between an element and a particle is the particle's support.
template <int Dim>
InterfaceCoupling<Dim>::InterfaceCoupling(StepContext<Dim>& context)
    : c_(context),
      fluid_at_elements_(elements_with(SetId::fluid, Targets::own)),
      fluid_ghosts_at_elements_(elements_with(SetId::fluid, Targets::ghosts)),
      solid_at_elements_(elements_with(SetId::solid, Targets::own)),
      elements_at_fluid_(with_elements(SetId::fluid, Targets::own)),
      element_ghosts_at_fluid_(with_elements(SetId::fluid, Targets::ghosts)),
      elements_at_solid_(with_elements(SetId::solid, Targets::own)) {
    // A hyperelastic solid keeps its order and its lists, but its grid must follow its motion.
    if (!c_.state.hyperelastic.empty()) c_.neighbors.place_before(SetId::solid, [] {});
    c_.neighbors.place_before(SetId::elements, [this] {
        c_.state.surface.update(c_.state.solid.position, c_.neighbors.solid_index_of_id(), c_.state.elements);
    });
}

template <int Dim>
const NeighborList& InterfaceCoupling<Dim>::elements_with(SetId particles, Targets targets) {
    return c_.neighbors.pair({SetId::elements, particles, Upkeep::coupling, targets, Reach::of_target}).list;
}

template <int Dim>
const NeighborList& InterfaceCoupling<Dim>::with_elements(SetId particles, Targets targets) {
    return c_.neighbors.pair({particles, SetId::elements, Upkeep::coupling, targets, Reach::of_query}).list;
}

template <int Dim>
void InterfaceCoupling<Dim>::forces() {
    const auto scope = c_.timer.measure(StepPhase::interface_pass);
    const Vec<Dim> on_solid = force_solid();
    auto& fluid = c_.state.fluid;
    const auto elements = view_of(c_.state.elements);
    const Vec<Dim> on_fluid = add_interface_force_on_fluid<Dim>(view_of(fluid), elements, elements_at_fluid_, c_.method,
                                                                block_totals_, fluid.acceleration);
    add_interface_force_on_fluid<Dim>(view_of(fluid), elements, element_ghosts_at_fluid_, c_.method, block_totals_,
                                      fluid.acceleration);
    record_balance(on_solid, on_fluid);
    for (const NeighborList* list : {&fluid_at_elements_, &fluid_ghosts_at_elements_, &elements_at_solid_,
                                     &elements_at_fluid_, &element_ghosts_at_fluid_})
        c_.pairs += list->pairs();
}

template <int Dim>
Vec<Dim> InterfaceCoupling<Dim>::force_solid() {
    auto& e = c_.state.elements;
    auto& solid = c_.state.solid;
    update_elements(solid.position, view_of(solid));
    std::fill(e.pressure.begin(), e.pressure.end(), 0.0);
    std::fill(e.image_pressure.begin(), e.image_pressure.end(), 0.0);
    const auto elements = view_of(e), fluid = view_of(c_.state.fluid);
    add_interface_pressure<Dim>(elements, fluid, fluid_at_elements_, c_.method, e.pressure);
    add_interface_pressure<Dim>(elements, fluid, fluid_ghosts_at_elements_, c_.method, e.image_pressure);
    for (std::size_t k = 0; k < e.owned; ++k) {
        e.pressure[k] += e.image_pressure[k];
        e.force.set(k, -e.pressure[k] * e.area_normal[k]);
        e.shared_force.set(k, e.solid_weight[k] > 0 ? (1 / e.solid_weight[k]) * e.force[k] : Vec<Dim>{});
    }
    for (auto& column : solid.interface_acceleration.c) std::fill(column.begin(), column.end(), 0.0);
    return interface_force_on_solid<Dim>(view_of(solid), elements, elements_at_solid_, c_.method, block_totals_,
                                         solid.interface_acceleration);
}

/// The forces between fluid and solid must add up to zero, except for those of the fluid's ghosts, that is the mirror
/// walls, on the solid.
template <int Dim>
void InterfaceCoupling<Dim>::record_balance(const Vec<Dim>& on_solid, const Vec<Dim>& on_fluid) {
    const auto& e = c_.state.elements;
    Vec<Dim> sum = on_solid + on_fluid;
    double magnitude = 0;
    for (std::size_t k = 0; k < e.owned; ++k) {
        sum += e.image_pressure[k] * e.area_normal[k];
        magnitude += norm(e.force[k]);
    }
    balance_.record(magnitude, norm(sum));
}

template <int Dim>
void InterfaceCoupling<Dim>::rates() {
    const auto scope = c_.timer.measure(StepPhase::interface_pass);
    // The kinematic condition sees the solid half-way through the step.
    ParticleView<Dim> halfway = view_of(c_.state.solid);
    halfway.position = columns_of(c_.state.solid.halfway_position);
    halfway.velocity = columns_of(c_.state.solid.mean_velocity);
    update_elements(c_.state.solid.halfway_position, halfway);
    const auto fluid = view_of(c_.state.fluid), elements = view_of(c_.state.elements);
    ScalarField& rate = c_.state.fluid.density_rate;
    add_interface_continuity<Dim>(fluid, elements, elements_at_fluid_, c_.method, rate);
    add_interface_continuity<Dim>(fluid, elements, element_ghosts_at_fluid_, c_.method, rate);
    c_.pairs += elements_at_fluid_.pairs() + element_ghosts_at_fluid_.pairs();
}

template <int Dim>
void InterfaceCoupling<Dim>::update_elements(const VectorField<Dim>& solid_position, const ParticleView<Dim>& solid) {
    auto& e = c_.state.elements;
    c_.state.surface.update(solid_position, c_.neighbors.solid_index_of_id(), e);
    interface_weights<Dim>(view_of(e), solid, solid_at_elements_, c_.method, e.solid_weight, e.velocity);
    for (std::size_t k = 0; k < e.owned; ++k)
        if (e.solid_weight[k] == 0) e.area_normal.set(k, {});  // torn off its body
    c_.pairs += solid_at_elements_.pairs();
    c_.state.elements.refresh_ghosts(column::position, column::area_normal, column::velocity);
}

template <int Dim>
Vec<Dim> InterfaceCoupling<Dim>::fluid_force_on(std::size_t body) const {
    const auto& e = c_.state.elements;
    Vec<Dim> sum;
    for (std::size_t k = 0; k < e.owned; ++k)
        if (e.body[k] == body) sum += e.force[k];
    return sum;
}

template <int Dim>
void InterfaceCoupling<Dim>::save(const StateWriter& writer) {
    writer("interface_balance", balance_);
}
template <int Dim>
void InterfaceCoupling<Dim>::restore(const StateReader& reader) {
    reader("interface_balance", balance_);
}

template class InterfaceCoupling<2>;
template class InterfaceCoupling<3>;

}  // namespace sluice
