#include "engine/view/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "engine/base/errors.hpp"
#include "engine/view/run_json.hpp"

namespace sluice {
namespace {

std::optional<Scene> kept_scene(const std::filesystem::path& directory) {
    try {
        return load_scene((directory / "scene.toml").string());
    } catch (const SceneError&) {
        return std::nullopt;
    }
}

using GroupKey = std::pair<std::uint8_t, std::uint16_t>;

std::map<GroupKey, std::size_t> count_groups(const FrameTable& table) {
    std::map<GroupKey, std::size_t> counts;
    for (std::size_t i = 0; i < table.particles; ++i) ++counts[{table.medium[i], table.body[i]}];
    return counts;
}

/// As if the particles filled the box around them: right for a full tank, and large enough to be seen elsewhere.
double estimated_spacing(const FrameTable& table, int dimension) {
    double volume = 1;
    for (int k = 0; k < dimension; ++k) {
        float low = table.points[static_cast<std::size_t>(k)], high = low;
        for (std::size_t i = 0; i < table.particles; ++i) {
            const float x = table.points[3 * i + static_cast<std::size_t>(k)];
            low = std::min(low, x), high = std::max(high, x);
        }
        volume *= std::max(1e-6, static_cast<double>(high) - low);  // a layer of no thickness is none to divide by
    }
    return std::pow(volume / static_cast<double>(table.particles), 1.0 / dimension);
}

ParticleGroup numbered_group(const GroupKey& key, double spacing) {
    constexpr std::array<const char*, 3> media{"fluid", "solid", "wall"};
    const auto medium = std::min<std::size_t>(key.first, media.size() - 1);
    return {fmt::format("{} {}", media[medium], key.second), static_cast<FrameMedium>(medium), key.second, spacing};
}

ParticleGroup named_group(const GroupKey& key, const Scene& scene) {
    const auto medium = static_cast<FrameMedium>(key.first);
    const std::size_t k = key.second;
    if (medium == FrameMedium::wall && k < scene.walls.size())
        return {scene.walls[k].name, medium, key.second, scene.walls[k].spacing};
    if (medium != FrameMedium::wall && k < scene.bodies.size())
        return {scene.bodies[k].name, medium, key.second, scene.bodies[k].spacing};
    return numbered_group(key, scene.method.spacing);
}

Point against(const Point& gravity) {
    const double size = std::hypot(gravity[0], gravity[1], gravity[2]);
    if (!(size > 0)) return {0.0, 1.0, 0.0};
    return {-gravity[0] / size, -gravity[1] / size, -gravity[2] / size};
}

void take_scene(RunFolder& run, const Scene& scene) {
    run.title = scene.title;
    run.dimension = scene.dimension;
    run.up = against(scene.gravity);
    run.end = scene.output.end;
    for (const Wall& wall : scene.walls)
        if (wall.kind == WallKind::mirror) run.planes.push_back({wall.name, wall.point, wall.normal});
}

}  // namespace

std::vector<std::uint32_t> RunFolder::group_of(const FrameTable& table) const {
    std::map<GroupKey, std::uint32_t> index;
    for (std::size_t g = 0; g < groups.size(); ++g)
        index[{static_cast<std::uint8_t>(groups[g].medium), groups[g].body}] = static_cast<std::uint32_t>(g);
    std::vector<std::uint32_t> of(table.particles);
    for (std::size_t i = 0; i < table.particles; ++i) {
        const auto found = index.find({table.medium[i], table.body[i]});
        if (found != index.end()) of[i] = found->second;
    }
    return of;
}

RunFolder read_run_folder(const std::filesystem::path& directory, const FrameTable& first) {
    RunFolder run;
    run.directory = directory;
    run.title = std::filesystem::absolute(directory).lexically_normal().filename().string();
    const bool flat = std::none_of(first.points.begin(), first.points.end(),
                                   [k = 0](float x) mutable { return k++ % 3 == 2 && x != 0.0F; });
    run.dimension = flat ? 2 : 3;
    const std::optional<Scene> scene = kept_scene(directory);
    if (scene) take_scene(run, *scene);
    const SummaryFacts summary = read_summary(directory);
    run.status = summary.status;
    if (!summary.title.empty()) run.title = summary.title;
    run.end = summary.end_time.value_or(run.end);
    for (const auto& [key, count] : count_groups(first))
        run.groups.push_back(scene ? named_group(key, *scene)
                                   : numbered_group(key, estimated_spacing(first, run.dimension)));
    return run;
}

std::string run_status(const std::filesystem::path& directory) { return read_summary(directory).status; }

}  // namespace sluice
