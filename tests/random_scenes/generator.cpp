#include "tests/random_scenes/generator.hpp"

#include <fmt/format.h>

#include <array>

#include "tests/random_scenes/nonsense.hpp"
#include "tests/random_scenes/random.hpp"

namespace random_scenes {
namespace {

/// The room that a body may take, and where bodies stand side by side.
struct Slot {
    std::array<double, 3> low, high;
};

class Generator {
  public:
    explicit Generator(std::uint64_t seed) : random_(seed) {}

    /// One draw to an expression: compilers evaluate arguments in any order.
    MadeUp make() {
        three_d_ = random_.chance(0.15);
        spacing_ = random_.scaled(1e-4, 10);
        room_ = spacing_ * (three_d_ ? 5 : 9);
        has_fluid_ = random_.chance(0.85);
        has_solid_ = !has_fluid_ || random_.chance(0.5);
        speed_ = random_.scaled(0.1, 10);
        head();
        method();
        materials();
        bodies();
        walls();
        probes();
        output();
        const bool spoil = random_.chance(0.4);
        return {spoil ? spoilt(text_, random_) : text_, spoil};
    }

  private:
    void line(const std::string& text) { text_ += text + "\n"; }
    /// "[a, b]" or "[a, b, c]".
    std::string vector(const std::array<double, 3>& v) const {
        return three_d_ ? fmt::format("[{}, {}, {}]", v[0], v[1], v[2]) : fmt::format("[{}, {}]", v[0], v[1]);
    }
    std::size_t dimension() const { return three_d_ ? 3 : 2; }

    void head() {
        line(fmt::format("title = \"made up\"\ndimension = {}", dimension()));
        // A fall through the whole room reaches `speed`.
        const double g = 0.5 * speed_ * speed_ / (4 * room_);
        has_gravity_ = random_.chance(0.7);
        if (has_gravity_) line("gravity = " + vector({random_.chance(0.2) ? 0.3 * g : 0, -g, 0}));
        if (random_.chance(0.1))
            line(fmt::format("acceleration = [\"{}*sin({}*t)\", \"0\"{}]", 0.2 * g, speed_ / room_,
                             three_d_ ? ", 0" : ""));
        if (random_.chance(0.2)) line("[constants]\nk = 2.5");
        has_constant_ = text_.find("[constants]") != std::string::npos;
        // The slots' room, and some around it.
        periodic_ = has_fluid_ && random_.chance(0.2);
        if (!periodic_) return;
        line(fmt::format("[domain]\nperiodic = {{x = [{}, {}]{}}}", -0.01 * room_, 2.01 * room_,
                         three_d_ && random_.chance(0.5) ? fmt::format(", z = [0.0, {}]", 2 * room_) : ""));
    }

    void maybe(double share, const std::string& key, const std::vector<std::string>& words) {
        if (random_.chance(share)) line(fmt::format("{} = \"{}\"", key, random_.word(words)));
    }
    void maybe(double share, const std::string& key, double low, double high) {
        if (random_.chance(share)) line(fmt::format("{} = {}", key, random_.between(low, high)));
    }

    void method() {
        line(fmt::format("[method]\nspacing = {}", spacing_));
        maybe(0.6, "preset", {"paper", "modern"});
        maybe(0.2, "smoothing_function", {"cubic-spline", "wendland-c2", "wendland-c4", "quintic-spline"});
        maybe(0.2, "smoothing_length", 1.2, 1.8);
        maybe(0.2, "coupling", {"interface-force", "moving-boundary"});
        maybe(0.3, "precision", {"double", "mixed"});
        maybe(0.2, "integrator", {"staggered-euler", "kick-drift-kick"});
        maybe(0.2, "step_size", {"fixed", "adaptive"});
        maybe(0.2, "time_stepping", {"single-rate", "multi-rate"});
        maybe(0.2, "courant", 0.1, 0.5);
        line(fmt::format("expected_speed = {}", 1.5 * speed_));
        if (random_.chance(0.25)) {
            line("[method.fluid]");
            maybe(0.3, "velocity_filter", 0.9, 1);
            maybe(0.3, "artificial_viscosity", 0, 0.1);
            maybe(0.3, "density_diffusion", {"none", "molteni-colagrossi", "fourtakas", "antuono"});
            maybe(0.3, "acoustic_damping", 0, 0.3);
            maybe(0.3, "particle_shifting", 0, 3);
            maybe(0.3, "viscous_form", {"morris", "monaghan-gingold"});
        }
        if (random_.chance(0.25)) {
            line("[method.solid]");
            maybe(0.3, "artificial_viscosity", 0.1, 1);
            maybe(0.3, "artificial_stress", 0, 0.5);
            maybe(0.3, "hourglass_control", 0.2, 1);
        }
        if (random_.chance(0.2)) {
            line("[effects]");
            maybe(0.5, "particle_shifting", {"auto", "off", "on"});
            maybe(0.5, "contact", {"auto", "off", "on"});
            maybe(0.3, "acoustic_damping", {"auto", "off"});
            maybe(0.3, "density_diffusion", {"auto", "off"});
        }
    }

