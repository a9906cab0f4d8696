#include "engine/scene/describe.hpp"

#include <fmt/format.h>

#include "engine/scene/table/excerpt.hpp"

namespace sluice {
namespace {

/// The table or array that holds a key: "a.b[1]" → "a.b" → "a" → "".
std::string parent_of(const std::string& key) {
    const std::size_t end = key.find_last_of(".[");
    return end == std::string::npos ? "" : key.substr(0, end);
}

}  // namespace

std::string describe_place(const Scene& scene, const Point& p) {
    if (scene.dimension == 2) return fmt::format("({:.6g}, {:.6g})", p[0], p[1]);
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", p[0], p[1], p[2]);
}

std::string describe_key(const Scene& scene, const std::string& key) {
    const auto found = scene.lines.find(key);
    if (found == scene.lines.end()) return key;
    return found->second == 0 ? key + " (set by --set)" : fmt::format("{} (line {})", key, found->second);
}

std::string located(const Scene& scene, const std::string& key, const std::string& message) {
    // A key that the file leaves out is reported at the table it belongs in, a table at the file's first line.
    std::string known = key;
    while (!known.empty() && !scene.lines.contains(known)) known = parent_of(known);
    const int line = known.empty() ? 1 : scene.lines.at(known);
    // Keys and names may hold anything, and the text of an exception ends at a zero byte.
    constexpr std::size_t longest = 4000;
    const std::string shown_key = excerpt(key), shown = excerpt(message, longest);
    if (line == 0) return fmt::format("{}: --set {}: {}", scene.file, shown_key, shown);
    return fmt::format("{}:{}: {}: {}", scene.file, line, shown_key, shown);
}

std::string spacing_key(const Scene& scene, const std::string& owner) {
    const std::string ratio = owner + ".spacing_ratio";
    if (scene.lines.contains(ratio)) return ratio;
    const std::string own = owner + ".spacing";
    return scene.lines.contains(own) ? own : "method.spacing";
}

}  // namespace sluice
