#include "engine/files/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "engine/base/errors.hpp"

namespace sluice {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (folder_ < 0)
        throw OutputError(
            fmt::format("{}: cannot open the folder: {}", folder.string(), std::generic_category().message(errno)));
    if (::flock(folder_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;  // not every file system has locks
    ::close(folder_);
    throw OutputError(
        fmt::format("{}: another run writes into this folder; wait for its end, or choose another folder "
                    "with -o",
                    folder.string()));
}

FolderLock::~FolderLock() { ::close(folder_); }

}  // namespace sluice
