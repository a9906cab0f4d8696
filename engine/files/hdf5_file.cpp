#include "engine/files/hdf5_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>

#include "engine/base/errors.hpp"

namespace sluice {
namespace {

/// Rows per chunk: 64 Ki float32 scalars are 256 KiB, which fits the library's chunk cache (1 MiB) with room for
/// vectors.
constexpr hsize_t chunk_rows = 65536;
/// The file grows in memory by this much at a time [bytes].
constexpr std::size_t growth = 1 << 20;
/// zlib's level. A frame of 93,000 particles becomes 1 % larger with level 1, in 0.8 of the time, and 2 % smaller with
/// level 9, in 1.5 times the time.
constexpr unsigned gzip_level = 4;

/// Half the children of a node in a dataset's index of chunks. The library's 32 makes 2 kB of index per dataset, most
/// of the file in a small scene; with 4 even 10⁷ particles need no more than three levels.
constexpr unsigned index_fanout = 4;

void check(herr_t status, std::string_view what) {
    if (status < 0) throw OutputError(fmt::format("HDF5: cannot {}", what));
}

/// Its error stack is for the library's own developers; ours say which file it was.
void silence() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

Hdf5Handle properties(hid_t kind) { return {H5Pcreate(kind), H5Pclose, "make a property list"}; }

Hdf5Handle simple_space(int rank, const hsize_t* size) {
    return {H5Screate_simple(rank, size, nullptr), H5Sclose, "make a data space"};
}

/// Chunks, byte shuffle, gzip; not for a single row, where a chunk's index alone is a hundred times the content.
Hdf5Handle dataset_properties(int rank, const std::array<hsize_t, 2>& size) {
    Hdf5Handle list = properties(H5P_DATASET_CREATE);
    check(H5Pset_obj_track_times(list.get(), false), "switch times off");
    if (size[0] <= 1) return list;
    const std::array<hsize_t, 2> chunk{std::min(size[0], chunk_rows), size[1]};
    check(H5Pset_chunk(list.get(), rank, chunk.data()), "set chunks");
    check(H5Pset_shuffle(list.get()), "set the shuffle filter");
    check(H5Pset_deflate(list.get(), gzip_level), "set compression");
    return list;
}

hid_t create_in_memory(std::size_t user_block) {
    silence();
    const Hdf5Handle access = properties(H5P_FILE_ACCESS);
    check(H5Pset_fapl_core(access.get(), growth, false), "keep a file in memory");
    const Hdf5Handle creation = properties(H5P_FILE_CREATE);
    check(H5Pset_obj_track_times(creation.get(), false), "switch times off");
    if (user_block > 0) check(H5Pset_userblock(creation.get(), user_block), "leave room in front");
    check(H5Pset_istore_k(creation.get(), index_fanout), "size the chunk index");
    // The name only tells open files apart; nothing of that name is touched. Two threads may make one at once.
    static std::atomic<unsigned> count = 0;
    const std::string name = fmt::format("sluice-memory-{}", count++);
    return H5Fcreate(name.c_str(), H5F_ACC_TRUNC, creation.get(), access.get());
}

}  // namespace

template <>
hid_t hdf5_type<float>() {
    return H5T_NATIVE_FLOAT;
}
template <>
hid_t hdf5_type<double>() {
    return H5T_NATIVE_DOUBLE;
}
template <>
hid_t hdf5_type<std::uint8_t>() {
    return H5T_NATIVE_UINT8;
}
template <>
hid_t hdf5_type<std::uint16_t>() {
    return H5T_NATIVE_UINT16;
}
template <>
hid_t hdf5_type<std::uint32_t>() {
    return H5T_NATIVE_UINT32;
}
template <>
hid_t hdf5_type<std::int32_t>() {
    return H5T_NATIVE_INT32;
}
template <>
hid_t hdf5_type<char>() {
    return H5T_NATIVE_CHAR;
}
template <>
hid_t hdf5_type<bool>() {
    return H5T_NATIVE_HBOOL;
}
template <>
hid_t hdf5_type<std::int64_t>() {
    return H5T_NATIVE_INT64;
}
template <>
hid_t hdf5_type<std::uint64_t>() {
    return H5T_NATIVE_UINT64;
}

Hdf5Handle copied_type(hid_t number) { return {H5Tcopy(number), H5Tclose, "copy a type"}; }
Hdf5Handle opaque_type(std::size_t bytes) { return {H5Tcreate(H5T_OPAQUE, bytes), H5Tclose, "make a type"}; }

Hdf5Handle::Hdf5Handle(hid_t id, Close close, std::string_view what) : id_(id), close_(close) {
    if (id < 0) throw OutputError(fmt::format("HDF5: cannot {}", what));
}

Hdf5Group Hdf5Group::group(const std::string& name) const {
    const Hdf5Handle creation = properties(H5P_GROUP_CREATE);
    check(H5Pset_obj_track_times(creation.get(), false), "switch times off");
    return Hdf5Group({H5Gcreate2(handle_.get(), name.c_str(), H5P_DEFAULT, creation.get(), H5P_DEFAULT), H5Gclose,
                      "make the group " + name});
}

void Hdf5Group::write_dataset(const std::string& name, Values values, std::size_t columns) const {
    const int rank = columns == 1 ? 1 : 2;
    const std::array<hsize_t, 2> size{values.count / columns, columns};
    const Hdf5Handle space = simple_space(rank, size.data());
    const Hdf5Handle list = dataset_properties(rank, size);
    const Hdf5Handle set(
        H5Dcreate2(handle_.get(), name.c_str(), values.type, space.get(), H5P_DEFAULT, list.get(), H5P_DEFAULT),
        H5Dclose, "make the dataset " + name);
    if (values.count == 0) return;
    check(H5Dwrite(set.get(), values.type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data), "fill the dataset " + name);
}

void Hdf5Group::write_plain(const std::string& name, Values values) const {
    const hsize_t count = values.count;
    const Hdf5Handle space = simple_space(1, &count);
    const Hdf5Handle list = properties(H5P_DATASET_CREATE);
    check(H5Pset_obj_track_times(list.get(), false), "switch times off");
    const Hdf5Handle set(
        H5Dcreate2(handle_.get(), name.c_str(), values.type, space.get(), H5P_DEFAULT, list.get(), H5P_DEFAULT),
        H5Dclose, "make the dataset " + name);
    check(H5Dwrite(set.get(), values.type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data), "fill the dataset " + name);
}

void Hdf5Group::attribute(const std::string& name, std::string_view text) const {
    const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "make a string type");
    // A string type needs at least one byte, also for an empty text.
    const std::string padded(text.empty() ? std::string_view("\0", 1) : text);
    check(H5Tset_size(type.get(), padded.size()), "size a string");
    check(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), "pad a string");
    const bool ascii = std::all_of(text.begin(), text.end(), [](char c) { return static_cast<signed char>(c) >= 0; });
    check(H5Tset_cset(type.get(), ascii ? H5T_CSET_ASCII : H5T_CSET_UTF8), "name a string's characters");
    write_attribute(name, {type.get(), padded.data(), 0});
}

