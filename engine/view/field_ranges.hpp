// Between which values colours are spread, and which part of space is looked at: of all frames, without being led by a
// few.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/view/field.hpp"

namespace sluice {

struct ValueRange {
    double low = 0, high = 0;    ///< that nearly all particles of nearly all frames lie between
    double least = 0, most = 0;  ///< that all lie between
};

/// Adds up frame by frame. What a run's first pressure wave or a lone drop does in one frame shifts no colour of the
/// others: of each frame the 1st and the 99th percentile count, and of these over the frames the 5th and the 95th.
class FieldRanges {
  public:
    void add(const FrameTable& table, int dimension);

    std::vector<std::string> fields() const;
    /// None if no particle of the medium has a value.
    std::optional<ValueRange> of(const std::string& field, FrameMedium medium) const;
    /// Low and high end of x, y, z, where particles are; a lone thousandth in each direction is left out.
    std::array<std::pair<double, double>, 3> bounds() const { return bounds_; }

  private:
    struct Frames {
        std::vector<float> low, high;  ///< of each frame
        float least = 0, most = 0;
    };
    std::map<std::string, std::array<Frames, 3>> fields_;
    std::array<std::pair<double, double>, 3> bounds_{};
    bool empty_ = true;
};

}  // namespace sluice
