#include "neighbor/neighbor_list.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "neighbor/parallel.hpp"

namespace sluice {

void NeighborList::clear() {
    query_.clear();
    query_start_.assign(1, 0);
    candidate_.clear();
    candidate_start_.assign(1, 0);
    pairs_ = 0;
}

namespace {

/// The smallest box around some particles.
template <int Dim>
struct Extent {
    Vec<Dim> lo, hi;

    Extent(const VectorField<Dim>& position, std::span<const Index> particles)
        : lo(position[particles[0]]), hi(position[particles[0]]) {
        for (const Index i : particles)
            for (int k = 0; k < Dim; ++k) {
                lo[k] = std::min(lo[k], position.c[static_cast<std::size_t>(k)][i]);
                hi[k] = std::max(hi[k], position.c[static_cast<std::size_t>(k)][i]);
            }
    }
    double distance2(const Vec<Dim>& x) const {
        double d2 = 0;
        for (int k = 0; k < Dim; ++k) {
            const double gap = std::max({0.0, x[k] - hi[k], lo[k] - x[k]});
            d2 += gap * gap;
        }
        return d2;
    }
};

/// A group's positions and reaches in a fixed number of lanes, for counting pairs without a branch.
template <int Dim>
class GroupMembers {
  public:
    GroupMembers(const VectorField<Dim>& position, std::span<const Index> group, const PairReach& reach) {
        for (std::size_t m = 0; m < max_group_size; ++m) {
            const bool there = m < group.size();
            for (std::size_t k = 0; k < Dim; ++k) x_[k][m] = there ? position.c[k][group[m]] : nowhere;
            reach_[m] = there ? reach.of_query(group[m]) : 0;
        }
    }
    double largest_reach() const { return *std::max_element(reach_, reach_ + max_group_size); }
    /// How many members are closer to x than their reach and this one's.
    int within_support(const Vec<Dim>& x, double reach) const {
        int count = 0;
        for (int m = 0; m < max_group_size; ++m) {
            double d2 = 0;
            unroll<Dim>([&](int k) { d2 += (x_[k][m] - x[k]) * (x_[k][m] - x[k]); });
            const double support = reach_[m] + reach;
            count += d2 < support * support;
        }
        return count;
    }

