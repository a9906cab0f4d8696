// Frames: one VTKHDF file per output time, and a series file that ParaView opens as an animation.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/files/background_writer.hpp"
#include "engine/run/output/frame_table.hpp"
#include "engine/simulation/simulation.hpp"

namespace sluice {

/// What a frame says about itself, in the group `sluice`.
struct FrameLabel {
    double time = 0;  ///< [s]
    std::uint64_t step = 0;
    std::string_view title;
};

/// Writes one frame, wholly or not at all. Throws OutputError.
void write_frame(const std::filesystem::path& file, const FrameTable& table, const FrameLabel& label);

/// Writes DIRECTORY/frames/frame_0000.hdf, frame_0001.hdf … and frames.hdf.series beside them, by way of a
/// BackgroundWriter.
template <int Dim>
class FrameWriter {
  public:
    /// Makes the folder and removes the frames of an earlier run, which would mix with ours. Throws OutputError.
    FrameWriter(const std::filesystem::path& directory, BackgroundWriter& writer);
    /// Goes on after the frames of these times [s]; later ones, which must all be written, are removed. Throws
    /// OutputError.
    FrameWriter(const std::filesystem::path& directory, const std::vector<double>& times, BackgroundWriter& writer);

    /// Adds a frame, to be written.
    void write(const Simulation<Dim>& simulation);

    std::size_t count() const { return frames_.size(); }
    std::vector<double> times() const;  ///< [s]
    /// Makes the disk keep what is to be written before.
    void sync();

  private:
    struct Frame {
        std::string name;
        double time;
    };
    std::string series() const;

    std::filesystem::path folder_;
    std::vector<Frame> frames_;
    BackgroundWriter& writer_;
};

extern template class FrameWriter<2>;
extern template class FrameWriter<3>;

}  // namespace sluice
