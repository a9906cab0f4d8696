#include "engine/files/hdf5_reader.hpp"

#include <fmt/format.h>

#include "engine/base/errors.hpp"

namespace sluice {
namespace {

/// More than any memory holds, so that sizes in bytes stay numbers.
constexpr hssize_t most_values = hssize_t{1} << 48;

void check(bool fine, std::string_view problem, const std::string& name) {
    if (!fine) throw CheckpointError(fmt::format("the checkpoint does not fit: {} {}", problem, name));
}

/// What the library returned, if it could.
Hdf5Handle opened(hid_t id, Hdf5Handle::Close close, const std::string& name) {
    check(id >= 0, "it lacks", name);
    return {id, close, name};
}

}  // namespace

Hdf5Source Hdf5Source::open(const std::filesystem::path& file) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    const Hdf5Handle opened_file = opened(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, file.string());
    return Hdf5Source(opened(H5Gopen2(opened_file.get(), "/", H5P_DEFAULT), H5Gclose, "the root group"));
}

Hdf5Source::Hdf5Source(const Hdf5File& file) : handle_(file.open_root()) {}

Hdf5Source Hdf5Source::group(const std::string& name) const {
    return Hdf5Source(opened(H5Gopen2(handle_.get(), name.c_str(), H5P_DEFAULT), H5Gclose, name));
}

bool Hdf5Source::has(const std::string& name) const { return H5Lexists(handle_.get(), name.c_str(), H5P_DEFAULT) > 0; }

std::vector<std::string> Hdf5Source::names() const {
    std::vector<std::string> all;
    const auto add = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
        static_cast<std::vector<std::string>*>(list)->emplace_back(name);
        return 0;
    };
    check(H5Literate(handle_.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &all) >= 0, "it does not list", "names");
    return all;
}

Hdf5Handle Hdf5Source::dataset(const std::string& name) const {
    return opened(H5Dopen2(handle_.get(), name.c_str(), H5P_DEFAULT), H5Dclose, name);
}

std::size_t Hdf5Source::count(const std::string& name) const {
    const Hdf5Handle set = dataset(name);
    const Hdf5Handle space = opened(H5Dget_space(set.get()), H5Sclose, name);
    const hssize_t n = H5Sget_simple_extent_npoints(space.get());
    check(n >= 0, "it has no size for", name);
    // A size that no bytes stand behind must not be believed. (Of those in chunks, which are compressed, some.)
    const Hdf5Handle type = opened(H5Dget_type(set.get()), H5Tclose, name);
    const Hdf5Handle made = opened(H5Dget_create_plist(set.get()), H5Pclose, name);
    const bool in_one_piece = H5Pget_layout(made.get()) == H5D_CONTIGUOUS;
    const hsize_t bytes = static_cast<hsize_t>(n) * (in_one_piece ? H5Tget_size(type.get()) : 0);
    check(n < most_values && H5Dget_storage_size(set.get()) >= bytes, "it lacks values of", name);
    return static_cast<std::size_t>(n);
}

std::size_t Hdf5Source::value_bytes(const std::string& name) const {
    return H5Tget_size(opened(H5Dget_type(dataset(name).get()), H5Tclose, name).get());
}

void Hdf5Source::read_dataset(const std::string& name, hid_t type, void* values, std::size_t expected) const {
    check(count(name) == expected, "it has another number of values in", name);
    const Hdf5Handle set = dataset(name);
    const Hdf5Handle stored = opened(H5Dget_type(set.get()), H5Tclose, name);
    check(H5Tequal(stored.get(), type) > 0, "it has another type of values in", name);
    check(H5Dread(set.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0, "it cannot be read:", name);
}

void Hdf5Source::read_attribute(const std::string& name, hid_t type, void* value) const {
    const Hdf5Handle attribute = opened(H5Aopen(handle_.get(), name.c_str(), H5P_DEFAULT), H5Aclose, name);
    const Hdf5Handle stored = opened(H5Aget_type(attribute.get()), H5Tclose, name);
    check(H5Tequal(stored.get(), type) > 0, "it has another type of", name);
    const Hdf5Handle space = opened(H5Aget_space(attribute.get()), H5Sclose, name);
    check(H5Sget_simple_extent_npoints(space.get()) == 1, "it has another number of values in", name);
    check(H5Aread(attribute.get(), type, value) >= 0, "it cannot be read:", name);
}

}  // namespace sluice
