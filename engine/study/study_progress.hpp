// How far a study has come, and how long the rest will take.
#pragma once

#include <chrono>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace sluice {

/// A run to make or made.
struct RunSize {
    std::size_t method = 0;
    double spacing = 0;  ///< [m]
};

/// Wall time of runs from those that are done: cost ~ d^-(Dim + 1), with the method's own factor where it has a run.
class TimeEstimate {
  public:
    explicit TimeEstimate(int dimension) : dimension_(dimension) {}

    void add(const RunSize& run, double wall_seconds);
    /// [s]; none before the first run.
    std::optional<double> of(const RunSize& run) const;

  private:
    struct Done {
        RunSize run;
        double factor = 0;  ///< wall time · d^(Dim + 1)
    };
    int dimension_;
    std::vector<Done> done_;
};

/// A line that stays at the bottom of a terminal; in a log only what happened.
class StudyProgress {
  public:
    explicit StudyProgress(std::FILE* stream = stderr);
    ~StudyProgress();
    StudyProgress(const StudyProgress&) = delete;
    StudyProgress& operator=(const StudyProgress&) = delete;

    /// "[####------] 5 of 24 runs | 3:20 left | modern, mixed, spacing 10 mm"; on a terminal, twice a second.
    void show(std::size_t done, std::size_t all, const std::optional<double>& left, const std::string& running);
    /// A line for good.
    void tell(const std::string& line);

  private:
    using Clock = std::chrono::steady_clock;
    std::FILE* stream_;
    bool on_terminal_;
    bool open_line_ = false;
    Clock::time_point shown_at_;
};

}  // namespace sluice
