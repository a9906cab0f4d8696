// Runs that go on from a checkpoint: their files are those of a run that was never stopped.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/base/errors.hpp"
#include "engine/files/atomic_file.hpp"
#include "engine/files/folder_lock.hpp"
#include "engine/run/checkpoint/checkpoint_store.hpp"
#include "engine/run/resume.hpp"
#include "engine/run/run.hpp"
#include "tests/catch.hpp"
#include "tests/engine/checkpoint_scenes.hpp"
#include "tests/engine/temporary_folder.hpp"

namespace sluice::test_resume {
namespace {

/// probes.csv, the frames and their list, by name.
std::map<std::string, std::string> results_in(const std::filesystem::path& folder) {
    std::map<std::string, std::string> files{{"probes.csv", text_of(folder / "probes.csv")}};
    for (const auto& file : std::filesystem::directory_iterator(folder / "frames"))
        files[file.path().filename()] = text_of(file.path());
    return files;
}

nlohmann::json summary_of(const std::filesystem::path& folder) {
    return nlohmann::json::parse(text_of(folder / "summary.json"));
}

void require_same(const std::filesystem::path& a, const std::filesystem::path& b) {
    const auto in_a = results_in(a), in_b = results_in(b);
    for (const auto& [name, text] : in_a) {
        CAPTURE(name);
        REQUIRE(in_b.count(name) == 1);
        const bool same = in_b.at(name) == text;
        REQUIRE(same);
    }
    REQUIRE(in_a.size() == in_b.size());
}

}  // namespace

TEST_CASE("Two runs do not write into one folder") {
    const TemporaryFolder folder;
    const Scene scene = load_scene(test_scene("small_gate.toml"), {"output.end=0.0002"});
    {
        const FolderLock other(folder.path());
        CHECK_THROWS_WITH(run(scene, {folder.path(), 1, {}, {}}),
                          Catch::Contains("another run writes into this folder"));
        CHECK(std::filesystem::is_empty(folder.path()));
    }
    CHECK(run(scene, {folder.path(), 1, {}, {}}).state == RunState::done);
}

TEST_CASE("Resumed runs write what uninterrupted ones do, without gap or doubling") {
    const std::vector<std::string> often{"output.checkpoint_interval=0.0006"};
    for (const std::string preset : {"paper", "modern"}) {
        std::vector<std::string> overrides{"method.preset=" + preset};
        const TemporaryFolder plain, stopped;
        run(load_scene(test_scene("small_gate.toml"), overrides), {plain.path(), 1, {}, {}});
        overrides.insert(overrides.end(), often.begin(), often.end());
        const Scene scene = load_scene(test_scene("small_gate.toml"), overrides);
        run(scene, {stopped.path(), 1, {}, {}});
        require_same(plain.path(), stopped.path());
        const auto files = checkpoints_in(stopped.path());
        REQUIRE(files.size() == 2);
        // From either checkpoint, with what was written after it still there; with one thread and with two.
        int threads = 0;
        for (const auto& file : {files[1], files[0]}) {
            if (!std::filesystem::exists(file)) continue;
            CAPTURE(preset, file);
            const std::uint64_t step = read_label(file).step;
            const RunStatus status = run(scene, {stopped.path(), ++threads, {}, file});
            REQUIRE(status.state == RunState::done);
            require_same(plain.path(), stopped.path());
            const auto summary = summary_of(stopped.path()), expected = summary_of(plain.path());
            for (const char* key : {"steps", "dt", "simulated_time", "particle_steps", "pairs", "neighbour_builds",
                                    "max_mach", "momentum_residual", "energy", "probes", "status"}) {
                CAPTURE(key);
                REQUIRE(summary[key] == expected[key]);
            }
            REQUIRE(summary["resumed_at_steps"].back() == step);
        }
    }
}

TEST_CASE("A run that goes on from an end in between forgets the frame that was not due") {
    const TemporaryFolder plain, stopped;
    const Scene scene = load_scene(test_scene("small_gate.toml"), {"output.checkpoint_interval=0.0004"});
    run(scene, {plain.path(), 1, {}, {}});
    run(scene, {stopped.path(), 1, 0.00133, {}});  // its last frame and row are at no multiple of an interval
    run(scene, {stopped.path(), 1, {}, checkpoints_in(stopped.path())[0]});
    require_same(plain.path(), stopped.path());
}

TEST_CASE("What cannot be gone on with is left as it is") {
    const TemporaryFolder folder;
    const Scene scene = load_scene(test_scene("small_gate.toml"), {"output.checkpoint_interval=0.001"});
    run(scene, {folder.path(), 1, {}, {}});
    const auto before = results_in(folder.path());
    const auto file = checkpoints_in(folder.path())[0];
    const Scene other = load_scene(test_scene("small_gate.toml"), {"method.spacing=0.002"});
    REQUIRE_THROWS_AS(run(other, {folder.path(), 1, {}, file}), CheckpointError);
    REQUIRE(results_in(folder.path()) == before);
    // Rows are missing: there is nothing to go on with.
    std::filesystem::resize_file(folder.path() / "probes.csv", 100);
    REQUIRE_THROWS_AS(run(scene, {folder.path(), 1, {}, file}), OutputError);
    REQUIRE(text_of(folder.path() / "probes.csv").size() == 100);
}

TEST_CASE("The folder of a run tells whether it is finished") {
    const TemporaryFolder folder;
    REQUIRE_FALSE(finished_at(folder.path()));
    write_atomically(folder.path() / "summary.json", "{ not json");
    REQUIRE_FALSE(finished_at(folder.path()));
    write_atomically(folder.path() / "summary.json", R"({"status": "interrupted", "end_time": 1})");
    REQUIRE_FALSE(finished_at(folder.path()));
    write_atomically(folder.path() / "summary.json", R"({"status": "done", "end_time": 0.5})");
    REQUIRE(finished_at(folder.path()) == 0.5);
}

}  // namespace sluice::test_resume
