// A list without the rows of those who need no sums.
#include <algorithm>
#include <utility>

#include "neighbor/neighbor_list.hpp"

namespace sluice {
namespace {

/// Appends a cluster, and its particles' indices if they are not in sequence.
void append_cluster(const ListedCluster& c, const Array<Index>& from, Array<ListedCluster>& to, Array<Index>& index) {
    if (c.in_sequence) {
        to.push_back(c);
        return;
    }
    to.push_back({static_cast<Index>(index.size()), c.size, false});
    index.insert(index.end(), from.begin() + c.first, from.begin() + c.first + c.size);
}

}  // namespace

bool NeighborList::holds_any(std::size_t q, std::span<const std::uint8_t> wanted) const {
    bool any = false;
    for_queries(q, [&](Index i) { any = any || wanted[i] != 0; });
    return any;
}

/// Parts keep all of their candidates, so that sums are taken in the same portions.
void NeighborList::append_block(const NeighborList& from, const ListView::Block& block,
                                std::span<const Index> queries) {
    ListView::Block made;
    made.queries.begin = static_cast<Index>(query_.size());
    for (const Index q : queries) {
        append_cluster(from.query_[q], from.query_index_, query_, query_index_);
        equal_reach_.push_back(from.equal_reach_[q]);
        size_ += from.query_[q].size;
    }
    made.queries.end = static_cast<Index>(query_.size());
    made.parts.begin = static_cast<Index>(part_.size());
    for (Index p = block.parts.begin; p < block.parts.end; ++p) {
        const ListView::Part& part = from.part_[p];
        const auto first = static_cast<Index>(candidate_.size());
        for (Index c = part.candidates.begin; c < part.candidates.end; ++c)
            append_cluster(from.candidate_[c], from.candidate_index_, candidate_, candidate_index_);
        part_.push_back({{first, static_cast<Index>(candidate_.size())}, static_cast<std::uint32_t>(row_.size())});
        for (const Index q : queries) {
            const ListView::Row& row = from.row_[part.first_row + (q - block.queries.begin)];
            row_.push_back({listed_.size(), row.listed, row.near});
            const auto begin = from.listed_.begin() + static_cast<std::ptrdiff_t>(row.begin);
            listed_.insert(listed_.end(), begin, begin + row.listed);
        }
    }
    made.parts.end = static_cast<Index>(part_.size());
    block_.push_back(made);
}

void NeighborList::keep_queries(std::span<const std::uint8_t> wanted) {
    NeighborList kept;
    Array<Index> queries;
    for (const ListView::Block& block : block_) {
        queries.clear();
        for (Index q = block.queries.begin; q < block.queries.end; ++q)
            if (holds_any(q, wanted)) queries.push_back(q);
        if (!queries.empty()) kept.append_block(*this, block, queries);
    }
    kept.near_ = kept.listed_;
    *this = std::move(kept);
}

void NeighborList::mark_candidates(std::span<const std::uint8_t> wanted, std::span<std::uint8_t> mark) const {
    for (const ListView::Block& block : block_)
        for (Index q = block.queries.begin; q < block.queries.end; ++q) {
            if (!holds_any(q, wanted)) continue;
            for (Index p = block.parts.begin; p < block.parts.end; ++p) {
                const ListView::Row& row = row_[part_[p].first_row + (q - block.queries.begin)];
                for (std::uint32_t e = 0; e < row.near; ++e)
                    for_candidates(part_[p].candidates.begin + near_[row.begin + e], [&](Index j) { mark[j] = 1; });
            }
        }
}

}  // namespace sluice
