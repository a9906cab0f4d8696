#include "engine/files/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "engine/base/errors.hpp"

namespace sluice {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view deed, int error) {
    throw OutputError(fmt::format("{}: cannot {}: {}", path.string(), deed, std::generic_category().message(error)));
}

/// A descriptor that closes itself.
class Descriptor {
  public:
    explicit Descriptor(int file) : file_(file) {}
    ~Descriptor() {
        if (file_ >= 0) ::close(file_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int get() const { return file_; }
    int release() { return std::exchange(file_, -1); }
    /// The answer of close(2): network file systems report a full disk only there.
    int close() { return ::close(std::exchange(file_, -1)); }

  private:
    int file_;
};

/// 0, or the error.
int write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t n = ::write(file, bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) return errno;
        if (n == 0) return ENOSPC;
        bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    return 0;
}

/// Waits until the disk has a file. 0, or the error.
int sync(int file) {
    while (::fsync(file) != 0) {
        if (errno == EINTR) continue;
        return errno == EINVAL ? 0 : errno;  // a file system that cannot sync; the bytes are handed over all the same
    }
    return 0;
}

/// Writes a file and waits until the disk has it. 0, or the error.
int write_and_sync(const std::filesystem::path& path, std::string_view bytes) {
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (file.get() < 0) return errno;
    if (const int error = write_all(file.get(), bytes)) return error;
    if (const int error = sync(file.get())) return error;
    return file.close() == 0 ? 0 : errno;
}

}  // namespace

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) fail(folder, "create the folder", error.value());
    if (!std::filesystem::is_directory(folder)) fail(folder, "create the folder", ENOTDIR);
}

void write_atomically(const std::filesystem::path& path, std::string_view bytes) {
    std::filesystem::path part = path;
    part += ".part";
    if (const int error = write_and_sync(part, bytes)) {
        ::unlink(part.c_str());
        fail(path, "write", error);
    }
    if (::rename(part.c_str(), path.c_str()) != 0) {
        const int error = errno;
        ::unlink(part.c_str());
        fail(path, "rename the finished file", error);
    }
}

void sync_folder(const std::filesystem::path& folder) {
    Descriptor file(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (file.get() < 0) fail(folder, "open the folder", errno);
    if (const int error = sluice::sync(file.get())) fail(folder, "write the folder", error);
}

LineFile::LineFile(std::filesystem::path path) : path_(std::move(path)) {
    file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666);
    if (file_ < 0) fail(path_, "create", errno);
}

LineFile::LineFile(std::filesystem::path path, std::uint64_t size)
    : path_(std::move(path)), size_(static_cast<long long>(size)) {
    Descriptor file(::open(path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
    if (file.get() < 0) fail(path_, "open", errno);
    const long long found = ::lseek(file.get(), 0, SEEK_END);
    if (found < size_)
        throw OutputError(fmt::format("{}: cannot go on after its first {} bytes: found only {}", path_.string(), size_,
                                      std::max(found, 0LL)));
    if (::ftruncate(file.get(), size_) != 0) fail(path_, "cut", errno);
    file_ = file.release();
}

LineFile::~LineFile() { ::close(file_); }

void LineFile::sync() {
    if (const int error = sluice::sync(file_)) fail(path_, "write", error);
}

void LineFile::cut_back(std::uint64_t size) {
    const long long kept = std::min(size_, static_cast<long long>(size));
    if (::ftruncate(file_, kept) != 0) fail(path_, "cut", errno);
    size_ = kept;
}

void LineFile::append(std::string line) {
    line += '\n';
    const int error = write_all(file_, line);
    if (error == 0) {
        size_ += static_cast<long long>(line.size());
        return;
    }
    // The line counts only as a whole. A device that cannot be cut has nothing to take back.
    [[maybe_unused]] const int cut = ::ftruncate(file_, size_);
    fail(path_, "write", error);
}

}  // namespace sluice
