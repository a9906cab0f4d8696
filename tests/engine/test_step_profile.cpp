// What a profile makes of sections, shares and waits; which effects a loop is said to run for; which steps are traced.
#include <algorithm>
#include <set>
#include <string>
#include <thread>
#include <utility>

#include "engine/run/profile/cost.hpp"
#include "engine/run/profile/profile.hpp"
#include "engine/run/profile/trace_recorder.hpp"
#include "neighbor/parallel.hpp"
#include "neighbor/thread_count.hpp"
#include "tests/catch.hpp"
#include "tests/engine/effect_scenes.hpp"

namespace sluice::test_step_profile {

namespace {

constexpr Section phase{"fluid momentum"};
double three_operations() { return 3; }
constexpr Section loop{"fluid momentum", sizeof(double), three_operations};

/// A step with a phase in which a loop runs twice.
void take_step(StepProfile& profile, std::uint64_t number, double time) {
    const StepProfile::Step step(&profile, number, time);
    const WatchedSection in_phase(phase);
    for (int n = 0; n < 2; ++n) {
        WatchedSection in_loop(loop);
        REQUIRE(in_loop.is_watched());
        in_loop.set_work({10, 40, 64, 500, 300});
        parallel_for(10'000, [](std::size_t) {});
    }
}

}  // namespace

TEST_CASE("a profile adds up sections and the work in them") {
    StepProfile profile(2);
    for (std::uint64_t n = 0; n < 3; ++n) take_step(profile, n, 0);
    const auto entries = profile.entries();
    REQUIRE(entries.size() == 3);
    CHECK(profile.steps() == 3);
    CHECK(entries[0].section == nullptr);
    CHECK(entries[1].section == &phase);
    CHECK(entries[2].section == &loop);
    CHECK(entries[2].parent == 1);
    CHECK(entries[1].calls == 3);
    CHECK(entries[2].calls == 6);
    CHECK(entries[2].work.pairs == 6 * 40);
    CHECK(entries[2].work.list_bytes + entries[2].work.column_bytes == 6 * 800);
    for (const auto& entry : entries) {
        REQUIRE(entry.busy.size() == 2);
        for (const Nanoseconds t : entry.busy) {
            CHECK(t >= 0);
            CHECK(t <= entry.wall);
        }
        CHECK(entry.wall <= entries[entry.parent].wall);
    }
}

TEST_CASE("nobody watches outside of a step, nor on other threads") {
    StepProfile profile(1);
    take_step(profile, 0, 0);
    CHECK(loop_watch == nullptr);
    const StepProfile::Step step(&profile, 1, 0);
    CHECK(loop_watch == &profile);
    LoopWatch* elsewhere = &profile;
    std::thread([&] { elsewhere = loop_watch; }).join();
    CHECK(elsewhere == nullptr);
    const StepProfile::Step none(nullptr, 1, 0);
}

TEST_CASE("traced steps are evenly spaced, and events within bounds") {
    TraceRecorder trace(1, {4, 1.0, 2.0});
    std::vector<double> traced;
    for (int n = 0; n < 100; ++n) {
        const double time = 1 + 0.01 * n;
        if (!trace.begin_step(static_cast<std::uint64_t>(n), time, 10 * n)) continue;
        traced.push_back(time);
        trace.end_step(10 * n + 5);
    }
    REQUIRE(traced.size() == 4);
    for (std::size_t k = 0; k < 4; ++k) CHECK(traced[k] == Approx(1 + 0.25 * static_cast<double>(k)).margin(0.0101));
    CHECK_FALSE(trace.is_cut());

    TraceRecorder full(1, {1000, 0.0, 1.0});
    std::size_t steps = 0;
    for (int n = 0; n < 1000; ++n) {
        if (!full.begin_step(static_cast<std::uint64_t>(n), 0.001 * n + 1e-9, n)) continue;
        ++steps;
        for (std::size_t e = 0; e < 1000; ++e) full.add(0, {TraceRecorder::Kind::share, 0, n, n});
        full.end_step(n);
    }
    CHECK(steps == TraceRecorder::most_events / 1000);
    CHECK(full.events(0).size() == TraceRecorder::most_events);
    CHECK(full.is_cut());

    TraceRecorder long_step(1, {1, 0.0, 1.0});
    REQUIRE(long_step.begin_step(0, 0, 0));
    for (std::size_t e = 0; e <= TraceRecorder::most_events; ++e)
        long_step.add(0, {TraceRecorder::Kind::share, 0, 0, 0});
    long_step.end_step(1);
    CHECK(long_step.events(0).size() == TraceRecorder::most_events);
    CHECK(long_step.is_cut());
}

TEST_CASE("the loops in which effects are said to run do run in those phases") {
    std::vector<Scene> scenes;
    for (const auto& c : effect_scenes::cases()) scenes.push_back(c.on.load());
    // Shifting beside all that has a say in it.
    scenes.push_back(effect_scenes::Case::Side{effect_scenes::water + effect_scenes::block + effect_scenes::fixed,
                                               {"method.preset=modern"}}
                         .load());
    const ThreadCount one(1);
    std::set<std::pair<std::string, std::string>> loops;
    for (const Scene& scene : scenes) {
        Simulation<2> simulation(scene);
        StepProfile profile(1);
        for (std::uint64_t n = 0; n < 2; ++n) {
            const StepProfile::Step step(&profile, n, simulation.time());
            simulation.step();
        }
        for (const ProfileRow& row : profile_of(profile, simulation.effects()).rows)
            if (row.kind == ProfileRow::Kind::loop) loops.emplace(row.phase, row.name);
    }
    for (const EffectInfo& effect : effect_table) {
        for (const StepPlace& place : effect.places) {
            CAPTURE(std::string(effect.key), std::string(name_of(place.phase)), std::string(place.loop));
            CHECK(place.loop.empty() != (place.part == StepPlace::Part::loop));
            if (!place.loop.empty())
                CHECK(loops.contains({std::string(name_of(place.phase)), std::string(place.loop)}));
        }
        for (const StepPhase phase : phases_for(effect.effect)) {
            INFO("phase of a required effect");
            CHECK(std::ranges::any_of(effect.places, [&](const StepPlace& place) { return place.phase == phase; }));
        }
    }
}

}  // namespace sluice::test_step_profile
