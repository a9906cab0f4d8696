#include "engine/run/schedule.hpp"

#include <cmath>

namespace sluice {

Schedule::Answer Schedule::ask(double time, double dt) {
    const double reached = time + dt / 2;
    if (interval_ <= 0 || reached < next_ * interval_) return Answer::wait;
    next_ += 1;
    // Steps longer than the interval skip what they jumped over.
    if (reached >= next_ * interval_) next_ = std::floor(reached / interval_) + 1;
    return Answer::due;
}

}  // namespace sluice
