// Checkpoints on the disk: damage is always noticed, and the one before takes the place of a damaged one.
#include <fmt/format.h>
#include <sys/resource.h>

#include <random>

#include "engine/files/atomic_file.hpp"
#include "engine/run/checkpoint/checkpoint_store.hpp"
#include "engine/run/resume.hpp"
#include "engine/run/schedule.hpp"
#include "engine/run/text_difference.hpp"
#include "neighbor/fields.hpp"
#include "tests/catch.hpp"
#include "tests/engine/scene_text.hpp"
#include "tests/engine/temporary_folder.hpp"

namespace sluice::test_checkpoint_files {
namespace {

using Catch::Matchers::Contains;

/// What a checkpoint may hold, with a value of each kind.
struct Content {
    double number = 0.1;
    std::uint64_t count = 0;
    bool flag = true;
    std::string text = "some text";
    std::array<double, 2> fixed{1, -0.0};
    Array<double> column = Array<double>(3, 0.3), empty;
    std::vector<Vec<2>> opaque;
    std::vector<std::vector<std::uint8_t>> lists;

    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("number", number), visit("count", count), visit("flag", flag), visit("text", text);
        visit("fixed", fixed), visit("column", column), visit("empty", empty), visit("opaque", opaque);
        visit("lists", lists);
    }
};

void write_content(const StateWriter& writer, Content content, std::uint64_t step) {
    CheckpointLabel label{"0.1.0", "avx2", "scene.toml", "a = 1\n", 0.5, 0.25, step};
    writer("label", label), writer("content", content);
}

/// A run's folder with checkpoints at these steps.
void fill(const std::filesystem::path& directory, const std::vector<std::uint64_t>& steps) {
    CheckpointStore store(directory);
    for (const std::uint64_t step : steps)
        store.write(step, [&](const StateWriter& writer) { write_content(writer, {}, step); });
}

std::vector<std::string> names_in(const std::filesystem::path& directory) {
    std::vector<std::string> names;
    for (const auto& file : checkpoints_in(directory)) names.push_back(file.filename());
    return names;
}

void overwrite(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

}  // namespace

TEST_CASE("A checkpoint is read back as it was written") {
    const TemporaryFolder folder;
    const auto file = folder.path() / "a.h5";
    Content out;
    out.number = 1.0 / 3;
    out.count = ~std::uint64_t{0};
    out.opaque = {{{1, 2}}, {{3, 4}}};
    out.lists = {{1, 2}, {}, {3}};
    write_checkpoint(file, [&](const StateWriter& writer) { write_content(writer, out, 7); });
    Content in;
    in.flag = false;
    in.text = "";
    in.column.clear();
    in.empty = {5};
    open_checkpoint(file)("content", in);
    REQUIRE(in.number == out.number);
    REQUIRE(in.count == out.count);
    REQUIRE(in.flag);
    REQUIRE(in.text == out.text);
    REQUIRE(in.fixed == out.fixed);
    REQUIRE(std::signbit(in.fixed[1]));
    REQUIRE(in.column == out.column);
    REQUIRE(in.empty.empty());
    REQUIRE(in.opaque.size() == 2);
    REQUIRE(in.opaque[1][0] == 3);
    REQUIRE(in.lists == out.lists);
    REQUIRE(read_label(file).step == 7);
}

TEST_CASE("A checkpoint that is cut short anywhere is noticed") {
    const TemporaryFolder folder;
    fill(folder.path(), {1, 2});
    const auto file = folder.path() / "checkpoints" / "step_0000000002.h5";
    const std::string whole = text_of(file);
    std::mt19937 random(1);  // any seed will do
    std::vector<std::size_t> lengths{0, 1, 511, 512, 513, whole.size() - 1};
    for (int k = 0; k < 100; ++k) lengths.push_back(random() % whole.size());
    for (const std::size_t length : lengths) {
        overwrite(file, whole.substr(0, length));
        CAPTURE(length);
        REQUIRE(checkpoint_problem(file) != "");
        const ResumePoint point = find_resume_point(folder.path());
        REQUIRE(point.label.step == 1);
        REQUIRE(point.warnings.size() == 1);
        REQUIRE_THAT(point.warnings[0], Contains(file.string()));
    }
    overwrite(file, whole + "x");
    REQUIRE(checkpoint_problem(file) != "");
}

TEST_CASE("A flipped bit anywhere in a checkpoint is noticed") {
    const TemporaryFolder folder;
    fill(folder.path(), {1, 2});
    const auto file = folder.path() / "checkpoints" / "step_0000000002.h5";
    const std::string whole = text_of(file);
    std::mt19937 random(2);  // any seed will do
    std::vector<std::size_t> places;
    for (std::size_t at = 0; at < 600; at += 7) places.push_back(at);  // the header and where HDF5 starts
    for (int k = 0; k < 300; ++k) places.push_back(random() % whole.size());
    for (const std::size_t at : places) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << random() % 8));
        overwrite(file, damaged);
        CAPTURE(at);
        REQUIRE(checkpoint_problem(file) != "");
        REQUIRE(find_resume_point(folder.path()).label.step == 1);
    }
    overwrite(file, whole);
    REQUIRE(find_resume_point(folder.path()).label.step == 2);
}

