// One run as a process of its own, so that its end, of whatever kind, is not the study's.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sluice {

struct ChildEnd {
    int exit_code = 0;
    int signal = 0;  ///< that ended it; 0 = none
    double cpu = 0;  ///< user and system time, all threads [s]
    double wall = 0;
};

class ChildRun {
  public:
    /// Starts a program; both its streams go into `log`. Throws OutputError.
    ChildRun(const std::vector<std::string>& words, const std::filesystem::path& log);
    /// Ends what still runs.
    ~ChildRun();
    ChildRun(const ChildRun&) = delete;
    ChildRun& operator=(const ChildRun&) = delete;

    /// How it ended; none while it runs.
    std::optional<ChildEnd> poll();
    /// Asks it to end as Ctrl-C would, and waits until it has.
    ChildEnd stop();

  private:
    std::optional<ChildEnd> wait(int options);

    pid_t process_ = -1;
    double start_ = 0;
};

/// This program's own file.
std::filesystem::path own_program();

}  // namespace sluice
