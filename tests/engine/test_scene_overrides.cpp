// Changes made on the command line, and how a wrong one is answered.
#include "engine/scene/scene.hpp"
#include "tests/catch.hpp"
#include "tests/engine/scene_text.hpp"

namespace sluice::test_scene_overrides {
using namespace scene_text;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

TEST_CASE("the command line changes single values", "[scene][overrides]") {
    const Scene s =
        load(gate, {"method.courant=0.25", "method.fluid.artificial_viscosity=0.1", "method.precision=mixed",
                    "gravity=[0, -1]", "title=dam break", "bodies.gate.spacing=5e-4", "constants.kL=2"});
    CHECK(s.method.courant == 0.25);
    CHECK(s.method.fluid.artificial_viscosity == 0.1);
    CHECK(s.method.precision == Precision::mixed);
    CHECK(s.gravity == Point{0, -1, 0});
    CHECK(s.title == "dam break");
    CHECK(s.bodies[1].spacing == 5e-4);
    CHECK(s.bodies[1].name == "gate");
    CHECK(s.constants.at("kL") == 2);
    CHECK_THAT(s.source, Contains("courant = 0.25") && Contains("title = 'dam break'"));
    // The text that is hashed does not depend on how the file was laid out, and reads back as the same scene.
    CHECK(load(s.source).source == s.source);
    CHECK(load("# a comment\n" + gate).source == load(gate).source);
}

TEST_CASE("mistakes on the command line say so", "[scene][overrides]") {
    const auto set_error = [](const std::string& text) {
        const std::string error = load_error(gate, {text});
        return error.starts_with(" ") ? error.substr(1) : error;  // "file: --set", where others have "file:line:"
    };
    CHECK(set_error("method.spacing=-1") == "--set method.spacing: found -1, expected a number > 0 [m]");
    CHECK_THAT(set_error("method.spacng=1"), StartsWith("--set method.spacng: found an unknown key, expected one of") &&
                                                 Contains("did you mean \"spacing\"?"));
    CHECK(set_error("bodies.gaet.spacing=1") ==
          "--set bodies.gaet.spacing=1: found no \"gaet\" in bodies, expected one of \"gate\", \"water\"; did you mean "
          "\"gate\"?");
    CHECK(set_error("constants.kl=1") ==
          "--set constants.kl=1: found no \"kl\" in constants, expected \"kL\"; did you mean \"kL\"?");
    CHECK(set_error("title.x=1") == "--set title.x=1: found a value at title, expected a table");
    CHECK(set_error("method.spacing") == "--set method.spacing: found no '=', expected key.path=value");
    CHECK(set_error("method..spacing=1") == "--set method..spacing=1: found an empty key, expected key.path=value");
    CHECK(set_error("=1") == "--set =1: found an empty key, expected key.path=value");
    CHECK(set_error("method.=1") == "--set method.=1: found an empty key, expected key.path=value");
    CHECK(set_error("gravity=[0, 1") == "--set gravity=[0, 1: found \"[0, 1\", expected a TOML value or a word");
    CHECK(set_error("method.spacing=") == "--set method.spacing=: found \"\", expected a TOML value or a word");
    CHECK(set_error("title=1\ndimension=3") ==
          "--set title=1\\x0adimension=3: found \"1\\x0adimension=3\", expected a TOML value or a word");
    CHECK(set_error("bodies.gate.shape={box={min=[0,0],max=[0,1]}}") ==
          "--set bodies.gate.shape.box.max: found x = 0, expected more than min's 0");
}

}  // namespace sluice::test_scene_overrides
