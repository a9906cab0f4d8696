// What a run's folder says about the run, besides its frames.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "engine/scene/scene.hpp"
#include "engine/view/frame_file.hpp"

namespace sluice {

/// Particles that are shown and hidden together: those of one body, or of one wall.
struct ParticleGroup {
    std::string name;
    FrameMedium medium = FrameMedium::fluid;
    std::uint16_t body = 0;  ///< as in FrameTable
    double spacing = 0;      ///< of its particles [m]
};

/// A mirror wall.
struct WallPlane {
    std::string name;
    Point point{}, normal{};
};

struct RunFolder {
    std::filesystem::path directory;
    std::string title;
    std::string status;  ///< as in summary.json; empty without one
    int dimension = 2;
    double end = 0;           ///< simulated time that the run is to reach [s]; 0 = not known
    Point up{0.0, 1.0, 0.0};  ///< against gravity
    std::vector<ParticleGroup> groups;
    std::vector<WallPlane> planes;

    /// Index into `groups` of each particle; 0 for one of no group.
    std::vector<std::uint32_t> group_of(const FrameTable& table) const;
};

/// Names and spacings come from the scene that the run keeps; `first` is its first frame: a run without its scene is
/// shown too, its bodies numbered and their spacing estimated. Throws RunReadError.
RunFolder read_run_folder(const std::filesystem::path& directory, const FrameTable& first);

/// `status` of summary.json as it is now; empty if there is none.
std::string run_status(const std::filesystem::path& directory);

}  // namespace sluice
