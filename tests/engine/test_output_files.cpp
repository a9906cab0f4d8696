#include <sys/resource.h>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "engine/base/errors.hpp"
#include "engine/files/atomic_file.hpp"
#include "tests/catch.hpp"
#include "tests/engine/temporary_folder.hpp"

namespace sluice::test_output_files {
namespace {

/// While it lives, no file of this process may grow beyond `bytes`: writes then fail part-way, as on a full disk.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes) {
        old_handler_ = std::signal(SIGXFSZ, SIG_IGN);
        ::getrlimit(RLIMIT_FSIZE, &old_);
        const rlimit limit{bytes, old_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &old_);
        std::signal(SIGXFSZ, old_handler_);
    }

  private:
    rlimit old_{};
    void (*old_handler_)(int);
};

}  // namespace

TEST_CASE("An atomic file has all of its bytes and leaves no part behind") {
    const TemporaryFolder folder;
    const auto file = folder.path() / "a.txt";
    write_atomically(file, "first");
    REQUIRE(text_of(file) == "first");
    write_atomically(file, std::string_view("se\0cond", 7));
    REQUIRE(text_of(file) == std::string("se\0cond", 7));
    REQUIRE_FALSE(std::filesystem::exists(folder.path() / "a.txt.part"));
}

TEST_CASE("An atomic file that cannot be written names path and reason") {
    const TemporaryFolder folder;
    const std::string file = folder.path() / "missing" / "a.txt";
    REQUIRE_THROWS_WITH(write_atomically(file, "text"), file + ": cannot write: No such file or directory");
}

TEST_CASE("A write that fails part-way leaves the old file and no part") {
    const TemporaryFolder folder;
    const auto file = folder.path() / "a.txt";
    write_atomically(file, "old");
    {
        const FileSizeLimit limit(1000);
        REQUIRE_THROWS_AS(write_atomically(file, std::string(5000, 'x')), OutputError);
    }
    REQUIRE(text_of(file) == "old");
    REQUIRE_FALSE(std::filesystem::exists(folder.path() / "a.txt.part"));
}

TEST_CASE("A file in the place of a folder is refused") {
    const TemporaryFolder folder;
    write_atomically(folder.path() / "a", "");
    REQUIRE_THROWS_AS(make_folder(folder.path() / "a"), OutputError);
    REQUIRE_THROWS_AS(make_folder(folder.path() / "a" / "b"), OutputError);
}

TEST_CASE("A line that does not fit is taken back whole") {
    const TemporaryFolder folder;
    const auto file = folder.path() / "a.csv";
    {
        LineFile lines(file);
        lines.append("t,x");
        const FileSizeLimit limit(10);
        REQUIRE_THROWS_AS(lines.append("0.123456789"), OutputError);
        REQUIRE(text_of(file) == "t,x\n");
        lines.append("0,1");
    }
    REQUIRE(text_of(file) == "t,x\n0,1\n");
}

TEST_CASE("A full device is reported as such") {
    LineFile lines("/dev/full");
    REQUIRE_THROWS_WITH(lines.append("0"), "/dev/full: cannot write: No space left on device");
}

}  // namespace sluice::test_output_files
