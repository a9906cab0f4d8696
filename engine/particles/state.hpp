// The state of all particles of a simulation at one instant.
#pragma once

#include <vector>

#include "engine/particles/materials.hpp"
#include "engine/particles/part_range.hpp"
#include "engine/particles/particle_set.hpp"
#include "engine/particles/surface.hpp"
#include "engine/scene/rules/effects.hpp"
#include "engine/scene/scene.hpp"

namespace sluice {

template <int Dim>
struct State {
    ParticleSet<Dim> fluid, solid, wall, elements, boundary;
    PartRange hypoelastic, hyperelastic;  ///< of the solid's particles
    MaterialList fluid_materials, solid_materials;
    BodySurface<Dim> surface;
    std::vector<int> solid_group;  ///< of each of the scene's bodies, if solids may meet (joined_bodies.hpp)
    std::vector<GhostPlane<Dim>> ghost_planes;  ///< mirror walls and sides of periodic boxes
    Vec<Dim> gravity;                           ///< [m/s²]
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
