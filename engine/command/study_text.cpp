#include "engine/command/study_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/study/advice.hpp"
#include "engine/study/matrix.hpp"
#include "engine/study/study_file.hpp"
#include "engine/study/truth.hpp"
#include "engine/study/words.hpp"

namespace sluice {
namespace {

std::string run_line(const Study& study, const StudyPoint& p, std::size_t width) {
    std::string line = fmt::format("{:<{}}  {:>9}", study.methods[p.method], width, length_text(p.spacing));
    switch (p.state) {
        case PointState::missing:
            return line + "  not run\n";
        case PointState::failed:
            return line + "  failed: " + p.reason + "\n";
        case PointState::done:
            break;
    }
    line += fmt::format("  {:>8}", seconds_text(p.cpu_seconds()));
    for (std::size_t q = 0; q < p.error.size(); ++q)
        line += fmt::format("  {:>{}}", p.error[q] ? percent_text(*p.error[q]) : "-",
                            std::max<std::size_t>(study.quantities[q].name.size(), 8));
    return line + "\n";
}

}  // namespace

std::string study_table(const Study& study) {
    std::size_t width = 6;
    for (const std::string& name : study.methods) width = std::max(width, name.size());
    std::string text = fmt::format("{:<{}}  {:>9}  {:>8}", "method", width, "spacing", "CPU-s");
    for (const Quantity& q : study.quantities)
        text += fmt::format("  {:>{}}", q.name, std::max<std::size_t>(q.name.size(), 8));
    text += "\n";
    for (std::size_t m = 0; m < study.methods.size(); ++m)
        for (const StudyPoint& p : study.points)
            if (p.method == m) text += run_line(study, p, width);
    return text;
}

std::string reference_table(const Scene& scene) {
    std::string text;
    for (const Reference& reference : scene.references) {
        text += fmt::format("reference {:<12}{}", reference.name, meaning_of(reference));
        if (reference.is_stated()) text += fmt::format("; 100 % = {:.4g}", scale_of(scene, reference));
        if (reference.uncertainty) text += fmt::format(", uncertainty {:.4g}", *reference.uncertainty);
        text += reference.source.empty() ? "\n" : fmt::format(" ({})\n", reference.source);
    }
    return text;
}

std::string target_report(const Scene& scene, const std::filesystem::path& file, double target) {
    const Study study = load_study(file);
    if (fingerprint(scene, study.axes) != study.fingerprint)
        throw SceneError(fmt::format(
            "{}: found the study of another scene or of another state of this one, expected one of {} as it is",
            file.string(), scene.file));
    std::string text;
    for (std::size_t q = 0; q < study.quantities.size(); ++q) text += target_text(study, q, target) + "\n";
    return text + fmt::format("measured {} on {}; sluice {}\n", study.date, machine_text(study), study.version);
}

}  // namespace sluice
