// What holds for every neighbour list, held against the plain twin; and lists byte for byte.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "tests/neighbor/search_cases.hpp"

namespace sluice {

/// A list read out row by row, with what the plain twin says about it.
template <int Dim>
class ListReader {
  public:
    /// `within`: the cut-off that the list's rows were made for.
    ListReader(const SearchCase<Dim>& c, const NeighborList& list, const CutOff& within)
        : case_(c), list_(list), view_(list.view()), targets_(c.targets().position.size()) {
        const auto neighbors = c.plain(within);
        is_pair_.assign(c.owned * targets_, 0);
        for (std::size_t i = 0; i < c.owned; ++i) {
            for (const Index j : neighbors[i]) is_pair_[i * targets_ + j] = 1;
            // A pass may need a particle's own share, as the velocity filter does.
            if (c.same_set) is_pair_[i * targets_ + i] = 1;
        }
    }

    /// Of a list that has been built or pruned: the first broken rule by name, or "".
    std::string broken_rule() {
        listed_.assign(case_.owned, 0);
        std::size_t particles = 0;
        for (std::size_t b = 0; b < list_.blocks(); ++b) {
            const ListView::Block& block = view_.block[b];
            if (block.queries.size() < 1 || block.queries.size() > block_size) return "a block has 1 … 16 clusters";
            if (block.parts.size() < 1) return "a listed block has candidates";
            for (Index q = block.queries.begin; q < block.queries.end; ++q) {
                const auto members = queries(q);
                if (members.empty() || members.size() > cluster_size) return "a cluster has 1 … 4 particles";
                particles += members.size();
                for (const Index i : members)
                    if (i >= case_.owned || listed_[i]++) return "each query stands once";
            }
            if (const auto rule = broken_rule_of(block); !rule.empty()) return rule;
        }
        if (particles != list_.size()) return "size() counts the particles";
        for (std::size_t i = 0; i < case_.owned; ++i) {
            const auto row = std::span(is_pair_).subspan(i * targets_, targets_);
            if (!listed_[i] && std::count(row.begin(), row.end(), 1) > 0) return "who has a neighbour is listed";
        }
        return "";
    }

    /// Of a list that has been pruned: whether it has no candidate without a pair, and counts what it has.
    std::string broken_rule_of_pruning() {
        std::uint64_t cluster_pairs = 0;
        for (std::size_t b = 0; b < list_.blocks(); ++b)
            for (Index p = view_.block[b].parts.begin; p < view_.block[b].parts.end; ++p)
                for (Index q = view_.block[b].queries.begin; q < view_.block[b].queries.end; ++q) {
                    const ListView::Row& row = row_of(view_.block[b], p, q);
                    cluster_pairs += row.near;
                    for (std::uint32_t e = 0; e < row.near; ++e)
                        if (!any_pair(q, view_.part[p].candidates.begin + view_.entry[row.begin + e]))
                            return "a near candidate holds a partner";
                }
        return cluster_pairs == list_.cluster_pairs() ? "" : "cluster_pairs() counts the near candidates";
    }

  private:
    std::vector<Index> queries(std::size_t q) const {
        std::vector<Index> members;
        list_.for_queries(q, [&](Index i) { members.push_back(i); });
        return members;
    }
    std::vector<Index> candidates(std::size_t c) const {
        std::vector<Index> members;
        list_.for_candidates(c, [&](Index j) { members.push_back(j); });
        return members;
    }
    const ListView::Row& row_of(const ListView::Block& block, Index part, Index q) const {
        return view_.row[view_.part[part].first_row + (q - block.queries.begin)];
    }
    bool any_pair(std::size_t q, std::size_t c) const {
        bool any = false;
        for (const Index i : queries(q))
            for (const Index j : candidates(c)) any = any || is_pair_[i * targets_ + j];
        return any;
    }

    std::string broken_rule_of(const ListView::Block& block) const {
        std::vector<int> held(targets_, 0);
        for (Index p = block.parts.begin; p < block.parts.end; ++p) {
            const Range c = view_.part[p].candidates;
            if (c.size() < 1 || c.size() > part_size) return "a part has 1 … 256 candidates";
            if (c.size() < part_size && p + 1 != block.parts.end) return "all parts of a block but its last are full";
            for (Index n = c.begin; n < c.end; ++n)
                for (const Index j : candidates(n))
                    if (j >= targets_ || held[j]++) return "each target is a candidate once";
        }
        for (Index q = block.queries.begin; q < block.queries.end; ++q)
            if (const auto rule = broken_rule_of(block, q); !rule.empty()) return rule;
        return "";
    }

