// What a scene may say of the truth, and how each mistake is answered.
#include <filesystem>
#include <fstream>

#include "engine/run/output/probes.hpp"
#include "engine/scene/probe_columns.hpp"
#include "engine/scene/read/number_table.hpp"
#include "engine/simulation/simulation.hpp"
#include "engine/study/truth.hpp"
#include "tests/catch.hpp"
#include "tests/engine/scene_text.hpp"
#include "tests/engine/temporary_folder.hpp"

namespace sluice::test_references {
using namespace scene_text;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

/// The gate with a reference at its end, which starts at this line.
constexpr int first_line = 48;

std::string gate_with(const std::string& reference) { return gate + "[reference.tip]\n" + reference; }

const std::string formula = "probe = \"free_end.x\"\nformula = \"0.04*sin(2*pi*t)\"\n";

std::string error_with(const std::string& reference) { return load_error(gate_with(reference)); }

}  // namespace

TEST_CASE("a reference is read in full", "[reference]") {
    const Scene s = load(gate_with(formula + R"(measure = "peak"
from = 0.1
to = 0.3
scale = 0.05
uncertainty = 0.002
source = "somebody 2007"
)"));
    REQUIRE(s.references.size() == 1);
    const Reference& r = s.references[0];
    CHECK(r.name == "tip");
    CHECK(r.column == "free_end.x");
    CHECK(r.measure == Measure::peak);
    CHECK(r.formula == "0.04*sin(2*pi*t)");
    CHECK(r.from == 0.1);
    CHECK(r.to == 0.3);
    CHECK(r.scale == 0.05);
    CHECK(r.uncertainty == 0.002);
    CHECK(r.source == "somebody 2007");
    CHECK(r.is_stated());
}

TEST_CASE("references change neither the run's scene nor its hash", "[reference]") {
    CHECK(load(gate_with(formula)).source == load(gate).source);
}

TEST_CASE("mistakes in a reference are answered with line, key, what was found and expected", "[reference]") {
    const std::string head = std::to_string(first_line) + ": reference.tip";
    const std::string at = std::to_string(first_line + 1) + ": reference.tip.";
    const std::string next = std::to_string(first_line + 2) + ": reference.tip.";
    CHECK_THAT(error_with("formula = \"t\"\n"),
               StartsWith(head + ".probe: found nothing, expected one of \"free_end.x\""));
    CHECK(error_with("probe = \"free_end.z\"\n") ==
          at + "probe: found \"free_end.z\", expected one of \"free_end.x\", \"free_end.y\", \"level.level\", "
               "\"balance.kinetic\", \"balance.potential\", \"balance.compression\", \"balance.elastic\", "
               "\"balance.contact\", \"balance.total\"; did you mean \"free_end.x\"?");
    CHECK_THAT(error_with("probe = \"free_end.x\"\nmeasure = \"peek\"\n"),
               StartsWith(next + "measure: found \"peek\", expected one of \"rms\"") && Contains("mean \"peak\"?"));
    CHECK_THAT(error_with("probe = \"free_end.x\"\nformula = \"sin(x)\"\n"),
               StartsWith(next + "formula: found \"sin(x)\"") && Contains("expected a formula in t, pi"));
    CHECK_THAT(error_with("probe = \"free_end.x\"\nvalue = 3\n"),
               StartsWith(next + "value: found one number for a measure of a whole curve"));
    CHECK_THAT(error_with(formula + "value = 3\n"), Contains("value: found it beside formula, expected one of"));
    CHECK_THAT(error_with(formula + "measure = \"peak\"\nuncertainty = -1\n"),
               Contains("found -1, expected a number >= 0"));
    CHECK_THAT(error_with(formula + "from = 0.2\nto = 0.1\n"),
               Contains("to: found 0.1, expected a time after from = 0.2"));
    CHECK_THAT(error_with(formula + "unsure = 1\n"), Contains("reference.tip.unsure: found an unknown key"));
    CHECK_THAT(error_with("probe = \"free_end.x\"\nmeasure = \"final\"\nvalue = 0\n"), Contains("without a scale"));
}

TEST_CASE("tables are read from beside the scene, the mean of what a row has", "[reference]") {
    const TemporaryFolder folder;
    const auto scene_with = [&](const std::string& table) {
        std::ofstream(folder.path() / "scene.toml") << gate_with("probe = \"free_end.x\"\ntable = " + table + "\n");
        return error_of([&] { load_scene(folder.path() / "scene.toml"); });
    };
    std::ofstream(folder.path() / "ref.csv") << "# measured\nt,a,b,c\n0,1,3,x1\n"
                                             << "0.1,2,,\n0.2,,,5\n";
    CHECK_THAT(scene_with("{file = \"ref.csv\", time = \"t\", values = [\"a\"]}"),
               Contains("ref.csv:3: found \"x1\", expected a number"));
    std::ofstream(folder.path() / "ref.csv") << "# measured\nt,a,b,c\n0,1,3,1\n0.1,2,,\n0.2,,,5\n";
    CHECK(scene_with("{file = \"ref.csv\", time = \"t\", values = [\"a\", \"b\"], factor = 0.001}").empty());
    const Scene s = load_scene(folder.path() / "scene.toml");
    CHECK(s.references[0].time == std::vector<double>{0, 0.1});
    CHECK(s.references[0].value == std::vector<double>{0.002, 0.002});  // (1 + 3)/2 and 2 alone, in thousandths
    CHECK_THAT(scene_with("{file = \"ref.csv\", time = \"t\", values = [\"d\"]}"),
               Contains("values[0]: found \"d\", expected one of \"t\", \"a\", \"b\", \"c\""));
    CHECK_THAT(scene_with("{file = \"rev.csv\", time = \"t\", values = [\"a\"]}"), Contains("rev.csv: cannot be read"));
    CHECK_THAT(scene_with("{file = \"ref.csv\", time = \"c\", values = [\"a\", \"b\"]}"),
               Contains("fewer than two rows"));
}

TEST_CASE("the columns that references may name are those that probes write", "[reference]") {
    const auto check = [](const std::string& file, auto dimension) {
        const Scene scene = load_scene(std::string(SLUICE_TEST_SCENES) + file);
        const Simulation<decltype(dimension)::value> simulation(scene);
        std::vector<std::string> written, named;
        for (const std::string& column : Probes<decltype(dimension)::value>(simulation).columns())
            written.push_back(column.substr(0, column.find(" [")));
        for (const Probe& probe : scene.probes)
            for (const std::string& column : probe_columns(probe, scene.dimension)) named.push_back(column);
        CHECK(written == named);
    };
    check("/small_gate.toml", std::integral_constant<int, 2>());
    check("/small_vortex.toml", std::integral_constant<int, 2>());
    check("/still_water_3d.toml", std::integral_constant<int, 3>());
}

TEST_CASE("the velocity's error is measured against the stated field", "[reference]") {
    const std::string file = SLUICE_TEST_SCENES "/small_vortex.toml";
    const auto error_against = [&](const std::string& u, const std::string& v) {
        const Scene scene = load_scene(file, {"probes.flow.velocity=[\"" + u + "\", \"" + v + "\"]"});
        const Simulation<2> simulation(scene);
        return Probes<2>(simulation).sample(simulation).back();
    };
    // At the start particles have the solution's velocity: rounding alone.
    CHECK(error_against("-cos(k*x)*sin(k*y)", "sin(k*x)*cos(k*y)") < 1e-14);
    // RMS of the field itself: 1/2 of each squared component's mean 1/4; exact on a lattice that the waves fit.
    CHECK(error_against("0", "0") == Approx(std::sqrt(0.5)).epsilon(1e-12));
    // Off by (3, 4) everywhere.
    CHECK(error_against("3-cos(k*x)*sin(k*y)", "4+sin(k*x)*cos(k*y)") == Approx(5).epsilon(1e-12));
    CHECK_THAT(error_of([&] { load_scene(file, {"probes.flow.velocity=[\"x+t+w\", \"0\"]"}); }),
               Contains("expected a formula in x, y, z, t, pi, k, nu"));
}

TEST_CASE("probes without a reference get one whose truth is the finest run", "[reference]") {
    const std::vector<Reference> all = references_of(load(gate_with(formula)));
    std::vector<std::string> names;
    for (const Reference& r : all) names.push_back(r.name);
    CHECK(names == std::vector<std::string>{"tip", "free_end.y", "level.level"});
    CHECK_FALSE(all[1].is_stated());
}

}  // namespace sluice::test_references
