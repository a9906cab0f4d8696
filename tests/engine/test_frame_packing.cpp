#include <cmath>
#include <cstdio>

#include "engine/base/errors.hpp"
#include "engine/view/frame_packing.hpp"
#include "tests/catch.hpp"
#include "tests/engine/view_runs.hpp"

namespace sluice::test_frame_packing {
namespace {

/// Unpacked as the page does it: by what the head says alone.
struct Unpacked {
    explicit Unpacked(const std::string& packed) {
        std::size_t length = 0;
        for (std::size_t b = 0; b < 4; ++b)
            length |= static_cast<std::size_t>(static_cast<unsigned char>(packed[b])) << (8 * b);
        head = packed.substr(4, length);
        std::size_t at = 4 + length;
        for (std::size_t k = head.find("{\"name\""); k != std::string::npos; k = head.find("{\"name\"", k + 1)) {
            char name[40];
            PackedColumn column;
            std::size_t bytes = 0;
            const char* form = R"({"name":"%39[^"]","width":%d,"low":%f,"high":%f,"bytes":%zu})";
            REQUIRE(std::sscanf(head.c_str() + k, form, name, &column.width, &column.low, &column.high, &bytes) == 5);
            column.name = name;
            column.bytes = packed.substr(at, bytes);
            columns.push_back(column);
            at += bytes;
        }
        REQUIRE(at == packed.size());
    }
    const PackedColumn& operator[](const std::string& name) const {
        for (const PackedColumn& column : columns)
            if (column.name == name) return column;
        FAIL("no column " + name);
        return columns.front();
    }
    std::string head;
    std::vector<PackedColumn> columns;
};

/// Half a step of the column's range, and the rounding of a float on the way there and back.
double half_step(const PackedColumn& column) {
    const double size = std::max(std::abs(column.low), std::abs(column.high));
    return 0.5 * (static_cast<double>(column.high) - column.low) / highest_step +
           std::numeric_limits<float>::epsilon() * size;
}

void check_numbers(const NumberColumn& original, const PackedColumn& packed) {
    const std::vector<float> values = unpack_numbers(packed, original.count);
    const double allowed = half_step(packed);
    for (std::size_t i = 0; i < original.count; ++i) {
        CHECK(std::isnan(values[i]) == std::isnan(original[i]));
        if (!std::isnan(original[i])) CHECK(std::abs(values[i] - original[i]) <= allowed);
    }
}

}  // namespace

TEST_CASE("A packed frame gives all columns back to half a step", "[view]") {
    for (const int dimension : {2, 3}) {
        CAPTURE(dimension);
        const StoredFrame frame{0.25, 7, lattice_table(dimension, 9, 0.0)};
        const std::vector<std::string> fields = chosen_fields(frame.table, dimension, {});
        const std::vector<std::uint32_t> group(frame.table.medium.begin(), frame.table.medium.end());
        const Unpacked unpacked(pack_frame(frame, group, {dimension, fields, 6}));
        CHECK_THAT(unpacked.head,
                   Catch::StartsWith(fmt::format(R"({{"time":0.25,"step":7,"particles":{},)", frame.table.particles)));
        // positions, velocities, pressure and density, group and id
        CHECK(unpacked.columns.size() == static_cast<std::size_t>(2 * dimension) + 2 + 2);
        for (const NumberColumn& column : position_columns(frame.table, dimension))
            check_numbers(column, unpacked[column.name]);
        for (const NumberColumn& column : field_columns(frame.table, dimension))
            check_numbers(column, unpacked[column.name]);
        CHECK(unpack_identities(unpacked["group"], frame.table.particles) == group);
        const std::vector<std::uint32_t> id = unpack_identities(unpacked["id"], frame.table.particles);
        CHECK(std::equal(id.begin(), id.end(), frame.table.id.begin(), frame.table.id.end()));
    }
}

TEST_CASE("Packed columns hold what is rare: no value, one value, no particle, large identities", "[view]") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const std::vector<float>& values :
         {std::vector<float>{nan, nan}, std::vector<float>{5, 5, nan}, std::vector<float>{},
          std::vector<float>{-1e30F, 1e30F, 0}, std::vector<float>{nan, std::numeric_limits<float>::infinity(), 1}}) {
        const NumberColumn column{"c", values.data(), values.size(), 1};
        const std::vector<float> back = unpack_numbers(pack_numbers(column, 6), values.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            CHECK(std::isnan(back[i]) == !std::isfinite(values[i]));
            if (std::isfinite(values[i])) CHECK(back[i] == Approx(values[i]).margin(2e30 / highest_step));  // a step
        }
    }
    const std::vector<std::uint32_t> id{4000000000U, 0, 4294967295U, 1, 1};
    CHECK(unpack_identities(pack_identities<std::uint32_t>("id", id, 1), id.size()) == id);
}

TEST_CASE("Base64 is that of RFC 4648, section 10", "[view]") {
    CHECK(base64("") == "");
    CHECK(base64("f") == "Zg==");
    CHECK(base64("fo") == "Zm8=");
    CHECK(base64("foo") == "Zm9v");
    CHECK(base64("foobar") == "Zm9vYmFy");
    CHECK(base64("\xff\xfe") == "//4=");
}

TEST_CASE("Fields are chosen by name, and a slip is answered with the nearest", "[view]") {
    FrameTable table = lattice_table(3, 2, 0.0);
    CHECK(chosen_fields(table, 3, {"velocity", "pressure", "velocity_x"}) ==
          std::vector<std::string>{"velocity_x", "velocity_y", "velocity_z", "pressure"});
    CHECK_THROWS_WITH(chosen_fields(table, 3, {"presure"}), Catch::Contains("did you mean \"pressure\"?"));
    CHECK_THROWS_AS(chosen_fields(table, 2, {"velocity_z"}), RunReadError);
}

}  // namespace sluice::test_frame_packing
