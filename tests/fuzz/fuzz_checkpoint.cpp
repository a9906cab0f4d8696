// Checkpoints that are damaged, or of another scene, or of another shape than the program writes.
//   bytes 0, 1   the scene that was saved, the scene that it is read into
//   byte 2       0: the file's bytes are changed; 1: what is in it, with a right checksum; 2: nothing
//   then         4 bytes for each change
// A damaged file must be noticed. What fits in shape is believed: its numbers are protected by the checksum only.
#include <hdf5.h>
#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <memory>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "engine/base/errors.hpp"
#include "engine/run/checkpoint/checkpoint_file.hpp"
#include "engine/run/watch/watch.hpp"
#include "engine/simulation/simulation.hpp"
#include "tests/engine/temporary_folder.hpp"
#include "tests/fuzz/demand.hpp"

namespace sluice {
namespace {

using Bytes = std::span<const std::uint8_t>;
constexpr std::size_t header_size = 512;

/// Scenes that have as many particles, but other sides, walls, materials and methods; the last in 3D.
const std::vector<Scene>& scenes() {
    static const std::vector<Scene> all = [] {
        const std::string gate = SLUICE_TEST_SCENES "/small_gate.toml",
                          tank = SLUICE_TEST_SCENES "/still_water_3d.toml";
        const std::vector<std::vector<std::string>> changes{
            {},
            {"gravity=[1.0, -5.0]", "output.end=1"},
            {"walls.back.point=[-0.0512, 0.0]"},
            {"walls.back.normal=[1.0, 0.1]"},
            {"walls.above={kind='mirror', point=[0.012, 0.0], normal=[-1.0, 0.0]}"},
            {"domain.periodic.x=[-0.06, 0.06]"},
            {"method.preset=modern"},
            {"method.preset=modern", "walls.back.point=[-0.0512, 0.0]"},
            {"method.preset=modern", "materials.rubber.model=hypoelastic"},
            {"method.preset=modern", "bodies.gate.clamp={box={min=[0.0, 0.0], max=[0.01, 0.01]}}"},
            {"method.preset=modern", "method.coupling=interface-force"},
            {"method.preset=modern", "effects.particle_shifting=off"},
        };
        std::vector<Scene> list;
        for (std::vector<std::string> change : changes) {
            change.push_back("method.spacing=0.005");
            list.push_back(load_scene(gate, change));
        }
        list.push_back(load_scene(tank));
        return list;
    }();
    return all;
}

std::filesystem::path scratch() {
    static const TemporaryFolder folder;
    return folder.path() / "checkpoint.h5";
}

void overwrite(const std::string& bytes) { std::ofstream(scratch(), std::ios::binary | std::ios::trunc) << bytes; }

template <int Dim>
std::string saved(const Scene& scene) {
    Simulation<Dim> simulation(scene);
    for (int step = 0; step < 3; ++step) simulation.step();
    write_checkpoint(scratch(), [&](const StateWriter& writer) {
        CheckpointLabel label{"0.1.0", "baseline", scene.file, scene.source, 0.5, 0.25, 3};
        writer("label", label);
        simulation.save(writer.group("simulation"));
    });
    return text_of(scratch());
}

/// The file that a run of the scene writes after three steps.
const std::string& checkpoint_of(std::size_t scene) {
    static std::vector<std::string> files(scenes().size());
    if (files[scene].empty())
        files[scene] = scenes()[scene].dimension == 2 ? saved<2>(scenes()[scene]) : saved<3>(scenes()[scene]);
    return files[scene];
}

struct Change {
    std::size_t where;
    std::uint8_t what, value;
};

std::vector<Change> changes_in(Bytes bytes) {
    std::vector<Change> changes;
    for (std::size_t k = 0; k + 4 <= bytes.size() && changes.size() < 16; k += 4)
        changes.push_back({static_cast<std::size_t>(bytes[k] << 8 | bytes[k + 1]), bytes[k + 2], bytes[k + 3]});
    return changes;
}

/// Cut short, lengthened, or with other bytes here and there.
std::string damaged(std::string file, const std::vector<Change>& changes) {
    for (const Change& c : changes) {
        // Every other place is in the header or soon after it, where most of the structure is.
        const std::size_t at = (c.what & 1 ? c.where % 1024 : c.where * 37) % std::max<std::size_t>(file.size(), 1);
        if (c.what < 8)
            file.resize(at);
        else if (c.what < 16)
            file.append(c.value, 'x');
        else if (!file.empty())
            file[at] = static_cast<char>(c.value);
    }
    return file;
}

/// An attribute, or a dataset.
struct Item {
    std::string group, name;
    bool is_attribute;
};

herr_t collect(hid_t, const char* name, const H5O_info_t* info, void* list) {
    auto& items = *static_cast<std::vector<Item>*>(list);
    const std::string path(name);
    const std::size_t slash = path.find_last_of('/');
    if (info->type == H5O_TYPE_DATASET)
        items.push_back({slash == std::string::npos ? "." : path.substr(0, slash), path.substr(slash + 1), false});
    else
        items.push_back({path, "", true});  // a group, whose attributes are named by number
    return 0;
}

void change_attribute(hid_t group, const Change& c) {
    H5O_info_t info;
    if (H5Oget_info2(group, &info, H5O_INFO_NUM_ATTRS) < 0 || info.num_attrs == 0) return;
    const hid_t attribute =
        H5Aopen_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, c.value % info.num_attrs, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t type = H5Aget_type(attribute);
    if (c.what % 4 == 0) {
        char name[256];
        H5Aget_name(attribute, sizeof name, name);
        H5Adelete(group, name);
    } else {
        const std::vector<char> value(H5Tget_size(type), static_cast<char>(c.what));
        H5Awrite(attribute, type, value.data());
    }
    H5Tclose(type);
    H5Aclose(attribute);
}

void change_dataset(hid_t group, const std::string& name, const Change& c) {
    const hid_t old = H5Dopen2(group, name.c_str(), H5P_DEFAULT);
    if (old < 0) return;  // gone already
    const hid_t type = c.what % 4 == 1 ? H5Tcopy(H5T_NATIVE_INT16) : H5Dget_type(old);
    H5Dclose(old);
    H5Ldelete(group, name.c_str(), H5P_DEFAULT);
    if (c.what % 4 == 0) return;
    // Zeros; or so many that no memory holds them, and none there.
    const hsize_t count = c.value == 255 ? hsize_t{1} << 50 : c.value;
    const hid_t space = H5Screate_simple(1, &count, nullptr), how = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_alloc_time(how, c.value == 255 ? H5D_ALLOC_TIME_LATE : H5D_ALLOC_TIME_EARLY);
    const hid_t made = H5Dcreate2(group, name.c_str(), type, space, H5P_DEFAULT, how, H5P_DEFAULT);
    if (made >= 0) H5Dclose(made);
    H5Pclose(how), H5Sclose(space), H5Tclose(type);
}

/// The file in `scratch` with other content, and the checksum that belongs to it.
void reshape(const std::vector<Change>& changes) {
    const hid_t file = H5Fopen(scratch().c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    demand(file >= 0, "the library opens its own file");
    std::vector<Item> items;
    H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, collect, &items, H5O_INFO_BASIC);
    for (const Change& c : changes) {
        const Item& item = items[c.where % items.size()];
        const hid_t group = H5Gopen2(file, item.group.c_str(), H5P_DEFAULT);
        if (group < 0) continue;
        if (item.is_attribute)
            change_attribute(group, c);
        else
            change_dataset(group, item.name, c);
        H5Gclose(group);
    }
    H5Fclose(file);
    std::string bytes = text_of(scratch());
    const auto sum =
        ::crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()) + header_size, bytes.size() - header_size);
    std::ostringstream header;
    header << bytes.substr(0, bytes.find("\nbytes")) << "\nbytes " << bytes.size() - header_size << "\ncrc32 ";
    header << std::hex;
    header.width(8);
    header.fill('0');
    header << sum << "\n";
    std::string text = header.str();
    text.resize(header_size, '\0');
    overwrite(text + bytes.substr(header_size));
    demand(checkpoint_problem(scratch()).empty(), "a right checksum is accepted");
}

