// Memory of an effect's fields.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "engine/scene/effects/effect_table.hpp"

namespace sluice {

/// A column that an effect needs.
struct ColumnBytes {
    std::string_view phase;  ///< "fluid", "solid", "wall", "elements", "boundary"
    std::string_view column;
    std::size_t bytes = 0;  ///< per particle of that phase
};

/// All columns of a phase that an effect needs.
struct FieldBytes {
    std::string_view phase;
    std::size_t bytes = 0;  ///< per particle of that phase
};

/// Phase by phase.
template <int Dim>
std::vector<ColumnBytes> column_bytes_of(const EffectInfo& effect);

/// The same, summed over each phase.
template <int Dim>
std::vector<FieldBytes> field_bytes(const EffectInfo& effect);

}  // namespace sluice
