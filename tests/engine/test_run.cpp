#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/run/run.hpp"
#include "tests/catch.hpp"
#include "tests/engine/temporary_folder.hpp"
#include "tests/engine/test_scenes.hpp"

namespace sluice::test_run {
namespace {

nlohmann::json summary_of(const std::filesystem::path& folder) {
    return nlohmann::json::parse(text_of(folder / "summary.json"));
}

/// The times in the first column of probes.csv.
std::vector<double> probe_times(const std::filesystem::path& folder) {
    std::istringstream text(text_of(folder / "probes.csv"));
    std::string line;
    std::getline(text, line);
    std::vector<double> times;
    while (std::getline(text, line)) times.push_back(std::stod(line));
    return times;
}

}  // namespace

TEST_CASE("A run leaves scene, probes, frames and summary") {
    const TemporaryFolder folder;
    const Scene scene = load_scene(test_scene("small_gate.toml"));
    const RunStatus status = run(scene, {folder.path(), 1, {}});
    REQUIRE(status.state == RunState::done);
    REQUIRE(status.report.find("particle-steps/s") != std::string::npos);
    REQUIRE(load_scene(folder.path() / "scene.toml").source == scene.source);

    const auto summary = summary_of(folder.path());
    REQUIRE(summary["status"] == "done");
    REQUIRE(summary["scene_hash"].get<std::string>().size() == 16);
    REQUIRE(summary["particles"]["fluid"] == 20 * 24);
    REQUIRE(summary["particles"]["solid"] == 4 * 20);
    REQUIRE(summary["effects"].size() == effect_count);
    REQUIRE(summary["probes"].contains("tip.x [m]"));
    const double dt = summary["dt"];
    REQUIRE(summary["simulated_time"].get<double>() == Approx(0.002).margin(dt / 2));

    const std::vector<double> times = probe_times(folder.path());
    REQUIRE(times.size() == 5);
    for (std::size_t k = 0; k < times.size(); ++k)
        REQUIRE(times[k] == Approx(0.0005 * static_cast<double>(k)).margin(dt / 2));

    const auto series = nlohmann::json::parse(text_of(folder.path() / "frames" / "frames.hdf.series"));
    REQUIRE(series["files"].size() == 3);
    for (const auto& frame : series["files"])
        REQUIRE(std::filesystem::exists(folder.path() / "frames" / frame["name"].get<std::string>()));
}

TEST_CASE("Results do not depend on the number of threads") {
    // The gate is refined so that fluid, solid and interface are all large enough to be shared out among threads.
    const std::vector<std::pair<std::string, std::vector<std::string>>> scenes{
        {"small_gate.toml", {"method.spacing=0.00035"}}, {"still_water_3d.toml", {}}};
    for (const auto& [name, overrides] : scenes) {
        const TemporaryFolder one;
        const Scene scene = load_scene(test_scene(name), overrides);
        run(scene, {one.path(), 1, {}});
        for (const int threads : {2, 4}) {
            const TemporaryFolder many;
            run(scene, {many.path(), threads, {}});
            CAPTURE(name, threads);
            REQUIRE(text_of(one.path() / "probes.csv") == text_of(many.path() / "probes.csv"));
            for (const char* frame : {"frames/frame_0000.hdf", "frames/frame_0001.hdf", "frames/frame_0002.hdf"}) {
                REQUIRE(std::filesystem::exists(one.path() / frame));
                REQUIRE(text_of(one.path() / frame) == text_of(many.path() / frame));
            }
        }
    }
}

TEST_CASE("A shorter run into the same folder leaves no frames of the longer one") {
    const TemporaryFolder folder;
    const Scene scene = load_scene(test_scene("small_gate.toml"));
    run(scene, {folder.path(), 1, {}});
    run(scene, {folder.path(), 1, 0.001});
    REQUIRE(std::filesystem::exists(folder.path() / "frames" / "frame_0001.hdf"));
    REQUIRE_FALSE(std::filesystem::exists(folder.path() / "frames" / "frame_0002.hdf"));
    REQUIRE(summary_of(folder.path())["end_time"] == 0.001);
}

TEST_CASE("A computation that breaks down is a failed run with readable output") {
    const TemporaryFolder folder;
    const RunStatus status = run(load_scene(test_scene("breakdown.toml")), {folder.path(), 1, {}});
    REQUIRE(status.state == RunState::failed);
    // The block is torn apart: all numbers stay finite, the particles fly off.
    REQUIRE(status.message.find("of body block") != std::string::npos);
    REQUIRE(status.message.find("faster than sound in rubber") != std::string::npos);
    const auto summary = summary_of(folder.path());
    REQUIRE(summary["status"] == "failed");
    REQUIRE(summary["steps"].get<int>() <= 50);
    REQUIRE(summary["message"] == status.message);
    REQUIRE(text_of(folder.path() / "probes.csv").find("nan") == std::string::npos);
}

TEST_CASE("A run does not overwrite the scene that it was given") {
    const TemporaryFolder folder;
    std::filesystem::copy(test_scene("small_gate.toml"), folder.path() / "scene.toml");
    const Scene scene = load_scene(folder.path() / "scene.toml");
    REQUIRE_THROWS_AS(run(scene, {folder.path(), 1, {}}), SceneError);
    REQUIRE(text_of(folder.path() / "scene.toml") == text_of(test_scene("small_gate.toml")));
}

}  // namespace sluice::test_run
