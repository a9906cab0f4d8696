// HDF5 files of our own, read back.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/files/hdf5_file.hpp"

namespace sluice {

/// A group of a file that is read. All of it throws CheckpointError for what is missing or of another type.
class Hdf5Source {
  public:
    /// The root of a file, which stays open as long as a group of it is.
    static Hdf5Source open(const std::filesystem::path& file);

    /// The root of a file that is being made in memory.
    explicit Hdf5Source(const Hdf5File& file);

    Hdf5Source group(const std::string& name) const;
    /// Whether there is a group or a dataset of this name.
    bool has(const std::string& name) const;

    /// Of groups and datasets, in the order of their spelling.
    std::vector<std::string> names() const;

    /// Values in a dataset.
    std::size_t count(const std::string& name) const;
    /// Of each value in a dataset.
    std::size_t value_bytes(const std::string& name) const;
    /// Fills `values` from a dataset of as many.
    template <class T>
    void read(const std::string& name, std::span<T> values) const {
        const Hdf5Handle type = memory_type<T>();
        read_dataset(name, type.get(), values.data(), values.size());
    }
    template <class T>
    T attribute(const std::string& name) const {
        // A byte that is neither 0 nor 1 makes no bool.
        std::conditional_t<std::is_same_v<T, bool>, std::uint8_t, T> value{};
        static_assert(sizeof value == sizeof(T));
        read_attribute(name, hdf5_type<T>(), &value);
        return static_cast<T>(value);
    }

  private:
    explicit Hdf5Source(Hdf5Handle handle) : handle_(std::move(handle)) {}
    Hdf5Handle dataset(const std::string& name) const;
    void read_dataset(const std::string& name, hid_t type, void* values, std::size_t count) const;
    void read_attribute(const std::string& name, hid_t type, void* value) const;

    Hdf5Handle handle_;
};

}  // namespace sluice
