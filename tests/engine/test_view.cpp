#include <algorithm>

#include "engine/base/errors.hpp"
#include "engine/view/color_map.hpp"
#include "engine/view/particle_raster.hpp"
#include "engine/view/render.hpp"
#include "engine/view/view_page.hpp"
#include "engine/view/view_server.hpp"
#include "tests/catch.hpp"
#include "tests/engine/temporary_folder.hpp"
#include "tests/engine/view_runs.hpp"

namespace sluice::test_view {
namespace {

std::string element_of(const std::string& page, const std::string& id) {
    const std::string start = "id=\"" + id + "\">";
    const std::size_t at = page.find(start);
    if (at == std::string::npos) return "";
    return page.substr(at + start.size(), page.find("</script>", at) - at - start.size());
}

void cut_short(const std::filesystem::path& file) { std::filesystem::resize_file(file, 600); }

}  // namespace

TEST_CASE("A page holds the run it was made of, in 2D and 3D", "[view]") {
    for (const int dimension : {2, 3}) {
        CAPTURE(dimension);
        const TemporaryFolder folder;
        write_lattice_run(folder.path(), dimension, 5);
        const std::filesystem::path file = folder.path() / "out.html";
        const ViewResult result = write_view_page({folder.path(), {}, 2}, file);
        CHECK(result.frames == 3);  // 0, 2, 4
        CHECK(result.left_out.empty());
        const std::string page = text_of(file);
        CHECK(page.size() == result.bytes);
        const std::string head = element_of(page, "run");
        CHECK_THAT(head, Catch::Contains(fmt::format("\"dimension\":{},", dimension)));
        const std::size_t particles = dimension == 2 ? 16 : 64;
        CHECK_THAT(head, Catch::EndsWith(fmt::format("\"frames\":[[0,0,{0}],[0.2,20,{0}],[0.4,40,{0}]]}}", particles)));
        CHECK_THAT(head, Catch::Contains(R"("groups":[{"name":"fluid 0","medium":0,)"));
        CHECK_THAT(head, Catch::Contains(R"(},{"name":"wall 0","medium":2,)"));
        CHECK_THAT(head, Catch::Contains(R"("fields":[{"name":"speed","unit":"m/s","ranges":[[)"));
        CHECK(!element_of(page, "frame-2").empty());
        CHECK(element_of(page, "frame-3").empty());
    }
}

TEST_CASE("What cannot be shown is said", "[view]") {
    const TemporaryFolder folder;
    const std::filesystem::path page = folder.path() / "page.html";
    CHECK_THROWS_WITH(write_view_page({folder.path() / "nowhere", {}, 1}, page), Catch::Contains("no such folder"));
    CHECK_THROWS_WITH(write_view_page({folder.path(), {}, 1}, page), Catch::Contains("not the folder of a run"));
    write_atomically(folder.path() / "summary.json", R"({"status": "done", "title": 7})");
    CHECK_THROWS_WITH(write_view_page({folder.path(), {}, 1}, page), Catch::Contains("has written none yet"));
    write_lattice_run(folder.path(), 2, 3);
    CHECK_THROWS_WITH(write_view_page({folder.path(), {"densty"}, 1}, page), Catch::Contains("\"density\"?"));
    CHECK(!std::filesystem::exists(page));
    write_atomically(folder.path() / "frames" / "frames.hdf.series", "{\"files\": [");
    CHECK_THROWS_WITH(write_view_page({folder.path(), {}, 1}, page), Catch::Contains("no list of frames"));
}

TEST_CASE("A frame that is cut short is left out, and named", "[view]") {
    const TemporaryFolder folder;
    write_lattice_run(folder.path(), 2, 3);
    cut_short(folder.path() / "frames" / "frame_0001.hdf");
    const ViewResult result = write_view_page({folder.path(), {}, 1}, folder.path() / "page.html");
    CHECK(result.frames == 2);
    REQUIRE(result.left_out.size() == 1);
    CHECK_THAT(result.left_out[0], Catch::Contains("frame_0001.hdf: cannot be read as a frame"));
    for (const char* name : {"frame_0000.hdf", "frame_0002.hdf"}) cut_short(folder.path() / "frames" / name);
    CHECK_THROWS_WITH(write_view_page({folder.path(), {}, 1}, folder.path() / "page.html"),
                      Catch::Contains("frame_0000.hdf: cannot be read"));
}

TEST_CASE("A run that goes on is followed, and one that starts anew is shown from its start", "[view]") {
    const TemporaryFolder folder;
    write_lattice_run(folder.path(), 2, 2);
    LiveRun run(folder.path(), {});
    const auto frames = [&run] {
        const std::string head = run.head();
        // one comma between two frames, and two within each
        return (std::count(head.begin() + static_cast<std::ptrdiff_t>(head.find("\"frames\"")), head.end(), ',') + 1) /
               3;
    };
    CHECK(frames() == 2);
    CHECK(run.frame(1).has_value());
    CHECK(!run.frame(2).has_value());
    write_lattice_run(folder.path(), 2, 4);
    CHECK(frames() == 4);
    CHECK(run.frame(3).has_value());
    write_lattice_run(folder.path(), 2, 1);
    CHECK(frames() == 1);
}

TEST_CASE("Ranges leave the few out that lie far off", "[view]") {
    FrameTable table = lattice_table(3, 10, 0.0);
    table.scalars[0].value.assign(table.particles, 1.0F);
    table.scalars[0].value[3] = 1e6F;  // one of 900 fluid particles
    FieldRanges ranges;
    ranges.add(table, 3);
    const auto range = ranges.of("pressure", FrameMedium::fluid);
    REQUIRE(range);
    CHECK(range->high == 1.0);
    CHECK(range->most == 1e6);
    CHECK(!ranges.of("density", FrameMedium::wall));  // walls have none
    CHECK(!ranges.of("pressure", FrameMedium::solid));
}

TEST_CASE("Colours run from one end of the map to the other", "[view]") {
    const ColorMap& map = color_map("viridis");
    CHECK(color_at(map, -1) == map.color.front());
    CHECK(color_at(map, 0.5) == map.color[8]);
    CHECK(color_at(map, 2) == map.color.back());
    CHECK_THROWS_WITH(color_map("virids"), Catch::Contains("\"viridis\"?"));
    CHECK(is_signed_range(-1, 2));
    CHECK(!is_signed_range(-0.1, 2));
}

TEST_CASE("Discs cover their area, and the nearer one is seen", "[view]") {
    constexpr int side = 100;
    ParticleRaster raster(side, side);
    const Sprite discs[] = {{50, 50, 30, 1, 0xff0000}, {50, 50, 10, 2, 0x0000ff}, {50, 50, 40, 0, 0x00ff00}};
    raster.draw(discs, Shading::flat);
    std::vector<unsigned char> pixels(4 * side * side, 0);
    raster.blend_into(pixels.data(), 4 * side);
    double area[3] = {0, 0, 0};  // blue, green, red
    for (std::size_t i = 0; i < pixels.size(); i += 4)
        for (std::size_t k = 0; k < 3; ++k) area[k] += pixels[i + k] / 255.0;
    // Half a sample along the rim, which is the most that a disc of samples may be off: π r with r in pixels.
    const double pi = 3.14159265358979;
    CHECK(area[0] == Approx(pi * 10 * 10).margin(pi * 10));
    CHECK(area[2] == Approx(pi * (30 * 30 - 10 * 10)).margin(pi * 40));
    CHECK(area[1] == Approx(pi * (40 * 40 - 30 * 30)).margin(pi * 70));
}

TEST_CASE("A run becomes pictures of the size asked for", "[view]") {
    const TemporaryFolder folder;
    write_lattice_run(folder.path(), 3, 3);
    RenderOptions options;
    options.directory = folder.path();
    options.output = folder.path() / "pictures";
    options.style.width = 320;
    options.style.height = 180;
    CHECK(render_run(options).frames == 3);
    const std::string png = text_of(options.output / "frame_0002.png");
    REQUIRE(png.size() > 24);
    CHECK(png.substr(1, 3) == "PNG");
    CHECK(static_cast<unsigned char>(png[18]) * 256 + static_cast<unsigned char>(png[19]) == 320);  // IHDR: width
    CHECK(static_cast<unsigned char>(png[22]) * 256 + static_cast<unsigned char>(png[23]) == 180);  // height
    options.every = 2;
    CHECK(render_run(options).frames == 2);
    CHECK(!std::filesystem::exists(options.output / "frame_0002.png"));  // of the earlier call
    options.fluid.field = "vonmises";
    CHECK_THROWS_AS(render_run(options), RunReadError);
}

}  // namespace sluice::test_view
