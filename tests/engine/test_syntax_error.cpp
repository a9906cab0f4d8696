// What is said of a text that is not TOML; tests/engine/wrong_edits has more, as users meet them.
#include "engine/scene/read/syntax_error.hpp"

#include "tests/catch.hpp"
#include "tests/engine/scene_text.hpp"

namespace sluice::test_syntax_error {
using scene_text::load_error;

TEST_CASE("brackets that are not closed are found where they open", "[syntax]") {
    CHECK(load_error("a = [[1, 2], [3, 4]\nb = 1\n") ==
          "1:5: found a [ that is not closed, expected a ] behind its last value");
    CHECK(load_error("a = [1, 2\n\n[method]\n") ==
          "1:5: found a [ that is not closed, expected a ] behind its last value");
    CHECK(load_error("a = {x = [1, 2, y = 3}\n") ==
          "1:10: found a [ that is not closed, expected a ] before the next key");
    CHECK(load_error("a = {x = 1\n") == "1:5: found a { that is not closed, expected a } in the same line");
    CHECK(load_error("[method\nspacing = 1\n") ==
          "1:1: found a [ that is not closed, expected a ] before the next key");
    // Those in texts and comments do not count.
    CHECK(load_error("a = \"[\"  # {\nb = 0,1\n") == "2:6: found 0,1, expected a point: 0.1");
}

TEST_CASE("values that are no TOML are shown as they should be", "[syntax]") {
    CHECK(load_error("a = 0,01\n") == "1:6: found 0,01, expected a point: 0.01");
    CHECK(load_error("a = .5\n") == "1:5: found .5, expected digits on both sides of the point: 0.5");
    CHECK(load_error("a = 5.\n") == "1:7: found 5., expected digits on both sides of the point: 5.0");
    CHECK(load_error("a = 1.e-3\n") == "1:7: found 1.e-3, expected digits on both sides of the point: 1.0e-3");
    CHECK(load_error("a = 1/100\n") == "1:6: found 1/100, expected a number; only formulas, in quotes, are computed");
    CHECK(load_error("a = 5 mm\n") == "1:7: found mm behind a number, expected the number alone, in SI units");
    CHECK(load_error("a = fluid\n") == "1:6: found fluid without quotes, expected \"fluid\"");
    CHECK(load_error("a = \"fluid\nb = 1\n") ==
          "1:11: found a text without its closing quote, expected it in the same line");
    CHECK(load_error("a: 5\n") == "1:2: found a colon, expected key = value");
}

TEST_CASE("what is there twice is shown with its first place", "[syntax]") {
    CHECK(load_error("a = 1\n\na = 2\n") == "3:5: found a second a, expected one; the first is in line 1");
    CHECK(load_error("[method]\n[output]\n[method]\n") ==
          "3:1: found a second [method], expected one; the first is in line 1");
}

TEST_CASE("where nothing better is known the parser is quoted", "[syntax]") {
    CHECK(explain_syntax_error("x 5\n", {1, 3}, "expected '='") == "1:3: expected '='");
    CHECK(explain_syntax_error("", {1, 1}, "nothing") == "1:1: nothing");
    CHECK(explain_syntax_error("a = 1", {9, 99}, "far away") == "9:99: far away");
}

}  // namespace sluice::test_syntax_error
