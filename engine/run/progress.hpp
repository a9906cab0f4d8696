// How far a run has come: a bar on a terminal, a line now and then in a log.
#pragma once

#include <chrono>
#include <cstdio>
#include <string>

namespace sluice {

struct ProgressState {
    double time = 0;          ///< simulated [s]
    double end = 0;           ///< simulated [s]
    double wall_seconds = 0;  ///< since the first step
    double steps = 0;
    double particle_steps = 0;
};

/// 45.0 % | 0:42 left | t = 0.18 of 0.4 s | 1.23 k steps/s | 2.31 M particle-steps/s: what matters most comes first,
/// as a narrow terminal cuts the rest.
std::string progress_text(const ProgressState& state);
/// [#########-----------], `width` marks wide.
std::string progress_bar(const ProgressState& state, int width);

class Progress {
  public:
    /// Writes to `stream`: a bar if that is a terminal, else lines. Null: nothing at all.
    explicit Progress(std::FILE* stream = stderr);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Called after each step; shows something only when it is time to.
    void update(const ProgressState& state);
    /// Writes a line of its own.
    void note(const std::string& text);
    /// Shows the last state and leaves the line.
    void finish(const ProgressState& state);

  private:
    enum class Style { none, bar, lines };
    using Clock = std::chrono::steady_clock;
    void show(const ProgressState& state);

    std::FILE* stream_;
    Style style_;
    Clock::time_point shown_at_;
    double shown_part_ = 0;   ///< of the simulated time
    bool open_line_ = false;  ///< the cursor stands behind a bar
};

}  // namespace sluice
