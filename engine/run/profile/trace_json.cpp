#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/run/profile/profile_text.hpp"

namespace sluice {
namespace {

using Event = TraceRecorder::Event;

/// Between two traced steps, in place of the time between them.
constexpr Nanoseconds gap = 10'000;

double micro(Nanoseconds t) { return 1e-3 * static_cast<double>(t); }

/// What the events of one thread are made of.
class EventText {
  public:
    EventText(const StepProfile& recorded, const Effects& effects) : steps_(recorded.trace().steps()) {
        const auto entries = recorded.entries();
        for (const auto& entry : entries) {
            const bool is_loop = entry.section && entry.section->number_bytes > 0;
            name_.emplace_back(entry.section ? entry.section->name : "step");
            category_.emplace_back(is_loop ? "loop" : entry.section ? "phase" : "step");
            arguments_.emplace_back();
            if (!is_loop) continue;
            const auto found = effects_at(effects, entries[entry.parent].section->name, name_.back());
            arguments_.back() = fmt::format(R"("effects":"{}")", keys_text(found, effects));
        }
        Nanoseconds start = 0;
        for (const TraceRecorder::Step& step : steps_) {
            shift_.push_back(step.begin - start);
            start += step.end - step.begin + gap;
        }
    }

    std::string operator()(int thread, const Event& event) const {
        const std::size_t step = step_of(event);
        const Nanoseconds begin = event.begin - shift_[step];
        std::string text =
            fmt::format(R"({{"name":"{}","cat":"{}","ph":"X","ts":{:.3f},"dur":{:.3f},"pid":1,"tid":{})",
                        name(thread, event), category(event), micro(begin), micro(event.end - event.begin), thread);
        const bool is_section = event.kind == TraceRecorder::Kind::section;
        if (is_section && !arguments_[event.entry].empty())
            text += fmt::format(R"(,"args":{{{}}})", arguments_[event.entry]);
        text += "}";
        return is_section && event.entry == 0 ? text + ",\n" + mark(steps_[step], begin) : text;
    }

  private:
    std::size_t step_of(const Event& event) const {
        const auto later = std::upper_bound(steps_.begin(), steps_.end(), event.begin,
                                            [](Nanoseconds t, const TraceRecorder::Step& s) { return t < s.begin; });
        return static_cast<std::size_t>(later - steps_.begin()) - 1;
    }
    std::string_view name(int thread, const Event& event) const {
        switch (event.kind) {
            case TraceRecorder::Kind::wait:
                return "wait for other threads";
            case TraceRecorder::Kind::share:
                if (thread == 0) return "share of the loop";
                break;
            case TraceRecorder::Kind::section:
                break;
        }
        return name_[event.entry];
    }
    std::string_view category(const Event& event) const {
        switch (event.kind) {
            case TraceRecorder::Kind::section:
                return category_[event.entry];
            case TraceRecorder::Kind::share:
                return "share";
            case TraceRecorder::Kind::wait:
                return "wait";
        }
        return {};
    }
    /// Which step it is, at its beginning. Not as an argument of the step: flame graphs add up what is called the same.
    std::string mark(const TraceRecorder::Step& step, Nanoseconds begin) const {
        return fmt::format(
            R"({{"name":"step {}","ph":"i","s":"t","ts":{:.3f},"pid":1,"tid":0,"args":{{"step":{},"time [s]":{:.9g},"begin [us]":{:.3f}}}}})",
            step.number, micro(begin), step.number, step.time, micro(step.begin - steps_.front().begin));
    }

    const std::vector<TraceRecorder::Step>& steps_;
    std::vector<std::string> name_, category_, arguments_;  ///< by entry
    std::vector<Nanoseconds> shift_;                        ///< by step: what is taken off the clock
};

/// As viewers nest them: what contains others in front of them, and each strictly within what contains it. An event
/// that ends when the next one begins would count as containing it, by a rounding error of the viewer's: so each ends a
/// nanosecond early.
std::vector<Event> nested(std::vector<Event> events) {
    std::sort(events.begin(), events.end(), [](const Event& a, const Event& b) {
        if (a.begin != b.begin) return a.begin < b.begin;
        if (a.end != b.end) return a.end > b.end;
        return a.kind != b.kind ? a.kind < b.kind : a.entry < b.entry;
    });
    std::vector<Nanoseconds> ends;
    for (Event& event : events) {
        while (!ends.empty() && ends.back() < event.begin) ends.pop_back();
        --event.end;
        if (!ends.empty()) event.end = std::min(event.end, ends.back() - 1);
        event.end = std::max(event.end, event.begin);
        ends.push_back(event.end);
    }
    return events;
}

std::string name_of_row(const char* what, int thread, const std::string& name) {
    return fmt::format(R"({{"name":"{}","ph":"M","pid":1,"tid":{},"args":{{"name":{}}}}})", what, thread,
                       nlohmann::json(name).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace

std::string trace_json(const StepProfile& recorded, const Effects& effects, const std::string& title) {
    const TraceRecorder& trace = recorded.trace();
    std::string text = "{\"displayTimeUnit\":\"ns\",\"traceEvents\":[\n" + name_of_row("process_name", 0, title);
    for (int t = 0; t < trace.threads(); ++t)
        text += ",\n" + name_of_row("thread_name", t, fmt::format("thread {}{}", t, t == 0 ? ", takes the steps" : ""));
    const EventText text_of(recorded, effects);
    for (int t = 0; t < trace.threads(); ++t)
        for (const Event& event : nested(trace.events(t))) text += ",\n" + text_of(t, event);
    return text + "\n]}\n";
}

}  // namespace sluice
