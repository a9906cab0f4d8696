#include "engine/run/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "engine/base/number_text.hpp"

namespace sluice {
namespace {

/// Five times a second looks smooth and costs nothing.
constexpr std::chrono::milliseconds bar_interval{200};
/// A log gets a line each 10 s or each 10 %, whichever comes first.
constexpr std::chrono::seconds line_interval{10};
constexpr double line_part = 0.1;
constexpr int bar_width = 20;

double part_done(const ProgressState& state) {
    return state.end > 0 ? std::clamp(state.time / state.end, 0.0, 1.0) : 1;
}

/// Columns of the terminal; 80 if it does not tell.
std::size_t terminal_columns(std::FILE* stream) {
    winsize size{};
    if (::ioctl(::fileno(stream), TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
    return size.ws_col;
}

std::string time_left(const ProgressState& state) {
    const double part = part_done(state);
    if (part <= 0 || state.wall_seconds <= 0) return "?:??";
    return clock_text(state.wall_seconds * (1 - part) / part);
}

}  // namespace

std::string progress_text(const ProgressState& state) {
    const double wall = std::max(state.wall_seconds, 1e-9);  // the first step may be faster than the clock
    return fmt::format("{:5.1f} % | {} left | t = {:.4g} of {:.4g} s | {} steps/s | {} particle-steps/s",
                       100 * part_done(state), time_left(state), state.time, state.end,
                       short_number(state.steps / wall), short_number(state.particle_steps / wall));
}

std::string progress_bar(const ProgressState& state, int width) {
    const auto marks = static_cast<std::size_t>(std::floor(part_done(state) * width));
    return fmt::format("[{:-<{}}]", std::string(marks, '#'), width);
}

Progress::Progress(std::FILE* stream)
    : stream_(stream),
      style_(!stream                      ? Style::none
             : ::isatty(::fileno(stream)) ? Style::bar
                                          : Style::lines),
      shown_at_(Clock::now()) {}

Progress::~Progress() {
    // An error message that follows starts on a line of its own.
    if (open_line_) std::fputc('\n', stream_);
}

void Progress::update(const ProgressState& state) {
    const auto since = Clock::now() - shown_at_;
    switch (style_) {
        case Style::none:
            return;
        case Style::bar:
            if (since >= bar_interval) show(state);
            return;
        case Style::lines:
            if (since >= line_interval || part_done(state) >= shown_part_ + line_part) show(state);
            return;
    }
}

void Progress::note(const std::string& text) {
    if (style_ == Style::none) return;
    std::fputs(fmt::format("{}{}\n", open_line_ ? "\r\033[K" : "", text).c_str(), stream_);
    std::fflush(stream_);
    open_line_ = false;
}

void Progress::finish(const ProgressState& state) {
    switch (style_) {
        case Style::none:
            return;
        case Style::bar:
            show(state);
            break;
        case Style::lines:
            if (part_done(state) > shown_part_) show(state);
            break;
    }
    if (open_line_) std::fputc('\n', stream_);
    open_line_ = false;
}

void Progress::show(const ProgressState& state) {
    shown_at_ = Clock::now();
    shown_part_ = part_done(state);
    std::string line = progress_text(state);
    switch (style_) {
        case Style::none:
            return;
        case Style::lines:
            std::fputs((line + "\n").c_str(), stream_);
            break;
        case Style::bar:
            line = progress_bar(state, bar_width) + " " + line;
            line.resize(std::min(line.size(), terminal_columns(stream_) - 1));  // a wrapped line cannot be redrawn
            std::fputs(fmt::format("\r{}\033[K", line).c_str(), stream_);
            open_line_ = true;
            break;
    }
    std::fflush(stream_);
}

}  // namespace sluice
