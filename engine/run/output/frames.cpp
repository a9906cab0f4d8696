#include "engine/run/output/frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <numeric>
#include <system_error>

#include "engine/base/errors.hpp"
#include "engine/base/version.hpp"
#include "engine/files/atomic_file.hpp"
#include "engine/files/hdf5_file.hpp"

namespace sluice {
namespace {

/// VTK_VERTEX: each particle is a cell of one point.
constexpr std::uint8_t vertex_cell = 1;
constexpr std::string_view series_name = "frames.hdf.series";

template <class T>
std::span<const T> view(const std::vector<T>& values) {
    return values;
}

void write_counts_and_cells(const Hdf5Group& vtk, std::size_t particles) {
    const auto n = static_cast<std::int64_t>(particles);
    const std::array<std::int64_t, 1> count{n};
    for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"})
        vtk.dataset<std::int64_t>(name, count);
    std::vector<std::int64_t> offsets(particles + 1);
    std::iota(offsets.begin(), offsets.end(), std::int64_t{0});
    vtk.dataset<std::int64_t>("Connectivity", view(offsets).first(particles));
    vtk.dataset<std::int64_t>("Offsets", offsets);
    vtk.dataset<std::uint8_t>("Types", std::vector<std::uint8_t>(particles, vertex_cell));
}

/// In 32 bits as long as they fit, which is what most readers expect.
void write_ids(const Hdf5Group& data, const std::vector<std::uint64_t>& id) {
    const bool fit = std::all_of(id.begin(), id.end(), [](std::uint64_t n) { return n <= UINT32_MAX; });
    if (fit)
        data.dataset<std::uint32_t>("id", std::vector<std::uint32_t>(id.begin(), id.end()));
    else
        data.dataset<std::uint64_t>("id", id);
}

void write_point_data(const Hdf5Group& data, const FrameTable& table) {
    data.dataset<float>("velocity", table.velocity, 3);
    for (const FrameScalar& scalar : table.scalars) data.dataset<float>(scalar.name, scalar.value);
    data.dataset<std::uint8_t>("phase", table.medium);
    data.dataset<std::uint16_t>("body", table.body);
    write_ids(data, table.id);
}

void write_label(const Hdf5Group& group, const FrameLabel& label) {
    group.attribute("time", label.time);
    group.attribute("step", label.step);
    group.attribute("title", label.title);
    group.attribute("version", program_version());
}

/// frame_0000.hdf and its unfinished twin frame_0000.hdf.part
bool is_frame(const std::filesystem::path& file) {
    const std::string name = file.filename().string();
    return name.starts_with("frame_") && (name.ends_with(".hdf") || name.ends_with(".hdf.part"));
}

std::string frame_name(std::size_t number) { return fmt::format("frame_{:04}.hdf", number); }

/// The series goes first: while frames are missing, no list should name them.
void remove_frames(const std::filesystem::path& folder, const std::vector<std::string>& kept) {
    std::error_code error;
    std::vector<std::filesystem::path> old;
    if (std::filesystem::exists(folder / series_name, error)) old.push_back(folder / series_name);
    for (std::filesystem::directory_iterator file(folder, error), end; !error && file != end; file.increment(error))
        if (is_frame(file->path()) &&
            std::find(kept.begin(), kept.end(), file->path().filename().string()) == kept.end())
            old.push_back(file->path());
    for (const auto& file : old)
        if (!error) std::filesystem::remove(file, error);
    if (error) throw OutputError(fmt::format("{}: cannot remove old frames: {}", folder.string(), error.message()));
}

}  // namespace

void write_frame(const std::filesystem::path& file, const FrameTable& table, const FrameLabel& label) {
    Hdf5File hdf;
    {
        const Hdf5Group root = hdf.root();
        const Hdf5Group vtk = root.group("VTKHDF");
        constexpr std::array<std::int64_t, 2> layout_version{1, 0};
        vtk.attribute<std::int64_t>("Version", layout_version);
        vtk.attribute("Type", "UnstructuredGrid");
        write_counts_and_cells(vtk, table.particles);
        vtk.dataset<float>("Points", table.points, 3);
        write_point_data(vtk.group("PointData"), table);
        write_label(root.group("sluice"), label);
    }
    write_atomically(file, hdf.bytes());
}

template <int Dim>
FrameWriter<Dim>::FrameWriter(const std::filesystem::path& directory, BackgroundWriter& writer)
    : folder_(directory / "frames"), writer_(writer) {
    make_folder(folder_);
    remove_frames(folder_, {});
}

template <int Dim>
FrameWriter<Dim>::FrameWriter(const std::filesystem::path& directory, const std::vector<double>& times,
                              BackgroundWriter& writer)
    : folder_(directory / "frames"), writer_(writer) {
    make_folder(folder_);
    std::vector<std::string> kept;
    for (const double time : times) {
        kept.push_back(frame_name(frames_.size()));
        frames_.push_back({kept.back(), time});
    }
    remove_frames(folder_, kept);
    write_atomically(folder_ / series_name, series());
}

template <int Dim>
std::vector<double> FrameWriter<Dim>::times() const {
    std::vector<double> times;
    for (const Frame& frame : frames_) times.push_back(frame.time);
    return times;
}

template <int Dim>
void FrameWriter<Dim>::sync() {
    writer_.add(0, [folder = folder_] { sync_folder(folder); });
}

template <int Dim>
void FrameWriter<Dim>::write(const Simulation<Dim>& simulation) {
    frames_.push_back({frame_name(frames_.size()), simulation.time()});
    FrameTable table = frame_table(simulation.fluid(), simulation.solid(), simulation.wall(),
                                   simulation.solid_materials(), simulation.hyperelastic());
    const std::size_t bytes = bytes_of(table);
    const FrameLabel label{simulation.time(), simulation.work().steps, simulation.scene().title};
    writer_.add(bytes,
                [folder = folder_, name = frames_.back().name, table = std::move(table), label, series = series()] {
                    write_frame(folder / name, table, label);
                    write_atomically(folder / series_name, series);
                });
}

template <int Dim>
std::string FrameWriter<Dim>::series() const {
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const Frame& frame : frames_) files.push_back({{"name", frame.name}, {"time", frame.time}});
    const nlohmann::ordered_json series{{"file-series-version", "1.0"}, {"files", files}};
    return series.dump(1) + "\n";
}

template class FrameWriter<2>;
template class FrameWriter<3>;

}  // namespace sluice
