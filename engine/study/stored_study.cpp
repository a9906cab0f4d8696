#include "engine/study/stored_study.hpp"

#include <fmt/format.h>

#include "engine/study/advice.hpp"
#include "engine/study/matrix.hpp"
#include "engine/study/study_file.hpp"
#include "engine/study/words.hpp"

namespace sluice {

std::filesystem::path study_beside(const std::string& scene_file) {
    const std::filesystem::path file(scene_file);
    const std::string name = file.stem() == "scene" ? "study.json" : file.stem().string() + ".study.json";
    return file.parent_path() / name;
}

std::optional<std::size_t> method_of(const Study& study, const Scene& scene) {
    if (fingerprint(scene, study.axes) != study.fingerprint) return std::nullopt;
    for (const StudyPoint& point : study.points) {
        bool same = true;
        for (std::size_t k = 0; k < study.axes.size(); ++k)
            if (study.axes[k].key != spacing_key_name)
                same &= is_same_value(value_in_scene(scene, study.axes[k].key), point.values[k]);
        if (same) return point.method;
    }
    return std::nullopt;
}

std::string expectation_text(const Scene& scene) {
    const std::filesystem::path file = study_beside(scene.file);
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) return "";
    std::optional<Study> study;
    try {
        study = load_study(file);
    } catch (const SceneError&) {
        return "";  // a run that is done has nothing to do with a spoilt study; `check --target-error` tells
    }
    const auto method = method_of(*study, scene);
    if (!method) return "";
    std::string text;
    for (std::size_t q = 0; q < study->quantities.size(); ++q)
        if (const auto choice = expected(*study, q, *method, scene.method.spacing)) {
            text += fmt::format("{}{} in {}", text.empty() ? "" : "; ", percent_text(choice->error),
                                study->quantities[q].name);
            if (choice->basis != Basis::measured) text += fmt::format(", {}", word_of(choice->basis));
        }
    return text.empty() ? "" : fmt::format("expected error, by {}: {}\n", file.string(), text);
}

}  // namespace sluice
