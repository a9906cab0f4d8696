// What a study will run, what it keeps, and what it tells.
#include <fstream>

#include "engine/scene/table/scene_keys.hpp"
#include "engine/study/advice.hpp"
#include "engine/study/matrix.hpp"
#include "engine/study/plan.hpp"
#include "engine/study/run_store.hpp"
#include "engine/study/stored_study.hpp"
#include "engine/study/study_file.hpp"
#include "engine/study/study_progress.hpp"
#include "engine/study/words.hpp"
#include "tests/catch.hpp"
#include "tests/engine/scene_text.hpp"
#include "tests/engine/study_examples.hpp"
#include "tests/engine/temporary_folder.hpp"

namespace sluice::test_study_matrix {
using namespace scene_text;
using Catch::Matchers::Contains;
using Strings = std::vector<std::string>;

namespace {

const std::string vortex = SLUICE_TEST_SCENES "/small_vortex.toml";

StudyOptions options_for(const Strings& vary) {
    StudyOptions options;
    options.scene = vortex;
    options.vary = vary;
    return options;
}

}  // namespace

TEST_CASE("Axes are split at commas outside brackets, factors taken of what the scene has", "[study]") {
    const Scene scene = load(gate);
    const auto values = [&](const std::string& text) { return parse_axis(text, scene).values; };
    CHECK(parse_axis("method.spacing=0.002,1e-3", scene).key == "method.spacing");
    CHECK(values("method.spacing=0.002,1e-3") == Strings{"0.002", "1e-3"});
    CHECK(values("method.spacing=x2,x1,x0.5") == Strings{"0.002", "0.001", "0.0005"});
    CHECK(values("method.smoothing_length=x1,x1.2") == Strings{"1.5", "1.8"});  // the preset's, not in the file
    CHECK(values("probes.free_end.at=[0,1],[0,2]") == Strings{"[0,1]", "[0,2]"});
    CHECK(values("title=\"a,b\",xylem") == Strings{"\"a,b\"", "xylem"});
    const auto error = [&](const std::string& text) { return error_of([&] { parse_axis(text, scene); }); };
    CHECK_THAT(error("method.spacing"), Contains("--vary method.spacing: found no key, expected"));
    CHECK_THAT(error("method.spacing=1,,2"), Contains("found an empty value"));
    CHECK_THAT(error("method.spacing=1,1.0"), Contains("found 1.0 twice"));
    CHECK_THAT(error("method.spacing=x-1"), Contains("found the factor x-1, expected a number > 0"));
    CHECK_THAT(error("title=x2"), Contains("but the scene has no number at title"));
}

TEST_CASE("What a scene has at a key of the method is known where only the preset states it", "[study]") {
    for (const std::string preset : {"modern", "paper"}) {
        const Scene scene = load(gate, {"method.preset=" + preset});
        int compared = 0;
        for (const SceneKey& key : scene_keys()) {
            const std::string path(key.path);
            if (!path.starts_with("method.") || key.otherwise.kind != Otherwise::Kind::value) continue;
            if (scene.lines.contains(path)) continue;
            const bool other = preset == "paper" && !key.otherwise.paper.empty();
            CAPTURE(preset, path, value_in_scene(scene, path));
            CHECK(is_same_value(value_in_scene(scene, path),
                                std::string(other ? key.otherwise.paper : key.otherwise.text)));
            ++compared;
        }
        CHECK(compared > 15);
        CHECK(value_in_scene(scene, "method.time_step").empty());
        CHECK(value_in_scene(scene, "method.no_such_key").empty());
    }
}

TEST_CASE("The matrix is every combination, the last axis fastest", "[study]") {
    const std::vector<Axis> axes{{"a", {"1", "2"}}, {"b", {"x", "y", "z"}}};
    CHECK(combinations(axes) ==
          std::vector<Strings>{{"1", "x"}, {"1", "y"}, {"1", "z"}, {"2", "x"}, {"2", "y"}, {"2", "z"}});
    CHECK(combinations({}) == std::vector<Strings>{{}});
    CHECK(overrides_of(axes, {"2", "y"}) == Strings{"a=2", "b=y"});
}

TEST_CASE("Methods are named by what varies beside the spacing", "[study]") {
    const Scene scene = load(gate);
    const std::vector<Axis> axes{
        {"method.preset", {}}, {"method.spacing", {}}, {"method.courant", {}}, {"effects.clamp", {}}};
    CHECK(method_name(axes, {"modern", "0.1", "0.5", "off"}, scene) == "modern, courant 0.5, clamp off");
    CHECK(method_name({{"method.spacing", {}}}, {"0.1"}, scene) == "paper, double");
}

TEST_CASE("A plan groups points to methods and runs the coarse ones first", "[study]") {
    const Plan plan = make_plan(options_for({"method.spacing=0.05,0.1", "method.precision=mixed,double"}));
    CHECK(plan.study.methods == Strings{"mixed", "double"});
    REQUIRE(plan.study.points.size() == 4);
    CHECK(run_order(plan.study) == std::vector<std::size_t>{2, 3, 0, 1});
    CHECK(plan.study.points[3].method == 1);
    CHECK(plan.study.points[3].spacing == 0.1);
    CHECK(plan.runs[0].key != plan.runs[1].key);
    // The same physics has the same key, however it is written; another thread count costs something else.
    CHECK(make_plan(options_for({"method.spacing=5e-2", "method.precision=mixed"})).runs[0].key == plan.runs[0].key);
    StudyOptions two = options_for({"method.spacing=0.05,0.1", "method.precision=mixed,double"});
    two.threads = 2;
    CHECK(make_plan(two).runs[0].key != plan.runs[0].key);
}

TEST_CASE("A combination that is refused is a failed point; if all are, the study is refused", "[study]") {
    const Plan plan = make_plan(options_for({"method.precision=mixed,triple"}));
    CHECK(plan.runs[0].refusal.empty());
    CHECK_THAT(plan.runs[1].refusal, Contains("found \"triple\", expected one of \"double\", \"mixed\""));
    CHECK_THROWS_WITH(make_plan(options_for({"method.precison=mixed,double"})), Contains("found an unknown key"));
    CHECK_THROWS_WITH(make_plan(options_for({"method.courant=0.1", "method.courant=0.2"})), Contains("key twice"));
}

TEST_CASE("How a run ended decides whether it stands", "[study]") {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / log_name) << "10 %\nsluice: error: step 3: the density is not finite\nmore\n";
    const auto end = [](int code, int signal) { return ChildEnd{code, signal, 1, 2}; };
    CHECK_FALSE(result_of_end(end(0, 0), folder.path())->failed);
    const auto failed = result_of_end(end(1, 0), folder.path());
    CHECK(failed->failed);
    CHECK(failed->reason == "step 3: the density is not finite");
    CHECK(result_of_end(end(2, 0), folder.path())->failed);
    // The disk was full, someone pressed Ctrl-C, or the system killed it: to be made again.
    CHECK_FALSE(result_of_end(end(3, 0), folder.path()));
    CHECK_FALSE(result_of_end(end(130, 0), folder.path()));
    CHECK_FALSE(result_of_end(end(0, 9), folder.path()));
    CHECK(failure_reason(end(0, 9), folder.path()) == "ended by signal 9 (Killed); last words: more");
    store_result(folder.path(), *failed);
    CHECK(load_result(folder.path())->reason == failed->reason);
    std::ofstream(folder.path() / "result.json") << "{\"failed\": fal";
    CHECK_FALSE(load_result(folder.path()));
}

