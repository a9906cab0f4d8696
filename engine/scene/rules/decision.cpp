#include "engine/scene/rules/decision.hpp"

#include <fmt/format.h>

namespace sluice::rules {

Decision fluid_in(const SceneContent& c) {
    return c.fluid ? required("fluid bodies: " + c.fluids) : impossible("no fluid body");
}

Decision solid_in(const SceneContent& c) {
    return c.solid ? required("solid bodies: " + c.solids) : impossible("no solid body");
}

Decision hypoelastic_solid_in(const SceneContent& c) {
    return c.solid && !c.hypoelastic ? impossible("the solids are total Lagrangian") : solid_in(c);
}

Decision total_lagrangian_solid_in(const SceneContent& c) {
    return c.solid && !c.total_lagrangian ? impossible("the solids are hypoelastic") : solid_in(c);
}

Decision by_materials(const std::vector<std::string>& materials, std::string_view otherwise) {
    if (materials.size() < 2) return impossible(std::string(otherwise));
    return required(fmt::format("materials: {}", fmt::join(materials, ", ")));
}

Decision by_constant(const Decision& medium, std::string_view symbol, double value, double off_value) {
    if (medium.is_impossible()) return medium;
    std::string why = fmt::format("{} = {}", symbol, value);
    return value != off_value ? used(std::move(why)) : impossible(std::move(why));
}

}  // namespace sluice::rules
