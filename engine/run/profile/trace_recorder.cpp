#include "engine/run/profile/trace_recorder.hpp"

#include <algorithm>

namespace sluice {

TraceRecorder::TraceRecorder(int threads, const TracePlan& plan)
    : plan_(plan), lanes_(static_cast<std::size_t>(threads)) {
    if (plan_.steps == 0) return;
    for (Lane& lane : lanes_) lane.events.reserve(most_events);  // none of it is touched before it is written
}

bool TraceRecorder::begin_step(std::uint64_t number, double time, Nanoseconds at) {
    if (due_ >= plan_.steps || time < plan_.begin + due_ * (plan_.end - plan_.begin) / plan_.steps) return false;
    ++due_;
    for (Lane& lane : lanes_) {
        full_ = full_ || lane.events.size() + lane.most_in_step > most_events;
        lane.before_step = lane.events.size();
    }
    if (full_) return false;
    steps_.push_back({number, time, at, at});
    return true;
}

void TraceRecorder::end_step(Nanoseconds at) {
    steps_.back().end = at;
    for (Lane& lane : lanes_) lane.most_in_step = std::max(lane.most_in_step, lane.events.size() - lane.before_step);
}

void TraceRecorder::add(int thread, const Event& event) {
    Lane& lane = lanes_[static_cast<std::size_t>(thread)];
    if (lane.events.size() < most_events)
        lane.events.push_back(event);
    else
        lane.cut = true;
}

bool TraceRecorder::is_cut() const {
    return full_ || std::any_of(lanes_.begin(), lanes_.end(), [](const Lane& lane) { return lane.cut; });
}

}  // namespace sluice