TEST_CASE("The time left follows cost ~ d^-(Dim + 1) from the nearest run of the method", "[study]") {
    TimeEstimate estimate(2);
    CHECK_FALSE(estimate.of({0, 1}));
    estimate.add({0, 0.4}, 1);
    CHECK(*estimate.of({0, 0.2}) == Approx(8));
    CHECK(*estimate.of({1, 0.2}) == Approx(8));
    estimate.add({0, 0.2}, 6);
    CHECK(*estimate.of({0, 0.1}) == Approx(48));
    estimate.add({1, 0.4}, 2);
    CHECK(*estimate.of({1, 0.1}) == Approx(128));
}

TEST_CASE("A study is read back as it was written", "[study]") {
    const Study study = study_examples::two_methods();
    const Study again = study_from_json(json_text(study));
    CHECK(json_text(again) == json_text(study));
    CHECK_THROWS_AS(study_from_json("{}"), std::runtime_error);
    CHECK_THAT(csv_text(study), Contains("method.spacing,method.precision,method,spacing [m],state,runs,CPU time [s]"));
    CHECK_THAT(csv_text(study), Contains("0.1,double,double,0.1,failed,0,,,,,\"torn, \"\"apart\"\"\""));
}

TEST_CASE("Advice: the cheapest spacing from which on down the error is kept", "[study]") {
    const Study study = study_examples::two_methods();
    // Fast: error = d², cost = d^-3, exactly; interpolated in logarithms that is exact too.
    const auto choices = choices_for(study, 0, 0.01);
    REQUIRE(choices.size() == 2);
    CHECK(study.methods[choices[0].method] == "mixed");
    CHECK(choices[0].basis == Basis::measured);
    CHECK(choices[0].spacing == 0.1);
    const Choice between = choices_for(study, 0, 0.0145).front();
    CHECK(between.basis == Basis::interpolated);
    CHECK(between.spacing == Approx(std::sqrt(0.0145)).epsilon(1e-10));
    CHECK(between.cpu == Approx(std::pow(0.0145, -1.5)).epsilon(1e-10));
    const Choice beyond = choices_for(study, 0, 0.05 * 0.05 / 2).front();
    CHECK(beyond.basis == Basis::extrapolated);
    CHECK(beyond.spacing == Approx(0.05 / std::sqrt(2)).epsilon(1e-10));
    CHECK(choices_for(study, 0, 0.05 * 0.05 / 8).empty());  // less than half of the finest spacing
    Study level = study;                                    // an error that no longer falls is not followed
    for (StudyPoint& p : level.points)
        if (p.spacing == 0.05) p.error[0] = 0.009;
    CHECK(choices_for(level, 0, 0.008).empty());
    // Slow: its error is small by luck at 0.2, larger at 0.1: what counts is the spacing from which it stays small.
    const Choice slow = choices[1];
    CHECK(slow.spacing < 0.1);
    CHECK(expected(study, 0, 0, 0.05)->error == Approx(0.0025).epsilon(1e-12));
    CHECK(expected(study, 0, 0, 0.07)->error == Approx(0.0049).epsilon(1e-10));
    CHECK_FALSE(expected(study, 0, 0, 0.8));
    CHECK(*target_of(study, 0) == Approx(0.005));  // twice 0.0025
    const std::string text = advice(study)[0];
    CHECK_THAT(text, Contains("For 0.50 % in tip: spacing 70.7 mm, mixed: 2828 CPU-s (interpolated)."));
    CHECK_THAT(text, Contains("Half the error: spacing 50 mm, mixed: 8000 CPU-s, 2.8 times the cost."));
    CHECK_THAT(text,
               Contains("Below 0.20 % (2 mm) the reference's own uncertainty hides any gain; no run comes that near."));
}

