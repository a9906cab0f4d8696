#include "engine/run/checkpoint/checkpoint_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "engine/base/errors.hpp"
#include "engine/files/atomic_file.hpp"

namespace sluice {
namespace {

/// The one before is for the case that the disk spoils the last.
constexpr std::size_t checkpoints_kept = 2;

std::filesystem::path folder_of(const std::filesystem::path& directory) { return directory / "checkpoints"; }

/// step_0000012345.h5; also its unfinished twin step_0000012345.h5.part, if that is asked for.
bool is_checkpoint(const std::filesystem::path& file, bool unfinished_too) {
    const std::string name = file.filename().string();
    return name.starts_with("step_") && (name.ends_with(".h5") || (unfinished_too && name.ends_with(".h5.part")));
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder, bool unfinished_too) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (std::filesystem::directory_iterator file(folder, error), end; !error && file != end; file.increment(error))
        if (is_checkpoint(file->path(), unfinished_too)) files.push_back(file->path());
    return files;
}

}  // namespace

std::vector<std::filesystem::path> checkpoints_in(const std::filesystem::path& directory) {
    std::vector<std::filesystem::path> files = files_in(folder_of(directory), false);
    std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.filename() > b.filename(); });
    return files;
}

CheckpointStore::CheckpointStore(const std::filesystem::path& directory) : folder_(folder_of(directory)) {
    remove_others();
}

CheckpointStore::CheckpointStore(const std::filesystem::path& directory, const std::filesystem::path& resumed_from)
    : folder_(folder_of(directory)), kept_{resumed_from} {}

void CheckpointStore::write(std::uint64_t step, CheckpointImage& image) {
    make_folder(folder_);
    const std::filesystem::path file = folder_ / fmt::format("step_{:010}.h5", step);
    image.write(file);
    std::erase(kept_, file);
    kept_.push_back(file);
    if (kept_.size() > checkpoints_kept) kept_.erase(kept_.begin());
    remove_others();
}

void CheckpointStore::remove_others() const {
    for (const std::filesystem::path& file : files_in(folder_, true)) {
        if (std::find(kept_.begin(), kept_.end(), file) != kept_.end()) continue;
        std::error_code error;
        std::filesystem::remove(file, error);
        if (error)
            throw OutputError(fmt::format("{}: cannot remove an old checkpoint: {}", file.string(), error.message()));
    }
}

}  // namespace sluice
