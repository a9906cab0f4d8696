#pragma once

#include <filesystem>

namespace sluice {

/// One run at a time in a folder. Held as long as it lives, and no longer if the process is killed; leaves nothing in
/// the folder.
class FolderLock {
  public:
    /// Throws OutputError if another process holds it, or the folder cannot be opened.
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

  private:
    int folder_ = -1;
};

}  // namespace sluice