TEST_CASE("A stored study is recognised by its scene, whatever is varied and written", "[study]") {
    const TemporaryFolder folder;
    std::filesystem::copy_file(vortex, folder.path() / "scene.toml");
    const std::string file = folder.path() / "scene.toml";
    StudyOptions options = options_for({"method.spacing=0.1,0.05", "method.precision=mixed,double"});
    options.scene = file;
    Study study = make_plan(options).study;
    CHECK(study_beside(file) == folder.path() / "study.json");
    CHECK(study_beside("a/gate.toml") == "a/gate.study.json");
    study.quantities.push_back({"energy", "", 1, "J/m", {}, false, ""});
    for (StudyPoint& p : study.points) {
        p.state = PointState::done;
        p.cpu = p.wall = {1};
        p.error = {p.spacing * p.spacing * static_cast<double>(1 + p.method)};
    }
    const auto expectation = [&](const Strings& changes) { return expectation_text(load_scene(file, changes)); };
    CHECK(expectation({}).empty());  // nothing stored
    std::ofstream(study_beside(file)) << json_text(study);
    // The scene's preset has mixed precision, which its file does not say.
    CHECK_THAT(expectation({}), Contains("study.json: 0.25 % in energy\n"));
    CHECK_THAT(expectation({"method.precision=double", "title=other", "output.frame_interval=0"}),
               Contains(" 0.50 % in"));
    CHECK_THAT(expectation({"method.spacing=0.07"}), Contains("0.49 % in energy, interpolated"));
    CHECK(expectation({"materials.water.viscosity=0.02"}).empty());
    CHECK(expectation({"output.end=0.01"}).empty());
    CHECK(expectation({"method.courant=0.1"}).empty());
    std::ofstream(study_beside(file)) << "{";
    CHECK(expectation({}).empty());
    CHECK_THROWS_WITH(load_study(study_beside(file)), Contains("found no study"));
}

TEST_CASE("Numbers of a study are short", "[study]") {
    CHECK(percent_text(0.0432) == "4.3 %");
    CHECK(percent_text(0.25) == "25 %");
    CHECK(percent_text(0.00031) == "0.031 %");
    CHECK(percent_text(0) == "0 %");
    CHECK(length_text(8.3333333e-4) == "0.833 mm");
    CHECK(length_text(0.02) == "20 mm");
    CHECK(length_text(3e-5) == "30 µm");
    CHECK(seconds_text(12345) == "12345");
}

}  // namespace sluice::test_study_matrix