  private:
    static constexpr double nowhere = 1e200;
    double x_[Dim][max_group_size];
    double reach_[max_group_size];
};

/// Lower bound for the squared distance between a box [lo, hi] and a cell of the grid.
template <int Dim>
double box_distance2(const Vec<Dim>& lo, const Vec<Dim>& hi, const CellGrid<Dim>& grid,
                     const std::array<std::int64_t, Dim>& c) {
    double d2 = 0;
    for (int k = 0; k < Dim; ++k) {
        const double cell_lo = grid.origin()[k] + static_cast<double>(c[static_cast<std::size_t>(k)]) * grid.cell_size();
        const double gap = std::max({0.0, cell_lo - hi[k], lo[k] - (cell_lo + grid.cell_size())});
        d2 += gap * gap;
    }
    return d2;
}

/// Calls visit(coordinate) for every cell coordinate in the box lo … hi, x fastest.
template <int Dim, class Visit>
void for_coordinates(const std::array<std::int64_t, Dim>& lo, const std::array<std::int64_t, Dim>& hi, Visit&& visit) {
    std::array<std::int64_t, Dim> c = lo;
    for (;;) {
        visit(c);
        std::size_t k = 0;
        while (k < Dim && ++c[k] > hi[k]) {
            c[k] = lo[k];
            ++k;
        }
        if (k == Dim) return;
    }
}

/// The occupied target cells that can hold a neighbour of some particle in [lo, hi] with this reach.
template <int Dim>
void find_near_cells(const Vec<Dim>& lo, const Vec<Dim>& hi, double reach, const CellGrid<Dim>& target,
                     double target_scale, Array<const Cell<Dim>*>& near_cells) {
    near_cells.clear();
    const double farthest = reach + target_scale * target.max_reach();
    std::array<std::int64_t, Dim> first, last;
    for (int k = 0; k < Dim; ++k) {
        const auto kk = static_cast<std::size_t>(k);
        first[kk] = static_cast<std::int64_t>(std::floor((lo[k] - farthest - target.origin()[k]) / target.cell_size()));
        last[kk] = static_cast<std::int64_t>(std::floor((hi[k] + farthest - target.origin()[k]) / target.cell_size()));
    }
    for_coordinates<Dim>(first, last, [&](const auto& c) {
        const double d2 = box_distance2<Dim>(lo, hi, target, c) * (1 - 1e-12);  // the cell's edges are rounded
        if (d2 > farthest * farthest) return;
        const Cell<Dim>* cell = target.find(c);
        if (!cell) return;
        const double cut = reach + target_scale * cell->reach;
        if (d2 <= cut * cut) near_cells.push_back(cell);
    });
}

}  // namespace

template <int Dim>
void NeighborSearch<Dim>::search_group(const Job& job, std::span<const Index> group, Share& share) {
    const auto& [query, owned, target, reach, group_size] = job;
    const bool same_set = &query.position == &target.position;
    const bool without_itself = same_set && group_size == 1;
    const GroupMembers<Dim> members(query.position, group, reach);
    const double group_cut = reach.skin + members.largest_reach();
    const Extent<Dim> extent(query.position, group);
    const std::size_t before = share.candidate.size();
    std::uint64_t pairs = 0;
    for (const Cell<Dim>* near : share.near_cells)
        for (Index t = near->begin; t < near->end; ++t) {
            const Index j = target.grid.order()[t];
            const Vec<Dim> x = target.position[j];
            const double reach_j = reach.of_target(j), cut = group_cut + reach_j;
            if (extent.distance2(x) >= cut * cut || (without_itself && group[0] == j)) continue;
            share.candidate.push_back(j);
            pairs += static_cast<std::uint64_t>(members.within_support(x, reach_j));
        }
    if (share.candidate.size() == before) return;
    share.pairs += pairs - (same_set && !without_itself ? group.size() : 0);  // each found itself
    share.candidate_count.push_back(static_cast<Index>(share.candidate.size() - before));
    share.query.insert(share.query.end(), group.begin(), group.end());
    share.query_count.push_back(static_cast<Index>(group.size()));
}

template <int Dim>
void NeighborSearch<Dim>::search_cells(const Job& job, Share& share) {
    for (Array<Index>* a : {&share.query, &share.query_count, &share.candidate, &share.candidate_count}) a->clear();
    share.pairs = 0;
    const auto& order = job.query.grid.order();
    for (std::size_t c = share.first_cell; c < share.last_cell; ++c) {
        const Cell<Dim>& cell = job.query.grid.cells()[c];
        const std::span<const Index> members{order.data() + cell.begin, cell.end - cell.begin};
        // Far tighter than the cell's own box where particles have different reaches or the cell is half empty.
        const Extent<Dim> extent(job.query.position, members);
        find_near_cells<Dim>(extent.lo, extent.hi, job.reach.query_scale * cell.reach + job.reach.skin, job.target.grid,
                             job.reach.target_scale, share.near_cells);
        if (share.near_cells.empty()) continue;
        // Groups of nearly equal size: eleven particles as six and five lie closer together than as eight and three.
        share.members.clear();
        for (const Index i : members)
            if (i < job.owned) share.members.push_back(i);
        const std::size_t n = share.members.size(), size = static_cast<std::size_t>(job.group_size);
        const std::size_t groups = (n + size - 1) / size;
        for (std::size_t g = 0; g < groups; ++g) {
            const std::size_t begin = n * g / groups, end = n * (g + 1) / groups;
            search_group(job, {share.members.data() + begin, end - begin}, share);
        }
    }
}

template <int Dim>
void NeighborSearch<Dim>::join(NeighborList& list) const {
    list.clear();
    for (const Share& share : shares_) {
        list.query_.insert(list.query_.end(), share.query.begin(), share.query.end());
        list.candidate_.insert(list.candidate_.end(), share.candidate.begin(), share.candidate.end());
        for (const Index n : share.query_count) list.query_start_.push_back(list.query_start_.back() + n);
        for (const Index n : share.candidate_count) list.candidate_start_.push_back(list.candidate_start_.back() + n);
        list.pairs_ += share.pairs;
    }
}

template <int Dim>
void NeighborSearch<Dim>::build(const Set& query, std::size_t owned, const Set& target, const PairReach& reach,
                                int group_size, NeighborList& list) {
    if (group_size < 1 || group_size > max_group_size) throw std::invalid_argument("group size out of range");
    const std::size_t cells = query.grid.cells().size();
    if (cells == 0 || target.grid.cells().empty()) return list.clear();
    const Job job{query, owned, target, reach, group_size};
    const int threads = query.position.size() > parallel_threshold ? omp_get_max_threads() : 1;
    shares_.resize(static_cast<std::size_t>(threads));
    for (std::size_t t = 0; t < shares_.size(); ++t) {
        shares_[t].first_cell = cells * t / shares_.size();
        shares_[t].last_cell = cells * (t + 1) / shares_.size();
    }
#pragma omp parallel for schedule(static, 1) num_threads(threads) if (threads > 1)
    for (int t = 0; t < threads; ++t) search_cells(job, shares_[static_cast<std::size_t>(t)]);
    join(list);
}

template class NeighborSearch<2>;
template class NeighborSearch<3>;

}  // namespace sluice
