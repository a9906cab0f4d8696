#include <hdf5.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/run/output/frames.hpp"
#include "tests/catch.hpp"
#include "tests/engine/temporary_folder.hpp"

namespace sluice::test_output_frames {
namespace {

/// A dataset as it is in the file.
template <class T>
struct Table {
    std::vector<hsize_t> size;
    std::vector<T> value;
};

/// Reads back with the plain C API, as a stranger would.
class FrameReader {
  public:
    explicit FrameReader(const std::filesystem::path& file)
        : file_(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)) {
        REQUIRE(file_ >= 0);
    }
    ~FrameReader() { H5Fclose(file_); }

    bool has(const std::string& name) const { return H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0; }

    template <class T>
    Table<T> read(const std::string& name, hid_t type) const {
        const hid_t set = H5Dopen2(file_, name.c_str(), H5P_DEFAULT);
        REQUIRE(set >= 0);
        const hid_t space = H5Dget_space(set);
        Table<T> table;
        table.size.resize(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
        H5Sget_simple_extent_dims(space, table.size.data(), nullptr);
        table.value.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
        REQUIRE(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, table.value.data()) >= 0);
        H5Sclose(space);
        H5Dclose(set);
        return table;
    }
    Table<float> floats(const std::string& name) const { return read<float>(name, H5T_NATIVE_FLOAT); }
    Table<std::int64_t> integers(const std::string& name) const { return read<std::int64_t>(name, H5T_NATIVE_INT64); }

