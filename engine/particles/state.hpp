// Everything that a simulation's particles are and do, at one instant.
#pragma once

#include <optional>
#include <vector>

#include "engine/effects.hpp"
#include "engine/scene/scene.hpp"
#include "engine/particles/particle_set.hpp"
#include "engine/particles/surface.hpp"
#include "kernels/materials/equation_of_state.hpp"
#include "kernels/materials/hyperelastic.hpp"

namespace sluice {

/// A medium's constants, of its one material.
struct Medium {
    std::string name;
    LinearEquationOfState eos;
    double shear_modulus = 0;  ///< μ [Pa]
    Hyperelastic law;          ///< of a total-Lagrangian solid
    double viscosity = 0;      ///< ν of a fluid, kinematic [m²/s]
};

template <int Dim>
struct State {
    ParticleSet<Dim> fluid, solid, wall, elements, boundary;
    BodySurface<Dim> surface;
    std::vector<int> solid_group;               ///< of each body of the scene (joined_bodies.hpp), if solids may meet
    std::vector<GhostPlane<Dim>> ghost_planes;  ///< mirror walls and sides of periodic boxes
    Vec<Dim> gravity;                           ///< [m/s²]
    std::optional<Medium> water;                ///< the fluid's, if there is fluid
    std::optional<Medium> rubber;               ///< the solid's, if there is a solid
    double max_h = 0;                           ///< largest smoothing length [m]
    double min_h = 0;                           ///< smallest [m]

    ParticleSet<Dim>& operator[](SetId set) {
        return const_cast<ParticleSet<Dim>&>(static_cast<const State&>(*this)[set]);
    }
    const ParticleSet<Dim>& operator[](SetId set) const {
        switch (set) {
            case SetId::fluid:
                return fluid;
            case SetId::solid:
                return solid;
            case SetId::wall:
                return wall;
            case SetId::elements:
                return elements;
            case SetId::boundary:
                return boundary;
        }
        __builtin_unreachable();
    }
};

/// Fills the scene's bodies and walls with particles, in their initial state. Throws SceneError.
template <int Dim>
State<Dim> place_particles(const Scene& scene, const Effects& effects);

}  // namespace sluice
