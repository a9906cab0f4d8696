#include "engine/scene/scene.hpp"

#include <fmt/format.h>

#include "engine/scene/excerpt.hpp"

namespace sluice {
namespace {

/// The table or array that holds a key: "a.b[1]" → "a.b" → "a" → "".
std::string parent_of(const std::string& key) {
    const std::size_t end = key.find_last_of(".[");
    return end == std::string::npos ? "" : key.substr(0, end);
}

}  // namespace

void Scene::fail(const std::string& key, const std::string& message) const {
    // A key that the file leaves out is reported at the table it belongs in, a table at the file's first line.
    std::string known = key;
    while (!known.empty() && !lines.contains(known)) known = parent_of(known);
    const int line = known.empty() ? 1 : lines.at(known);
    // Keys and names may hold anything, and the text of an exception ends at a zero byte.
    constexpr std::size_t longest = 4000;
    const std::string shown_key = excerpt(key), shown = excerpt(message, longest);
    if (line == 0) throw SceneError(fmt::format("{}: --set {}: {}", file, shown_key, shown));
    throw SceneError(fmt::format("{}:{}: {}: {}", file, line, shown_key, shown));
}

}  // namespace sluice
