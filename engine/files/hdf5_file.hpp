// HDF5 files, built in memory through the C API: the disk is touched in one place only (atomic_file), where a full disk
// is an ordinary error. (The library itself does not survive one: it tries to flush again when the program ends.)
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace sluice {

/// An HDF5 identifier that closes itself.
class Hdf5Handle {
  public:
    using Close = herr_t (*)(hid_t);
    /// `id` as the library returned it. Throws OutputError if that was an error; `what` was being done.
    Hdf5Handle(hid_t id, Close close, std::string_view what);
    ~Hdf5Handle() {
        if (id_ >= 0) close_(id_);
    }
    Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
    Hdf5Handle& operator=(Hdf5Handle&&) = delete;
    hid_t get() const { return id_; }

  private:
    hid_t id_;
    Close close_;
};

/// The library's name for a C++ number type.
template <class T>
hid_t hdf5_type();

/// The type of a value as the memory has it: a number type, else an opaque one of the value's size. Throws OutputError.
Hdf5Handle copied_type(hid_t number);
Hdf5Handle opaque_type(std::size_t bytes);
template <class T>
Hdf5Handle memory_type() {
    static_assert(std::is_trivially_copyable_v<T>);
    if constexpr (std::is_arithmetic_v<T>)
        return copied_type(hdf5_type<T>());
    else
        return opaque_type(sizeof(T));
}

/// A group: takes attributes, datasets and further groups.
class Hdf5Group {
  public:
    explicit Hdf5Group(Hdf5Handle handle) : handle_(std::move(handle)) {}

    Hdf5Group group(const std::string& name) const;

    /// A table of `values.size() / columns` rows; one column makes a one-dimensional dataset.
    template <class T>
    void dataset(const std::string& name, std::span<const T> values, std::size_t columns = 1) const {
        write_dataset(name, {hdf5_type<T>(), values.data(), values.size()}, columns);
    }
    /// As the memory has it: in one piece, not compressed. Values that are no numbers keep their bytes.
    template <class T>
    void plain_dataset(const std::string& name, std::span<const T> values) const {
        const Hdf5Handle type = memory_type<T>();
        write_plain(name, {type.get(), values.data(), values.size()});
    }
    /// A string of fixed length, ASCII if it can be: the only kind that VTK accepts.
    void attribute(const std::string& name, std::string_view text) const;
    /// A list of numbers.
    template <class T>
    void attribute(const std::string& name, std::span<const T> values) const {
        write_attribute(name, {hdf5_type<T>(), values.data(), values.size()});
    }
    /// One number.
    template <class T>
    requires(!std::is_convertible_v<T, std::string_view>) void attribute(const std::string& name, T value) const {
        write_attribute(name, {hdf5_type<T>(), &value, 0});
    }

  private:
    struct Values {
        hid_t type;
        const void* data;
        std::size_t count;  ///< 0: one number without a dimension
    };
    void write_dataset(const std::string& name, Values values, std::size_t columns) const;
    void write_plain(const std::string& name, Values values) const;
    void write_attribute(const std::string& name, Values values) const;

    Hdf5Handle handle_;
};

/// A file under construction. Equal content gives equal bytes: no times are stored.
class Hdf5File {
  public:
    /// user_block: bytes in front that are left to the caller; 0, or a power of two from 512.
    explicit Hdf5File(std::size_t user_block = 0);
    Hdf5Group root() const { return Hdf5Group(open_root()); }
    Hdf5Handle open_root() const;
    /// Whether the library may be used by several threads at once, each with a file of its own.
    static bool is_thread_safe();
    /// The file's content so far; groups should be closed by then.
    std::string bytes() const;
    /// The same in place, with the user block in front, which may be written to. Valid until the file changes or goes.
    std::span<char> image();

  private:
    Hdf5Handle file_;
    std::size_t user_block_;
};

}  // namespace sluice
