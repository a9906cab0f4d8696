// Each pair pass on a set of particles, per dimension, h/d in hundredths, particles, precision and instruction set.
// Rates are per second of process CPU time: with two threads, per core.
#include "bench/pass_benchmark.hpp"
#include "bench/suite.hpp"
#include "kernels/passes/boundary_loops.hpp"
#include "kernels/passes/boundary_passes.hpp"
#include "kernels/passes/contact_loops.hpp"
#include "kernels/passes/contact_passes.hpp"
#include "kernels/passes/density_loops.hpp"
#include "kernels/passes/density_passes.hpp"
#include "kernels/passes/fluid_loops.hpp"
#include "kernels/passes/fluid_passes.hpp"
#include "kernels/passes/interface_loops.hpp"
#include "kernels/passes/shift_loops.hpp"
#include "kernels/passes/shift_passes.hpp"
#include "kernels/passes/solid_loops.hpp"
#include "kernels/passes/solid_passes.hpp"
#include "kernels/passes/total_lagrangian_loops.hpp"
#include "kernels/passes/total_lagrangian_passes.hpp"
#include "kernels/passes/wall_loops.hpp"
#include "kernels/passes/wall_passes.hpp"

namespace sluice::bench {
namespace {

// Constants of the elastic gate.
constexpr FluidTerms fluid_terms{1, 30};
constexpr FluidTerms laminar_terms{0, 0, Viscosity::monaghan_gingold, 1e-6},
    morris_terms{0, 0, Viscosity::morris, 1e-6};
constexpr SolidTerms solid_terms{1, 134.8, 0.3, 4, 1.5};
constexpr ElasticViscosity elastic_viscosity{1, 134.8, 1100};
constexpr double filter_theta = 0.92;
constexpr ShiftTerms shift_terms{1.5};
constexpr double water_viscosity = 1e-6;  // [m²/s]

template <class Sample>
using Rows = std::vector<PassRow<Sample>>;

template <int Dim>
Rows<Cube<Dim>> fluid_rows() {
    using S = Cube<Dim>;
    using Out = Output<Dim>;
    const Roles<S> all{&S::medium, &S::medium, &S::list};
    return {
        pass_row<ViscousMomentum<Dim>>("fluid_momentum", all, Dim,
                                       [](const S& s, Precision p, Out& out) {
                                           fluid_momentum<Dim>(s.medium.view(), s.list, fluid_terms, p, out.vectors);
                                       }),
        pass_row<ViscousMomentum<Dim>>("laminar_momentum", all, Dim,
                                       [](const S& s, Precision p, Out& out) {
                                           fluid_momentum<Dim>(s.medium.view(), s.list, laminar_terms, p, out.vectors);
                                       }),
        pass_row<MorrisMomentum<Dim>>("morris_momentum", all, Dim,
                                      [](const S& s, Precision p, Out& out) {
                                          fluid_momentum<Dim>(s.medium.view(), s.list, morris_terms, p, out.vectors);
                                      }),
        pass_row<InviscidMomentum<Dim>>("inviscid_momentum", all, Dim,
                                        [](const S& s, Precision p, Out& out) {
                                            fluid_momentum<Dim>(s.medium.view(), s.list, {}, p, out.vectors);
                                        }),
        pass_row<DensityRate<Dim>>(
            "continuity", all, 1,
            [](const S& s, Precision p, Out& out) { continuity<Dim>(s.medium.view(), s.list, p, out.scalars); }),
        pass_row<FilterSums<Dim>>("velocity_filter", all, Dim, [](const S& s, Precision p, Out& out) {
            velocity_filter<Dim>(s.medium.view(), s.list, filter_theta, p, out.vectors);
        })};
}

template <int Dim>
Rows<Cube<Dim>> density_rows() {
    using S = Cube<Dim>;
    using Out = Output<Dim>;
    const Roles<S> all{&S::medium, &S::medium, &S::list};
    return {pass_row<DiffusiveDensityRate<Dim, StratifiedDiffusion<Dim>>>(
                "diffusive_continuity", all, 1,
                [](const S& s, Precision p, Out& out) {
                    diffusive_continuity<Dim>(s.medium.view(), s.list, {DensityDiffusion::fourtakas, 30, 0.1, 1000, {}},
                                              p, out.scalars);
                }),
            pass_row<DiffusiveDensityRate<Dim, GradientDiffusion>>(
                "antuono_continuity", all, 1,
                [](const S& s, Precision p, Out& out) {
                    diffusive_continuity<Dim>(s.medium.view(), s.list, {DensityDiffusion::antuono, 30, 0.1, 1000, {}},
                                              p, out.scalars);
                }),
            pass_row<DensityGradientSums<Dim>>("density_gradient", all, Dim, [](const S& s, Precision p, Out& out) {
                density_gradient<Dim>(s.medium.view(), s.list, p, out.vectors);
            })};
}

template <int Dim>
Rows<Cube<Dim>> shift_rows() {
    using S = Cube<Dim>;
    using Out = Output<Dim>;
    const Roles<S> all{&S::medium, &S::medium, &S::list};
    return {pass_row<FluidConcentration<Dim>>("shift_sums", all, Dim + 2,
                                              [](const S& s, Precision p, Out& out) {
                                                  shift_sums<Dim>(s.medium.view(), s.list, shift_terms, p, out.shift);
                                              }),
            pass_row<SurfaceNormal<Dim>>("surface_normals", all, Dim, [](const S& s, Precision p, Out& out) {
                surface_normals<Dim>(s.medium.view(), s.list, p, out.shift);
            })};
}

/// In double only, whatever is asked for.
template <int Dim>
Rows<Boundary<Dim>> boundary_shift_rows() {
    using S = Boundary<Dim>;
    const Roles<S> fluid{&S::fluid, &S::backing, &S::fluid_backing};
    return {pass_row<BoundaryConcentration<Dim>>(
        "boundary_shift_sums", fluid, Dim + 2, [](const S& s, Precision p, Output<Dim>& out) {
            boundary_shift_sums<Dim>(s.fluid.view(), s.backing.view(), s.fluid_backing, shift_terms, p, out.shift);
        })};
}

template <int Dim>
Rows<Cube<Dim>> solid_rows() {
    using S = Cube<Dim>;
    using Out = Output<Dim>;
    using Momentum = StressDivergence<Dim, ArtificialViscosity, ArtificialStress>;
    const Roles<S> all{&S::medium, &S::medium, &S::list};
    return {pass_row<Momentum>("solid_momentum", all, Dim,
                               [](const S& s, Precision p, Out& out) {
                                   solid_momentum<Dim>(s.medium.view(), s.list, solid_terms, p, out.vectors);
                               }),
            pass_row<SolidRateSums<Dim>>("solid_rates", all, 1 + Dim * Dim, [](const S& s, Precision p, Out& out) {
                solid_rates<Dim>(s.medium.view(), s.list, p, out.scalars, out.tensors);
            })};
}

template <int Dim>
Rows<Cube<Dim>> elastic_rows() {
    using S = Cube<Dim>;
    using Out = Output<Dim>;
    const Roles<S> all{&S::medium, &S::medium, &S::list};
    return {pass_row<GradientMatrixSums<Dim>>("elastic_correction", all, 1 + sym_components<Dim>,
                                              [](const S& s, Precision, Out& out) {
                                                  const double stiffness = 1e6;
                                                  elastic_correction<Dim>(s.medium.view(), s.list, {&stiffness, 1}, {},
                                                                          out.symmetric, out.scalars);
                                              }),
            pass_row<DeformationSums<Dim>>(
                "elastic_deformation", all, 2 * Dim * Dim,
                [](const S& s, Precision, Out& out) {
                    const auto rubber = Hyperelastic::with(ElasticLaw::neo_hookean, 12e6, 0.4);
                    elastic_deformation<Dim>(s.medium.view(), s.list, {&rubber, 1}, {}, out.tensors, out.more_tensors);
                }),
            pass_row<ElasticMomentum<Dim>>("elastic_momentum", all, Dim,
                                           [](const S& s, Precision, Out& out) {
                                               elastic_momentum<Dim>(s.medium.view(), s.list, {}, {}, out.vectors);
                                           }),
            pass_row<ElasticMomentum<Dim, ReferenceViscosity>>(
                "elastic_viscous", all, Dim,
                [](const S& s, Precision, Out& out) {
                    elastic_momentum<Dim>(s.medium.view(), s.list, elastic_viscosity, {}, out.vectors);
                }),
            pass_row<HourglassErrors<Dim>>("hourglass_energy", all, 1, [](const S& s, Precision, Out& out) {
                hourglass_energy<Dim>(s.medium.view(), s.list, {}, out.scalars);
            })};
}

/// Two bodies that touch. In double only, whatever is asked for.
template <int Dim>
Rows<Boundary<Dim>> contact_rows() {
    using S = Boundary<Dim>;
    using Out = Output<Dim>;
    const Roles<S> body{&S::fluid, &S::backing, &S::fluid_backing};
    return {pass_row<ContactSums<Dim>>("contact_sums", body, 1 + Dim,
                                       [](const S& s, Precision, Out& out) {
                                           contact_sums<Dim>(s.fluid.view(), s.backing.view(), s.fluid_backing, {},
                                                             out.scalars, out.vectors);
                                       }),
            pass_row<ContactForce<Dim>>("contact_force", body, Dim, [](const S& s, Precision, Out& out) {
                contact_force<Dim>(s.fluid.view(), s.backing.view(), s.fluid_backing, {}, out.vectors);
            })};
}

template <int Dim>
Rows<Boundary<Dim>> wall_rows() {
    using S = Boundary<Dim>;
    using Out = Output<Dim>;
    const Roles<S> ghosts{&S::backing, &S::fluid, &S::backing_fluid}, fluid{&S::fluid, &S::backing, &S::fluid_backing};
    return {pass_row<GhostPressureSums<Dim>>("wall_pressure", ghosts, 1,
                                             [](const S& s, Precision p, Out& out) {
                                                 fixed_ghost_pressure<Dim>(s.backing.view(), s.fluid.view(),
                                                                           s.backing_fluid, {}, p, out.scalars);
                                             }),
            pass_row<MovingGhostPressureSums<Dim>>("moving_wall_pressure", ghosts, 1,
                                                   [](const S& s, Precision p, Out& out) {
                                                       const std::vector<Vec<Dim>> of_walls(1);
                                                       moving_ghost_pressure<Dim>(s.backing.view(), s.fluid.view(),
                                                                                  s.backing_fluid, of_walls,
                                                                                  s.backing.body, p, out.scalars);
                                                   }),
            pass_row<GhostPressure<Dim>>("wall_force", fluid, Dim,
                                         [](const S& s, Precision p, Out& out) {
                                             fixed_ghost_force<Dim>(s.fluid.view(), s.backing.view(), s.fluid_backing,
                                                                    p, out.vectors);
                                         }),
            pass_row<GhostContinuity<Dim>>("wall_continuity", fluid, 1, [](const S& s, Precision p, Out& out) {
                fixed_ghost_continuity<Dim>(s.fluid.view(), s.backing.view(), s.fluid_backing, p, out.scalars);
            })};
}

/// The solid's particles, or the ghosts of a moving or no-slip wall, as the fluid's boundary.
template <int Dim>
Rows<Boundary<Dim>> boundary_rows() {
    using S = Boundary<Dim>;
    using Out = Output<Dim>;
    const Roles<S> solid{&S::backing, &S::fluid, &S::backing_fluid}, fluid{&S::fluid, &S::backing, &S::fluid_backing};
    return {pass_row<BoundaryPressure<Dim>>("boundary_force", fluid, Dim,
                                            [](const S& s, Precision, Out& out) {
                                                boundary_pressure_on_fluid<Dim>(s.fluid.view(), s.backing.view(),
                                                                                s.fluid_backing, {}, {}, out.totals,
                                                                                out.vectors);
                                            }),
            pass_row<BoundaryReaction<Dim>>("boundary_reaction", solid, Dim,
                                            [](const S& s, Precision, Out& out) {
                                                boundary_reaction<Dim>(s.backing.view(), s.fluid.view(),
                                                                       s.backing_fluid, {}, {}, out.totals,
                                                                       out.vectors);
                                            }),
            pass_row<BoundaryContinuity<Dim>>("boundary_continuity", fluid, 1, [](const S& s, Precision, Out& out) {
                boundary_continuity<Dim>(s.fluid.view(), s.backing.view(), s.fluid_backing, {}, out.scalars);
            })};
}

template <int Dim>
Rows<Boundary<Dim>> friction_rows() {
    using S = Boundary<Dim>;
    using Out = Output<Dim>;
    const Roles<S> solid{&S::backing, &S::fluid, &S::backing_fluid}, fluid{&S::fluid, &S::backing, &S::fluid_backing};
    return {pass_row<BoundaryVelocitySums<Dim>>("ghost_velocity", solid, Dim,
                                                [](const S& s, Precision, Out& out) {
                                                    boundary_ghost_velocity<Dim>(s.backing.view(), s.fluid.view(),
                                                                                 s.backing_fluid, {}, out.vectors);
                                                }),
            pass_row<BoundaryFrictionPass<Dim>>("boundary_friction", fluid, Dim,
                                                [](const S& s, Precision, Out& out) {
                                                    boundary_friction<Dim>(s.fluid.view(), s.backing.view(),
                                                                           s.fluid_backing, water_viscosity, {},
                                                                           out.totals, out.vectors);
                                                }),
            pass_row<BoundaryFrictionReactionPass<Dim>>(
                "friction_reaction", solid, Dim, [](const S& s, Precision, Out& out) {
                    boundary_friction_reaction<Dim>(s.backing.view(), s.fluid.view(), s.backing_fluid, water_viscosity,
                                                    {}, out.totals, out.vectors);
                })};
}

template <int Dim>
Rows<Boundary<Dim>> interface_rows() {
    using S = Boundary<Dim>;
    using Out = Output<Dim>;
    const Roles<S> pressure{&S::elements, &S::fluid, &S::element_fluid};
    const Roles<S> weights{&S::elements, &S::backing, &S::element_backing};
    const Roles<S> solid{&S::backing, &S::elements, &S::backing_element};
    const Roles<S> fluid{&S::fluid, &S::elements, &S::fluid_element};
    return {pass_row<ElementPressure<Dim>>("interface_pressure", pressure, 1,
                                           [](const S& s, Precision, Out& out) {
                                               add_interface_pressure<Dim>(s.elements.view(), s.fluid.view(),
                                                                           s.element_fluid, {}, out.scalars);
                                           }),
            pass_row<ElementWeights<Dim>>("interface_weights", weights, 1 + Dim,
                                          [](const S& s, Precision, Out& out) {
                                              interface_weights<Dim>(s.elements.view(), s.backing.view(),
                                                                     s.element_backing, {}, out.scalars, out.vectors);
                                          }),
            pass_row<ForceShare<Dim>>("interface_force_on_solid", solid, Dim,
                                      [](const S& s, Precision, Out& out) {
                                          interface_force_on_solid<Dim>(s.backing.view(), s.elements.view(),
                                                                        s.backing_element, {}, out.totals, out.vectors);
                                      }),
            pass_row<SurfaceIntegral<Dim>>("interface_force_on_fluid", fluid, Dim,
                                           [](const S& s, Precision, Out& out) {
                                               add_interface_force_on_fluid<Dim>(s.fluid.view(), s.elements.view(),
                                                                                 s.fluid_element, {}, out.totals,
                                                                                 out.vectors);
                                           }),
            pass_row<SurfaceFlux<Dim>>("interface_continuity", fluid, 1, [](const S& s, Precision, Out& out) {
                add_interface_continuity<Dim>(s.fluid.view(), s.elements.view(), s.fluid_element, {}, out.scalars);
            })};
}

template <class Sample>
void register_rows(const Rows<Sample>& rows, const std::vector<Precision>& precisions, int h, std::size_t n) {
    for (const auto& row : rows)
        for (const Precision precision : precisions) {
            for (const Isa isa : available_isas()) register_pass(row, {h, n, precision, isa, 1});
            if (h == 150 && n == 100'000) register_pass(row, {h, n, precision, available_isas().back(), 2});
        }
}

const std::vector<Precision> both{Precision::mixed, Precision::full};

template <int Dim>
void register_dimension() {
    const auto fluid = fluid_rows<Dim>();
    const auto density = density_rows<Dim>();
    const auto shift = shift_rows<Dim>();
    const auto boundary_shift = boundary_shift_rows<Dim>();
    const auto solid = solid_rows<Dim>();
    const auto elastic = elastic_rows<Dim>();
    const auto contact = contact_rows<Dim>();
    const auto wall = wall_rows<Dim>();
    const auto interface = interface_rows<Dim>();
    const auto boundary = boundary_rows<Dim>();
    const auto friction = friction_rows<Dim>();
    for (const int h : {120, 150})
        for (const std::size_t n : {10'000U, 100'000U}) {
            register_rows(fluid, both, h, n);
            register_rows(density, both, h, n);
            register_rows(shift, both, h, n);
            register_rows(solid, both, h, n);
            register_rows(wall, both, h, n);
            // These know no other.
            register_rows(elastic, {Precision::full}, h, n);
            for (const auto* rows : {&boundary_shift, &contact, &interface, &boundary, &friction})
                register_rows(*rows, {Precision::full}, h, n);
        }
}

/// Far larger than the caches.
void register_large() {
    for (const auto& rows : {fluid_rows<3>(), solid_rows<3>()})
        for (const auto& row : rows)
            for (const Precision precision : both)
                register_pass(row, {120, 1'000'000, precision, available_isas().back(), 1}, "large/");
}

}  // namespace

void register_passes() {
    register_dimension<2>();
    register_dimension<3>();
    register_large();
}

}  // namespace sluice::bench
