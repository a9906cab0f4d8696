// A run watches itself: what it says of what looks wrong, and what it does when the computation breaks down.
#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/base/errors.hpp"
#include "engine/run/checkpoint/checkpoint_store.hpp"
#include "engine/run/run.hpp"
#include "engine/run/watch/inside_walls.hpp"
#include "engine/run/watch/watch.hpp"
#include "tests/catch.hpp"
#include "tests/engine/physics_scenes.hpp"
#include "tests/engine/temporary_folder.hpp"
#include "tests/engine/test_scenes.hpp"

namespace sluice::test_watch {
namespace {

nlohmann::json summary_of(const std::filesystem::path& folder) {
    return nlohmann::json::parse(text_of(folder / "summary.json"));
}

Warning warning_of(const Watch<2>& watch, const std::string& name) {
    for (const Warning& w : watch.warnings())
        if (w.name == name) return w;
    return {};
}

/// A free block in a swing, at a step beyond its limit: it blows up, and does not at half the step.
const std::string hasty_block = R"toml(
[method]
preset = "modern"
spacing = 0.002
courant = 1.2
[method.solid]
artificial_viscosity = 0.0
[materials.rubber]
kind = "solid"
density = 1100.0
youngs_modulus = 1.2e6
poisson_ratio = 0.4
[bodies.block]
material = "rubber"
shape = { box = { min = [-0.02, -0.01], max = [0.02, 0.01] } }
velocity = ["0.1*sin(300*x)", "0.05*cos(500*y)"]
[probes.energy]
kind = "energy"
[output]
end = 0.05
frame_interval = 0.004
probe_interval = 0.0005
)toml";

std::vector<double> times_in(const std::filesystem::path& folder) {
    std::ifstream table(folder / "probes.csv");
    std::string line;
    std::getline(table, line);
    std::vector<double> times;
    while (std::getline(table, line)) times.push_back(std::stod(line));
    return times;
}

}  // namespace

TEST_CASE("A sound run has no warnings") {
    Simulation<2> s(scene_text::load(gate_in_basin(), {"method.preset=modern"}));
    Watch<2> watch(s);
    for (int n = 0; n < 10; ++n) {
        advance(s, 20);
        watch.look(s);
    }
    CHECK(watch.looks() == 10);
    for (const Warning& w : watch.warnings()) CHECK(w.message == "");
}

TEST_CASE("Rounding at rest is no growth of energy") {
    Simulation<2> s(scene_text::load(preamble(0.005) + rubber_box("1e6, 0.0", "1000000.03, 0.02"),
                                     {"method.preset=modern", "materials.rubber.poisson_ratio=0.3"}));
    Watch<2> watch(s);
    for (int n = 0; n < 4; ++n) advance(s, 50), watch.look(s);
    CHECK(watch.warnings().empty());
}

TEST_CASE("A flow too fast for its sound speed is named once, with the sound speed that it needs") {
    Simulation<2> s(scene_text::load(with_gravity + preamble(0.005) + water_box("0.0, 0.0", "0.05, 0.05") +
                                     "velocity = [4.5, 0.0]\n"));
    Watch<2> watch(s);
    watch.look(s);
    watch.look(s);
    const Warning w = warning_of(watch, "mach");
    CHECK(w.looks == 2);
    CHECK(w.worst == Approx(4.5 / 30));
    CHECK_THAT(w.message, Catch::Contains("of body water, at (") && Catch::Contains("Mach 0.15 > 0.1") &&
                              Catch::Contains("raise materials.water.sound_speed to 45"));
    CHECK(watch.take_news().size() == 1);
    CHECK(watch.take_news().empty());
}

TEST_CASE("A fixed wall is entered behind its first layer, not in its face, also where it has moved to") {
    // A floor of four layers and, on top of its end, a block that moves: faces at y = 0 and x = 0.04 + t.
    const std::string walls = R"toml(
[walls.floor]
kind = "fixed"
shape = { box = { min = [0.0, -0.02], max = [0.06, 0.0] } }
[walls.block]
kind = "fixed"
shape = { box = { min = [0.04, 0.0], max = [0.06, 0.02] } }
motion.displacement = ["t", "0"]
)toml";
    Simulation<2> s(scene_text::load(preamble(0.005) + water_box("0.0, 0.0", "0.03, 0.02") + walls));
    const double d = 0.005;
    const auto inside = [&](double x, double y) { return InsideWalls<2>(s)(Vec<2>{x, y}); };
    CHECK_FALSE(inside(0.02, 0.5 * d));
    CHECK_FALSE(inside(0.02, -0.4 * d));
    CHECK(inside(0.02, -0.8 * d));
    CHECK_FALSE(inside(0.02, -3.8 * d));  // in the face below
    CHECK(inside(0.05, 0));               // between the two
    CHECK(inside(0.04 + 0.8 * d, 0.01));
    advance(s, 20);
    const double moved = s.time();
    REQUIRE(moved > 0);
    CHECK_FALSE(inside(0.04 + moved + 0.55 * d, 0.01));
    CHECK(inside(0.04 + moved + 0.65 * d, 0.01));
    Watch<2> watch(s);
    watch.look(s);
    CHECK(warning_of(watch, "entry").looks == 0);
}