    std::string text_attribute(const std::string& group, const std::string& name) const {
        const hid_t attribute = H5Aopen_by_name(file_, group.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
        REQUIRE(attribute >= 0);
        const hid_t type = H5Aget_type(attribute);
        REQUIRE(H5Tis_variable_str(type) == 0);
        REQUIRE(H5Tget_cset(type) == H5T_CSET_ASCII);
        std::string text(H5Tget_size(type), '\0');
        REQUIRE(H5Aread(attribute, type, text.data()) >= 0);
        H5Tclose(type);
        H5Aclose(attribute);
        return text;
    }

  private:
    hid_t file_;
};

template <int Dim>
void add_base(ParticleSet<Dim>& phase, std::uint32_t id) {
    Vec<Dim> x, v;
    for (int k = 0; k < Dim; ++k) x[k] = id + 0.1 * k, v[k] = -x[k];
    phase.position.push_back(x);
    phase.velocity.push_back(v);
    phase.pressure.push_back(100 + id);
    phase.density.push_back(1000 + id);
    phase.id.push_back(id);
    phase.body.push_back(static_cast<std::uint16_t>(id % 2));
    ++phase.owned;
}

/// Three fluid, two solid and one wall particle, in the order of `fluid_ids`, with an image behind the fluid.
template <int Dim>
FrameTable small_table(const std::vector<std::uint32_t>& fluid_ids) {
    ParticleSet<Dim> fluid;
    for (const std::uint32_t id : fluid_ids) add_base(fluid, id);
    add_base(fluid, 0);
    --fluid.owned;
    ParticleSet<Dim> solid;
    for (const std::uint32_t id : {1U, 0U}) {
        add_base(solid, id);
        Vec<sym_components<Dim>> s;
        for (int k = 0; k < sym_components<Dim>; ++k) s[k] = id * (k + 1.0);
        solid.deviatoric_stress.push_back(s);
    }
    ParticleSet<Dim> wall;
    wall.position.push_back({});
    wall.pressure.push_back(7);
    wall.id.push_back(0);
    wall.body.push_back(2);
    wall.owned = 1;
    return frame_table(fluid, solid, wall, {}, {});
}

}  // namespace

TEST_CASE("A frame has the layout that ParaView 5.11 reads") {
    const TemporaryFolder folder;
    const auto file = folder.path() / "frame.hdf";
    write_frame(file, small_table<2>({2, 0, 1}), {0.5, 12, "Title"});
    const FrameReader frame(file);
    REQUIRE(frame.text_attribute("VTKHDF", "Type") == "UnstructuredGrid");
    REQUIRE(frame.text_attribute("sluice", "title") == "Title");
    for (const char* count : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"}) {
        const auto number = frame.integers(std::string("VTKHDF/") + count);
        REQUIRE(number.size == std::vector<hsize_t>{1});
        REQUIRE(number.value == std::vector<std::int64_t>{6});
    }
    REQUIRE(frame.integers("VTKHDF/Connectivity").value == std::vector<std::int64_t>{0, 1, 2, 3, 4, 5});
    REQUIRE(frame.integers("VTKHDF/Offsets").value == std::vector<std::int64_t>{0, 1, 2, 3, 4, 5, 6});
    REQUIRE(frame.integers("VTKHDF/Types").value == std::vector<std::int64_t>(6, 1));
    REQUIRE(frame.floats("VTKHDF/Points").size == std::vector<hsize_t>{6, 3});
    REQUIRE(frame.floats("VTKHDF/PointData/velocity").size == std::vector<hsize_t>{6, 3});
    REQUIRE(frame.integers("VTKHDF/PointData/phase").value == std::vector<std::int64_t>{0, 0, 0, 1, 1, 2});
    REQUIRE(frame.integers("VTKHDF/PointData/body").value == std::vector<std::int64_t>{0, 1, 0, 0, 1, 2});
    REQUIRE(frame.integers("VTKHDF/PointData/id").value == std::vector<std::int64_t>{0, 1, 2, 0, 1, 0});
    REQUIRE(frame.floats("VTKHDF/PointData/pressure").value == std::vector<float>{100, 101, 102, 100, 101, 7});
}

TEST_CASE("Particles are sorted by id, so that frames do not depend on the order in memory") {
    const TemporaryFolder folder;
    write_frame(folder.path() / "a", small_table<2>({2, 0, 1}), {0.5, 12, "Title"});
    write_frame(folder.path() / "b", small_table<2>({0, 1, 2}), {0.5, 12, "Title"});
    REQUIRE(text_of(folder.path() / "a") == text_of(folder.path() / "b"));
    const auto points = FrameReader(folder.path() / "a").floats("VTKHDF/Points").value;
    REQUIRE(points[3] == 1.0F);
    REQUIRE(points[4] == 1.1F);
    REQUIRE(points[5] == 0.0F);
}

TEST_CASE("Stress in a frame is -p I + S, with S_zz of plane strain in 2D") {
    const TemporaryFolder folder;
    write_frame(folder.path() / "a", small_table<2>({0, 1, 2}), {});
    const FrameReader frame(folder.path() / "a");
    // The solid particle with id 1 stands fifth: p = 101, S = (1, 2, 3) in xx, yy, xy.
    const auto fifth = [&](const char* name) { return frame.floats(std::string("VTKHDF/PointData/") + name).value[4]; };
    REQUIRE(fifth("stress_xx") == -100.0F);
    REQUIRE(fifth("stress_yy") == -99.0F);
    REQUIRE(fifth("stress_zz") == -104.0F);
    REQUIRE(fifth("stress_xy") == 3.0F);
    // sqrt(3/2 (1 + 4 + 9 + 2·9)); float32 holds 1e-7
    REQUIRE(fifth("von_mises") == Approx(std::sqrt(48.0)).epsilon(1e-6));
    REQUIRE(frame.floats("VTKHDF/PointData/stress_yy").value[1] == -101.0F);
    REQUIRE(frame.floats("VTKHDF/PointData/von_mises").value[1] == 0.0F);
}

TEST_CASE("A frame in 3D has all six components of the stress") {
    const TemporaryFolder folder;
    write_frame(folder.path() / "a", small_table<3>({0, 1, 2}), {});
    const FrameReader frame(folder.path() / "a");
    const auto fifth = [&](const char* name) { return frame.floats(std::string("VTKHDF/PointData/") + name).value[4]; };
    REQUIRE(fifth("stress_xx") == -100.0F);
    REQUIRE(fifth("stress_zz") == -98.0F);
    REQUIRE(fifth("stress_xy") == 4.0F);
    REQUIRE(fifth("stress_xz") == 5.0F);
    REQUIRE(fifth("stress_yz") == 6.0F);
    REQUIRE(frame.floats("VTKHDF/Points").value[3 * 4 + 2] == 1.2F);
}

TEST_CASE("Without solids a frame has no stress; without particles it is still a frame") {
    const TemporaryFolder folder;
    write_frame(folder.path() / "a", frame_table<2>({}, {}, {}, {}, {}), {});
    const FrameReader frame(folder.path() / "a");
    REQUIRE_FALSE(frame.has("VTKHDF/PointData/stress_xx"));
    REQUIRE(frame.has("VTKHDF/PointData/density"));
    REQUIRE(frame.floats("VTKHDF/Points").value.empty());
    REQUIRE(frame.integers("VTKHDF/Offsets").value == std::vector<std::int64_t>{0});
}

TEST_CASE("Frames are compressed") {
    const TemporaryFolder folder;
    ParticleSet<2> fluid;
    for (std::uint32_t i = 0; i < 20000; ++i) add_base(fluid, i);
    write_frame(folder.path() / "a", frame_table<2>(fluid, {}, {}, {}, {}), {});
    // 56 bytes a particle as they are: 16 for points and velocity twice, 8 for scalars, 7 for names, 17 for cells.
    REQUIRE(std::filesystem::file_size(folder.path() / "a") < 20000 * 56 / 2);
}

}  // namespace sluice::test_output_frames
