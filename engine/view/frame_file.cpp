#include "engine/view/frame_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/errors.hpp"
#include "engine/files/hdf5_reader.hpp"
#include "engine/view/run_json.hpp"

namespace sluice {
namespace {

/// What a run writes as a field's name; anything else in a file is not ours, and is left alone.
bool is_plain_name(const std::string& name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    });
}

template <class T>
std::vector<T> column(const Hdf5Source& group, const std::string& name, std::size_t count) {
    std::vector<T> values(count);
    group.read<T>(name, values);
    return values;
}

/// In 32 bits or in 64.
std::vector<std::uint64_t> ids(const Hdf5Source& data, std::size_t count) {
    if (data.value_bytes("id") == sizeof(std::uint64_t)) return column<std::uint64_t>(data, "id", count);
    const std::vector<std::uint32_t> narrow = column<std::uint32_t>(data, "id", count);
    return {narrow.begin(), narrow.end()};
}

FrameScalar speed_of(const std::vector<float>& velocity) {
    FrameScalar speed{"speed", {}};
    for (std::size_t i = 0; i + 2 < velocity.size(); i += 3)
        speed.value.push_back(std::hypot(velocity[i], velocity[i + 1], velocity[i + 2]));
    return speed;
}

FrameTable read_table(const Hdf5Source& vtk) {
    FrameTable table;
    const Hdf5Source data = vtk.group("PointData");
    const std::size_t n = table.particles = vtk.count("Points") / 3;
    table.points = column<float>(vtk, "Points", 3 * n);
    table.velocity = column<float>(data, "velocity", 3 * n);
    table.medium = column<std::uint8_t>(data, "phase", n);
    table.body = column<std::uint16_t>(data, "body", n);
    table.id = ids(data, n);
    table.scalars.push_back(speed_of(table.velocity));
    for (const std::string& name : data.names()) {
        const bool read = name == "velocity" || name == "phase" || name == "body" || name == "id";
        if (!read && is_plain_name(name) && data.count(name) == n)
            table.scalars.push_back({name, column<float>(data, name, n)});
    }
    return table;
}

}  // namespace

std::vector<FrameFile> list_frames(const std::filesystem::path& directory) {
    if (!std::filesystem::is_directory(directory))
        throw RunReadError(fmt::format("{}: no such folder, expected the results of `sluice run`", directory.string()));
    const std::filesystem::path series = directory / "frames" / "frames.hdf.series";
    std::vector<FrameFile> frames;
    if (std::filesystem::exists(series)) frames = read_series(series);
    if (!frames.empty()) return frames;
    const bool is_run = std::filesystem::exists(directory / "summary.json");
    throw RunReadError(fmt::format(
        "{}: holds no frames: {}", directory.string(),
        is_run ? "the run has written none yet, or its scene has none in [output]" : "it is not the folder of a run"));
}

StoredFrame read_frame(const FrameFile& file) {
    if (!std::filesystem::exists(file.path)) throw RunReadError(file.path.string() + ": is missing");
    try {
        const Hdf5Source root = Hdf5Source::open(file.path);
        const Hdf5Source label = root.group("sluice");
        return {label.attribute<double>("time"), label.attribute<std::uint64_t>("step"),
                read_table(root.group("VTKHDF"))};
    } catch (const CheckpointError&) {
        throw RunReadError(file.path.string() + ": cannot be read as a frame: it is cut short or damaged");
    }
}

}  // namespace sluice
