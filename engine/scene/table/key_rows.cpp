#include "engine/scene/table/key_rows.hpp"

namespace sluice {
namespace {

// Numbers.
constexpr NumberRange any{}, positive{.low = 0, .open_low = true}, not_negative{.low = 0};
constexpr NumberRange fraction{.low = 0, .high = 1, .open_low = true};

constexpr KeyValue number(NumberRange range, std::string_view unit = "") { return {KeyType::number, unit, range}; }
constexpr KeyValue whole(double low, double high) { return {KeyType::whole, "", {low, high}}; }

// What else there is.
constexpr KeyValue text{KeyType::text}, table{KeyType::table}, names{KeyType::names}, shape{KeyType::shape};
constexpr KeyValue vector(std::string_view unit = "") { return {KeyType::vector, unit}; }
constexpr KeyValue place = vector("m");
template <class Enum>
constexpr KeyValue word{KeyType::word, "", {}, word_list<Enum>};
constexpr KeyValue formula(Variable variables, std::string_view unit = "") {
    return {KeyType::formula, unit, {}, {}, variables};
}
constexpr KeyValue formulas(Variable variables, std::string_view unit) {
    return {KeyType::formulas, unit, {}, {}, variables};
}

// Without the key.
constexpr Otherwise required{};
constexpr Otherwise value(std::string_view toml) { return {Otherwise::Kind::value, toml}; }
constexpr Otherwise preset(std::string_view modern, std::string_view paper) {
    return {Otherwise::Kind::value, modern, paper};
}
template <auto word>
constexpr Otherwise chosen = value(quoted_word<word>);
template <auto modern, auto paper>
constexpr Otherwise chosen_by_preset = preset(quoted_word<modern>, quoted_word<paper>);
constexpr Otherwise said(std::string_view words) { return {Otherwise::Kind::said, words}; }
constexpr Otherwise none = said("none");

constexpr SceneKey rows[]{
    // The scene.
    {"title", text, said("empty"), "heads reports, pictures and pages"},
    {"dimension", whole(2, 3), value("2"), "2: a unit of length into the page, masses and forces per metre; or 3"},
    {"gravity", vector("m/s²"), said("none"), "constant acceleration of all that moves", "", Effect::gravity},
    {"acceleration", formulas(Variable::time, "m/s²"), none,
     "depends on time, added to gravity: a tank seen from within", "", Effect::driven_acceleration},
    {"constants", names, none, "numbers that formulas may use by their names"},
    {"constants.*", number(any), said("none"), "its value"},
    {"domain", table, none, "the space that fluid moves in"},
    {"domain.periodic", table, none, "axes along which what leaves on one side comes back on the other", "",
     Effect::periodic_box},
    {"domain.periodic.x", {KeyType::sides, "m"}, said("not periodic"), "sides of the box along x: [low, high]"},
    {"domain.periodic.y", {KeyType::sides, "m"}, said("not periodic"), "along y"},
    {"domain.periodic.z", {KeyType::sides, "m"}, said("not periodic"), "along z", "3D"},

    // How it is computed.
    {"method", table, required, "how the scene is computed; a preset sets every choice that is not stated"},
    {"method.preset", word<Preset>, chosen<Preset::modern>,
     "\"paper\": Antoci et al. 2007 to the letter; \"modern\": the best that we know"},
    {"method.spacing", number(positive, "m"), required,
     "initial distance of particles; halved, a 2D run takes about 8 times as long, a 3D run 16 times"},
    {"method.smoothing_function", word<SmoothingFunction>,
     chosen_by_preset<SmoothingFunction::wendland_c2, SmoothingFunction::cubic_spline>,
     "kernel that sums over neighbours are weighted with"},
    {"method.smoothing_length", number({1, 3}), value("1.5"), "h over the spacing"},
    {"method.coupling", word<CouplingScheme>,
     chosen_by_preset<CouplingScheme::moving_boundary, CouplingScheme::interface_force>,
     "how fluid and solid feel each other: by pressure on elements of the interface, or with the solid's particles as "
     "the fluid's moving boundary",
     "fluid with solids"},
    {"method.precision", word<Precision>, chosen_by_preset<Precision::mixed, Precision::full>,
     "of pairs; the state is double in both"},
    {"method.integrator", word<Integrator>, chosen_by_preset<Integrator::kick_drift_kick, Integrator::staggered_euler>,
     "how a step is taken"},
    {"method.step_size", word<StepSize>, chosen_by_preset<StepSize::adaptive, StepSize::fixed>,
     "whether steps follow speed and acceleration", "", Effect::adaptive_step},
    {"method.courant", number({0, 2, true}), preset("0.75", "0.9"),
     "time step over h/c0; lower it if a run is unstable"},
    {"method.time_step", number(positive, "s"), said("by the Courant number"), "a fixed time step"},
    {"method.time_stepping", word<TimeStepping>, chosen_by_preset<TimeStepping::multi_rate, TimeStepping::single_rate>,
     "one step for all, or the solid at its own rate within the fluid's", "fluid with solids", Effect::solid_substeps},
    {"method.mach_limit", number(positive), value("0.1"),
     "highest Mach number that a scene is accepted with; densities are off by about its square"},
    {"method.expected_speed", number(positive, "m/s"), said("estimated from initial speeds and heights of fall"),
     "the fastest that the fluid is expected to become"},
    {"method.fluid", table, said("the preset's"), "method constants of the fluid"},
    {"method.fluid.velocity_filter", number(fraction), preset("1", "0.92"),
     "θ: velocities become θ times themselves and 1 - θ times their neighbours' mean in each step; 1 = off", "",
     Effect::velocity_filter},
    {"method.fluid.artificial_viscosity", number(not_negative), preset("0.02", "0"), "α of Monaghan's; 0 = off", "",
     Effect::artificial_viscosity},
    {"method.fluid.viscous_form", word<Viscosity>, chosen<Viscosity::morris>,
     "how viscosity acts: the first between walls, the second with a free surface", "viscous fluids",
     Effect::laminar_viscosity},
    {"method.fluid.density_diffusion", word<DensityDiffusion>,
     chosen_by_preset<DensityDiffusion::fourtakas, DensityDiffusion::none>, "keeps pressure smooth", "",
     Effect::density_diffusion},
    {"method.fluid.acoustic_damping", number(not_negative), preset("0.3", "0"), "damps sound; 0 = off", "",
     Effect::acoustic_damping},
    {"method.fluid.particle_shifting", number(not_negative), preset("2", "0"), "keeps particles in order; 0 = off", "",
     Effect::particle_shifting},
    {"method.fluid.diffusion_coefficient", number(positive), value("0.1"), "δ of the density diffusion", "",
     Effect::density_diffusion},
    {"method.solid", table, said("the preset's"), "method constants of solids"},
    {"method.solid.velocity_filter", number(fraction), value("1"), "as the fluid's; 1 = off", "hypoelastic solids",
     Effect::solid_filter},
    {"method.solid.artificial_viscosity", number(not_negative), preset("0.1", "1"),
     "α of Monaghan's; 0 = off; without it up to 1 if lighter than the fluid", "", Effect::solid_viscosity},
    {"method.solid.artificial_stress", number(not_negative), preset("0", "0.3"),
     "e of Gray's, against numerical fracture; 0 = off", "hypoelastic solids", Effect::artificial_stress},
    {"method.solid.artificial_stress_exponent", whole(1, 8), value("4"), "its exponent", "hypoelastic solids",
     Effect::artificial_stress},
    {"method.solid.hourglass_control", number(not_negative), value("0.85"),
     "against zigzags that cost no energy; 0 = off", "total-Lagrangian solids", Effect::hourglass_control},
    {"effects", table, said("all \"auto\""), "switches; `sluice help effects` explains them"},

    // What there is.
    {"materials", names, required, "fluids and solids, any number"},
    {"materials.*", table, said("none"), "a material"},
    {"materials.*.kind", word<MaterialKind>, required, "what it is"},
    {"materials.*.density", number(positive, "kg/m³"), required, "at rest; water 1000, rubber 1100"},
    {"materials.*.sound_speed", number(positive, "m/s"), required,
     "ten times the fastest flow keeps densities within 1 %; more only costs time", "fluid"},
    {"materials.*.viscosity", number(not_negative, "Pa s"), value("0"), "dynamic; water 0.001", "fluid?",
     Effect::laminar_viscosity},
    {"materials.*.equation_of_state", word<PressureLaw>, chosen<PressureLaw::linear>, "pressure over density", "fluid?",
     Effect::fluid_pressure},
    {"materials.*.model", word<SolidModel>,
     chosen_by_preset<SolidModel::saint_venant_kirchhoff, SolidModel::hypoelastic>,
     "the first as in the paper, the others total Lagrangian", "solid?"},
    {"materials.*.youngs_modulus", number(positive, "Pa"), said("from bulk_modulus and shear_modulus"),
     "with poisson_ratio", "solid?"},
    // At 1/2 the bulk modulus of an isotropic solid is infinite, at -1 the shear modulus.
    {"materials.*.poisson_ratio", number({-1, 0.5, true, true}), said("from bulk_modulus and shear_modulus"),
     "rubber 0.4 to 0.49, steel 0.3", "solid?"},
    {"materials.*.bulk_modulus", number(positive, "Pa"), said("from youngs_modulus and poisson_ratio"),
     "with shear_modulus", "solid?"},
    {"materials.*.shear_modulus", number(positive, "Pa"), said("from youngs_modulus and poisson_ratio"),
     "with bulk_modulus", "solid?"},
    {"bodies", names, required, "what is made of particles; one or more"},
    {"bodies.*", table, said("none"), "a body"},
    {"bodies.*.material", text, required, "a name from [materials]"},
    {"bodies.*.shape", shape, required, "the space that it fills with particles"},
    {"bodies.*.spacing", number(positive, "m"), said("method.spacing"), "its particles' distance", "",
     Effect::variable_resolution},
    {"bodies.*.spacing_ratio", number(positive), said("1"), "the same as a multiple of method.spacing", "",
     Effect::variable_resolution},
    {"bodies.*.clamp", shape, none, "particles whose centres lie in it are held", "solids", Effect::clamp},
    {"bodies.*.hydrostatic_surface", number(any, "m"), said("pressure starts at 0"),
     "height of the free surface: pressure starts as that of water at rest below it", "fluids with gravity"},
    {"bodies.*.velocity", formulas(Variable::place, "m/s"), said("at rest"), "initial velocity"},
    {"bodies.*.pressure", formula(Variable::place, "Pa"), value("0"), "initial, on top of the hydrostatic one",
     "fluids"},
    {"walls", names, none, "what is rigid"},
    {"walls.*", table, said("none"), "a wall"},
    {"walls.*.kind", word<WallKind>, required, "a plane that mirrors the fluid, or layers of fixed ghosts"},
    {"walls.*.point", place, required, "any point of the plane", "mirror", Effect::mirror_wall},
    {"walls.*.normal", vector(), required, "direction from the plane into the fluid", "mirror"},
    {"walls.*.shape", shape, required, "the space that it fills; four spacings thick holds a fluid", "fixed",
     Effect::fixed_wall},
    {"walls.*.spacing", number(positive, "m"), said("method.spacing"), "its particles' distance", "fixed?"},
    {"walls.*.spacing_ratio", number(positive), said("1"), "the same as a multiple of method.spacing", "fixed?"},
    {"walls.*.condition", word<WallCondition>, chosen<WallCondition::slip>, "whether a viscous fluid slips along it",
     "fixed?", Effect::no_slip_wall},
    {"walls.*.motion", table, none, "how it moves: displacement or table", "fixed?", Effect::moving_wall},
    {"walls.*.motion.displacement", formulas(Variable::time, "m"), said("by the table"),
     "from where the shape puts it"},
    {"walls.*.motion.table",
     {KeyType::rows, "s, m"},
     said("by displacement"),
     "rows [t, x, y] or [t, x, y, z]; uniform motion between them"},

    // Shapes, in bodies, walls and clamps.
    {"SHAPE.box", table, none, "a box along the axes"},
    {"SHAPE.box.min", place, required, "its lowest corner"},
    {"SHAPE.box.max", place, required, "its highest corner"},
    {"SHAPE.circle", table, none, "a disc", "2D"},
    {"SHAPE.circle.centre", place, required, "its centre"},
    {"SHAPE.circle.radius", number(positive, "m"), required, "its radius"},
    {"SHAPE.polygon", {KeyType::vertices, "m"}, none, "vertices [x, y] in turn; edges must not cross", "2D"},
    {"SHAPE.sphere", table, none, "a ball", "3D"},
    {"SHAPE.sphere.centre", place, required, "its centre"},
    {"SHAPE.sphere.radius", number(positive, "m"), required, "its radius"},
    {"SHAPE.cylinder", table, none, "a circular cylinder in any direction", "3D"},
    {"SHAPE.cylinder.from", place, required, "centre of one end"},
    {"SHAPE.cylinder.to", place, required, "centre of the other end"},
    {"SHAPE.cylinder.radius", number(positive, "m"), required, "its radius"},
    {"SHAPE.extrusion", table, none, "a polygon, drawn out along an axis", "3D"},
    {"SHAPE.extrusion.polygon", {KeyType::vertices, "m"}, required, "vertices in the plane of the other two axes"},
    {"SHAPE.extrusion.axis", word<Direction>, required, "along which it is drawn out"},
    {"SHAPE.extrusion.from", number(any, "m"), required, "where it begins on the axis"},
    {"SHAPE.extrusion.to", number(any, "m"), required, "where it ends"},
    {"SHAPE.union", {KeyType::shapes}, none, "what lies in any of the shapes"},
    {"SHAPE.difference", {KeyType::shapes}, none, "what lies in the first shape and in none of the others"},

    // What is measured.
    {"probes", names, none, "columns of probes.csv"},
    {"probes.*", table, said("none"), "a probe"},
    {"probes.*.kind", word<ProbeKind>, required,
     "what it measures: how far a place of a solid has moved; pressure; height of the water; energies or momentum of "
     "all; the fluid's force on a solid; how far the fluid's velocity is from a field"},
    {"probes.*.body", text, required, "a name from [bodies]; a pressure without it is measured in the fluid",
     "displacement force velocity_error pressure?"},
    {"probes.*.at",
     {KeyType::station, "m"},
     required,
     "where: a place; for a water_level x in 2D, [x, z] in 3D",
     "displacement pressure water_level"},
    {"probes.*.velocity", formulas(Variable::place_and_time, "m/s"), required, "what the fluid's velocity should be",
     "velocity_error"},
    {"watch", table, none, "what happens when a run breaks down"},
    {"watch.policy", word<WatchPolicy>, chosen<WatchPolicy::stop>,
     "stop; go back to the last good state and on with half the step; or go on as long as numbers are finite"},
    {"output", table, required, "when a run ends and what it writes"},
    {"output.end", number(positive, "s"), required, "simulated time to run to"},
    {"output.frame_interval", number(not_negative, "s"), value("0"), "between frames; 0 = none"},
    {"output.probe_interval", number(not_negative, "s"), value("0"), "between rows of probes.csv; 0 = none"},
    {"output.checkpoint_interval", number(not_negative, "s"), value("0"),
     "simulated time between checkpoints; 0 = none"},
    {"output.checkpoint_minutes", number(not_negative, "min"), value("10"), "wall time between checkpoints; 0 = none"},

    // What it should be.
    {"reference", names, none, "what probes should show, for studies"},
    {"reference.*", table, said("none"), "a reference"},
    {"reference.*.probe", text, required, "a column of probes.csv, as \"tip.x\""},
    {"reference.*.measure", word<Measure>, chosen<Measure::rms>,
     "how it is compared: rms and max point by point, the others by one number"},
    {"reference.*.formula", formula(Variable::time), said("by table or value"), "what it should be"},
    {"reference.*.table", table, said("by formula or value"), "a CSV file of what it should be"},
    {"reference.*.table.file", text, required, "beside the scene"},
    {"reference.*.table.time", text, required, "its column of times [s]"},
    {"reference.*.table.values", {KeyType::texts}, required, "its columns of values, of which the mean is taken"},
    {"reference.*.table.factor", number(any), value("1"), "that values are multiplied by"},
    {"reference.*.value", number(any), said("by formula or table"), "the number that the measure should give"},
    {"reference.*.from", number(not_negative, "s"), value("0"), "what is before is not compared"},
    {"reference.*.to", number(positive, "s"), said("the end"), "nor what comes after"},
    {"reference.*.scale", number(positive), said("the reference's own size"), "what relative errors refer to"},
    {"reference.*.uncertainty", number(not_negative), said("not known"), "of the reference, in the unit of the error"},
    {"reference.*.source", text, said("empty"), "where it was published"},
};

}  // namespace

std::span<const SceneKey> key_rows() { return rows; }

}  // namespace sluice
