// The smaller texts that users write: formulas, tables of numbers, stored studies, changes by --set, and what tells two
// texts apart. The first byte chooses which.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>

#include "engine/run/text_difference.hpp"
#include "engine/scene/formula.hpp"
#include "engine/scene/read/number_table.hpp"
#include "engine/study/study_file.hpp"
#include "tests/engine/scene_text.hpp"
#include "tests/fuzz/demand.hpp"

namespace sluice {
namespace {

void compile_formula(const std::string& text) {
    Scene scene;
    scene.file = "scene.toml";
    scene.constants = {{"k", 2.5}};
    for (const Variable variable : {Variable::place, Variable::time, Variable::place_and_time}) try {
            const CompiledFormula formula(scene, "bodies.water.velocity", text, variable);
            const double value = variable == Variable::place_and_time ? formula.at({1, -2, 3}, 0.5)
                                 : variable == Variable::time         ? formula(0.5)
                                                                      : formula(Point{1, -2, 3});
            demand(std::isfinite(value), "a formula's value is finite");
        } catch (const SceneError&) {
        }
}

void read_table(const std::string& text) {
    try {
        std::istringstream lines(text);
        const NumberTable table = read_number_table(lines, "table.csv");
        demand(!table.names.empty() && table.names.size() == table.columns.size(), "a table has columns");
        for (const auto& column : table.columns) demand(column.size() == table.rows(), "columns are equally long");
    } catch (const std::runtime_error& error) {
        demand(std::string(error.what()).starts_with("table.csv:"), "a table's message names the file");
    }
}

void read_study(const std::string& text) {
    try {
        const Study study = study_from_json(text);
        const std::string again = json_text(study);
        demand(json_text(study_from_json(again)) == again, "a study's own text reads as the same study");
        csv_text(study);
    } catch (const std::runtime_error&) {
    }
}

void change_scene(const std::string& text) {
    try {
        parse_scene(scene_text::gate, "scene.toml", {text});
    } catch (const SceneError& error) {
        demand(std::string(error.what()).starts_with("scene.toml:"), "a message names the file");
    }
}

/// Every line of either text must be found again: common ones counted once.
void compare_texts(const std::string& text) {
    const std::size_t half = text.size() / 2;
    const std::string a = text.substr(0, half), b = text.substr(half);
    demand(text_difference(a, a).empty(), "a text differs from itself");
    text_difference(a, b);
}

}  // namespace
}  // namespace sluice

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
    constexpr void (*targets[])(const std::string&){sluice::compile_formula, sluice::read_table, sluice::read_study,
                                                    sluice::change_scene, sluice::compare_texts};
    targets[data[0] % std::size(targets)](text);
    return 0;
}
