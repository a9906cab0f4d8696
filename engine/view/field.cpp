#include "engine/view/field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "engine/base/errors.hpp"
#include "engine/scene/table/suggestion.hpp"

namespace sluice {
namespace {

constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};

std::vector<NumberColumn> components(const std::vector<float>& vectors, int dimension, const std::string& prefix) {
    std::vector<NumberColumn> columns;
    for (int k = 0; k < dimension; ++k)
        columns.push_back(
            {prefix + std::string(axes[static_cast<std::size_t>(k)]), vectors.data() + k, vectors.size() / 3, 3});
    return columns;
}

std::vector<std::string> names_of(const std::vector<NumberColumn>& columns) {
    std::vector<std::string> names;
    for (const NumberColumn& column : columns) names.push_back(column.name);
    return names;
}

}  // namespace

std::string_view field_unit(std::string_view field) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 7> by_start{{{"speed", "m/s"},
                                                                                     {"velocity", "m/s"},
                                                                                     {"pressure", "Pa"},
                                                                                     {"stress", "Pa"},
                                                                                     {"von_mises", "Pa"},
                                                                                     {"density", "kg/m³"},
                                                                                     {"temperature", "K"}}};
    for (const auto& [start, unit] : by_start)
        if (field.starts_with(start)) return unit;
    return "";
}

std::vector<NumberColumn> position_columns(const FrameTable& table, int dimension) {
    return components(table.points, dimension, "");
}

std::vector<NumberColumn> field_columns(const FrameTable& table, int dimension) {
    std::vector<NumberColumn> columns = components(table.velocity, dimension, "velocity_");
    for (const FrameScalar& scalar : table.scalars)
        columns.push_back({scalar.name, scalar.value.data(), scalar.value.size(), 1});
    return columns;
}

std::vector<std::string> chosen_fields(const FrameTable& table, int dimension, const std::vector<std::string>& asked) {
    std::vector<std::string> known = names_of(field_columns(table, dimension)), chosen;
    if (asked.empty()) {
        std::erase(known, "speed");
        return known;
    }
    for (const std::string& name : asked) {
        const bool vector = name == "velocity";
        if (!vector && std::find(known.begin(), known.end(), name) == known.end()) {
            known.insert(known.begin(), "velocity");
            throw RunReadError(fmt::format("field \"{}\": not in the frames, expected {}{}", name, one_of(known),
                                           did_you_mean(name, known)));
        }
        for (const std::string& one :
             vector ? names_of(components(table.velocity, dimension, "velocity_")) : std::vector<std::string>{name})
            if (std::find(chosen.begin(), chosen.end(), one) == chosen.end()) chosen.push_back(one);
    }
    return chosen;
}

}  // namespace sluice
