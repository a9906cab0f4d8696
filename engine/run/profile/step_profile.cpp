#include "engine/run/profile/step_profile.hpp"

#include <sys/resource.h>

namespace sluice {
long interruptions() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_nivcsw;
}

StepProfile::StepProfile(int threads, const TracePlan& plan)
    : lanes_(static_cast<std::size_t>(threads)), trace_(threads, plan) {
    add_place(nullptr, 0);
}

/// While no other thread works: their sums are made room for here.
std::size_t StepProfile::add_place(const Section* section, std::size_t parent) {
    const std::size_t added = places_.size();
    places_.emplace_back();
    places_[added].section = section;
    places_[added].parent = parent;
    if (added > 0) places_[parent].inside.push_back(added);
    for (Lane& lane : lanes_) lane.busy.push_back(0);
    return added;
}

void StepProfile::begin_step(std::uint64_t number, double time) {
    current_ = 0;
    const Nanoseconds now = clock_now();
    tracing_ = trace_.begin_step(number, time, now);
    places_[0].entered = now;
    loop_watch = this;
}

void StepProfile::end_step() {
    loop_watch = nullptr;
    const Nanoseconds now = clock_now();
    Place& step = places_[0];
    ++step.calls;
    step.wall += now - step.entered;
    if (!tracing_) return;
    trace_.add(0, {TraceRecorder::Kind::section, 0, step.entered, now});
    trace_.end_step(now);
    tracing_ = false;
}

void StepProfile::enter(const Section& section) {
    std::size_t found = 0;
    for (const std::size_t inside : places_[current_].inside)
        if (places_[inside].section == &section) found = inside;
    current_ = found == 0 ? add_place(&section, current_) : found;
    places_[current_].entered = clock_now();
}

void StepProfile::leave(const PairWork& work) {
    Place& place = places_[current_];
    // A loop is left when its team has come together: the clock was read just then.
    const bool is_loop = place.section->number_bytes > 0;
    const Nanoseconds now = is_loop && joined_at_ > place.entered ? joined_at_ : clock_now();
    ++place.calls;
    place.wall += now - place.entered;
    place.work += work;
    if (tracing_) trace_.add(0, {TraceRecorder::Kind::section, static_cast<std::uint32_t>(current_), place.entered, now});
    current_ = place.parent;
}

void StepProfile::worked(int thread, Nanoseconds begin, Nanoseconds end) {
    if (thread >= threads()) return;
    lanes_[static_cast<std::size_t>(thread)].busy[current_] += end - begin;
    if (thread == 0) share_end_ = end;
    if (tracing_) trace_.add(thread, {TraceRecorder::Kind::share, static_cast<std::uint32_t>(current_), begin, end});
}

void StepProfile::joined(Nanoseconds at) {
    joined_at_ = at;
    places_[current_].waited += at - share_end_;
    if (tracing_) trace_.add(0, {TraceRecorder::Kind::wait, static_cast<std::uint32_t>(current_), share_end_, at});
}

/// The first thread works whenever it does not wait for the others; the others work in loops alone.
std::vector<StepProfile::Entry> StepProfile::entries() const {
    std::vector<Entry> entries;
    for (std::size_t p = 0; p < places_.size(); ++p) {
        const Place& place = places_[p];
        entries.push_back({place.section, place.parent, place.calls, place.wall, place.work, {place.waited}});
        for (std::size_t t = 1; t < lanes_.size(); ++t) entries.back().busy.push_back(lanes_[t].busy[p]);
    }
    // Those inside come behind: by the time that an entry is handed on, it is complete.
    for (std::size_t p = entries.size(); p-- > 1;)
        for (std::size_t t = 0; t < lanes_.size(); ++t) entries[entries[p].parent].busy[t] += entries[p].busy[t];
    for (Entry& entry : entries) entry.busy[0] = entry.wall - entry.busy[0];
    return entries;
}

}  // namespace sluice
