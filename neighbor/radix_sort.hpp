// Stable parallel radix sort of keys with an attached index.
#pragma once

#include <cstdint>

#include "neighbor/fields.hpp"

namespace sluice {

/// Sorts by the lowest `key_bits` bits of the keys, least significant digit first; equal keys keep their order, so the
/// result does not depend on the number of threads. Keys and values are permuted together; both have n entries. What it
/// needs beside them, 12 n bytes, is given back: grids are built seldom, and memory is short the whole time.
void radix_sort(Array<std::uint64_t>& keys, Array<Index>& values, int key_bits);

}  // namespace sluice
