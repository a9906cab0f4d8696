#include "engine/scene/place.hpp"

#include <fmt/format.h>

namespace sluice {

std::string describe_place(const Scene& scene, const Point& p) {
    if (scene.dimension == 2) return fmt::format("({:.6g}, {:.6g})", p[0], p[1]);
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", p[0], p[1], p[2]);
}

std::string describe_key(const Scene& scene, const std::string& key) {
    const auto found = scene.lines.find(key);
    if (found == scene.lines.end()) return key;
    return found->second == 0 ? key + " (set by --set)" : fmt::format("{} (line {})", key, found->second);
}

std::string spacing_key(const Scene& scene, const std::string& owner) {
    const std::string ratio = owner + ".spacing_ratio";
    if (scene.lines.contains(ratio)) return ratio;
    const std::string own = owner + ".spacing";
    return scene.lines.contains(own) ? own : "method.spacing";
}

}  // namespace sluice
