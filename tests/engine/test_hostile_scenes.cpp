// Scenes that are out to do harm, or look as if: each is refused with a message, none ends or stops the program.
#include <algorithm>

#include "engine/geometry/packing.hpp"
#include "engine/geometry/particle_count.hpp"
#include "engine/run/output/frame_table.hpp"
#include "engine/scene/read/key_parts.hpp"
#include "engine/scene/table/excerpt.hpp"
#include "engine/simulation/simulation.hpp"
#include "tests/catch.hpp"
#include "tests/engine/physics_scenes.hpp"
#include "tests/engine/scene_text.hpp"
#include "tests/engine/temporary_folder.hpp"

namespace sluice::test_hostile_scenes {
namespace {

using namespace scene_text;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

std::string repeated(const std::string& piece, int times) {
    std::string text;
    for (int k = 0; k < times; ++k) text += piece;
    return text;
}

/// What a simulation of the changed gate is answered with.
std::string simulation_error(const std::string& from, const std::string& to) {
    return error_of([&] { Simulation<2> simulation(load(with(gate, from, to))); });
}

}  // namespace

TEST_CASE("Nesting deeper than any scene is refused", "[scene][hostile]") {
    const std::string parts = repeated("a.", 100000) + "a";
    CHECK(load_error("title = 1\n" + parts + " = 1\n") ==
          "2:1: found a key of more than 16 parts, expected a scene's key");
    CHECK_THAT(load_error("[" + parts + "]\n"), StartsWith("1:1: found a key of more than 16 parts"));
    CHECK_THAT(load_error("x = {\"a\"" + repeated(" . 'a'", 20) + " = 1}\n"), StartsWith("1:1: found a key of"));
    CHECK_THAT(load_error("x = " + repeated("[", 100000) + repeated("]", 100000)), StartsWith("1:260: "));
    CHECK_THAT(load_error("x = " + repeated("[", 100000)), Contains("found a [ that is not closed"));
    CHECK_THAT(load_error("x = " + repeated("{a = ", 100000)), StartsWith("1:"));
    // Dots of numbers, texts and comments are none of a key.
    const std::string dots = repeated(".", 100);
    CHECK(line_of_long_key("a.b = [" + repeated("0.1, ", 100) + "] # " + dots) == 0);
    CHECK(line_of_long_key("a = \"\\\"" + dots + "\"\nb = '" + dots + "'\nc = \"\"\"\n" + dots + "\"\"\"") == 0);
    CHECK(line_of_long_key("a = '''\n\n'''\n" + parts) == 4);
    CHECK(line_of_long_key("a = \"unfinished\n" + parts) == 2);
}

TEST_CASE("Bytes that are no text are refused", "[scene][hostile]") {
    CHECK_THAT(load_error("title = \"\xff\xfe\"\n"), StartsWith("1:") && Contains("invalid utf-8"));
    CHECK_THAT(load_error(std::string("title = \"a\0b\"\n", 14)), StartsWith("1:11"));
    // A message is one line, and does not end at a zero.
    CHECK(gate_error("density = 1000.0", R"(density = "\u0000\n\u001b")") ==
          R"(11: materials.water.density: found "\x00\x0a\x1b", expected a number > 0 [kg/m³])");
    CHECK_THAT(gate_error("courant = 0.5", R"("cou\u0000rant" = 0.5)"), Contains(R"(cou\x00rant: found an unknown)"));
}

TEST_CASE("Texts of any length are answered in short", "[scene][hostile]") {
    const std::string letters(1000000, 'a');
    CHECK_THAT(gate_error("density = 1000.0", "density = \"" + letters + "\""), Contains("... (1000000 bytes)"));
    CHECK(gate_error("courant = 0.5", letters + " = 0.5").size() < 5000);
    CHECK_THAT(gate_error("[\"0\",", "[\"" + repeated("1+", 100000) + "1\","),
               StartsWith("23: bodies.water.velocity[0]: found \"1+1+"));
    CHECK_THAT(gate_error("[\"0\",", "[\"" + repeated("(", 100000) + "\","), Contains("expected a formula in"));
    CHECK(excerpt("ab\xc3\xa4"
                  "c",
                  3) == "ab\xc3\xa4... (5 bytes)");  // not in the middle of a letter
}

TEST_CASE("A file without end is refused", "[scene][hostile]") {
    CHECK_THROWS_WITH(load_scene("/dev/zero"), "/dev/zero: found more than 32 MB, expected a scene file");
}

TEST_CASE("A scene reads no file outside its folder", "[scene][hostile]") {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.path() / "scene" / "data");
    for (const char* file : {"outside.csv", "scene/inside.csv", "scene/data/below.csv"})
        std::ofstream(folder.path() / file) << "t,a\n0,1\n1,2\n";
    const auto error_with = [&](const std::string& file) {
        std::ofstream(folder.path() / "scene" / "scene.toml")
            << with(gate, "[output]",
                    "[reference.tip]\nprobe = \"free_end.x\"\ntable = {file = '" + file +
                        "', time = \"t\", values = [\"a\"]}\n[output]");
        return error_of([&] { load_scene(folder.path() / "scene" / "scene.toml"); });
    };
    for (const char* file : {"inside.csv", "./inside.csv", "data/below.csv", "data/../inside.csv"}) {
        CAPTURE(file);
        CHECK(error_with(file).empty());
    }
    const std::string absolute = folder.path() / "outside.csv";
    for (const std::string& file : {absolute, std::string("../outside.csv"), std::string("data/../../outside.csv"),
                                    std::string("/dev/zero"), std::string("..")}) {
        CAPTURE(file);
        CHECK(error_with(file) == "47: reference.tip.table.file: found \"" + file +
                                      "\", expected a path that starts at the scene's folder and stays in it");
    }
}

