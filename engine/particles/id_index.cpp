#include "engine/particles/id_index.hpp"

#include <algorithm>

namespace sluice {

void IdIndex::update(const Array<std::uint64_t>& id, std::size_t count) {
    const std::uint64_t near = 2 * count + 64;  // a table of that size costs no more than the ids themselves
    std::uint64_t size = 0;
    far_index_.clear();
    for (std::size_t i = 0; i < count; ++i) {
        if (id[i] < near)
            size = std::max(size, id[i] + 1);
        else
            far_index_.push_back(static_cast<Index>(i));
    }
    table_.assign(size, none);
    for (std::size_t i = 0; i < count; ++i)
        if (id[i] < near) table_[id[i]] = static_cast<Index>(i);
    std::sort(far_index_.begin(), far_index_.end(), [&](Index a, Index b) { return id[a] < id[b]; });
    far_id_.clear();
    for (const Index i : far_index_) far_id_.push_back(id[i]);
}

Index IdIndex::find(std::uint64_t id) const {
    const auto at = std::lower_bound(far_id_.begin(), far_id_.end(), id);
    if (at == far_id_.end() || *at != id) return none;
    return far_index_[static_cast<std::size_t>(at - far_id_.begin())];
}

std::size_t IdIndex::bytes() const {
    return (table_.capacity() + far_index_.capacity()) * sizeof(Index) + far_id_.capacity() * sizeof(std::uint64_t);
}

}  // namespace sluice
