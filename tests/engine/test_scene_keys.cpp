// The table of scene keys is what the reader does: nothing missing in either direction, and defaults as it says.
#include "engine/scene/table/scene_keys.hpp"

#include <fmt/format.h>

#include <set>

#include "engine/scene/effects/effect_table.hpp"
#include "engine/scene/help/scene_help.hpp"
#include "engine/scene/scene.hpp"
#include "tests/catch.hpp"
#include "tests/engine/scene_text.hpp"

namespace sluice::test_scene_keys {

namespace {

const std::string every_key = SLUICE_TEST_SCENES "/every_key/";

std::string text_of(const MediumMethod& method) {
    const auto& [filter, diffusion, damping, shifting, coefficient, form, viscosity, stress, exponent, hourglass] =
        method;
    return fmt::format("{} {} {} {} {} {} {} {} {} {}\n", filter, static_cast<int>(diffusion), damping, shifting,
                       coefficient, static_cast<int>(form), viscosity, stress, exponent, hourglass);
}

// A new member of a structure does not compile here before it is compared too.
std::string text_of(const Method& method) {
    const auto& [preset, function, integrator, size, coupling, spacing, length, courant, step, precision, rate, mach,
                 speed, fluid, solid] = method;
    return fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {}\n", static_cast<int>(preset), static_cast<int>(function),
                       static_cast<int>(integrator), static_cast<int>(size), static_cast<int>(coupling), spacing,
                       length, courant, step.value_or(-1), word_of(precision), word_of(rate), mach,
                       speed.value_or(-1)) +
           text_of(fluid) + text_of(solid);
}

std::string text_of(const OutputTimes& output) {
    const auto& [end, frames, probes, checkpoints, minutes] = output;
    return fmt::format("{} {} {} {} {}\n", end, frames, probes, checkpoints, minutes);
}

/// What keys with a default decide.
std::string snapshot(const Scene& scene) {
    std::string text = fmt::format("{} {}\n", scene.dimension, static_cast<int>(scene.watch));
    text += text_of(scene.method) + text_of(scene.output);
    for (const Switch asked : scene.switches) text += fmt::format("{} ", static_cast<int>(asked));
    for (const Material& m : scene.materials)
        text += fmt::format("{} {} {} {}\n", m.name, static_cast<int>(m.model), m.viscosity, m.pressure_exponent);
    for (const Body& b : scene.bodies) text += fmt::format("{} {}\n", b.name, b.pressure.empty() ? "0" : b.pressure);
    for (const Wall& w : scene.walls) text += fmt::format("{} {}\n", w.name, word_of(w.condition));
    for (const Reference& r : scene.references)
        text += fmt::format("{} {} {} {}\n", r.name, static_cast<int>(r.measure), r.from, fmt::join(r.value, " "));
    return text;
}

/// States as little as a scene can that has a place for every key with a default.
std::string bare_scene(const std::string& preset) {
    return "[method]\npreset = \"" + preset + R"toml("
spacing = 0.1
[materials.water]
kind = "fluid"
density = 1000.0
sound_speed = 50.0
[materials.rubber]
kind = "solid"
density = 1100.0
youngs_modulus = 1e7
poisson_ratio = 0.4
[bodies.water]
material = "water"
shape = {box = {min = [0, 0], max = [1, 1]}}
[bodies.gate]
material = "rubber"
shape = {box = {min = [1, 0], max = [2, 1]}}
[walls.floor]
kind = "fixed"
shape = {box = {min = [0, -1], max = [1, 0]}}
[probes.tip]
kind = "displacement"
body = "gate"
at = [1, 1]
[output]
end = 1
[reference.tip]
probe = "tip.x"
table = {file = "reference.csv", time = "t", values = ["one"]}
)toml";
}

/// The key in the bare scene.
std::string concrete(const SceneKey& key) {
    const std::string table(key.path.substr(0, key.path.find('.')));
    const std::string name = table == "materials"   ? (key.only.starts_with("solid") ? "rubber" : "water")
                             : table == "bodies"    ? "water"
                             : table == "walls"     ? "floor"
                             : table == "reference" ? "tip"
                                                    : "";
    std::string path(key.path);
    const std::size_t star = path.find('*');
    return star == std::string::npos ? path : path.replace(star, 1, name);
}

/// Another value than the default.
std::string changed(const SceneKey& key, const std::string& value) {
    if (key.value.type == KeyType::formula) return "5";
    if (key.value.type != KeyType::word) return value == "1" ? "0.5" : "1";
    for (const std::string& word : choices_of(key))
        if ('"' + word + '"' != value) return '"' + word + '"';
    return value;
}

}  // namespace

