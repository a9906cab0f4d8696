// A test of the passes at the interface: elements, lists, and one evaluation.
#pragma once

#include "kernels/passes/interface_passes.hpp"
#include "tests/kernels/twins_wall.hpp"

namespace sluice {

/// Interface elements of a test, and what the passes make of them.
template <int Dim>
struct Elements {
    VectorField<Dim> position, area_normal, velocity, force, shared_force;
    ScalarField pressure, weight, h;

    std::size_t size() const { return position.size(); }
    void add(const Vec<Dim>& x, const Vec<Dim>& normal_area) {
        position.push_back(x);
        area_normal.push_back(normal_area);
        velocity.push_back({});
        force.push_back({});
        shared_force.push_back({});
        for (ScalarField* column : {&pressure, &weight}) column->push_back(0);
        h.push_back(1);  // whatever it is: the particles' own counts
    }
    /// f_k = −p_k n_k ΔΓ_k, or what a test sets, divided by the weight.
    void share_forces() {
        for (std::size_t k = 0; k < size(); ++k) shared_force.set(k, (1 / weight[k]) * force[k]);
    }
    ParticleView<Dim> view() const {
        ParticleView<Dim> v;
        v.position = columns_of(position);
        v.velocity = columns_of(velocity);
        v.smoothing_length = h.data();
        v.area_normal = columns_of(area_normal);
        v.shared_force = columns_of(shared_force);
        return v;
    }
};

/// The four lists between elements and particles.
template <int Dim>
struct InterfaceLists {
    NeighborList element_fluid, fluid_element, element_solid, solid_element;

    InterfaceLists(const Elements<Dim>& e, const Particles<Dim>& fluid, const Particles<Dim>& solid)
        : element_fluid(list_between<Dim>(e.position, {}, fluid.position, fluid.h)),
          fluid_element(list_between<Dim>(fluid.position, fluid.h, e.position, {})),
          element_solid(list_between<Dim>(e.position, {}, solid.position, solid.h)),
          solid_element(list_between<Dim>(solid.position, solid.h, e.position, {})) {}
};

/// Accelerations and density rates that the interface causes.
template <int Dim>
struct InterfaceResult {
    VectorField<Dim> solid_acceleration, fluid_acceleration;
    ScalarField density_rate;
    Vec<Dim> on_solid, on_fluid;  ///< the sums that the passes return
};

/// One evaluation, in the engine's order: pressure (a), weights and v_k, f_k = −p_k n ΔΓ, (b), (c), (d).
template <int Dim>
InterfaceResult<Dim> evaluate_interface(Elements<Dim>& e, const Particles<Dim>& fluid, const Particles<Dim>& solid,
                                        const InterfaceLists<Dim>& lists) {
    InterfaceResult<Dim> r{zeros<Dim>(solid.size()), zeros<Dim>(fluid.size()), ScalarField(fluid.size(), 0.0), {}, {}};
    std::fill(e.pressure.begin(), e.pressure.end(), 0.0);
    add_interface_pressure<Dim>(e.view(), fluid.view(), lists.element_fluid, {}, e.pressure);
    interface_weights<Dim>(e.view(), solid.view(), lists.element_solid, {}, e.weight, e.velocity);
    for (std::size_t k = 0; k < e.size(); ++k) e.force.set(k, -e.pressure[k] * e.area_normal[k]);
    e.share_forces();
    BlockTotals<Dim> totals;
    r.on_solid =
        interface_force_on_solid<Dim>(solid.view(), e.view(), lists.solid_element, {}, totals, r.solid_acceleration);
    r.on_fluid = add_interface_force_on_fluid<Dim>(fluid.view(), e.view(), lists.fluid_element, {}, totals,
                                                   r.fluid_acceleration);
    add_interface_continuity<Dim>(fluid.view(), e.view(), lists.fluid_element, {}, r.density_rate);
    return r;
}

/// A solid cube and fluid all around it, both disordered, and elements strewn over the gap with any normals and areas.
/// Every element has solid near it, as elements have by construction.
template <int Dim>
struct IrregularInterface {
    Particles<Dim> solid, fluid;
    Elements<Dim> elements;

    explicit IrregularInterface(unsigned seed) {
        Random random(seed);
        const double d = 0.1;
        const int n = Dim == 2 ? 8 : 4;
        solid = lattice(cube<Dim>(n, d, 1.3));
        auto box = cube<Dim>(n, d, 1.5);
        box.lo.fill(-3);
        box.hi.fill(n + 3);
        const auto around = lattice(box);
        for (std::size_t i = 0; i < around.size(); ++i) {
            bool inside = true;
            for (int k = 0; k < Dim; ++k) inside = inside && around.position[i][k] > 0 && around.position[i][k] < n * d;
            if (!inside) fluid.add(around.position[i], around.h[i], around.mass[i], around.density[i]);
        }
        for (auto* p : {&solid, &fluid}) {
            jitter(*p, 0.3 * d, random);
            randomize_h(*p, random);
            randomize_state(*p, random);
        }
        // A cluster: a few particles of either medium at nearly one place.
        for (std::size_t i = 1; i < 12; ++i) {
            fluid.position.set(i, fluid.position[0] + random.vector<Dim>(-1e-3 * d, 1e-3 * d));
            solid.position.set(i, solid.position[0] + random.vector<Dim>(-1e-3 * d, 1e-3 * d));
        }
        for (std::size_t a = 0; a < solid.size(); a += 2)
            elements.add(solid.position[a] + random.vector<Dim>(-0.3 * d, 0.3 * d), random.vector<Dim>(-d, d));
    }
};

}  // namespace sluice
