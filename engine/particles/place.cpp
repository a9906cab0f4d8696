#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/geometry/site_index.hpp"
#include "engine/particles/joined_bodies.hpp"
#include "engine/particles/state.hpp"
#include "engine/scene/check/checks.hpp"
#include "engine/scene/formula.hpp"
#include "kernels/smoothing.hpp"

namespace sluice {
namespace {

template <int Dim>
Vec<Dim> to_vec(const Point& p) {
    Vec<Dim> v;
    for (int k = 0; k < Dim; ++k) v[k] = p[static_cast<std::size_t>(k)];
    return v;
}

MaterialConstants constants_of(const Scene& scene, std::size_t number) {
    const Material& m = scene.materials[number];
    const ElasticLaw law = law_of(m.model).value_or(ElasticLaw{});  // any: others have no use for it
    return {number,
            {m.density, m.sound_speed, m.pressure_exponent},
            m.shear_modulus,
            {law, m.bulk_modulus() - 2.0 / 3 * m.shear_modulus, m.shear_modulus},
            m.viscosity / m.density};
}

/// The order in which bodies are placed: hypoelastic solids before hyperelastic ones, so that each model is a range.
std::vector<std::size_t> bodies_in_order(const Scene& scene) {
    std::vector<std::size_t> order(scene.bodies.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_partition(order.begin(), order.end(), [&](std::size_t b) {
        const Material& material = scene.materials[scene.bodies[b].material];
        return material.kind == MaterialKind::fluid || material.model == SolidModel::hypoelastic;
    });
    return order;
}

/// Refuses what pairs of different fluids are not defined for.
void check_fluids(const Scene& scene, const MaterialList& fluids) {
    if (fluids.empty() || fluids.uniform()) return;
    const auto material = [&](const MaterialConstants& of) -> const Material& { return scene.materials[of.number]; };
    for (const MaterialConstants& other : fluids)
        if (std::abs(other.viscosity - fluids.front().viscosity) > 1e-9 * fluids.front().viscosity)
            scene.fail("materials." + material(other).name + ".viscosity",
                       fmt::format("found a kinematic viscosity of {:.4g} m2/s beside the {:.4g} m2/s of {}; expected "
                                   "fluids of one kinematic viscosity, viscosity/density",
                                   other.viscosity, fluids.front().viscosity, material(fluids.front()).name));
    if (scene.method.fluid.density_diffusion == DensityDiffusion::antuono)
        scene.fail("method.fluid.density_diffusion",
                   "found \"antuono\", whose density gradient is not defined across different fluids; expected "
                   "\"fourtakas\", \"molteni-colagrossi\" or \"none\"");
}

/// Fills the columns of constants that differ between materials, if there are several.
template <int Dim>
void place_constants(const MaterialList& materials, ParticleSet<Dim>& set) {
    for (std::size_t i = 0; i < set.rest_density.size(); ++i) {
        const EquationOfState& eos = materials.of_body(set.body[i]).eos;
        set.rest_density[i] = eos.density;
        set.sound_speed[i] = eos.sound_speed;
    }
}

/// Appends a particle to the columns that both media have.
template <int Dim>
void append(ParticleSet<Dim>& phase, const Vec<Dim>& x, const Vec<Dim>& v, double pressure, double density) {
    phase.position.push_back(x);
    phase.velocity.push_back(v);
    phase.pressure.push_back(pressure);
    phase.density.push_back(density);
    phase.id.push_back(phase.id.size());
}

/// Pressure of a fluid at rest under a free surface whose height is measured against gravity. [Pa]
double hydrostatic_pressure(const Scene& scene, const Body& body, const Point& x, double rho0) {
    if (!body.hydrostatic_surface) return 0;
    double g2 = 0, g_x = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        g2 += scene.gravity[k] * scene.gravity[k];
        g_x += scene.gravity[k] * x[k];
    }
    if (g2 == 0) return 0;
    const double g = std::sqrt(g2), height = -g_x / g;
    return rho0 * g * std::max(0.0, *body.hydrostatic_surface - height);
}

/// Initial velocity of a body at a point.
template <int Dim>
class InitialVelocity {
  public:
    InitialVelocity(const Scene& scene, const Body& body) {
        for (std::size_t k = 0; k < Dim; ++k)
            components_.emplace_back(scene, "bodies." + body.name + ".velocity", body.velocity[k]);
    }
    Vec<Dim> operator()(const Point& p) const {
        Vec<Dim> v;
        for (int k = 0; k < Dim; ++k) v[k] = components_[static_cast<std::size_t>(k)](p);
        return v;
    }

