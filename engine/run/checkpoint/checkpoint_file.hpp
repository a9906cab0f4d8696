// One checkpoint: all that a run needs to go on, in one HDF5 file.
//
// The file starts with a block of text, HDF5's "user block", which states the format, the number of bytes behind it and
// their CRC-32. It is read first and must be right to the last byte, so that the HDF5 library never sees a damaged
// file.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "engine/files/state_visitors.hpp"
#include "engine/run/checkpoint/checkpoint_label.hpp"

namespace sluice {

/// A checkpoint in memory: a state to go back to, or to write to a file.
class CheckpointImage {
  public:
    /// `fill` says what goes in.
    explicit CheckpointImage(const std::function<void(const StateWriter&)>& fill);

    StateReader reader() const;
    /// What it takes in memory.
    std::size_t bytes() { return hdf_.image().size(); }
    /// Writes a file, wholly or not at all, and makes the disk keep it. Throws OutputError.
    void write(const std::filesystem::path& file);

  private:
    Hdf5File hdf_;
};

/// The same at once.
void write_checkpoint(const std::filesystem::path& file, const std::function<void(const StateWriter&)>& fill);

/// Why a file is no checkpoint that can be read; empty if it is one.
std::string checkpoint_problem(const std::filesystem::path& file);

/// A file without a problem. Throws CheckpointError.
StateReader open_checkpoint(const std::filesystem::path& file);
CheckpointLabel read_label(const std::filesystem::path& file);

}  // namespace sluice