TEST_CASE("If no checkpoint can be used, all are named") {
    const TemporaryFolder folder;
    REQUIRE_THROWS_WITH(find_resume_point(folder.path() / "missing"), Contains("missing: found no such folder"));
    REQUIRE_THROWS_WITH(find_resume_point(folder.path()), Contains("found no checkpoint"));
    fill(folder.path(), {1, 2});
    for (const auto& file : checkpoints_in(folder.path())) overwrite(file, text_of(file).substr(0, 700));
    REQUIRE_THROWS_WITH(find_resume_point(folder.path()),
                        Contains("step_0000000001.h5: is damaged") && Contains("step_0000000002.h5: is damaged"));
}

TEST_CASE("The last two checkpoints are kept") {
    const TemporaryFolder folder;
    fill(folder.path(), {1, 20, 300});
    REQUIRE(names_in(folder.path()) == std::vector<std::string>{"step_0000000300.h5", "step_0000000020.h5"});
    // A part that a crash has left goes with the next one, and what is newer than where the run went on from.
    overwrite(folder.path() / "checkpoints" / "step_0000000400.h5.part", "half");
    CheckpointStore store(folder.path(), checkpoints_in(folder.path())[1]);
    REQUIRE(names_in(folder.path()).size() == 2);
    store.write(250, [](const StateWriter& writer) { write_content(writer, {}, 250); });
    REQUIRE(names_in(folder.path()) == std::vector<std::string>{"step_0000000250.h5", "step_0000000020.h5"});
    REQUIRE_FALSE(std::filesystem::exists(folder.path() / "checkpoints" / "step_0000000400.h5.part"));
    // A new run in the same folder starts without.
    const CheckpointStore anew(folder.path());
    REQUIRE(names_in(folder.path()).empty());
}

TEST_CASE("A checkpoint that cannot be written leaves the old ones") {
    const TemporaryFolder folder;
    fill(folder.path(), {1, 2});
    CheckpointStore store(folder.path(), checkpoints_in(folder.path())[0]);
    // A folder in the part's place stands for any reason.
    std::filesystem::create_directory(folder.path() / "checkpoints" / "step_0000000003.h5.part");
    REQUIRE_THROWS_AS(store.write(3, [](const StateWriter& writer) { write_content(writer, {}, 3); }), OutputError);
    REQUIRE(find_resume_point(folder.path()).label.step == 2);
}

TEST_CASE("What has changed in a scene is told line by line") {
    REQUIRE(text_difference("a\nb\n", "a\nb\n").empty());
    REQUIRE(text_difference("a\nb\nc\n", "a\nB\nc\n") == "- b\n+ B\n");
    REQUIRE(text_difference("a\nb\nc\nd\n", "a\nc\nd\ne\n") == "- b\n+ e\n");
    REQUIRE(text_difference("", "a\n") == "+ a\n");
    REQUIRE(text_difference("a\nx\nb\ny\nc", "a\nb\nc") == "- x\n- y\n");
}

TEST_CASE("Of long texts that differ all over, all lines are told, and no table of their pairs is made") {
    const auto numbers = [](const char* sign, int from, int count) {
        std::string text;
        for (int i = from; i < from + count; ++i) text += sign + std::to_string(i) + '\n';
        return text;
    };
    const auto peak_megabytes = [] {
        rusage usage{};
        ::getrusage(RUSAGE_SELF, &usage);
        return usage.ru_maxrss / 1024;
    };
    constexpr int lines = 20'000;  // 4e8 pairs, a table of 1.6 GB
    const long before = peak_megabytes();
    const std::string difference = text_difference("a\n" + numbers("", 0, lines), "a\n" + numbers("", lines, lines));
    REQUIRE(peak_megabytes() - before < 100);  // both texts, their lines, and the answer: 2 MB
    REQUIRE((difference == numbers("- ", 0, lines) + numbers("+ ", lines, lines)));
}

TEST_CASE("A line file goes on after the lines that count") {
    const TemporaryFolder folder;
    const auto file = folder.path() / "a.csv";
    overwrite(file, "one\ntwo\nthree\n");
    {
        LineFile lines(file, 4);
        REQUIRE(text_of(file) == "one\n");
        lines.append("2");
        REQUIRE(lines.size() == 6);
    }
    REQUIRE(text_of(file) == "one\n2\n");
    REQUIRE_THROWS_WITH(LineFile(file, 7), Contains("cannot go on after its first 7 bytes: found only 6"));
    REQUIRE_THROWS_AS(LineFile(folder.path() / "missing", 0), OutputError);
}

TEST_CASE("The scene beside the results keeps the order of what has names") {
    const std::string text = scene_text::gate;  // water before gate, free_end before balance
    const Scene first = scene_text::load(text), second = scene_text::load(first.source);
    REQUIRE(second.source == first.source);
    for (std::size_t b = 0; b < first.bodies.size(); ++b) REQUIRE(second.bodies[b].name == first.bodies[b].name);
    for (std::size_t p = 0; p < first.probes.size(); ++p) REQUIRE(second.probes[p].name == first.probes[p].name);
    for (std::size_t w = 0; w < first.walls.size(); ++w) REQUIRE(second.walls[w].name == first.walls[w].name);
    REQUIRE(first.bodies[0].name == "water");
}

}  // namespace sluice::test_checkpoint_files