  private:
    std::vector<CompiledFormula> components_;
};

template <int Dim>
void place_body(const Scene& scene, std::size_t number, const Packing& packing, State<Dim>& state) {
    const Body& body = scene.bodies[number];
    const bool is_fluid = scene.materials[body.material].kind == MaterialKind::fluid;
    const MaterialConstants material = constants_of(scene, body.material);
    MaterialList& materials = is_fluid ? state.fluid_materials : state.solid_materials;
    materials.add(number, material);
    const EquationOfState eos = material.eos;
    ParticleSet<Dim>& phase = is_fluid ? state.fluid : state.solid;
    const InitialVelocity<Dim> velocity(scene, body);
    const CompiledFormula initial_pressure(scene, "bodies." + body.name + ".pressure", body.pressure);
    // h follows the lattice as it was fitted, so that h/d and with it every sum over a full support is what was asked
    // for.
    const double h = scene.method.smoothing_length * std::pow(packing.volume, 1.0 / Dim);
    for (const Point& p : packing.position) {
        const double pressure = is_fluid ? hydrostatic_pressure(scene, body, p, eos.density) + initial_pressure(p) : 0;
        const double density = eos.density_at(pressure);
        const bool clamped = body.clamp && body.clamp->contains(p);
        append(phase, to_vec<Dim>(p), clamped ? Vec<Dim>{} : velocity(p), pressure, density);
        phase.mass.push_back(density * packing.volume);
        phase.smoothing_length.push_back(h);
        phase.body.push_back(static_cast<std::uint16_t>(number));
        if (!is_fluid) state.solid.clamped.push_back(clamped);
    }
}

/// Two planes for each axis along which the domain is periodic.
template <int Dim>
void place_periodic_sides(const Scene& scene, State<Dim>& state) {
    for (int k = 0; k < Dim; ++k) {
        const auto& sides = scene.periodic[static_cast<std::size_t>(k)];
        if (!sides) continue;
        const auto [low, high] = *sides;
        const int first = static_cast<int>(state.ghost_planes.size());
        Vec<Dim> at_low, at_high, up;
        at_low[k] = low;
        at_high[k] = high;
        up[k] = 1;
        state.ghost_planes.push_back({at_low, up, high - low, first + 1});
        state.ghost_planes.push_back({at_high, -1.0 * up, high - low, first});
    }
}

template <int Dim>
void place_wall(const Scene& scene, std::size_t number, const Packing& packing, State<Dim>& state) {
    const Wall& wall = scene.walls[number];
    switch (wall.kind) {
        case WallKind::mirror:
            state.ghost_planes.push_back({to_vec<Dim>(wall.point), to_vec<Dim>(wall.normal)});
            return;
        case WallKind::fixed:
            break;
    }
    const double h = scene.method.smoothing_length * std::pow(packing.volume, 1.0 / Dim);
    for (const Point& p : packing.position) {
        state.wall.position.push_back(to_vec<Dim>(p));
        state.wall.volume.push_back(packing.volume);
        state.wall.smoothing_length.push_back(h);
        state.wall.pressure.push_back(0);
        state.wall.id.push_back(state.wall.id.size());
        state.wall.body.push_back(static_cast<std::uint16_t>(number));
    }
}

/// Sizes the columns that the effects need; those that placing has not filled are zero.
template <int Dim>
void allocate(const Effects& effects, SetId id, std::size_t particles, State<Dim>& state) {
    ParticleSet<Dim>& set = state[id];
    set.owned = particles;
    for_each_array(set, [&](const ColumnInfo& info, auto& values) {
        values.resize(effects.needs(id, info.column) ? particles : 0);
        values.shrink_to_fit();
    });
}

/// Makes the interface elements around all solid bodies.
template <int Dim>
void place_interface(const Scene& scene, const std::vector<Packing>& packings, State<Dim>& state) {
    Index first_id = 0;
    for (const std::size_t b : bodies_in_order(scene)) {
        if (scene.materials[scene.bodies[b].material].kind != MaterialKind::solid) continue;
        state.surface.add_body(packings[b], first_id, static_cast<std::uint16_t>(b));
        first_id += static_cast<Index>(packings[b].position.size());
    }
    state.surface.allocate(state.elements);
    state.elements.smoothing_length.assign(state.elements.owned, state.solid.smoothing_length[0]);
}

/// Which of a body's particles have an empty lattice site within `range` of them: only those can come near a fluid.
template <int Dim>
std::vector<bool> near_surface(const Packing& packing, double range) {
    const SiteIndex lattice(packing.site);
    // Beside a body of much coarser particles the range may exceed the lattice many times; sites beyond it are empty.
    Site size{};
    for (const Site& s : packing.site)
        for (std::size_t k = 0; k < 3; ++k) size[k] = std::max(size[k], s[k] + 1);
    Site reach{};
    for (std::size_t k = 0; k < Dim; ++k)
        reach[k] = static_cast<std::int32_t>(std::min<double>(range / packing.spacing[k], size[k]));
    std::vector<bool> near(packing.site.size());
    for (std::size_t i = 0; i < near.size(); ++i) {
        const Site& s = packing.site[i];
        for (std::int32_t x = -reach[0]; x <= reach[0] && !near[i]; ++x)
            for (std::int32_t y = -reach[1]; y <= reach[1] && !near[i]; ++y)
                for (std::int32_t z = -reach[2]; z <= reach[2] && !near[i]; ++z) {
                    const double distance =
                        std::hypot(x * packing.spacing[0], y * packing.spacing[1], z * packing.spacing[2]);
                    near[i] = distance <= range && !lattice.taken({s[0] + x, s[1] + y, s[2] + z});
                }
    }
    return near;
}

/// Makes the boundary set of the solids' particles that a fluid can feel: those within a support of their surface.
template <int Dim>
void place_boundary(const Scene& scene, const Effects& effects, const std::vector<Packing>& packings,
                    State<Dim>& state) {
    auto& boundary = state.boundary;
    const double support = Smoothing<Dim>(scene.method.smoothing_function).support;
    Index id = 0;
    for (const std::size_t b : bodies_in_order(scene)) {
        if (scene.materials[scene.bodies[b].material].kind != MaterialKind::solid) continue;
        const std::vector<bool> near = near_surface<Dim>(packings[b], support * state.max_h);
        for (std::size_t i = 0; i < near.size(); ++i, ++id) {
            if (!near[i]) continue;
            boundary.solid_id.push_back(id);
            boundary.body.push_back(static_cast<std::uint16_t>(b));
            boundary.smoothing_length.push_back(state.solid.smoothing_length[id]);
        }
    }
    allocate(effects, SetId::boundary, boundary.solid_id.size(), state);
}

template <int Dim>
void find_smoothing_range(State<Dim>& state) {
    state.max_h = 0;
    state.min_h = 1e300;
    for (const ScalarField* h :
         {&state.fluid.smoothing_length, &state.solid.smoothing_length, &state.wall.smoothing_length})
        for (const double value : *h) {
            state.max_h = std::max(state.max_h, value);
            state.min_h = std::min(state.min_h, value);
        }
}

}  // namespace

template <int Dim>
State<Dim> place_particles(const Scene& scene, const Effects& effects) {
    const std::vector<Packing> bodies = pack_bodies(scene), walls = pack_walls(scene);
    check_geometry(scene, bodies, walls);
    check_mach(scene, bodies);
    State<Dim> state;
    if (effects.has(Effect::gravity)) state.gravity = to_vec<Dim>(scene.gravity);
    for (const std::size_t b : bodies_in_order(scene)) {
        place_body(scene, b, bodies[b], state);
        const Material& material = scene.materials[scene.bodies[b].material];
        if (material.kind != MaterialKind::solid) continue;
        state.hyperelastic.last = state.solid.id.size();
        if (material.model == SolidModel::hypoelastic)
            state.hypoelastic.last = state.hyperelastic.first = state.hyperelastic.last;
    }
    for (std::size_t w = 0; w < walls.size(); ++w) place_wall(scene, w, walls[w], state);
    allocate(effects, SetId::fluid, state.fluid.id.size(), state);
    allocate(effects, SetId::solid, state.solid.id.size(), state);
    check_fluids(scene, state.fluid_materials);
    place_constants(state.fluid_materials, state.fluid);
    place_constants(state.solid_materials, state.solid);
    // A wall that nothing can meet has no particles.
    allocate(effects, SetId::wall, effects.needs(SetId::wall, Column::position) ? state.wall.id.size() : 0, state);
    if (effects.has(Effect::moving_wall)) state.wall.initial_position = state.wall.position;
    if (effects.has(Effect::no_slip_wall))
        for (std::size_t i = 0; i < state.wall.owned; ++i) {
            const bool slips = scene.walls[state.wall.body[i]].condition == WallCondition::slip;
            state.wall.friction_volume[i] = slips ? 0.0 : state.wall.volume[i];
        }
    place_periodic_sides(scene, state);
    if (effects.has(Effect::total_lagrangian)) {
        state.solid.reference_position = state.solid.position;
        for (std::size_t i = 0; i < state.solid.owned; ++i)
            state.solid.volume[i] = state.solid.mass[i] / state.solid.density[i];
    }
    find_smoothing_range(state);
    if (effects.has(Effect::contact) && effects.has(Effect::total_lagrangian)) {
        state.solid_group = join_bodies(scene, bodies);
        const double support = Smoothing<Dim>(scene.method.smoothing_function).support;
        part_references<Dim>(state.solid_group, 2 * support * state.max_h, state.hyperelastic, state.solid);
    }
    if (effects.has(Effect::interface_force)) place_interface(scene, bodies, state);
    if (effects.has(Effect::moving_boundary)) place_boundary(scene, effects, bodies, state);
    return state;
}

template State<2> place_particles<2>(const Scene&, const Effects&);
template State<3> place_particles<3>(const Scene&, const Effects&);

}  // namespace sluice
