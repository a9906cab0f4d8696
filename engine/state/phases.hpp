// The particles of each medium. A phase holds only the fields that the scene's effects need; the others stay empty.
//
// Particles beyond `owned` are images: reflections of owned particles across mirror walls, refreshed before each pass.
#pragma once

#include <cstdint>

#include "kernels/shift_passes.hpp"
#include "neighbor/fields.hpp"

namespace sluice {

/// Fields that every medium has.
template <int Dim>
struct PhaseBase {
    std::size_t owned = 0;
    VectorField<Dim> position;      ///< x^n [m]
    VectorField<Dim> velocity;      ///< between steps v^(n-1/2) by staggered Euler, v^n by kick-drift-kick [m/s]
    VectorField<Dim> acceleration;  ///< [m/s²]
    ScalarField density;            ///< [kg/m³]
    ScalarField density_rate;       ///< [kg/m³/s]
    ScalarField pressure;           ///< [Pa]
    ScalarField mass;               ///< [kg; kg/m in 2D]
    ScalarField smoothing_length;   ///< h [m]
    Array<std::uint32_t> id;        ///< number in the initial order of this phase; never changes
    Array<std::uint16_t> body;      ///< index into Scene::bodies (walls: Scene::walls)
};

template <int Dim>
struct FluidPhase : PhaseBase<Dim> {
    ScalarField pressure_over_rho2;        ///< p/ρ² [Pa m⁶/kg²]
    VectorField<Dim> velocity_correction;  ///< velocity filter: what eq. (16) adds [m/s]
    ScalarField excess_density;            ///< ρ − ρ0 g·x/c0², what Fourtakas' diffusion evens out [kg/m³]
    VectorField<Dim> density_gradient;     ///< ⟨∇ρ⟩ of Antuono's density diffusion [kg/m⁴]
    ShiftFields<Dim> surroundings;         ///< what particle shifting needs to know
};

/// A solid's particles. Those of the hypoelastic model and those of the total-Lagrangian one have some columns each.
template <int Dim>
struct SolidPhase : PhaseBase<Dim> {
    Array<std::uint8_t> clamped;  ///< 1 = held fixed

    // hypoelastic
    SymTensorField<Dim> deviatoric_stress;    ///< S [Pa]; in 2D S_zz = -S_xx - S_yy (plane strain)
    SymTensorField<Dim> stress_over_rho2;     ///< σ/ρ² [Pa m⁶/kg²]
    SymTensorField<Dim> artificial_stress;    ///< R of eq. (14), same unit
    TupleField<Dim * Dim> velocity_gradient;  ///< dv_i/dx_j, row-major [1/s]
    VectorField<Dim> velocity_correction;     ///< velocity filter, only if the scene filters its solids [m/s]

    // total Lagrangian (kernels/total_lagrangian_passes.hpp); acceleration is then the elastic one
    VectorField<Dim> reference_position;      ///< X [m]
    ScalarField volume;                       ///< V in the reference configuration [m³; m² in 2D]
    TupleField<Dim * Dim> deformation;        ///< F, row by row
    TupleField<Dim * Dim> corrected_stress;   ///< T = P L − k F, row by row [Pa]
    SymTensorField<Dim> gradient_correction;  ///< L
    ScalarField hourglass_stiffness;          ///< k [Pa]
    ScalarField elastic_share;                ///< of a particle's energy, below 1 where a clamp cuts its cell

    // Only if it meets a fluid: the fluid's force, constant over a step, and the motion over the step that it goes
    // with.
    VectorField<Dim> interface_acceleration;  ///< [m/s²]
    VectorField<Dim> steady_acceleration;     ///< what is steady in it (engine/step/steady_load.hpp) [m/s²]
    VectorField<Dim> halfway_position;        ///< (x^n + x^(n+1))/2; x^n while the step is under way [m]
    VectorField<Dim> mean_velocity;           ///< (x^(n+1) − x^n)/Δt [m/s]
    VectorField<Dim> mean_acceleration;       ///< (v^(n+1) − v^n)/Δt, if it is the fluid's moving boundary [m/s²]
};

/// Layers of fixed ghosts of rigid walls, fixed to their wall, which may move; their pressure is taken from the fluid
/// in front of them.
template <int Dim>
struct WallPhase {
    std::size_t owned = 0;
    VectorField<Dim> position;     ///< [m]
    ScalarField pressure;          ///< [Pa]
    ScalarField volume;            ///< [m³; m² in 2D]
    ScalarField smoothing_length;  ///< [m]
    Array<std::uint32_t> id;
    Array<std::uint16_t> body;  ///< index into Scene::walls

    // Only if the fluid does not slip at a wall.
    VectorField<Dim> ghost_velocity;  ///< v_g of kernels/terms/boundary_viscosity.hpp [m/s]
    ScalarField friction_volume;      ///< volume; 0 where the fluid slips

    // Only if a wall moves.
    VectorField<Dim> initial_position;  ///< [m]
    VectorField<Dim> velocity;          ///< [m/s]
};

/// The solids' particles that fluid can come near, as the fluid's moving boundary: copies of what the fluid sees.
/// Particles beyond `owned` are images across mirror walls.
template <int Dim>
struct BoundaryParticles {
    std::size_t owned = 0;
    VectorField<Dim> position;        ///< [m]
    VectorField<Dim> velocity;        ///< [m/s]
    VectorField<Dim> acceleration;    ///< [m/s²]
    ScalarField volume;               ///< m/ρ [m³; m² in 2D]
    ScalarField smoothing_length;     ///< of the solid [m]
    VectorField<Dim> force;           ///< of the fluid on it [N; N/m in 2D]
    VectorField<Dim> ghost_velocity;  ///< v_g, only if the fluid is viscous [m/s]
    Array<std::uint32_t> solid;       ///< id of the solid's particle
    Array<std::uint16_t> body;        ///< index into Scene::bodies
};

/// Elements of the interface between fluid and solids: a closed surface around each solid body, see surface.hpp.
/// Elements beyond `owned` are images across mirror walls.
template <int Dim>
struct InterfaceElements {
    std::size_t owned = 0;
    VectorField<Dim> position;      ///< centre [m]
    VectorField<Dim> area_normal;   ///< n ΔΓ, into the fluid [m²; m in 2D]
    VectorField<Dim> velocity;      ///< of the solid at the element [m/s]
    ScalarField pressure;           ///< p_int of eq. (26) [Pa]
    ScalarField image_pressure;     ///< the part of it that images of fluid particles contribute [Pa]
    ScalarField solid_weight;       ///< Σ V W over the solid around it, by which forces are shared out
    VectorField<Dim> force;         ///< of the fluid on the element [N; N/m in 2D]
    VectorField<Dim> shared_force;  ///< force/solid_weight
    ScalarField smoothing_length;   ///< of the solid [m]
    Array<std::uint16_t> body;      ///< index into Scene::bodies
};

}  // namespace sluice
