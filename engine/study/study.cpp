#include "engine/study/study.hpp"

#include <algorithm>

namespace sluice {

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double StudyPoint::cpu_seconds() const { return median(cpu); }
double StudyPoint::wall_seconds() const { return median(wall); }

bool Study::is_complete() const {
    return std::all_of(points.begin(), points.end(), [this](const StudyPoint& p) {
        return p.state == PointState::failed || p.cpu.size() == static_cast<std::size_t>(repeats);
    });
}

std::vector<const StudyPoint*> points_of(const Study& study, std::size_t method, std::size_t quantity) {
    std::vector<const StudyPoint*> points;
    for (const StudyPoint& p : study.points)
        if (p.method == method && p.state == PointState::done && p.error[quantity]) points.push_back(&p);
    std::stable_sort(points.begin(), points.end(),
                     [](const StudyPoint* a, const StudyPoint* b) { return a->spacing > b->spacing; });
    return points;
}

}  // namespace sluice
