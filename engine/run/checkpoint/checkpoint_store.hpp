// The checkpoints of a run: DIRECTORY/checkpoints/step_0000012345.h5, of which the last two are kept.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "engine/run/checkpoint/checkpoint_file.hpp"

namespace sluice {

/// Those in the folder of a run, the newest first. None if there is no such folder.
std::vector<std::filesystem::path> checkpoints_in(const std::filesystem::path& directory);

class CheckpointStore {
  public:
    /// Of a new run: the checkpoints of an earlier one, which would mix with ours, are removed. Throws OutputError.
    explicit CheckpointStore(const std::filesystem::path& directory);
    /// Of a run that goes on from a checkpoint: that one stays until there are two newer ones.
    CheckpointStore(const std::filesystem::path& directory, const std::filesystem::path& resumed_from);

    /// Writes a checkpoint, then removes all but it and the good one before. Throws OutputError; the old ones stay
    /// then.
    void write(std::uint64_t step, CheckpointImage& image);
    void write(std::uint64_t step, const std::function<void(const StateWriter&)>& fill) {
        CheckpointImage image(fill);
        write(step, image);
    }

  private:
    void remove_others() const;

    std::filesystem::path folder_;
    std::vector<std::filesystem::path> kept_;
};

}  // namespace sluice
