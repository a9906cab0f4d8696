#include "engine/study/study_progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "engine/base/number_text.hpp"

namespace sluice {
namespace {

constexpr std::chrono::milliseconds interval{500};
constexpr std::size_t bar_width = 20;

std::size_t terminal_columns(std::FILE* stream) {
    winsize size{};
    if (::ioctl(::fileno(stream), TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
    return size.ws_col;
}

}  // namespace

void TimeEstimate::add(const RunSize& run, double wall_seconds) {
    done_.push_back({run, wall_seconds * std::pow(run.spacing, dimension_ + 1)});
}

std::optional<double> TimeEstimate::of(const RunSize& run) const {
    // The run nearest in spacing knows best: small runs are dearer per particle than large ones, by their set-up.
    const Done* best = nullptr;
    const auto distance = [&](const Done& d) {
        const double other_method = d.run.method == run.method ? 0 : 100;  // farther than any ratio of spacings
        return other_method + std::abs(std::log(d.run.spacing / run.spacing));
    };
    for (const Done& d : done_)
        if (!best || distance(d) <= distance(*best)) best = &d;
    if (!best) return std::nullopt;
    return best->factor / std::pow(run.spacing, dimension_ + 1);
}

StudyProgress::StudyProgress(std::FILE* stream)
    : stream_(stream), on_terminal_(::isatty(::fileno(stream)) != 0), shown_at_(Clock::now() - interval) {}

StudyProgress::~StudyProgress() {
    if (open_line_) std::fputc('\n', stream_);
}

void StudyProgress::show(std::size_t done, std::size_t all, const std::optional<double>& left,
                         const std::string& running) {
    if (!on_terminal_ || Clock::now() - shown_at_ < interval) return;
    shown_at_ = Clock::now();
    const std::string marks(all == 0 ? bar_width : bar_width * done / all, '#');
    std::string line = fmt::format("[{:-<{}}] {} of {} runs | {} left | {}", marks, bar_width, done, all,
                                   left ? clock_text(*left) : "?:??", running);
    line.resize(std::min(line.size(), terminal_columns(stream_) - 1));  // a wrapped line cannot be redrawn
    std::fputs(fmt::format("\r{}\033[K", line).c_str(), stream_);
    std::fflush(stream_);
    open_line_ = true;
}

void StudyProgress::tell(const std::string& line) {
    std::fputs(fmt::format("{}{}\n", open_line_ ? "\r\033[K" : "", line).c_str(), stream_);
    std::fflush(stream_);
    open_line_ = false;
    shown_at_ = Clock::now() - interval;
}

}  // namespace sluice
