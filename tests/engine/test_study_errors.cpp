// Errors, limits, fronts and slopes against numbers worked out by hand.
#include <cmath>
#include <fstream>
#include <numbers>

#include "engine/study/curve.hpp"
#include "engine/study/evaluate.hpp"
#include "engine/study/extrapolation.hpp"
#include "engine/study/fit.hpp"
#include "engine/study/truth.hpp"
#include "tests/catch.hpp"
#include "tests/engine/scene_text.hpp"
#include "tests/engine/temporary_folder.hpp"

namespace sluice::test_study_errors {
using Catch::Matchers::Contains;

namespace {

constexpr double pi = std::numbers::pi;
// Sums of a few numbers of size 1.
constexpr double rounding = 1e-13;

Curve sampled(double end, int intervals, double (*f)(double)) {
    Curve c;
    for (int i = 0; i <= intervals; ++i) {
        c.time.push_back(end * i / intervals);
        c.value.push_back(f(c.time.back()));
    }
    return c;
}

/// f0 + C d^p
SpacedResult made_up(double d, double f0, double c, double p) { return {d, {f0 + c * std::pow(d, p)}}; }

}  // namespace

TEST_CASE("Measures of a curve", "[study]") {
    const Curve parabola{{0, 1, 2, 4}, {0, 3, 4, 0}};  // t (4 − t), unevenly sampled
    CHECK(*measure_of(parabola, Measure::peak) == Approx(4).epsilon(rounding));
    CHECK(*measure_of(parabola, Measure::peak_time) == Approx(2).epsilon(rounding));
    const Curve between{{0, 1, 2.5, 4}, {0, 3, 3.75, 0}};  // the same with no sample at the top
    CHECK(*measure_of(between, Measure::peak) == Approx(4).epsilon(rounding));
    CHECK(*measure_of(between, Measure::peak_time) == Approx(2).epsilon(rounding));
    CHECK(*measure_of(parabola, Measure::final) == 0);
    // Trapezes: 1.5 + 3.5 + 2·2 over 4.
    CHECK(*measure_of(parabola, Measure::mean) == Approx(9.0 / 4).epsilon(rounding));
    CHECK_FALSE(measure_of({{0}, {1}}, Measure::final));
}

TEST_CASE("The period is that of the passes, wherever the curve swings", "[study]") {
    const Curve c = sampled(3.1, 3100, [](double t) { return 7 + 0.5 * std::sin(2 * pi * t / 0.9 + 1); });
    // Straight lines between samples a thousandth apart: passes are off by less than 1e-6 of the period.
    CHECK(*measure_of(c, Measure::period) == Approx(0.9).epsilon(1e-6));
    CHECK_FALSE(measure_of(sampled(0.4, 100, [](double t) { return std::sin(2 * pi * t / 0.9); }), Measure::period));
}

TEST_CASE("Distances of curves, at the truth's times within the run", "[study]") {
    const Curve run{{0, 2, 4}, {0, 2, 4}};
    const Curve truth{{0, 1, 3, 5}, {0, 0, 5, 100}};  // differences 0, 1, −2; 5 s lies beyond the run
    CHECK(*distance(run, truth, Measure::rms) == Approx(std::sqrt(5.0 / 3)).epsilon(rounding));
    CHECK(*distance(run, truth, Measure::max) == Approx(2).epsilon(rounding));
    CHECK_FALSE(distance(run, {{0, 7}, {1, 1}}, Measure::rms));
    const Curve part = window(truth, 1, 3);
    CHECK(part.time == std::vector<double>{1, 3});
}

TEST_CASE("Errors against a formula, a number and the scales that they refer to", "[study]") {
    const Scene scene = scene_text::load(scene_text::gate);
    Reference r;
    r.name = "x";
    r.formula = "2*t";
    const Curve run{{0, 0.1, 0.2, 0.4}, {0, 0.2, 0.5, 0.7}};
    CHECK(*stated_error(scene, r, run) == Approx(std::sqrt((0.01 + 0.01) / 4)).epsilon(rounding));
    CHECK(scale_of(scene, r) == Approx(0.8).epsilon(rounding));  // 2 t at the end of output, 0.4 s
    r.from = 0.15;
    CHECK(*stated_error(scene, r, run) == Approx(0.1).epsilon(rounding));
    Reference number;
    number.name = "peak";
    number.measure = Measure::peak;
    number.number = -0.5;
    CHECK(*stated_error(scene, number, run) == Approx(1.2).epsilon(rounding));
    CHECK(scale_of(scene, number) == 0.5);
    r.formula = "0";
    CHECK_THROWS_WITH(scale_of(scene, r), Contains("without a scale"));
}

TEST_CASE("Extrapolation finds a known limit and order, at any ratios of spacings", "[study]") {
    const double p = GENERATE(0.7, 1.0, 2.0, 3.5);
    const Extrapolation e = extrapolate({made_up(0.4, 5, 3, p), made_up(0.1, 5, 3, p), made_up(0.25, 5, 3, p)});
    CHECK(e.is_credible);
    // Bisection to the last bit; differences of results lose two digits.
    CHECK(*e.order == Approx(p).epsilon(1e-10));
    CHECK(e.value[0] == Approx(5).epsilon(1e-12));
    CHECK(e.uncertainty == Approx(1.25 * 3 * std::pow(0.1, p)).epsilon(1e-9));
    CHECK_THAT(e.note, Contains("observed order"));
}

TEST_CASE("Extrapolation of a curve goes value by value with one order", "[study]") {
    std::vector<SpacedResult> results;
    for (const double d : {4.0, 2.0, 1.0}) results.push_back({d, {1 + 0.1 * d * d, 2 - 0.3 * d * d, 3}});
    const Extrapolation e = extrapolate(results);
    CHECK(*e.order == Approx(2).epsilon(1e-10));
    CHECK(e.value[0] == Approx(1).epsilon(1e-12));
    CHECK(e.value[1] == Approx(2).epsilon(1e-12));
    CHECK(e.value[2] == 3);
}

TEST_CASE("An order that cannot be believed is told, and the finest run stands", "[study]") {
    const Extrapolation turning = extrapolate({{4, {1.0}}, {2, {2.0}}, {1, {1.5}}});
    CHECK_FALSE(turning.is_credible);
    CHECK(turning.value[0] == 1.5);
    CHECK(turning.uncertainty == 1);  // the largest difference of three
    CHECK_THAT(turning.note, Contains("change sign"));
    const Extrapolation steep = extrapolate({made_up(4, 1, 1, 6), made_up(2, 1, 1, 6), made_up(1, 1, 1, 6)});
    CHECK_FALSE(steep.is_credible);
    CHECK_THAT(steep.note, Contains("no credible order (one of 6 observed"));
    const Extrapolation growing = extrapolate({{4, {1.0}}, {2, {1.1}}, {1, {1.5}}});
    CHECK_FALSE(growing.is_credible);
    const Extrapolation two = extrapolate({{2, {1.0}}, {1, {1.5}}});
    CHECK_FALSE(two.is_credible);
    CHECK(two.uncertainty == 1.5);  // 3 |f1 − f2|
    CHECK_THROWS_AS(extrapolate({{1, {1.0}}}), std::logic_error);
}

TEST_CASE("Slopes are exact on power laws and state their scatter otherwise", "[study]") {
    const auto fit = fit_power({1, 2, 4}, {3, 24, 192});
    CHECK(fit->exponent == Approx(3).epsilon(rounding));
    CHECK(fit->factor == Approx(3).epsilon(rounding));
    CHECK(*fit->uncertainty < 1e-7);  // the root of rounding
    // log2 y = 0, 1, 1 over log2 x = 0, 1, 2: slope 1/2; residuals −1/6, 1/3, −1/6, so sqrt((1/6)/1/2) = 0.2887.
    const auto rough = fit_power({1, 2, 4}, {1, 2, 2});
    CHECK(rough->exponent == Approx(0.5).epsilon(rounding));
    CHECK(*rough->uncertainty == Approx(std::sqrt(1.0 / 12)).epsilon(1e-10));
    CHECK_FALSE(fit_power({1, 2}, {3, 6})->uncertainty);
    CHECK_FALSE(fit_power({2, 2}, {3, 6}));
    CHECK_FALSE(fit_power({2}, {3}));
    CHECK_FALSE(fit_power({1, 2}, {0, 6}));
}

TEST_CASE("The Pareto front keeps what nothing beats", "[study]") {
    const std::vector<CostAndError> points{{4, 0.1}, {1, 1}, {2, 2}, {2, 0.5}, {3, 0.5}, {8, 0.2}, {9, 0.05}};
    CHECK(pareto_front(points) == std::vector<std::size_t>{1, 3, 0, 6});
    CHECK(pareto_front({{1, 1}, {2, 0.995}, {3, 0.98}}) == std::vector<std::size_t>{0, 2});
    CHECK(pareto_front({}).empty());
}

TEST_CASE("Without a stated truth a study measures against the limit of its finest method", "[study]") {
    const TemporaryFolder folder;
    const Scene scene = scene_text::load(scene_text::gate);
    Study study;
    study.methods = {"a", "b"};
    std::vector<std::optional<ProbeTable>> curves;
    // Level 1 + d² for method a, at spacings 4, 2, 1, and 1 + d for b at 4, 2: the limit is a's, 1.
    for (const auto& [method, d] :
         std::vector<std::pair<std::size_t, double>>{{0, 4}, {0, 2}, {0, 1}, {1, 4}, {1, 2}}) {
        StudyPoint p;
        p.method = method;
        p.spacing = d;
        p.state = PointState::done;
        study.points.push_back(p);
        const double level = 1 + (method == 0 ? d * d : d);
        const auto file = folder.path() / std::to_string(curves.size());
        std::ofstream(file) << "t [s],free_end.x [m],free_end.y [m],level.level [m]\n0,0,0," << level << "\n0.4,0,0,"
                            << level << "\n";
        curves.emplace_back(file);
    }
    measure_errors(study, scene, curves);
    REQUIRE(study.quantities.size() == 3);
    const Quantity& q = study.quantities[2];
    CHECK(q.name == "level.level");
    CHECK(q.extrapolated);
    CHECK(q.unit == "m");
    CHECK(q.scale == Approx(1).epsilon(1e-12));
    CHECK(*q.uncertainty == Approx(1.25).epsilon(1e-10));  // 1.25 |f1 − f0| = 1.25 · 1
    CHECK_THAT(q.note, Contains("a: extrapolated") && Contains("2.00"));
    const double wanted[]{16, 4, 1, 4, 2};
    for (std::size_t i = 0; i < 5; ++i) CHECK(*study.points[i].error[2] == Approx(wanted[i]).epsilon(1e-10));
    // Without the coarsest of a's, its finest stands for the truth: it has no error, and the others' is from it.
    study.points[0].state = PointState::failed;
    curves[0].reset();
    measure_errors(study, scene, curves);
    CHECK_THAT(study.quantities[2].note, Contains("only two spacings"));
    CHECK_FALSE(study.points[2].error[2]);
    CHECK(*study.points[1].error[2] == Approx(3.0 / 2).epsilon(1e-12));  // 5 and 2, over the size 2
    // A displacement that is 0 throughout has no size that errors could refer to.
    CHECK_FALSE(study.points[1].error[0]);
}

}  // namespace sluice::test_study_errors
