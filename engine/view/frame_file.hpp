// Frames of a run, read back from its folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "engine/run/output/frame_table.hpp"

namespace sluice {

struct FrameFile {
    std::filesystem::path path;
    double time = 0;  ///< [s]
};

struct StoredFrame {
    double time = 0;  ///< [s]
    std::uint64_t step = 0;
    /// As it was written, and one scalar more in front: `speed`, the velocity's magnitude.
    FrameTable table;
};

/// The frames that the series file of a run's folder names, in the order of time. Throws RunReadError if there is no
/// such folder, or none that a run writes frames into.
std::vector<FrameFile> list_frames(const std::filesystem::path& directory);

/// Throws RunReadError for a file that is missing, cut short, or no frame.
StoredFrame read_frame(const FrameFile& file);

}  // namespace sluice
