// Formulas of a scene: what they know, and how a wrong one is answered.
#include <cmath>

#include "engine/scene/formula.hpp"
#include "tests/catch.hpp"
#include "tests/engine/scene_text.hpp"

namespace sluice::test_formula {
using namespace scene_text;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

TEST_CASE("formulas", "[scene][formula]") {
    const Scene s = load(gate);
    const CompiledFormula v(s, "bodies.water.velocity[1]", s.bodies[0].velocity[1]);
    CHECK(v({0.25, 0, 0}) == Approx(0.01 * std::sin(3.14159265358979 * 0.25 * 1.875)).epsilon(1e-12));
    CHECK(CompiledFormula(s, "k", "")({1, 2, 3}) == 0);
    CHECK(CompiledFormula(s, "k", "x + 10*y + 100*z")({1, 2, 3}) == 321);
    CHECK(CompiledFormula(s, "k", "x > 0.5 ? kL : 0")({1, 2, 3}) == 1.875);
    CHECK_THROWS_WITH(
        CompiledFormula(s, "bodies.water.velocity[1]", "1/x")({0, 2, 0}),
        Contains(".toml:23: bodies.water.velocity[1]: found \"1/x\": inf at (0, 2, 0), expected a formula"));
    const auto formula_error = [](const std::string& text) { return gate_error("0.01*sin(pi*x*kL)", text); };
    CHECK_THAT(formula_error("0.01*sin(w)"), StartsWith("23: bodies.water.velocity[1]: found \"0.01*sin(w)\": ") &&
                                                 Contains("\"w\"") &&
                                                 Contains("expected a formula in x, y, z, pi, kL"));
    CHECK_THAT(formula_error("sin(x"), StartsWith("23: bodies.water.velocity[1]: found \"sin(x\": "));
    CHECK_THAT(formula_error("1, 2"), Contains("found \"1, 2\": 2 values"));
    CHECK_THAT(formula_error("x = 3"), Contains("an assignment"));
    CHECK(gate_error("[\"0\", \"0.01*sin(pi*x*kL)\"]", "[0.5, -1]") == "");
    CHECK(gate_error("[\"0\", \"0.01*sin(pi*x*kL)\"]", "[0.5]") ==
          "23: bodies.water.velocity: found [0.5], expected an array of 2 numbers or formulas");
    CHECK(gate_error("[\"0\", \"0.01*sin(pi*x*kL)\"]", "[0.5, true]") ==
          "23: bodies.water.velocity[1]: found true, expected a text in quotes");
}

TEST_CASE("constants have names of their own", "[scene][formula]") {
    CHECK(gate_error("kL = 1.875", "x = 1.875") ==
          "4: constants.x: found a name that formulas have already, expected a new name for the constant");
    CHECK_THAT(gate_error("kL = 1.875", "sin = 1.875"), StartsWith("4: constants.sin: found the name of a function"));
    CHECK_THAT(gate_error("kL = 1.875", "k-L = 1.875"),
               StartsWith("4: constants.k-L: found a name that is not made of"));
    CHECK(gate_error("kL = 1.875", "kL = \"a\"") == "4: constants.kL: found \"a\", expected a number");
}

}  // namespace sluice::test_formula
