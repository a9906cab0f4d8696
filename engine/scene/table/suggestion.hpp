// "Did you mean …?": the nearest of the words that would have been right.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sluice {

/// Insertions, deletions, replacements and swaps of neighbouring letters that lead from a to b.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate that `word` is most likely a slip of; empty if none is near.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// `; did you mean "…"?`, or nothing if no candidate is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

/// `one of "a", "b"`; `"a"` alone if it is the only one.
std::string one_of(const std::vector<std::string>& candidates);

}  // namespace sluice
