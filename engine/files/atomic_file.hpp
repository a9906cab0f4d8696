// Files that are either wholly there or not at all, and lines that are never torn.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace sluice {

/// Creates a folder and those above it. Throws OutputError.
void make_folder(const std::filesystem::path& folder);

/// Writes PATH.part, makes the disk take it, and renames it to PATH: a reader sees the old text or the new one, and a
/// full disk or a crash leaves the old one. Throws OutputError.
void write_atomically(const std::filesystem::path& path, std::string_view bytes);

/// Makes the disk keep the names in a folder: after a power failure a file that was renamed is there. Throws
/// OutputError.
void sync_folder(const std::filesystem::path& folder);

/// A text file that grows by whole lines. A line is one write(2) unless the disk takes less; one that does not fit is
/// taken back.
class LineFile {
  public:
    /// Starts an empty file. Throws OutputError.
    explicit LineFile(std::filesystem::path path);
    /// Goes on with a file after its first `size` bytes; what is behind them is cut off. Throws OutputError if there
    /// are fewer.
    LineFile(std::filesystem::path path, std::uint64_t size);
    ~LineFile();
    LineFile(const LineFile&) = delete;
    LineFile& operator=(const LineFile&) = delete;

    /// Adds a line; the end of line is added here. Throws OutputError.
    void append(std::string line);
    /// Makes the disk take what was written. Throws OutputError.
    void sync();
    /// Takes back what was appended beyond its first `size` bytes. Throws OutputError.
    void cut_back(std::uint64_t size);
    /// Of the whole lines. [bytes]
    std::uint64_t size() const { return static_cast<std::uint64_t>(size_); }

  private:
    std::filesystem::path path_;
    int file_ = -1;
    long long size_ = 0;  ///< of the whole lines [bytes]
};

}  // namespace sluice
