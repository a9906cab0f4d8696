// Everything that a simulation's particles are and do, at one instant.
#pragma once

#include <optional>
#include <vector>

#include "engine/effects.hpp"
#include "engine/scene/scene.hpp"
#include "engine/state/images.hpp"
#include "engine/state/phases.hpp"
#include "engine/state/surface.hpp"
#include "kernels/terms/equation_of_state.hpp"
#include "kernels/terms/hyperelastic.hpp"

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
    FluidPhase<Dim> fluid;
    SolidPhase<Dim> solid;
    WallPhase<Dim> wall;
    InterfaceElements<Dim> elements;
    BoundaryParticles<Dim> boundary;
    BodySurface<Dim> surface;
    std::vector<int> solid_group;               ///< of each body of the scene (joined_bodies.hpp), if solids may meet
    std::vector<ImagePlane<Dim>> image_planes;  ///< mirror walls and sides of periodic boxes
    Vec<Dim> gravity;                           ///< [m/s²]
    std::optional<Medium> water;                ///< the fluid's, if there is fluid
    std::optional<Medium> rubber;               ///< the solid's, if there is a solid
    double max_h = 0;                           ///< largest smoothing length [m]
    double min_h = 0;                           ///< smallest [m]
};

/// Fills the scene's bodies and walls with particles, in their initial state. Throws SceneError.
template <int Dim>
State<Dim> place_particles(const Scene& scene, const Effects& effects);

}  // namespace sluice
