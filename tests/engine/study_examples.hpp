// Studies made up for tests.
#pragma once

#include <cmath>

#include "engine/study/study.hpp"

namespace study_examples {

inline sluice::StudyPoint point(const std::string& precision, double spacing, double cpu, double error) {
    sluice::StudyPoint p;
    p.values = {std::to_string(spacing), precision};
    p.method = precision == "mixed" ? 0 : 1;
    p.spacing = spacing;
    p.state = sluice::PointState::done;
    p.cpu = {cpu, 1.05 * cpu, 0.95 * cpu};
    p.wall = p.cpu;
    p.error = {error, 0.02};
    return p;
}

/// Mixed precision: error d², cost d^-3, at 0.4, 0.2, 0.1 and 0.05. Double: 1.5 times the cost, errors that do not fall
/// steadily, and one failed run. A second quantity is extrapolated.
inline sluice::Study two_methods() {
    sluice::Study study;
    study.title = "A <made-up> study & its scene";
    study.scene = "scene.toml";
    study.fingerprint = "0123456789abcdef";
    study.version = "0.1.0";
    study.date = "2026-01-01";
    study.machine = {"Some processor", 2, "avx2", 0.5};
    study.repeats = 3;
    study.axes = {{"method.spacing", {"0.4", "0.2", "0.1", "0.05"}}, {"method.precision", {"mixed", "double"}}};
    study.methods = {"mixed", "double"};
    study.quantities = {{"tip", "peak of tip.x against reference.csv", 1.0, "m", 0.002, false, "an experiment"},
                        {"level", "RMS distance of level from the finest runs", 0.5, "m", 0.01, true, "order 1.9"}};
    for (const double d : {0.4, 0.2, 0.1, 0.05}) {
        study.points.push_back(point("mixed", d, std::pow(d, -3), d * d));
        study.points.push_back(point("double", d, 1.5 * std::pow(d, -3), d == 0.2 ? 0.005 : 1.5 * d * d));
    }
    sluice::StudyPoint failed;
    failed.values = {"0.1", "double"};
    failed.method = 1;
    failed.spacing = 0.1;
    failed.state = sluice::PointState::failed;
    failed.reason = "torn, \"apart\"";
    failed.error = {std::nullopt, std::nullopt};
    study.points.push_back(failed);
    return study;
}

}  // namespace study_examples
