// What a scene file may say, and how each mistake is answered: line, key, what was found, what was expected.
#include "engine/scene/scene.hpp"
#include "engine/scene/table/suggestion.hpp"
#include "tests/catch.hpp"
#include "tests/engine/scene_text.hpp"

namespace sluice::test_scene_reader {
using namespace scene_text;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

TEST_CASE("a scene is read in full", "[scene]") {
    const Scene s = load(gate);
    CHECK(s.title == "elastic gate");
    CHECK(s.dimension == 2);
    CHECK(s.gravity == Point{0, -9.81, 0});
    CHECK(s.constants.at("kL") == 1.875);
    REQUIRE(s.materials.size() == 2);
    CHECK(s.materials[0].name == "water");
    CHECK(s.materials[0].sound_speed == 30);
    // K = E / (3 (1 - 2ν)), μ = E / (2 (1 + ν))
    CHECK(s.materials[1].bulk_modulus() == Approx(2e7).epsilon(1e-14));
    CHECK(s.materials[1].shear_modulus == Approx(1.2e7 / 2.8).epsilon(1e-14));
    REQUIRE(s.bodies.size() == 2);
    CHECK(s.bodies[0].name == "water");
    CHECK(s.bodies[0].spacing == 2e-3);
    CHECK(s.bodies[0].hydrostatic_surface == 0.14);
    CHECK(s.bodies[0].velocity[0] == "0");
    CHECK_FALSE(s.bodies[0].clamp);
    CHECK(s.bodies[1].material == 1);
    CHECK(s.bodies[1].spacing == 1e-3);
    CHECK(s.bodies[1].clamp->contains({0.001, 0.076, 0}));
    REQUIRE(s.walls.size() == 2);
    CHECK(s.walls[0].normal == Point{0, 1, 0});
    CHECK(s.walls[1].kind == WallKind::fixed);
    CHECK(s.walls[1].spacing == 0.002);
    REQUIRE(s.probes.size() == 3);
    CHECK(s.probes[0].body == 1u);
    CHECK(s.probes[0].at == Point{0.0025, 0, 0});
    CHECK(s.probes[1].at == Point{-0.05, 0, 0});
    CHECK(s.probes[2].kind == ProbeKind::energy);
    CHECK(s.output.end == 0.4);
    CHECK(s.output.probe_interval == 0);
    CHECK(s.output.checkpoint_interval == 0);
    CHECK(s.output.checkpoint_minutes == 10);
    CHECK(s.output.has_checkpoints());
    CHECK_FALSE(load(gate + "checkpoint_minutes = 0\n").output.has_checkpoints());
    CHECK_THAT(load_error(gate + "checkpoint_interval = -1\n"), Contains("expected a number >= 0"));
}

TEST_CASE("method constants default to the preset's", "[scene]") {
    const Scene s = load(with(gate, "[output]", "[method.solid]\nartificial_stress_exponent = 3\n[output]"));
    CHECK(s.method.courant == 0.5);
    CHECK(s.method.smoothing_length == 1.5);
    CHECK(s.method.precision == Precision::full);
    CHECK(s.method.fluid.velocity_filter == 0.92);
    CHECK(s.method.fluid.artificial_viscosity == 0);
    CHECK(s.method.solid.velocity_filter == 1);
    CHECK(s.method.solid.artificial_viscosity == 1);
    CHECK(s.method.solid.artificial_stress == 0.3);
    CHECK(s.method.solid.artificial_stress_exponent == 3);
    CHECK_FALSE(s.method.time_step);
}

TEST_CASE("lines of keys are kept", "[scene]") {
    const Scene s = load(gate, {"method.courant=0.8"});
    CHECK(s.lines.at("bodies.gate.shape") == 26);
    CHECK(s.lines.at("bodies.water.velocity[1]") == 23);
    CHECK(s.lines.at("probes.level") == 40);
    CHECK(s.lines.at("method.courant") == 0);
    CHECK_FALSE(s.lines.contains("bodies.gate.spacing"));
    CHECK_THROWS_WITH(s.fail("bodies.gate.spacing", "x"), Contains(".toml:24: bodies.gate.spacing: x"));
    CHECK_THROWS_WITH(s.fail("method.courant", "x"), Contains(".toml: --set method.courant: x"));
    CHECK_THROWS_WITH(s.fail("nowhere.at", "x"), Contains(".toml:1: nowhere.at: x"));
}

TEST_CASE("bodies keep the order of the file", "[scene]") {
    const Scene s = load(with(gate, "[bodies.gate]",
                              "[bodies.a]\nmaterial = \"rubber\"\nshape = { circle = { centre = [9, "
                              "9], radius = 1 } }\n[bodies.gate]"));
    REQUIRE(s.bodies.size() == 3);
    CHECK(s.bodies[1].name == "a");
    CHECK(s.bodies[2].name == "gate");
}

TEST_CASE("three dimensions", "[scene]") {
    const Scene s = load(R"(dimension = 3
gravity = [0, 0, -9.81]
method = { spacing = 0.1 }
materials.water = { kind = "fluid", density = 1000, sound_speed = 30 }
bodies.water = { material = "water", shape = { box = { min = [0, 0, 0], max = [1, 1, 1] } }, velocity = [0, 0, "-z"] }
probes.level = { kind = "water_level", at = [0.5, 0.25] }
output = { end = 1 }
)");
    CHECK(s.bodies[0].velocity[2] == "-z");
    CHECK(s.bodies[0].shape->contains({1, 1, 1}));
    CHECK(s.probes[0].at == Point{0.5, 0, 0.25});
}

TEST_CASE("files that are no scene", "[scene]") {
    CHECK_THROWS_WITH(load_scene("/tmp/no-such-scene.toml"),
                      "/tmp/no-such-scene.toml: cannot be read: No such file or directory");
    CHECK_THROWS_WITH(load_scene("/tmp"), "/tmp: found a folder, expected a scene file");
    CHECK_THAT(load_error("title = \"a\"\ngravity = [0, -9.81\n[method]\n"),
               StartsWith("2:11: found a [ that is not closed"));
    CHECK_THAT(load_error("title = \n"), StartsWith("1:9: "));
    CHECK_THAT(load_error("a = 1\na = 2\n"), StartsWith("2:"));
    CHECK_THAT(load_error(""), StartsWith("1: method: found nothing, expected a table: how the scene is computed"));
    CHECK_THROWS_AS(load("title = "), SceneError);
    const File file(with(gate, "courant = 0.5", "courant = -1"));
    CHECK_THROWS_WITH(load_scene(file.path()),
                      file.path() + ":8: method.courant: found -1, expected a number in (0, 2]");
}

TEST_CASE("unknown keys are answered with the nearest valid one", "[scene]") {
    CHECK_THAT(gate_error("courant = 0.5", "courrant = 0.5"),
               StartsWith("8: method.courrant: found an unknown key, expected one of \"preset\", \"spacing\"") &&
                   Contains("did you mean \"courant\"?"));
    CHECK(gate_error("spacing = 1e-3", "spacng = 1e-3") ==
          "7: method.spacng: found an unknown key, expected \"spacing\"; did you mean \"spacing\"?");
    CHECK_THAT(gate_error("[walls.bottom]", "[wals.bottom]"),
               StartsWith("28: wals: found an unknown key") && Contains("did you mean \"walls\"?"));
    CHECK(gate_error("max = [0.0, 0.14]", "mx = [0.0, 0.14]") ==
          "20: bodies.water.shape.box.mx: found an unknown key, expected \"max\"; did you mean \"max\"?");
    const std::string far = gate_error("courant = 0.5", "colour = 0.5");
    CHECK_THAT(far, StartsWith("8: method.colour: found an unknown key, expected one of"));
    CHECK_THAT(far, !Contains("did you mean"));
    CHECK_THAT(gate_error("sound_speed = 30", "sound_speed = 30\nyoungs_modulus = 1"),
               StartsWith("13: materials.water.youngs_modulus: found a key of materials whose kind is \"solid\""));
}

TEST_CASE("missing keys are answered with the table's line", "[scene]") {
    CHECK(
        gate_error("spacing = 1e-3\n", "") ==
        "5: method.spacing: found nothing, expected a number > 0 [m]: initial distance of particles; halved, a 2D run "
        "takes about 8 times as long, a 3D run 16 times");
    CHECK(gate_error("end = 0.4\n", "") ==
          "45: output.end: found nothing, expected a number > 0 [s]: simulated time to run to");
    CHECK(
        gate_error("sound_speed = 30\n", "") ==
        "9: materials.water.sound_speed: found nothing, expected a number > 0 [m/s]: ten times the fastest flow keeps "
        "densities within 1 %; more only costs time");
    CHECK(gate_error("material = \"rubber\"\n", "") ==
          "24: bodies.gate.material: found nothing, expected one of \"water\", \"rubber\": a name from [materials]");
    CHECK(gate_error("body = \"gate\"\n", "") ==
          "36: probes.free_end.body: found nothing, expected one of \"water\", \"gate\": a name from [bodies]; a "
          "pressure without it is measured in the fluid");
    CHECK(gate_error(", max = [0.0, 0.14]", "") ==
          "20: bodies.water.shape.box.max: found nothing, expected 2 numbers [x, y]: its highest corner");
}

TEST_CASE("values of the wrong type or out of range", "[scene]") {
    CHECK(gate_error("courant = 0.5", "courant = 2.5") == "8: method.courant: found 2.5, expected a number in (0, 2]");
    CHECK(gate_error("courant = 0.5", "courant = \"x\"") ==
          "8: method.courant: found \"x\", expected a number in (0, 2]");
    CHECK(gate_error("courant = 0.5", "courant = true") ==
          "8: method.courant: found true, expected a number in (0, 2]");
    CHECK(gate_error("courant = 0.5", "courant = nan") == "8: method.courant: found nan, expected a finite number");
    CHECK(gate_error("courant = 0.5", "courant = {}") ==
          "8: method.courant: found a table, expected a number in (0, 2]");
    CHECK(gate_error("courant = 0.5", "smoothing_length = 0.9") ==
          "8: method.smoothing_length: found 0.9, expected a number in [1, 3]");
    CHECK(gate_error("courant = 0.5", "fluid = { velocity_filter = 0 }") ==
          "8: method.fluid.velocity_filter: found 0, expected a number in (0, 1]");
    CHECK(gate_error("courant = 0.5", "solid = { artificial_stress_exponent = 9 }") ==
          "8: method.solid.artificial_stress_exponent: found 9, expected a whole number from 1 to 8");
    CHECK(gate_error("courant = 0.5", "solid = { artificial_stress = -1.0 }") ==
          "8: method.solid.artificial_stress: found -1, expected a number >= 0");
    CHECK(gate_error("courant = 0.5", "time_step = 0") == "8: method.time_step: found 0, expected a number > 0 [s]");
    CHECK(gate_error("courant = 0.5", "mach_limit = 0") == "8: method.mach_limit: found 0, expected a number > 0");
    CHECK(gate_error("courant = 0.5", "solid = 3") == "8: method.solid: found 3, expected a table");
    CHECK(gate_error("title = \"elastic gate\"", "title = 1979-05-27") ==
          "1: title: found a date or time, expected a text in quotes");
    CHECK(gate_error("title = \"elastic gate\"", "dimension = 4") ==
          "1: dimension: found 4, expected a whole number from 2 to 3");
    CHECK(gate_error("gravity = [0.0, -9.81]", "gravity = [0.0, 0.0, -9.81]") ==
          "2: gravity: found [0, 0, -9.81], expected 2 numbers [x, y], or dimension = 3 at the top of the file");
    CHECK(gate_error("gravity = [0.0, -9.81]", "gravity = [0.0, \"down\"]") ==
          "2: gravity[1]: found \"down\", expected a number");
    CHECK(gate_error("gravity = [0.0, -9.81]", "gravity = -9.81") ==
          "2: gravity: found -9.81, expected 2 numbers [x, y]");
    CHECK(gate_error("end = 0.4", "end = 0") == "46: output.end: found 0, expected a number > 0 [s]");
    CHECK(gate_error("frame_interval = 0.01", "frame_interval = -0.01") ==
          "47: output.frame_interval: found -0.01, expected a number >= 0 [s]");
}

TEST_CASE("choices and names suggest the nearest", "[scene]") {
    CHECK(gate_error("material = \"rubber\"", "material = \"ruber\"") ==
          "25: bodies.gate.material: found \"ruber\", expected one of \"water\", \"rubber\"; did you mean \"rubber\"?");
    CHECK(gate_error("body = \"gate\"", "body = \"gaet\"") ==
          "38: probes.free_end.body: found \"gaet\", expected one of \"water\", \"gate\"; did you mean \"gate\"?");
    CHECK(gate_error("kind = \"mirror\"", "kind = \"miror\"") ==
          "29: walls.bottom.kind: found \"miror\", expected one of \"mirror\", \"fixed\"; did you mean \"mirror\"?");
    CHECK(gate_error("preset = \"paper\"", "preset = \"new\"") ==
          "6: method.preset: found \"new\", expected one of \"paper\", \"modern\"");
    CHECK(gate_error("courant = 0.5", "time_stepping = \"multi\"") ==
          "8: method.time_stepping: found \"multi\", expected one of \"single-rate\", \"multi-rate\"");
    CHECK(gate_error("courant = 0.5", "precision = \"single\"") ==
          "8: method.precision: found \"single\", expected one of \"double\", \"mixed\"");
    CHECK_THAT(gate_error("kind = \"energy\"", "kind = \"enregy\""),
               StartsWith("44: probes.balance.kind: found \"enregy\"") && Contains("did you mean \"energy\"?"));
    CHECK(gate_error("[bodies.gate]", "[bodies.\"the gate\"]") ==
          "24: bodies.the gate: found the name \"the gate\", expected letters, digits, _ and -");
    CHECK(gate_error("[probes.level]", "[probes.\"a/b\"]") ==
          "40: probes.a/b: found the name \"a/b\", expected letters, digits, _ and -");
}

TEST_CASE("materials", "[scene]") {
    CHECK(gate_error("density = 1000.0", "density = -1000.0") ==
          "11: materials.water.density: found -1000, expected a number > 0 [kg/m³]");
    CHECK(gate_error("poisson_ratio = 0.4", "poisson_ratio = 0.5") ==
          "17: materials.rubber.poisson_ratio: found 0.5, expected a number in (-1, 0.5)");
    CHECK(gate_error("poisson_ratio = 0.4\n", "") ==
          "13: materials.rubber.poisson_ratio: found nothing, expected a number in (-1, 0.5): rubber 0.4 to 0.49, "
          "steel 0.3");
    CHECK(gate_error("poisson_ratio = 0.4", "bulk_modulus = 2e7") ==
          "17: materials.rubber.bulk_modulus: found it beside youngs_modulus, expected either youngs_modulus and "
          "poisson_ratio, or bulk_modulus and shear_modulus");
    CHECK_THAT(gate_error("youngs_modulus = 1.2e7\npoisson_ratio = 0.4\n", ""),
               StartsWith("13: materials.rubber: found no elastic constants, expected either youngs_modulus"));
    CHECK_THAT(gate_error("youngs_modulus", "young_modulus"),
               StartsWith("16: materials.rubber.young_modulus: found an unknown key") &&
                   Contains("did you mean \"youngs_modulus\"?"));
    const Scene s = load(
        with(with(gate, "youngs_modulus = 1.2e7", "bulk_modulus = 2e7"), "poisson_ratio = 0.4", "shear_modulus = 4e6"));
    CHECK(s.materials[1].bulk_modulus() == Approx(2e7).epsilon(1e-14));
    CHECK(s.materials[1].shear_modulus == 4e6);
}

TEST_CASE("bodies, walls and probes refuse what does not fit them", "[scene]") {
    CHECK(gate_error("spacing_ratio = 2.0", "spacing_ratio = 2.0\nspacing = 1e-3") ==
          "21: bodies.water.spacing_ratio: found it beside spacing, expected one of the two");
    CHECK(gate_error("spacing_ratio = 2.0", "spacing = 0") ==
          "21: bodies.water.spacing: found 0, expected a number > 0 [m]");
    CHECK(gate_error("spacing_ratio = 2.0", "clamp = { circle = { centre = [0, 0], radius = 1 } }") ==
          "21: bodies.water.clamp: found a clamp on a fluid, expected it for solids only");
    CHECK(gate_error("clamp = { box = { min = [0.0, 0.075], max = [0.005, 0.08] } }", "hydrostatic_surface = 1") ==
          "27: bodies.gate.hydrostatic_surface: found a free surface of a solid, expected it for fluids only");
    CHECK(gate_error("gravity = [0.0, -9.81]", "") ==
          "22: bodies.water.hydrostatic_surface: found a free surface without gravity, expected gravity in the scene");
    CHECK(gate_error("normal = [0.0, 2.0]", "normal = [0.0, 0.0]") ==
          "31: walls.bottom.normal: found a vector of length 0, expected a direction into the fluid");
    CHECK(gate_error("body = \"gate\"", "body = \"water\"") ==
          "38: probes.free_end.body: found \"water\", a fluid, expected a solid body");
    CHECK(gate_error("kind = \"energy\"", "kind = \"force\"\nbody = \"water\"") ==
          "45: probes.balance.body: found \"water\", a fluid, expected a solid body");
    CHECK(gate_error("at = -0.05", "at = [-0.05, 0.0]") ==
          "42: probes.level.at: found [-0.05, 0], expected a number x");
    CHECK_THAT(
        gate_error("kind = \"energy\"", "kind = \"energy\"\nat = 3"),
        StartsWith("45: probes.balance.at: found a key of probes whose kind is \"displacement\" or \"pressure\""));
    const std::string head = "method.spacing = 1\nmaterials.w = { kind = \"fluid\", density = 1, sound_speed = 1 }\n";
    CHECK(load_error(head) == "1: bodies: found nothing, expected a table of one body or more");
    CHECK(load_error(head + "[bodies]\n") == "3: bodies: found no body, expected one or more");
}

TEST_CASE("shapes", "[scene]") {
    const auto shape_error = [](const std::string& shape) {
        return gate_error("{ box = { min = [0.0, 0.0], max = [0.005, 0.08] } }", shape);
    };
    CHECK(shape_error("{ polygon = [[0, 0], [0.01, 0], [0, 0.01]] }") == "");
    CHECK(shape_error(
              "{ difference = [{ box = { min = [0, 0], max = [1, 1] } }, { union = [{ circle = { centre = [0, 0], "
              "radius = 0.5 } }] }] }") == "");
    CHECK(shape_error("3") ==
          "26: bodies.gate.shape: found 3, expected a table with one of box, circle, polygon, union, difference");
    CHECK(shape_error("{}") ==
          "26: bodies.gate.shape: found an empty table, expected one of box, circle, polygon, union, difference");
    CHECK_THAT(shape_error("{ bx = { min = [0, 0], max = [1, 1] } }"),
               StartsWith("26: bodies.gate.shape.bx: found an unknown key") && Contains("did you mean \"box\"?"));
    CHECK_THAT(shape_error("{ box = { min = [0, 0], max = [1, 1] }, circle = { centre = [0, 0], radius = 1 } }"),
               StartsWith("26: bodies.gate.shape.circle: found a second shape"));
    CHECK(shape_error("{ box = { min = [0, 1], max = [1, 1] } }") ==
          "26: bodies.gate.shape.box.max: found y = 1, expected more than min's 1");
    CHECK(shape_error("{ circle = { centre = [0, 0], radius = 0 } }") ==
          "26: bodies.gate.shape.circle.radius: found 0, expected a number > 0 [m]");
    CHECK(shape_error("{ polygon = [[0, 0], [1, 0]] }") ==
          "26: bodies.gate.shape.polygon: found a polygon of 2 vertices, expected 3 or more");
    CHECK_THAT(shape_error("{ polygon = [[0, 0], [1, 1], [1, 0], [0, 1]] }"),
               StartsWith("26: bodies.gate.shape.polygon: found edges that meet (from vertex 0 and from vertex 2"));
    CHECK(shape_error("{ polygon = [[0, 0], [1, 1], [2, 2]] }") ==
          "26: bodies.gate.shape.polygon: found a polygon without area, expected vertices not on one line");
    CHECK(shape_error("{ union = [] }") == "26: bodies.gate.shape.union: found no shape, expected one or more");
    CHECK(shape_error("{ difference = [{ circle = { centre = [0, 0], radius = 1 } }] }") ==
          "26: bodies.gate.shape.difference: found 1 shapes, expected two or more: the first and what is cut from it");
    CHECK(shape_error("{ union = [{ circle = { centre = [0, 0], radius = \"a\" } }] }") ==
          "26: bodies.gate.shape.union[0].circle.radius: found \"a\", expected a number > 0 [m]");
    // What only three dimensions have.
    CHECK(shape_error("{ sphere = { centre = [0, 0], radius = 1 } }") ==
          "26: bodies.gate.shape.sphere: found a sphere in a 2D scene, expected circle");
    CHECK(shape_error("{ cylinder = {} }") ==
          "26: bodies.gate.shape.cylinder: found a cylinder in a 2D scene, expected circle, or box for one seen from "
          "its side");
    CHECK(shape_error("{ union = [{ extrusion = {} }] }") ==
          "26: bodies.gate.shape.union[0].extrusion: found an extrusion in a 2D scene, expected polygon");
}

TEST_CASE("shapes in three dimensions", "[scene]") {
    const auto scene = [](const std::string& shape) {
        return "dimension = 3\nmethod.spacing = 1\noutput.end = 1\n"
               "materials.w = { kind = \"fluid\", density = 1, sound_speed = 1 }\n"
               "bodies.w = { material = \"w\", shape = " +
               shape + " }\n";
    };
    const auto error = [&](const std::string& shape) { return load_error(scene(shape)); };
    CHECK(error("{ polygon = [] }") ==
          "5: bodies.w.shape.polygon: found a polygon in a 3D scene, expected extrusion = {polygon = [[x, y], ...], "
          "axis = \"z\", from = z0, to = z1}");
    CHECK(error("{ circle = { centre = [0, 0, 0], radius = 1 } }") ==
          "5: bodies.w.shape.circle: found a circle in a 3D scene, expected sphere");
    CHECK(error("{}") ==
          "5: bodies.w.shape: found an empty table, expected one of box, sphere, cylinder, extrusion, union, "
          "difference");
    CHECK_THAT(error("{ cilinder = {} }"), StartsWith("5: bodies.w.shape.cilinder: found an unknown key") &&
                                               Contains("did you mean \"cylinder\"?"));
    CHECK(error("{ sphere = { centre = [0, 0], radius = 1 } }") ==
          "5: bodies.w.shape.sphere.centre: found [0, 0], expected 3 numbers [x, y, z]");
    CHECK(error("{ cylinder = { from = [0, 0, 0], to = [0, 0, 0], radius = 1 } }") ==
          "5: bodies.w.shape.cylinder.to: found the same point as from's, expected the centre of the other end");
    CHECK(error("{ cylinder = { from = [0, 0, 0], to = [0, 0, 1], radius = -1 } }") ==
          "5: bodies.w.shape.cylinder.radius: found -1, expected a number > 0 [m]");
    const std::string triangle =
        "{ extrusion = { polygon = [[0, 0], [1, 0], [0, 1]], axis = \"y\", from = 2, to = 3 } }";
    const auto extrusion_error = [&](const std::string& from, const std::string& to) {
        return error(with(triangle, from, to));
    };
    CHECK(extrusion_error("to = 3", "to = 2") ==
          "5: bodies.w.shape.extrusion.to: found 2, expected more than from's 2");
    CHECK(extrusion_error("\"y\"", "\"up\"") ==
          "5: bodies.w.shape.extrusion.axis: found \"up\", expected one of \"x\", \"y\", \"z\"");
    CHECK(extrusion_error("[1, 0]", "[1, 0, 0]") ==
          "5: bodies.w.shape.extrusion.polygon[1]: found [1, 0, 0], expected 2 numbers [x, z]");
    CHECK(extrusion_error("[0, 1]]", "[2, 0]]") ==
          "5: bodies.w.shape.extrusion.polygon: found a polygon without area, expected vertices not on one line");
    CHECK(error("{ cylinder = { from = [0, 0, 0], to = [0, 0, 1], radius = 1 } }") == "");
    // Along y the vertices are [x, z].
    const ShapePtr prism = load(scene(triangle)).bodies[0].shape;
    CHECK(prism->contains({0.7, 2.5, 0.2}));
    CHECK_FALSE(prism->contains({0.7, 2.5, 0.4}));
    CHECK(prism->bounds().min == Point{0, 2, 0});
    CHECK(prism->bounds().max == Point{1, 3, 1});
}

TEST_CASE("edit distance", "[scene]") {
    CHECK(edit_distance("", "abc") == 3);
    CHECK(edit_distance("gate", "gaet") == 1);
    CHECK(edit_distance("kitten", "sitting") == 3);
    CHECK(nearest("spacing_ratoi", {"spacing", "spacing_ratio"}) == "spacing_ratio");
    CHECK(nearest("min", {"max"}).empty());
    CHECK(nearest("density", {"shape", "kind"}).empty());
}

}  // namespace sluice::test_scene_reader