    void materials() {
        const double sound = 20 * speed_, water = random_.scaled(1, 1e4);
        if (has_fluid_) {
            line(fmt::format("[materials.water]\nkind = \"fluid\"\ndensity = {}\nsound_speed = {}", water, sound));
            if (random_.chance(0.3)) line(fmt::format("viscosity = {}", random_.scaled(1e-6, 1) * speed_ * spacing_));
            maybe(0.3, "equation_of_state", {"linear", "tait"});
        }
        if (!has_solid_) return;
        // Solids lighter than a third of the water are known to break down (tests/hard).
        const double density = water * random_.scaled(0.6, 8),
                     stiffness = density * sound * sound * random_.scaled(0.3, 30);
        line(fmt::format("[materials.rubber]\nkind = \"solid\"\ndensity = {}", density));
        if (random_.chance(0.5))
            line(fmt::format("youngs_modulus = {}\npoisson_ratio = {}", stiffness, random_.between(0, 0.45)));
        else
            line(
                fmt::format("bulk_modulus = {}\nshear_modulus = {}", stiffness, random_.between(0.2, 0.8) * stiffness));
        maybe(0.4, "model", {"hypoelastic", "st-venant-kirchhoff", "neo-hookean"});
    }

    /// Slots stand in two columns and two rows (and two layers); walls stand around them.
    Slot slot(std::size_t number) {
        Slot s;
        for (std::size_t k = 0; k < 3; ++k) {
            const double from = (number >> k & 1) != 0 ? room_ : 0;
            // Touching its neighbours, or with a gap; at times where another one stands.
            const double gap = random_.chance(0.4) ? 0 : random_.between(0, 0.2) * room_;
            const double shift = random_.chance(0.05) ? random_.between(-0.3, 0.3) * room_ : 0;
            s.low[k] = from + gap + shift;
            s.high[k] = from + room_ - gap + shift;
        }
        return s;
    }

    std::string box(const std::array<double, 3>& low, const std::array<double, 3>& high) const {
        return fmt::format("{{box = {{min = {}, max = {}}}}}", vector(low), vector(high));
    }
    std::string ball(const Slot& s, double share) {
        std::array<double, 3> centre;
        for (std::size_t k = 0; k < 3; ++k) centre[k] = 0.5 * (s.low[k] + s.high[k]);
        const double radius = share * 0.5 * std::min(s.high[0] - s.low[0], s.high[1] - s.low[1]);
        return fmt::format("{{{} = {{centre = {}, radius = {}}}}}", three_d_ ? "sphere" : "circle", vector(centre),
                           radius);
    }
    std::string polygon(const Slot& s) {
        const double top = random_.between(s.low[0], s.high[0]), side = random_.between(s.low[1], s.high[1]);
        const std::string points = fmt::format("[[{}, {}], [{}, {}], [{}, {}], [{}, {}]]", s.low[0], s.low[1],
                                               s.high[0], s.low[1], top, s.high[1], s.low[0], side);
        if (!three_d_) return "{polygon = " + points + "}";
        return fmt::format("{{extrusion = {{polygon = {}, axis = \"z\", from = {}, to = {}}}}}", points, s.low[2],
                           s.high[2]);
    }
    std::string shape(const Slot& s, int depth = 0) {
        const double kind = random_.unit();
        if (kind < 0.5 || depth > 2) return box(s.low, s.high);
        if (kind < 0.65) return ball(s, 1);
        if (kind < 0.8) return polygon(s);
        Slot part = s;
        const std::size_t axis = random_.below(dimension());
        part.high[axis] = random_.between(0.3, 0.9) * (s.high[axis] - s.low[axis]) + s.low[axis];
        if (kind < 0.9) return fmt::format("{{union = [{}, {}]}}", shape(part, depth + 1), ball(s, 1));
        const std::string base = shape(s, depth + 1);
        return fmt::format("{{difference = [{}, {}]}}", base, ball(s, random_.between(0.2, 0.6)));
    }

    std::string velocity() {
        const double v = 0.5 * speed_, along = random_.between(-v, v), down = -v * random_.unit();
        const std::string wave = fmt::format("\"{}*sin({}*y)\"", v, random_.scaled(0.3, 3) / spacing_);
        std::string text = fmt::format("[{}, {}", along, random_.chance(0.5) ? wave : fmt::format("{}", down));
        if (has_constant_ && random_.chance(0.5)) text = fmt::format("[\"{}*k/5\", 0.0", v);
        return text + (three_d_ ? ", 0.0]" : "]");
    }

    void bodies() {
        const std::size_t slots = three_d_ ? 8 : 4;
        std::size_t made = 0;
        for (std::size_t number = 0; number < slots; ++number) {
            if (made > 0 && random_.chance(three_d_ ? 0.7 : 0.4)) continue;
            const bool solid = has_solid_ && (!has_fluid_ || (made > 0 && solids_.empty()) || random_.chance(0.4));
            body(number, solid && (made > 0 || !has_fluid_));
            ++made;
        }
        if (has_solid_ && solids_.empty()) body(slots - 1, true);
    }

