// Keep the TOML library from tables nested deeper than its stack.
#pragma once

#include <string_view>

namespace sluice {

/// The longest key that a scene needs has five parts: bodies.NAME.shape.box.min.
inline constexpr int most_key_parts = 16;

/// Line of the first key with more parts than that; 0 if there is none. `a.b.c` makes tables in tables, as many as one
/// likes, which the library reads and takes apart by recursion: some ten thousand are a stack. (What nests by brackets
/// it counts itself.)
int line_of_long_key(std::string_view text);

}  // namespace sluice