TEST_CASE("Particles are counted before there is memory for them", "[checks][hostile]") {
    const ShapePtr box = make_box({0, 0, 0}, {1, 1, 0});
    CHECK(holds_more_than(99, *box, 0.1, 2));
    CHECK_FALSE(holds_more_than(100, *box, 0.1, 2));
    CHECK(holds_more_than(1e6, *box, 1e-5, 2));  // of 1e10
    // 1.4e9 particles: more than any machine's memory that runs this test.
    CHECK_THAT(simulation_error("spacing_ratio = 2.0", "spacing = 3.2e-6"),
               StartsWith("21: bodies.water.spacing: found 3.2e-06 m, which makes ") && Contains(" expected "));
}

TEST_CASE("Steps that come to nothing, or to no end, are refused", "[checks][hostile]") {
    CHECK_THAT(simulation_error("sound_speed = 30", "sound_speed = 1e300"),
               StartsWith("46: output.end: found 0.4 s, which takes "));
    CHECK_THAT(simulation_error("end = 0.4", "end = 1e300"), StartsWith("46: output.end: found 1e+300 s"));
    CHECK_THAT(simulation_error("preset = \"paper\"", "time_stepping = \"multi-rate\"\ntime_step = 1e3"),
               Contains("found a solid that takes "));
    CHECK_THAT(simulation_error("density = 1100.0", "density = 1e-320"), Contains(": materials.rubber"));
}

/// A solid of its own, with the rest of the scene to be added.
const std::string solid = R"toml([method]
spacing = 1e-3
[materials.rubber]
kind = "solid"
density = 1100.0
youngs_modulus = 1.2e7
poisson_ratio = 0.4
[output]
end = 0.1
[bodies.gate]
material = "rubber"
)toml";

TEST_CASE("A wall that nothing meets has no particles", "[checks][hostile]") {
    const Simulation<2> simulation(load(solid + R"toml(shape = {box = {min = [0.0, 0.0], max = [0.005, 0.02]}}
[walls.floor]
kind = "fixed"
shape = {box = {min = [-0.01, -0.01], max = [0.01, 0.0]}}
[effects]
contact = "off"
)toml"));
    REQUIRE(simulation.wall().owned == 0);
    const FrameTable table = frame_table<2>(simulation.fluid(), simulation.solid(), simulation.wall(),
                                            simulation.solid_materials(), simulation.hyperelastic());
    REQUIRE(table.particles == simulation.solid().owned);
}

TEST_CASE("A grain of a solid beside coarse water does not take for ever", "[checks][hostile]") {
    // All of it is within the water's support of its surface: a hundred thousand lattice sites in each direction.
    const Simulation<2> simulation(load(solid + R"toml(shape = {box = {min = [0.0, 0.0], max = [4e-5, 4e-5]}}
spacing = 1e-5
[materials.water]
kind = "fluid"
density = 1000.0
sound_speed = 30.0
[bodies.water]
material = "water"
shape = {box = {min = [1.0, 0.0], max = [5.0, 4.0]}}
spacing = 1.0
)toml"));
    REQUIRE(simulation.boundary().owned == 16);
}

TEST_CASE("More bodies or walls than particles can name are refused", "[scene][hostile]") {
    const auto many = [](const std::string& kind, std::size_t count) {
        std::string text = with(gate, "[bodies.water]", "[bodies.first]");
        text = with(text, "[walls.bottom]", "[walls.first]");
        for (std::size_t k = 0; k < count; ++k) text += "[" + kind + ".more" + std::to_string(k) + "]\n";
        return text;
    };
    // The gate has two of each.
    const auto line = [](std::size_t more) {
        return std::to_string(static_cast<std::size_t>(std::ranges::count(gate, '\n')) + 1 + more);
    };
    CHECK(load_error(many("bodies", most_numbers - 1)) ==
          line(65534) + ": bodies.more65534: found 65537 bodies, expected 65536 at the most");
    CHECK(load_error(many("walls", most_numbers - 1)) ==
          line(65534) + ": walls.more65534: found 65537 walls, expected 65536 at the most");
    // As many as there may be are read: the first of those that say nothing is answered.
    CHECK_THAT(load_error(many("bodies", most_numbers - 2)), StartsWith(line(0) + ": bodies.more0"));
    CHECK_THAT(load_error(many("walls", most_numbers - 2)), StartsWith(line(0) + ": walls.more0"));
}

TEST_CASE("More mirror walls in one place than ghosts can be told apart by are refused", "[checks][hostile]") {
    const auto answer = [](int walls) {
        std::string text = preamble(0.01) + water_box("0.0, 0.0", "0.02, 0.02");  // four particles
        for (int k = 0; k < walls; ++k)
            text += "[walls.w" + std::to_string(k) + "]\nkind = \"mirror\"\npoint = [0.0, 0.0]\nnormal = [0.0, 1.0]\n";
        return error_of([&] { Simulation<2> simulation(load(text)); });
    };
    CHECK(answer(8) == "");
    CHECK(answer(17) ==
          "20: walls: found 17 walls, and so many mirror walls lie near the same particles that these have ghosts by "
          "more "
          "than 65535 ways across them; expected fewer mirror walls within a support, or a wall of kind \"fixed\" in "
          "their place");
}

}  // namespace sluice::test_hostile_scenes
