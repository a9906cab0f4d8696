// A scene as its file states it: checked values only, no particles yet. SI units throughout.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/errors.hpp"
#include "engine/geometry/shape.hpp"
#include "engine/scene/effects/effect.hpp"
#include "engine/scene/reference.hpp"
#include "engine/scene/table/choices.hpp"

namespace sluice {

struct Material {
    std::string name;
    MaterialKind kind = MaterialKind::fluid;
    double density = 0;        ///< reference density ρ0 [kg/m³]
    double sound_speed = 0;    ///< c0 [m/s]: given for a fluid; sqrt(K/ρ0) for a solid
    double shear_modulus = 0;  ///< μ [Pa], 0 for a fluid
    SolidModel model = SolidModel::hypoelastic;
    double viscosity = 0;          ///< dynamic, of a fluid [Pa s]
    double pressure_exponent = 1;  ///< γ of a fluid's equation of state: 1 = linear

    /// K = ρ0 c0² [Pa]
    double bulk_modulus() const { return density * sound_speed * sound_speed; }
};

/// A formula in x, y, z, or in t, or in all of them, and the scene's [constants]; empty = 0.
using Formula = std::string;

struct Body {
    std::string name;
    std::size_t material = 0;  ///< index into Scene::materials
    ShapePtr shape;
    double spacing = 0;               ///< nominal initial particle distance d [m]
    ShapePtr clamp;                   ///< particles whose centre lies in it are held fixed; may be null
    std::array<Formula, 3> velocity;  ///< initial velocity [m/s]
    /// Height of the free surface against gravity [m]; none = start at p = 0.
    std::optional<double> hydrostatic_surface;
    Formula pressure;  ///< initial, of a fluid, on top of the hydrostatic one [Pa]
};

/// How a wall moves: its displacement as formulas in t, or as a table between whose rows it moves uniformly.
struct Motion {
    std::array<Formula, 3> displacement;  ///< [m]
    std::vector<double> time;             ///< rising [s]
    std::vector<Point> place;             ///< displacement at these times [m]

    bool moves() const { return !time.empty() || !(displacement == std::array<Formula, 3>{}); }
};

struct Wall {
    std::string name;
    WallKind kind = WallKind::mirror;
    Point point{};                                  ///< mirror: a point of the plane [m]
    Point normal{};                                 ///< mirror: unit normal into the fluid
    ShapePtr shape;                                 ///< fixed: filled with layers of fixed ghost particles
    Motion motion;                                  ///< fixed
    WallCondition condition = WallCondition::slip;  ///< fixed
    double spacing = 0;                             ///< fixed: [m]
};

struct Probe {
    std::string name;
    ProbeKind kind = ProbeKind::energy;
    std::optional<std::size_t> body;  ///< displacement, force, velocity error, pressure on a surface: index of bodies
    Point at{};                       ///< displacement, pressure: reference position; water_level: x (2D), x and z (3D)
    std::array<Formula, 3> velocity;  ///< velocity_error: what it should be, in x, y, z and t [m/s]

    /// Whether it measures at a place, which `at` states.
    bool has_place() const;
};

/// Method constants of one medium. A value of 0 (or θ = 1) takes the term out of the loops.
struct MediumMethod {
    double velocity_filter = 1;  ///< θ of eq. (16); 1 = off
    DensityDiffusion density_diffusion = DensityDiffusion::none;
    double acoustic_damping = 0;                 ///< α of the bulk viscosity α ρ c0 h; 0 = off
    double shifting = 0;                         ///< A of kernels/terms/particle_shift.hpp; 0 = off
    double diffusion_coefficient = 0.1;          ///< δ
    Viscosity viscous_form = Viscosity::morris;  ///< of a viscous fluid
    double artificial_viscosity = 0;             ///< α of eq. (12)
    double artificial_stress = 0;                ///< e of eq. (14)
    int artificial_stress_exponent = 4;          ///< q of eq. (11)
    double hourglass_control = 0.85;  ///< ζ of kernels/passes/total_lagrangian_passes.hpp, which says why 0.85
};

struct Method {
    Preset preset = Preset::paper;
    SmoothingFunction smoothing_function = SmoothingFunction::cubic_spline;
    Integrator integrator = Integrator::staggered_euler;
    StepSize step_size = StepSize::fixed;
    CouplingScheme coupling = CouplingScheme::interface_force;
    double spacing = 0;               ///< reference spacing d [m]; bodies may state their own
    double smoothing_length = 1.5;    ///< h / d
    double courant = 0.9;             ///< dt = courant · h / c0, smallest over the media
    std::optional<double> time_step;  ///< fixed dt [s] in place of the Courant limit
    Precision precision = Precision::full;
    TimeStepping time_stepping = TimeStepping::single_rate;
    double mach_limit = 0.1;
    std::optional<double> expected_speed;  ///< highest fluid speed expected [m/s]; none = estimated from the scene
    MediumMethod fluid;
    MediumMethod solid;
};

struct OutputTimes {
    double end = 0;                  ///< simulated time to run to [s]
    double frame_interval = 0;       ///< [s]; 0 = no frames
    double probe_interval = 0;       ///< [s]
    double checkpoint_interval = 0;  ///< of simulated time [s]; 0 = none
    /// Of wall time [min]; 0 = none. Few enough to cost nothing; what a crash may take is not worth more.
    double checkpoint_minutes = 10;

    bool has_checkpoints() const { return checkpoint_interval > 0 || checkpoint_minutes > 0; }
};

/// Where a key was found: line of the scene file; 0 = set on the command line. Keys left at their default are absent.
using KeyLines = std::map<std::string, int>;

struct Scene {
    std::string title;
    std::string file;    ///< path as given, for messages
    std::string source;  ///< the file's text with the command line's changes applied, as canonical TOML, without the
                         ///< references, which change nothing in a run; hashed for summary.json
    int dimension = 2;
    Point gravity{};
    std::array<Formula, 3> acceleration;  ///< that depends on time, as formulas in t; added to gravity [m/s²]
    /// Sides of a periodic box along each axis, none = not periodic. [m]
    std::array<std::optional<std::pair<double, double>>, 3> periodic;
    std::map<std::string, double> constants;
    std::vector<Material> materials;
    std::vector<Body> bodies;
    std::vector<Wall> walls;
    std::vector<Probe> probes;
    std::vector<Reference> references;
    Method method;
    PerEffect<Switch> switches;
    WatchPolicy watch = WatchPolicy::stop;
    OutputTimes output;
    KeyLines lines;

    /// Throws SceneError naming file, line and key.
    [[noreturn]] void fail(const std::string& key, const std::string& message) const;
};

/// Reads, overrides (`key.path=value`) and checks a scene. Throws SceneError.
Scene load_scene(const std::string& path, const std::vector<std::string>& overrides = {});
/// The same for a text in memory. `name` stands for the file in messages; files that the scene names are sought beside
/// it.
Scene parse_scene(const std::string& text, const std::string& name, const std::vector<std::string>& overrides = {});

}  // namespace sluice
