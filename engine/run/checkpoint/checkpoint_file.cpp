#include "engine/run/checkpoint/checkpoint_file.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <vector>

#include "engine/files/atomic_file.hpp"

namespace sluice {
namespace {

/// To be raised whenever what is in a checkpoint changes.
constexpr int format_version = 3;
/// The least that HDF5 allows.
constexpr std::size_t header_size = 512;

/// CRC-32 (IEEE 802.3) of text that comes in pieces: finds every burst of up to 32 bits, and misses one in 2³² others.
class Checksum {
  public:
    void add(std::string_view bytes) {
        sum_ = ::crc32_z(sum_, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
        size_ += bytes.size();
    }
    /// The block in front of the bytes that were added.
    std::string header() const {
        std::string text =
            fmt::format("sluice checkpoint\nformat {}\nbytes {}\ncrc32 {:08x}\n", format_version, size_, sum_);
        text.resize(header_size, '\0');
        return text;
    }

  private:
    uLong sum_ = ::crc32_z(0, nullptr, 0);
    std::size_t size_ = 0;
};

std::string first_lines(const std::string& header) { return header.substr(0, header.find("\nbytes")); }

}  // namespace

CheckpointImage::CheckpointImage(const std::function<void(const StateWriter&)>& fill) : hdf_(header_size) {
    fill(StateWriter(hdf_.root()));
}

StateReader CheckpointImage::reader() const { return StateReader(Hdf5Source(hdf_)); }

void CheckpointImage::write(const std::filesystem::path& file) {
    const std::span<char> image = hdf_.image();
    const std::string_view bytes(image.data(), image.size());
    Checksum checksum;
    checksum.add(bytes.substr(header_size));
    const std::string header = checksum.header();
    std::copy(header.begin(), header.end(), image.begin());
    write_atomically(file, bytes);
    sync_folder(file.parent_path());
}

void write_checkpoint(const std::filesystem::path& file, const std::function<void(const StateWriter&)>& fill) {
    CheckpointImage(fill).write(file);
}

std::string checkpoint_problem(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return "cannot be read: " + std::generic_category().message(errno);
    std::string header(header_size, '\0');
    stream.read(header.data(), static_cast<std::streamsize>(header_size));
    if (static_cast<std::size_t>(stream.gcount()) != header_size) return "is damaged: it is cut short";
    Checksum checksum;
    std::vector<char> piece(1 << 20);
    while (stream) {
        stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
        checksum.add({piece.data(), static_cast<std::size_t>(stream.gcount())});
    }
    if (stream.bad()) return "cannot be read: " + std::generic_category().message(errno);
    const std::string expected = checksum.header();
    if (header == expected) return "";
    if (first_lines(header) != first_lines(expected))
        return fmt::format("is damaged, or none of this program's format {}", format_version);
    return "is damaged: size or checksum do not match";
}

StateReader open_checkpoint(const std::filesystem::path& file) {
    const std::string problem = checkpoint_problem(file);
    if (!problem.empty()) throw CheckpointError(fmt::format("{}: {}", file.string(), problem));
    return StateReader(Hdf5Source::open(file));
}

CheckpointLabel read_label(const std::filesystem::path& file) {
    CheckpointLabel label;
    open_checkpoint(file)("label", label);
    return label;
}

}  // namespace sluice
