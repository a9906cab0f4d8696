// Stable parallel radix sort of keys with an attached index.
#pragma once

#include <cstdint>

#include "neighbor/fields.hpp"

namespace sluice {

/// Sorts by the lowest `key_bits` bits of the keys, least significant digit first; equal keys keep their order, so the
/// result does not depend on the number of threads. Buffers are kept between calls.
class RadixSorter {
  public:
    /// keys and values are permuted together; both have n entries.
    void sort(Array<std::uint64_t>& keys, Array<Index>& values, int key_bits);

  private:
    Array<std::uint64_t> key_buffer_;
    Array<Index> value_buffer_;
    Array<std::uint32_t> offsets_;  ///< [thread][digit]
};

}  // namespace sluice