    void body(std::size_t number, bool solid) {
        const Slot s = slot(number);
        const std::string name = fmt::format("body_{}", number);
        line(fmt::format("[bodies.{}]\nmaterial = \"{}\"\nshape = {}", name, solid ? "rubber" : "water", shape(s)));
        if (random_.chance(0.2)) line(fmt::format("spacing_ratio = {}", random_.one_of<double>({0.5, 0.8, 1.5, 2})));
        if (random_.chance(0.5)) line("velocity = " + velocity());
        (solid ? solids_ : fluids_).push_back(name);
        middle_.push_back({0.5 * (s.low[0] + s.high[0]), 0.5 * (s.low[1] + s.high[1]), 0.5 * (s.low[2] + s.high[2])});
        if (solid) {
            Slot held = s;
            held.high[1] = s.low[1] + 0.3 * room_;
            if (random_.chance(0.5)) line("clamp = " + box(held.low, held.high));
            return;
        }
        if (has_gravity_ && random_.chance(0.5)) line(fmt::format("hydrostatic_surface = {}", s.high[1]));
        if (random_.chance(0.1)) line(fmt::format("pressure = \"{}*x/x\"", speed_ * speed_));
    }

    void mirror(const std::string& name, const std::array<double, 3>& point, const std::array<double, 3>& normal) {
        line(
            fmt::format("[walls.{}]\nkind = \"mirror\"\npoint = {}\nnormal = {}", name, vector(point), vector(normal)));
    }

    void walls() {
        const double low = -0.3 * room_, high = 2.3 * room_;
        const double floor = random_.unit();
        if (floor < 0.4) mirror("floor", {0, random_.chance(0.5) ? low : 0, 0}, {0, 1, 0});
        if (floor > 0.6) {
            line(fmt::format("[walls.floor]\nkind = \"fixed\"\nshape = {}",
                             box({low, -4 * spacing_, low}, {high, 0, high})));
            maybe(0.5, "condition", {"slip", "no-slip"});
            if (random_.chance(0.2)) line(fmt::format("spacing_ratio = {}", random_.one_of<double>({0.5, 2})));
            if (random_.chance(0.3)) motion();
        }
        if (!periodic_ && random_.chance(0.4)) mirror("left", {low, 0, 0}, {1, random_.chance(0.3) ? 0.4 : 0, 0});
        if (!periodic_ && random_.chance(0.4)) mirror("right", {high, 0, 0}, {-1, 0, 0});
    }

    void motion() {
        const double v = 0.3 * speed_, period = room_ / speed_;
        if (random_.chance(0.5))
            line(fmt::format("motion = {{displacement = [\"{}*t\", \"0\"{}]}}", v, three_d_ ? ", \"0\"" : ""));
        else
            line(fmt::format("motion = {{table = [[0, {0}], [{1}, {2}], [{3}, {0}]]}}", three_d_ ? "0, 0, 0" : "0, 0",
                             period, fmt::format("{}, 0{}", v * period, three_d_ ? ", 0" : ""), 2 * period));
    }

    void probes() {
        const auto head = [&](const std::string& kind) { line(fmt::format("[probes.{0}]\nkind = \"{0}\"", kind)); };
        if (random_.chance(0.5)) head("energy");
        if (random_.chance(0.3)) head("momentum");
        if (random_.chance(0.2)) {
            head("pressure");
            line("at = " + vector(random_.one_of(middle_)));
        }
        if (random_.chance(0.2)) {
            head("water_level");
            line(three_d_ ? fmt::format("at = [{0}, {0}]", 0.5 * room_) : fmt::format("at = {}", 0.5 * room_));
        }
        if (!solids_.empty() && random_.chance(0.3)) {
            head("force");
            line(fmt::format("body = \"{}\"", random_.one_of(solids_)));
        }
        if (!fluids_.empty() && random_.chance(0.2)) {
            head("velocity_error");
            line(fmt::format("body = \"{}\"\nvelocity = [\"x-t\", \"y\"{}]", fluids_[0], three_d_ ? ", \"z\"" : ""));
        }
    }

    void output() {
        if (random_.chance(0.5)) {
            line("[watch]");
            maybe(1, "policy", {"stop", "retry", "warn"});
        }
        const double end = room_ / speed_;
        line(fmt::format("[output]\nend = {}", end));
        if (random_.chance(0.5)) line(fmt::format("frame_interval = {}", end / 3));
        if (random_.chance(0.5)) line(fmt::format("probe_interval = {}", end / 100));
        if (random_.chance(0.2)) line(fmt::format("checkpoint_interval = {}", end / 4));
    }

    Random random_;
    std::string text_;
    bool three_d_ = false, has_fluid_ = false, has_solid_ = false, has_gravity_ = false, has_constant_ = false,
         periodic_ = false;
    double spacing_ = 0, room_ = 0, speed_ = 0;
    std::vector<std::string> fluids_, solids_;
    std::vector<std::array<double, 3>> middle_;
};

}  // namespace

MadeUp make_scene(std::uint64_t seed) { return Generator(seed).make(); }

}  // namespace random_scenes
