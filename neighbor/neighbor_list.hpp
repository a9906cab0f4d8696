// Neighbour lists: for each particle of one set, the particles of another (or the same) within a cut-off.
//
// A list is built with a skin: it holds every pair closer than the cut-off plus the skin, and so stays complete until
// two particles together have moved by more than the skin.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "neighbor/cell_grid.hpp"
#include "neighbor/fields.hpp"

namespace sluice {

/// The cut-off of a pair: query_scale · the query's reach + target_scale · the target's reach + skin, where the reaches
/// are those that the grids were built with. An empty span counts as reach 0.
struct PairReach {
    std::span<const double> query;
    std::span<const double> target;
    double skin = 0;
    double query_scale = 1;
    double target_scale = 1;

    double of_query(std::size_t i) const { return query.empty() ? 0.0 : query_scale * query[i]; }
    double of_target(std::size_t j) const { return target.empty() ? 0.0 : target_scale * target[j]; }
};

/// Most particles in a group.
inline constexpr int max_group_size = 8;

/// Particles that are near each other form a group and share one list of candidates: every particle that one of them
/// may have as neighbour. Only groups that have a candidate are listed, so that a pass runs only where it acts. With a
/// group size of 1 the candidates are the particle's own neighbours.
class NeighborList {
  public:
    std::size_t groups() const { return candidate_start_.size() - 1; }
    /// The particles of a group, at most max_group_size.
    std::span<const Index> queries(std::size_t group) const {
        return {query_.data() + query_start_[group], query_start_[group + 1] - query_start_[group]};
    }
    std::span<const Index> candidates(std::size_t group) const {
        return {candidate_.data() + candidate_start_[group], candidate_start_[group + 1] - candidate_start_[group]};
    }
    /// True if a group's particles and all its candidates have one and the same reach.
    bool equal_reach(std::size_t group) const { return equal_reach_[group] != 0; }
    /// Particles in all groups.
    std::size_t size() const { return query_.size(); }
    /// Directed pairs within the cut-off, without the skin and without a particle itself, when the list was built.
    std::uint64_t pairs() const { return pairs_; }
    std::size_t bytes() const {
        return (query_.capacity() + candidate_.capacity() + query_start_.capacity()) * sizeof(Index) +
               candidate_start_.capacity() * sizeof(std::uint64_t) + equal_reach_.capacity();
    }
    void clear();

    template <int Dim>
    friend class NeighborSearch;

  private:
    Array<Index> query_;
    Array<Index> query_start_{0};
    Array<Index> candidate_;
    Array<std::uint64_t> candidate_start_{0};
    Array<std::uint8_t> equal_reach_;
    std::uint64_t pairs_ = 0;
};

/// Targets around one cell, packed: read once from memory, then tested against each of the cell's groups.
template <int Dim>
struct NearTargets {
    std::array<ScalarField, Dim> x;
    ScalarField reach;
    Array<Index> index;

    void resize(std::size_t n) {
        for (auto& column : x) column.resize(n);
        reach.resize(n);
        index.resize(n);
    }
};

/// Builds lists from cell grids; keeps its buffers between builds.
template <int Dim>
class NeighborSearch {
  public:
    /// A set of particles with the grid built over it.
    struct Set {
        const VectorField<Dim>& position;
        const CellGrid<Dim>& grid;
    };

    /// Candidates in `target` for those particles of `query` whose index is below `owned`, in groups of at most
    /// group_size. Groups stand in the query grid's order, candidates in the target grid's, whatever the number of
    /// threads. If both sets are the same object, a group's own particles are among its candidates, so that every owned
    /// particle is listed, one that has nobody else too; with a group size of 1 a particle is not its own.
    void build(const Set& query, std::size_t owned, const Set& target, const PairReach& reach, int group_size,
               NeighborList& list);

  private:
    /// What one thread finds in its share of the query's cells.
    struct Share {
        std::size_t first_cell = 0, last_cell = 0;
        Array<Index> query, query_count, candidate, candidate_count;
        Array<std::uint8_t> equal_reach;
        Array<Index> members;  ///< owned particles of the cell in hand
        std::uint64_t pairs = 0;
        NearTargets<Dim> near;        ///< of the cell in hand
        Array<std::uint8_t> is_near;  ///< of the group in hand
    };
    /// One call of build().
    struct Job {
        const Set& query;
        std::size_t owned;
        const Set& target;
        const PairReach& reach;
        int group_size;
    };
    static void search_cells(const Job& job, Share& share);
    static void search_group(const Job& job, std::span<const Index> group, Share& share);
    void join(NeighborList& list) const;

    std::vector<Share> shares_;
};

extern template class NeighborSearch<2>;
extern template class NeighborSearch<3>;

}  // namespace sluice
