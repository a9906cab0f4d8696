// Plain scalar twins of the passes at walls and at the interface.
#pragma once

#include "kernels/interface_passes.hpp"
#include "tests/kernels/twins.hpp"

namespace sluice::twin {

/// The two sums of a fixed ghost's pressure: Σ V W and Σ V (p_f + ρ_f g·(x_w − x_f)) W.
template <int Dim>
Sums<2> ghost_pressure_sums(const Particles<Dim>& wall, const Particles<Dim>& fluid, const Vec<Dim>& g) {
    return sum_all<2>(wall, fluid, [&](std::size_t, std::size_t f, const PairOf<Dim>& wf) {
        const double v_w = fluid.mass[f] / fluid.density[f] * wf.w;
        double head = 0;
        for (int k = 0; k < Dim; ++k) head += fluid.density[f] * g[k] * wf.x[k];
        return Vec<2>{{v_w, v_w * (fluid.pressure[f] + head)}};
    });
}

/// −1/ρ_i Σ V_j (p_i + p_j) ∇W
template <int Dim>
Sums<Dim> ghost_force(const Particles<Dim>& fluid, const Particles<Dim>& wall) {
    return sum_all<Dim>(fluid, wall, [&](std::size_t i, std::size_t j, const PairOf<Dim>& ij) {
        return -wall.volume[j] * (fluid.pressure[i] + wall.pressure[j]) / fluid.density[i] * ij.grad;
    });
}

/// ρ_i Σ V_j v_i · ∇W
template <int Dim>
Sums<1> ghost_continuity(const Particles<Dim>& fluid, const Particles<Dim>& wall) {
    return sum_all<1>(fluid, wall, [&](std::size_t i, std::size_t j, const PairOf<Dim>& ij) {
        double sum = 0;
        for (int k = 0; k < Dim; ++k) sum += fluid.density[i] * wall.volume[j] * fluid.velocity[i][k] * ij.grad[k];
        return Vec<1>{{sum}};
    });
}

}  // namespace sluice::twin

namespace sluice {

/// Interface elements of a test, and what the passes make of them.
template <int Dim>
struct Elements {
    VectorField<Dim> position, area_normal, velocity, force;
    ScalarField pressure, image_pressure, weight;
    std::size_t owned = 0;

    std::size_t size() const { return position.size(); }
    void add(const Vec<Dim>& x, const Vec<Dim>& normal_area) {
        position.push_back(x);
        area_normal.push_back(normal_area);
        velocity.push_back({});
        force.push_back({});
        for (ScalarField* column : {&pressure, &image_pressure, &weight}) column->push_back(0);
        owned = position.size();
    }
    ElementView<Dim> view() const {
        return {columns_of(position), columns_of(area_normal), columns_of(velocity), owned};
    }
};

/// The four lists between elements and particles, all with groups of one.
template <int Dim>
struct InterfaceLists {
    NeighborList element_fluid, fluid_element, element_solid, solid_element;

    InterfaceLists(const Elements<Dim>& e, const Particles<Dim>& fluid, const Particles<Dim>& solid)
        : element_fluid(list_between<Dim>(e.position, {}, fluid.position, fluid.h, 1)),
          fluid_element(list_between<Dim>(fluid.position, fluid.h, e.position, {}, 1)),
          element_solid(list_between<Dim>(e.position, {}, solid.position, solid.h, 1)),
          solid_element(list_between<Dim>(solid.position, solid.h, e.position, {}, 1)) {}
};

/// Accelerations and density rates that the interface causes.
template <int Dim>
struct InterfaceResult {
    VectorField<Dim> solid_acceleration, fluid_acceleration;
    ScalarField density_rate;
    Vec<Dim> on_solid, on_fluid;  ///< the sums that the passes return
};

/// One evaluation, in the engine's order: pressure (a), weights and v_k, f_k = −p_k n ΔΓ, (b), (c), (d).
template <int Dim, class Real>
InterfaceResult<Dim> evaluate_interface(Elements<Dim>& e, const Particles<Dim>& fluid, const Particles<Dim>& solid,
                                        const InterfaceLists<Dim>& lists) {
    InterfaceResult<Dim> r{zeros<Dim>(solid.size()), zeros<Dim>(fluid.size()), ScalarField(fluid.size(), 0.0), {}, {}};
    interface_pressure<Dim, Real>(e.view(), fluid.view(), fluid.size(), lists.element_fluid, e.pressure,
                                  e.image_pressure);
    interface_weights<Dim, Real>(e.view(), solid.view(), lists.element_solid, e.weight, e.velocity);
    for (std::size_t k = 0; k < e.size(); ++k) e.force.set(k, -e.pressure[k] * e.area_normal[k]);
    r.on_solid = interface_force_on_solid<Dim, Real>(solid.view(), e.view(), lists.solid_element, e.weight, e.force,
                                                     r.solid_acceleration);
    r.on_fluid = interface_force_on_fluid<Dim, Real>(fluid.view(), e.view(), lists.fluid_element, r.fluid_acceleration);
    interface_continuity<Dim, Real>(fluid.view(), e.view(), lists.fluid_element, r.density_rate);
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