TEST_CASE("Water inside a solid is named") {
    // A block of rubber whose edge has run into the water by half a spacing, as after a step that was too long.
    Simulation<2> s(scene_text::load(preamble(0.002) + water_box("0.0, 0.0", "0.03, 0.02") +
                                         rubber_box("0.03, 0.0", "0.05, 0.02") + "velocity = [-3.0, 0.0]\n",
                                     {"method.preset=modern", "method.courant=0.3"}));
    Watch<2> watch(s);
    watch.look(s);
    CHECK(warning_of(watch, "entry").looks == 0);
    const ClosestPair closest = s.closest_pair(Neighbor::solid, 1.2);
    REQUIRE(closest.count == 10);  // the column beside the block
    CHECK(s.closest_pair(Neighbor::fluid, 0.2).count == 0);
    CHECK(s.closest_pair(Neighbor::wall, 1.2).count == 0);
    CHECK(closest.spacings == Approx(1).epsilon(0.2));  // several are that close
}

TEST_CASE("What breaks a run is told with its cause") {
    const auto message = [](const std::vector<std::string>& overrides) -> std::string {
        try {
            Simulation<2> s(scene_text::load(hasty_block, overrides));
            Watch<2> watch(s);
            for (int n = 0; n < 400; ++n) advance(s, 10), watch.look(s);
        } catch (const NumericalError& error) {
            return error.what();
        }
        return "";
    };
    CHECK_THAT(message({}), Catch::Contains("at a courant of 1.2: lower method.courant"));
    CHECK_THAT(message({"method.courant=0.5", "method.time_step=1e-3"}), Catch::Contains("lower method.time_step"));
    CHECK_THAT(message({"method.courant=0.9", "bodies.block.velocity=[\"9e3*x\", \"0\"]"}),
               Catch::Contains("four spacings and more are safe"));
}

TEST_CASE("A run that breaks down goes back and on with shorter steps, if it may") {
    const Scene scene = scene_text::load(hasty_block, {"watch.policy=retry"});
    const TemporaryFolder folder;
    const RunStatus status = run(scene, {folder.path(), 1, {}, {}});
    REQUIRE(status.state == RunState::done);
    const auto watch = summary_of(folder.path())["watch"];
    CHECK(watch["retries"].get<int>() > 0);
    CHECK(watch["retried"].size() == watch["retries"].get<std::size_t>());
    CHECK_THAT(watch["retried"][0]["message"].get<std::string>(), Catch::Contains("body block"));
    // No row twice, none missing.
    const std::vector<double> times = times_in(folder.path());
    REQUIRE(times.size() == 101);
    for (std::size_t k = 0; k < times.size(); ++k)
        CHECK(times[k] == Approx(0.0005 * static_cast<double>(k)).margin(1e-4));
    std::size_t frames = 0;
    for (const auto& file : std::filesystem::directory_iterator(folder.path() / "frames"))
        frames += file.path().extension() == ".hdf";
    CHECK(frames == 14);  // thirteen that are due, and the last state
}

TEST_CASE("A run that breaks down leaves its last good state, from which a better step goes on") {
    const Scene scene = scene_text::load(hasty_block);
    const TemporaryFolder folder;
    REQUIRE(run(scene, {folder.path(), 1, {}, {}}).state == RunState::failed);
    const auto kept = checkpoints_in(folder.path());
    REQUIRE(kept.size() == 1);
    CHECK(checkpoint_problem(kept[0]) == "");
    CHECK(read_label(kept[0]).step % 1000 == 0);
}

TEST_CASE("A run that may go on goes on, as long as numbers are finite") {
    const Scene scene = load_scene(test_scene("breakdown.toml"), {"watch.policy=warn", "output.end=5"});
    const TemporaryFolder folder;
    const RunStatus status = run(scene, {folder.path(), 1, {}, {}});
    CHECK(status.state == RunState::done);
    CHECK(summary_of(folder.path())["watch"]["policy"] == "warn");
}

}  // namespace sluice::test_watch
