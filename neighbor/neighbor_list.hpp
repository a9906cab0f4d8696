// Neighbour lists: for each cluster of particles of one set, the clusters of another (or the same) that hold a particle
// within a cut-off of one of its own.
//
// A list is built with a skin: it holds every pair closer than the cut-off plus the skin, and so stays complete until
// two particles together have moved by more than the skin. In between it is pruned with a thinner skin now and then:
// loops then run over the rows that are left.
#pragma once

#include <cstdint>
#include <span>

#include "neighbor/cluster_grid.hpp"
#include "neighbor/fields.hpp"

namespace sluice {

/// Most candidates in a part, so that a row's entries are bytes.
inline constexpr Index part_size = 256;

/// Up to cluster_size particles: `first`, first + 1, … if `in_sequence`, else index[first], index[first + 1], ….
struct ListedCluster {
    Index first = 0;
    std::uint8_t size = 0;
    bool in_sequence = false;

    /// The particle in a lane; the first one in a lane that has none.
    [[gnu::always_inline]] Index particle(Index lane, const Index* index) const {
        const Index at = first + (lane < size ? lane : 0);
        return in_sequence ? at : index[at];
    }
};

/// What a loop over pairs sees of a list. Blocks hold consecutive query clusters; a block's candidates come in parts;
/// for each part, each of the block's clusters has a row of candidates (numbers within the part).
struct ListView {
    struct Block {
        Range queries;  ///< in `query`
        Range parts;    ///< in `part`
    };
    struct Part {
        Range candidates;         ///< in `candidate`
        std::uint32_t first_row;  ///< of the block's first query cluster
    };
    /// Entries row_begin … row_end − 1 of `entry`.
    struct Row {
        std::uint64_t begin = 0;
        std::uint32_t listed = 0;  ///< entries since the list was built
        std::uint32_t near = 0;    ///< those of them, in front, that pruning has left
    };

    const Block* block = nullptr;
    const Part* part = nullptr;
    const ListedCluster* query = nullptr;
    const ListedCluster* candidate = nullptr;
    const Row* row = nullptr;
    const std::uint8_t* entry = nullptr;
    const std::uint8_t* equal_reach =
        nullptr;  ///< per query cluster: it and its candidates have one and the same reach
    const Index* query_index = nullptr;
    const Index* candidate_index = nullptr;
};

class NeighborList {
  public:
    /// Blocks that have a candidate: a pass runs only where it acts.
    std::size_t blocks() const { return block_.size(); }
    /// Particles in all blocks.
    std::size_t size() const { return size_; }
    /// Directed pairs within the cut-off, without the skin and without a particle itself, when the list was built.
    std::uint64_t pairs() const { return pairs_; }
    /// Pairs of clusters that a loop goes over, 16 pairs of particles each.
    std::uint64_t cluster_pairs() const { return work_.empty() ? 0 : work_.back(); }

    /// calls visit(particle) for the particles of query cluster q or of a candidate.
    template <class Visit>
    void for_queries(std::size_t q, Visit&& visit) const {
        for_members(query_[q], query_index_, visit);
    }
    template <class Visit>
    void for_candidates(std::size_t c, Visit&& visit) const {
        for_members(candidate_[c], candidate_index_, visit);
    }
    ListView view() const {
        return {block_.data(), part_.data(),        query_.data(),       candidate_.data(),      row_.data(),
                near_.data(),  equal_reach_.data(), query_index_.data(), candidate_index_.data()};
    }
    /// The blocks of share k of n: consecutive, of about equal work.
    Range share(int k, int n) const;

    std::size_t bytes() const;
    /// What one loop over the list reads of it.
    std::size_t loop_bytes() const;
    /// Clusters of candidates over all blocks; one that is near several blocks counts once for each.
    std::size_t candidate_clusters() const { return candidate_.size(); }
    void clear();

    /// visit(name, member) for each member: a copy of them all is the same list.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("block", block_), visit("part", part_), visit("query", query_), visit("candidate", candidate_);
        visit("row", row_), visit("listed", listed_), visit("near", near_), visit("equal_reach", equal_reach_);
        visit("query_index", query_index_), visit("candidate_index", candidate_index_), visit("work", work_);
        visit("size", size_), visit("pairs", pairs_), visit("counted", counted_);
    }