    std::string broken_rule_of(const ListView::Block& block, Index q) const {
        std::vector<char> covered(targets_, 0);
        bool equal = true, all_near = true;
        const auto own = queries(q);
        const double reach = case_.queries().reach[own[0]];
        for (const Index i : own) equal = equal && case_.queries().reach[i] == reach;
        for (Index p = block.parts.begin; p < block.parts.end; ++p) {
            const ListView::Row& row = row_of(block, p, q);
            if (row.near > row.listed) return "the near entries are among the listed";
            all_near = all_near && row.near == row.listed;
            for (std::uint32_t e = 0; e < row.near; ++e) {
                const std::uint8_t entry = view_.entry[row.begin + e];
                if (entry >= view_.part[p].candidates.size()) return "entries are numbers of candidates";
                if (e > 0 && entry <= view_.entry[row.begin + e - 1]) return "entries ascend";
                for (const Index j : candidates(view_.part[p].candidates.begin + entry)) {
                    covered[j] = 1;
                    equal = equal && case_.targets().reach[j] == reach;
                }
            }
        }
        if (view_.equal_reach[q] && !equal) return "equal_reach holds for a cluster and its candidates";
        if (all_near && equal && !view_.equal_reach[q]) return "a cluster of one reach with its candidates is told so";
        for (const Index i : own)
            for (std::size_t j = 0; j < targets_; ++j)
                if (is_pair_[i * targets_ + j] && !covered[j]) return "a cluster's row holds all partners";
        return "";
    }

    const SearchCase<Dim>& case_;
    const NeighborList& list_;
    ListView view_;
    std::size_t targets_;
    std::vector<char> is_pair_;
    std::vector<int> listed_;
};

/// The first broken rule of a list that has been pruned to a cut-off for the first time, by name, or "".
template <int Dim>
std::string broken_rule(const SearchCase<Dim>& c, const NeighborList& list, const CutOff& within) {
    ListReader<Dim> reader(c, list, within);
    const auto rule = reader.broken_rule();
    return rule.empty() ? reader.broken_rule_of_pruning() : rule;
}

/// The same of a list that has been pruned again: in single precision, to a hair more than was asked for.
template <int Dim>
std::string broken_rule_when_pruned_again(const SearchCase<Dim>& c, const NeighborList& list, const CutOff& within) {
    const auto rule = ListReader<Dim>(c, list, within).broken_rule();
    constexpr double hair = 1 + 2e-5;  // 1e-5 on purpose, the rest for rounding
    const CutOff wider{hair * within.skin, hair * within.query_scale, hair * within.target_scale};
    return rule.empty() ? ListReader<Dim>(c, list, wider).broken_rule_of_pruning() : rule;
}

/// All that a pruned list says, number by number.
inline std::vector<std::uint64_t> contents(const NeighborList& list) {
    const ListView view = list.view();
    std::vector<std::uint64_t> all{list.blocks(), list.size(), list.pairs(), list.cluster_pairs()};
    const auto add = [&](Index i) { all.push_back(i); };
    for (std::size_t b = 0; b < list.blocks(); ++b) {
        const ListView::Block& block = view.block[b];
        for (Index q = block.queries.begin; q < block.queries.end; ++q) {
            all.push_back(view.equal_reach[q]);
            list.for_queries(q, add);
        }
        for (Index p = block.parts.begin; p < block.parts.end; ++p) {
            for (Index c = view.part[p].candidates.begin; c < view.part[p].candidates.end; ++c)
                list.for_candidates(c, add);
            for (Index q = 0; q < block.queries.size(); ++q) {
                const ListView::Row& row = view.row[view.part[p].first_row + q];
                all.push_back(row.near);
                all.insert(all.end(), view.entry + row.begin, view.entry + row.begin + row.near);
            }
        }
    }
    return all;
}

}  // namespace sluice