TEST_CASE("every key of the table is one that the reader asks for", "[keys]") {
    std::set<std::string_view> asked;
    for (const std::string file : {"plane.toml", "space.toml"}) {
        const Scene scene = load_scene(every_key + file);
        // The reader notes the line of each key that it finds.
        for (const auto& [path, line] : scene.lines) {
            const SceneKey* key = resolve_scene_key(path);
            CAPTURE(path);
            REQUIRE(key);
            asked.insert(key->path);
        }
    }
    for (const SceneKey& key : scene_keys()) {
        CAPTURE(std::string(key.path));
        CHECK(asked.count(key.path) == 1);
    }
}

TEST_CASE("keys are in the table once, below a table that is there too, of kinds that exist", "[keys]") {
    std::set<std::string_view> paths;
    for (const SceneKey& key : scene_keys()) {
        CAPTURE(std::string(key.path));
        CHECK(paths.insert(key.path).second);
        const std::string_view table = table_of(key);
        CHECK((table.empty() || table == "SHAPE" || paths.count(table) == 1));
        CHECK_FALSE(key.meaning.empty());
        // Where entries are of kinds, a key belongs to some of them.
        const SceneKey* kind = table == "" ? nullptr : find_scene_key(table, "kind");
        if (!kind) continue;
        for (std::string word : words_in(key.only)) {
            if (word.ends_with('?')) word.pop_back();
            CHECK_THAT(choices_of(*kind), Catch::Matchers::VectorContains(word));
        }
    }
}

TEST_CASE("a key left out is as if its default stood there, in both presets", "[keys]") {
    int compared = 0;
    for (const std::string preset : {"modern", "paper"}) {
        const std::string text = bare_scene(preset);
        const auto read = [&](const std::vector<std::string>& overrides) {
            return snapshot(parse_scene(text, every_key + "bare.toml", overrides));
        };
        const std::string bare = read({});
        for (const SceneKey& key : scene_keys()) {
            if (key.otherwise.kind != Otherwise::Kind::value || key.path == "method.preset") continue;
            const bool other = preset == "paper" && !key.otherwise.paper.empty();
            const std::string value(other ? key.otherwise.paper : key.otherwise.text);
            const std::string path = concrete(key);
            CAPTURE(preset, path, value);
            CHECK(read({path + "=" + value}) == bare);
            // What is compared must show the key; of a dimension of 3 the scene's places would be wrong.
            if (key.path != "dimension") CHECK(read({path + "=" + changed(key, value)}) != bare);
            ++compared;
        }
    }
    CHECK(compared > 100);
}

TEST_CASE("paths of a scene lead to their rows", "[keys]") {
    const auto path_of = [](const char* path) {
        const SceneKey* key = resolve_scene_key(path);
        return key ? std::string(key->path) : "";
    };
    CHECK(path_of("method.fluid.acoustic_damping") == "method.fluid.acoustic_damping");
    CHECK(path_of("bodies.gate") == "bodies.*");
    CHECK(path_of("bodies.gate.shape.union[0].difference[1].box.min") == "SHAPE.box.min");
    CHECK(path_of("walls.piston.motion.displacement[0]") == "walls.*.motion.displacement");
    CHECK(path_of("SHAPE.circle.radius") == "SHAPE.circle.radius");
    CHECK(path_of("method.spacng") == "");
    CHECK(path_of("method.spacing.x") == "");
    CHECK(path_of("") == "");
}

TEST_CASE("ranges say what they hold", "[keys]") {
    CHECK(NumberRange{}.text() == "a number");
    CHECK(NumberRange{.low = 0, .open_low = true}.text() == "a number > 0");
    CHECK(NumberRange{.low = 0}.text() == "a number >= 0");
    CHECK(NumberRange{.high = 2}.text() == "a number <= 2");
    const NumberRange part{.low = 0, .high = 1, .open_low = true};
    CHECK(part.text() == "a number in (0, 1]");
    CHECK_FALSE(part.holds(0));
    CHECK(part.holds(1));
}

TEST_CASE("help on scenes has every key, by path and by name", "[keys]") {
    const std::string list = scene_key_list(), document = scene_document();
    for (const SceneKey& key : scene_keys()) {
        CAPTURE(std::string(key.path));
        if (key.value.type != KeyType::table && table_of(key) != "effects")
            CHECK(document.find(key.meaning) != std::string::npos);
        CHECK(meant_scene_keys(shown_path(key)).size() == 1);
        const std::string page = scene_key_page(key);
        CHECK(page.find(key.meaning) != std::string::npos);
        CHECK(page.find(key.value.unit) != std::string::npos);
    }
    CHECK(meant_scene_keys("spacing").size() == 3);
    CHECK(meant_scene_keys("spacng").empty());
    CHECK(list.find("\n[method.fluid]\n  velocity_filter ") != std::string::npos);
    CHECK(scene_key_page(*resolve_scene_key("method.courant")).find("0.75; 0.9 with preset = \"paper\"") !=
          std::string::npos);
}

}  // namespace sluice::test_scene_keys
