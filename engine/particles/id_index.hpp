// Finds a particle by its id.
#pragma once

#include <cstdint>
#include <limits>

#include "neighbor/fields.hpp"

namespace sluice {

/// Ids may have gaps. Most are looked up in a table; those far beyond the number of particles by binary search.
class IdIndex {
  public:
    static constexpr Index none = std::numeric_limits<Index>::max();

    IdIndex() = default;
    /// Indexes these ids.
    explicit IdIndex(const Array<std::uint64_t>& id) { update(id, id.size()); }

    /// Indexes the first `count` ids.
    void update(const Array<std::uint64_t>& id, std::size_t count);

    /// The particle's index, or `none`.
    Index operator[](std::uint64_t id) const { return id < table_.size() ? table_[id] : find(id); }

    /// visit(name, member) for each member.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("table", table_), visit("far_id", far_id_), visit("far_index", far_index_);
    }
    std::size_t bytes() const;

  private:
    Index find(std::uint64_t id) const;

    Array<Index> table_;           ///< index by id
    Array<std::uint64_t> far_id_;  ///< ids beyond the table, rising
    Array<Index> far_index_;       ///< index of each of these
};

}  // namespace sluice
