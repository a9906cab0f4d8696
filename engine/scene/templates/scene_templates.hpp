// Commented scenes to start from.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace sluice {

/// Its first lines are comments: the schema's place, what happens, and what a run costs.
struct SceneTemplate {
    std::string_view name;
    std::string_view text;

    std::string_view summary() const;
    std::string_view cost() const;
};

std::span<const SceneTemplate> scene_templates();

/// The file beside a scene in which editors look for the schema: what `#:schema` in the templates names.
inline constexpr std::string_view schema_file = "sluice.schema.json";

/// A line for each: name, what happens, what it costs.
std::string template_list();

}  // namespace sluice
