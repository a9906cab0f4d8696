#include <fmt/format.h>

#include "engine/scene/templates/scene_templates.hpp"

namespace sluice {
namespace {

constexpr std::string_view comment = "# ", cost_mark = "# Cost: ";

/// The first line that starts so, without what it starts with.
std::string_view line_after(std::string_view text, std::string_view start) {
    while (!text.starts_with(start)) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) return {};
        text.remove_prefix(end + 1);
    }
    text.remove_prefix(start.size());
    return text.substr(0, text.find('\n'));
}

}  // namespace

std::string_view SceneTemplate::summary() const { return line_after(text, comment); }
std::string_view SceneTemplate::cost() const { return line_after(text, cost_mark); }

std::string template_list() {
    std::string list;
    for (const SceneTemplate& scene : scene_templates())
        list += fmt::format("{:<15}{}\n{:<15}{}\n", scene.name, scene.summary(), "", scene.cost());
    return list;
}

}  // namespace sluice