    /// Leaves out the query clusters that hold no particle of those `wanted` (by index). The others' rows, and so the
    /// sums over them, stay what they are, to the bit. Prune before use.
    void keep_queries(std::span<const std::uint8_t> wanted);
    /// Sets the mark of each particle (by index) that stands in a row of a cluster with one of those `wanted`.
    void mark_candidates(std::span<const std::uint8_t> wanted, std::span<std::uint8_t> mark) const;

    template <int Dim>
    friend class NeighborSearch;

  private:
    template <class Visit>
    static void for_members(const ListedCluster& c, const Array<Index>& index, Visit&& visit) {
        for (Index l = 0; l < c.size; ++l) visit(c.particle(l, index.data()));
    }
    std::uint64_t pairs_of_clusters(const ListView::Block& block) const;
    bool holds_any(std::size_t q, std::span<const std::uint8_t> wanted) const;
    void append_block(const NeighborList& from, const ListView::Block& block, std::span<const Index> queries);

    Array<ListView::Block> block_;
    Array<ListView::Part> part_;
    Array<ListedCluster> query_, candidate_;
    Array<ListView::Row> row_;
    Array<std::uint8_t> listed_, near_;  ///< entries as found, and as pruning left them
    Array<std::uint8_t> equal_reach_;
    Array<Index> query_index_, candidate_index_;  ///< particles of clusters that are not in sequence
    Array<std::uint64_t> work_;                   ///< cluster pairs up to each block's end
    std::size_t size_ = 0;
    std::uint64_t pairs_ = 0;
    bool counted_ = false;
};

/// The cut-off of a pair: query_scale · reach_i + target_scale · reach_j + skin.
struct CutOff {
    double skin = 0;
    double query_scale = 1, target_scale = 1;
};

/// Boxes and reaches of candidates, column by column, filled up to a multiple of box_multiple with boxes that are near
/// nothing.
template <int Dim>
struct BoxColumns {
    Array<double> lo[Dim], hi[Dim], min_reach, max_reach;

    std::size_t size() const { return max_reach.size(); }
    void resize(std::size_t n) {
        for (int k = 0; k < Dim; ++k) {
            lo[k].resize(n);
            hi[k].resize(n);
        }
        min_reach.resize(n);
        max_reach.resize(n);
    }
};
inline constexpr std::size_t box_multiple = 8;

/// What is near a cluster.
struct NearBoxes {
    std::uint32_t count = 0;
    bool equal_reach = true;  ///< all that are near have the cluster's own reach
};

/// Builds lists from cluster grids.
template <int Dim>
class NeighborSearch {
  public:
    /// Particles, each with its share of a pair's cut-off, and the grids over parts of them.
    struct Set {
        const VectorField<Dim>& position;
        std::span<const double> reach;  ///< of every particle
    };

    /// Lists what the target grids hold near the query grid's clusters, and perhaps a little more: distances are those
    /// of boxes. Clusters stand in the query grid's order, candidates cell by cell, whatever the number of threads. If
    /// both sets have the same position field, the target grids must hold the queries: a particle is then among its own
    /// candidates. Prune before use.
    void build(const ClusterGrid<Dim>& query, std::span<const ClusterGrid<Dim>* const> targets, const CutOff& cut,
               NeighborList& list);

    /// Shortens the rows to what lies within the cut-off. The first time after a build it also counts the pairs within
    /// it but for the skin.
    void prune(const Set& query, const Set& target, const CutOff& cut, NeighborList& list);

  private:
    /// What one thread finds in its share of the query's blocks.
    struct Share {
        Array<ListView::Block> block;
        Array<ListView::Part> part;
        Array<ListedCluster> query, candidate;
        Array<ListView::Row> row;
        Array<std::uint8_t> entry, equal_reach;
        Array<Index> query_index, candidate_index;
        std::size_t size = 0;
        /// Candidates of the block in hand, as (grid, cluster).
        Array<Index> near_grid, near_cluster;
        BoxColumns<Dim> near_box;
    };
    struct Job {
        const ClusterGrid<Dim>& query;
        std::span<const ClusterGrid<Dim>* const> targets;
        CutOff cut;
        NearBoxes (*find_near)(const BoxColumns<Dim>&, std::size_t, std::size_t, const Extent<Dim>&, const CutOff&,
                               std::uint8_t*);
    };
    static void search_block(const Job& job, std::size_t block, Share& share);
    static void list_part(const Job& job, Range clusters, std::size_t first_near, std::size_t last_near, Share& share);
    static void join(const std::vector<Share>& shares, NeighborList& list);
};

extern template class NeighborSearch<2>;
extern template class NeighborSearch<3>;

}  // namespace sluice
