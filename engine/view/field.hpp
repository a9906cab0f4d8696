// What is stored per particle, by name: units, and columns of single numbers.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/run/output/frame_table.hpp"

namespace sluice {

/// In SI; empty for a number without unit or of unknown kind.
std::string_view field_unit(std::string_view field);

/// Every `stride`-th number, without a copy.
struct NumberColumn {
    std::string name;
    const float* first = nullptr;
    std::size_t count = 0, stride = 1;

    float operator[](std::size_t i) const { return first[i * stride]; }
};

/// x, y, in 3D also z.
std::vector<NumberColumn> position_columns(const FrameTable& table, int dimension);
/// Scalars, and the velocity as velocity_x, velocity_y, in 3D also velocity_z. Valid as long as the table is.
std::vector<NumberColumn> field_columns(const FrameTable& table, int dimension);

/// The names in `asked` as columns, `velocity` as its components; all of them, speed apart, if none is asked for: it
/// follows from the velocity. Throws RunReadError for a name that is not there, with the nearest one.
std::vector<std::string> chosen_fields(const FrameTable& table, int dimension, const std::vector<std::string>& asked);

}  // namespace sluice