template <int Dim>
void go_on(const Scene& scene, bool reshaped) {
    Simulation<Dim> simulation(scene);
    read_label(scratch());
    simulation.restore(open_checkpoint(scratch()).group("simulation"));
    if (reshaped) return;  // what is within arrays is believed
    Watch<Dim> watch(simulation);
    for (int step = 0; step < 3; ++step) simulation.step();
    watch.look(simulation);
}

void read(Bytes bytes) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    const std::size_t from = bytes[0] % scenes().size(), to = bytes[1] % scenes().size();
    const std::vector<Change> changes = changes_in(bytes.subspan(3));
    const std::string& whole = checkpoint_of(from);
    const bool reshaped = bytes[2] % 3 == 1 && !changes.empty();
    if (bytes[2] % 3 == 0) {
        const std::string file = damaged(whole, changes);
        overwrite(file);
        demand(checkpoint_problem(scratch()).empty() == (file == whole), "damage is noticed");
    } else {
        overwrite(whole);
        if (reshaped) reshape(changes);
    }
    try {
        if (scenes()[to].dimension == 2)
            go_on<2>(scenes()[to], reshaped);
        else
            go_on<3>(scenes()[to], reshaped);
        demand(from != to || reshaped || checkpoint_problem(scratch()).empty(), "a damaged file was read");
    } catch (const CheckpointError&) {
    } catch (const NumericalError&) {
        demand(from != to, "a good checkpoint breaks down");
    }
}

}  // namespace
}  // namespace sluice

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size >= 3) sluice::read({data, size});
    return 0;
}