void Hdf5Group::write_attribute(const std::string& name, Values values) const {
    const hsize_t count = values.count;
    const Hdf5Handle space =
        count == 0 ? Hdf5Handle(H5Screate(H5S_SCALAR), H5Sclose, "make a data space") : simple_space(1, &count);
    const Hdf5Handle attribute(
        H5Acreate2(handle_.get(), name.c_str(), values.type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
        "make the attribute " + name);
    check(H5Awrite(attribute.get(), values.type, values.data), "fill the attribute " + name);
}

Hdf5File::Hdf5File(std::size_t user_block)
    : file_(create_in_memory(user_block), H5Fclose, "make a file in memory"), user_block_(user_block) {}

Hdf5Handle Hdf5File::open_root() const {
    return {H5Gopen2(file_.get(), "/", H5P_DEFAULT), H5Gclose, "open the root group"};
}

bool Hdf5File::is_thread_safe() {
    hbool_t safe = false;
    return H5is_library_threadsafe(&safe) >= 0 && safe;
}

std::string Hdf5File::bytes() const {
    check(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), "finish a file");
    const ssize_t size = H5Fget_file_image(file_.get(), nullptr, 0);
    if (size < 0) throw OutputError("HDF5: cannot finish a file");
    std::string bytes(static_cast<std::size_t>(size), '\0');
    if (H5Fget_file_image(file_.get(), bytes.data(), bytes.size()) != size)
        throw OutputError("HDF5: cannot copy a finished file");
    return bytes;
}

std::span<char> Hdf5File::image() {
    check(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), "finish a file");
    void* memory = nullptr;  // where the driver keeps its pointer to the bytes
    check(H5Fget_vfd_handle(file_.get(), H5P_DEFAULT, &memory), "find a finished file");
    const ssize_t behind = H5Fget_file_image(file_.get(), nullptr, 0);  // the user block does not count
    const auto size = static_cast<std::size_t>(behind) + user_block_;
    hsize_t allocated = 0;
    check(H5Fget_filesize(file_.get(), &allocated), "size a finished file");
    if (behind < 0 || allocated < size) throw OutputError("HDF5: cannot finish a file");
    return {*static_cast<char**>(memory), size};
}

}  // namespace sluice
