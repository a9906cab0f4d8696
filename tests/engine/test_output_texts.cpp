#include "engine/base/number_text.hpp"
#include "engine/base/text_hash.hpp"
#include "engine/run/progress.hpp"
#include "engine/run/report.hpp"
#include "engine/run/schedule.hpp"
#include "engine/run/summary.hpp"
#include "tests/catch.hpp"

namespace sluice::test_output_texts {

TEST_CASE("Outputs are due at the step nearest to each multiple of the interval") {
    Schedule schedule(0.01);
    const double dt = 0.003;
    std::vector<int> due;
    for (int step = 0; step < 12; ++step)
        if (schedule.ask(step * dt, dt) == Schedule::Answer::due) due.push_back(step);
    // 0, 0.009 (nearest to 0.01), 0.021, 0.030
    REQUIRE(due == std::vector<int>{0, 3, 7, 10});
}

TEST_CASE("Steps longer than the interval give one output each, an interval of 0 none") {
    Schedule often(0.001), never(0);
    for (int step = 0; step < 5; ++step) {
        REQUIRE(often.ask(step * 0.01, 0.01) == Schedule::Answer::due);
        REQUIRE(never.ask(step * 0.01, 0.01) == Schedule::Answer::wait);
    }
}

TEST_CASE("Multiples of the interval do not drift") {
    // 1e5 outputs of 1e-5 s in steps of exactly that: as many outputs as steps, whatever rounding does.
    Schedule schedule(1e-5);
    int count = 0;
    for (int step = 0; step < 100000; ++step) count += schedule.ask(step * 1e-5, 1e-5) == Schedule::Answer::due;
    REQUIRE(count == 100000);
}

TEST_CASE("Text hashes are FNV-1a") {
    // The test vectors of its authors.
    REQUIRE(text_hash("") == "cbf29ce484222325");
    REQUIRE(text_hash("a") == "af63dc4c8601ec8c");
    REQUIRE(text_hash("foobar") == "85944171f73967e8");
}

TEST_CASE("Progress says how far, how fast and how long") {
    const ProgressState state{0.1, 0.4, 20, 2000, 4e6};
    REQUIRE(progress_text(state) == " 25.0 % | 1:00 left | t = 0.1 of 0.4 s | 100 steps/s | 200 k particle-steps/s");
    REQUIRE(progress_bar(state, 8) == "[##------]");
    REQUIRE(progress_bar({2, 1, 0, 0, 0}, 4) == "[####]");
    REQUIRE(progress_text({0, 1, 0, 0, 0}).find("?:??") != std::string::npos);
}

TEST_CASE("Numbers and times are short") {
    REQUIRE(short_number(0) == "0");
    REQUIRE(short_number(999) == "999");
    REQUIRE(short_number(999.7) == "1.00 k");
    REQUIRE(short_number(12345) == "12.3 k");
    REQUIRE(short_number(2.31e6) == "2.31 M");
    REQUIRE(short_number(5e12) == "5000 G");
    REQUIRE(memory_text(950) == "950 B");
    REQUIRE(memory_text(8.1e6) == "8.10 MB");
    REQUIRE(clock_text(7) == "0:07");
    REQUIRE(clock_text(3723) == "1:02:03");
}

}  // namespace sluice::test_output_texts
