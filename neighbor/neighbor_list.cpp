#include "neighbor/neighbor_list.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "neighbor/isa.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {

void NeighborList::clear() {
    query_.clear();
    query_start_.assign(1, 0);
    candidate_.clear();
    candidate_start_.assign(1, 0);
    equal_reach_.clear();
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
};

/// Squared distance of x from the box; 0 inside.
template <int Dim>
inline double distance2(const Extent<Dim>& box, const Vec<Dim>& x) {
    double d2 = 0;
    unroll<Dim>([&](int k) {
        const double gap = larger(larger(x[k] - box.hi[k], box.lo[k] - x[k]), 0.0);
        d2 += gap * gap;
    });
    return d2;
}

/// near[t] = 1 for those targets that are closer to the box than cut + their reach.
template <int Dim>
SLUICE_ISA_CLONES void mark_near_box(const NearTargets<Dim>& targets, const Extent<Dim>& box, double cut,
                                     std::uint8_t* near) {
    const std::size_t n = targets.index.size();
    const double* reach = targets.reach.data();
    std::array<const double*, Dim> x;
    for (std::size_t k = 0; k < Dim; ++k) x[k] = targets.x[k].data();
#pragma GCC ivdep
    for (std::size_t t = 0; t < n; ++t) {
        Vec<Dim> at;
        unroll<Dim>([&](int k) { at[k] = x[static_cast<std::size_t>(k)][t]; });
        const double limit = cut + reach[t];
        near[t] = distance2(box, at) < limit * limit;
    }
}

/// How many targets are closer to x than reach + their reach.
template <int Dim>
SLUICE_ISA_CLONES std::uint64_t count_within(const NearTargets<Dim>& targets, const Vec<Dim>& from, double reach) {
    const std::size_t n = targets.index.size();
    const double* target_reach = targets.reach.data();
    std::array<const double*, Dim> x;
    for (std::size_t k = 0; k < Dim; ++k) x[k] = targets.x[k].data();
    std::int64_t count = 0;
    for (std::size_t t = 0; t < n; ++t) {
        double d2 = 0;
        unroll<Dim>([&](int k) {
            const double d = from[k] - x[static_cast<std::size_t>(k)][t];
            d2 += d * d;
        });
        const double support = reach + target_reach[t];
        count += d2 < support * support;
    }
    return static_cast<std::uint64_t>(count);
}

/// Lower bound for the squared distance between a box [lo, hi] and a cell of the grid.
template <int Dim>
double box_distance2(const Vec<Dim>& lo, const Vec<Dim>& hi, const CellGrid<Dim>& grid,
                     const std::array<std::int64_t, Dim>& c) {
    double d2 = 0;
    for (int k = 0; k < Dim; ++k) {
        const double cell_lo =
            grid.origin()[k] + static_cast<double>(c[static_cast<std::size_t>(k)]) * grid.cell_size();
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

/// Packs the targets that lie in cells which can hold a neighbour of some particle in the box with this reach.
template <int Dim>
void pack_near_targets(const Extent<Dim>& box, double reach, const typename NeighborSearch<Dim>::Set& target,
                       const PairReach& pair_reach, NearTargets<Dim>& near) {
    near.resize(0);
    const CellGrid<Dim>& grid = target.grid;
    const double farthest = reach + pair_reach.target_scale * grid.max_reach();
    std::array<std::int64_t, Dim> first, last;
    for (int k = 0; k < Dim; ++k) {
        const auto kk = static_cast<std::size_t>(k);
        first[kk] = static_cast<std::int64_t>(std::floor((box.lo[k] - farthest - grid.origin()[k]) / grid.cell_size()));
        last[kk] = static_cast<std::int64_t>(std::floor((box.hi[k] + farthest - grid.origin()[k]) / grid.cell_size()));
    }
    for_coordinates<Dim>(first, last, [&](const auto& c) {
        const double d2 = box_distance2<Dim>(box.lo, box.hi, grid, c) * (1 - 1e-12);  // the cell's edges are rounded
        if (d2 > farthest * farthest) return;
        const Cell<Dim>* cell = grid.find(c);
        if (!cell) return;
        const double cut = reach + pair_reach.target_scale * cell->reach;
        if (d2 > cut * cut) return;
        const std::size_t before = near.index.size(), count = cell->end - cell->begin;
        near.resize(before + count);
        const Index* members = grid.order().data() + cell->begin;
        for (std::size_t t = 0; t < count; ++t) near.index[before + t] = members[t];
        for (std::size_t t = 0; t < count; ++t) near.reach[before + t] = pair_reach.of_target(members[t]);
        for (std::size_t k = 0; k < Dim; ++k)
            for (std::size_t t = 0; t < count; ++t) near.x[k][before + t] = target.position.c[k][members[t]];
    });
}

}  // namespace

template <int Dim>
void NeighborSearch<Dim>::search_group(const Job& job, std::span<const Index> group, Share& share) {
    const auto& [query, owned, target, reach, group_size] = job;
    const bool same_set = &query.position == &target.position;
    const bool without_itself = same_set && group_size == 1;
    double group_reach = 0;
    for (const Index i : group) group_reach = std::max(group_reach, reach.of_query(i));
    const NearTargets<Dim>& near = share.near;
    share.is_near.resize(near.index.size());
    mark_near_box(near, Extent<Dim>(query.position, group), reach.skin + group_reach, share.is_near.data());
    const std::size_t before = share.candidate.size();
    share.candidate.resize(before + near.index.size());
    std::size_t end = before;
    bool equal = true;
    for (const Index i : group) equal = equal && reach.of_query(i) == group_reach;
    for (std::size_t t = 0; t < near.index.size(); ++t) {  // without a branch: write always, go on if it counts
        share.candidate[end] = near.index[t];
        end += share.is_near[t] && !(without_itself && near.index[t] == group[0]);
        equal = equal && (!share.is_near[t] || near.reach[t] == group_reach);
    }
    share.candidate.resize(end);
    if (end == before) return;
    for (const Index i : group) share.pairs += count_within(near, query.position[i], reach.of_query(i));
    if (same_set) share.pairs -= group.size();  // each found itself
    share.candidate_count.push_back(static_cast<Index>(end - before));
    share.query.insert(share.query.end(), group.begin(), group.end());
    share.query_count.push_back(static_cast<Index>(group.size()));
    share.equal_reach.push_back(equal);
}

template <int Dim>
void NeighborSearch<Dim>::search_cells(const Job& job, Share& share) {
    for (Array<Index>* a : {&share.query, &share.query_count, &share.candidate, &share.candidate_count}) a->clear();
    share.equal_reach.clear();
    share.pairs = 0;
    const auto& order = job.query.grid.order();
    for (std::size_t c = share.first_cell; c < share.last_cell; ++c) {
        const Cell<Dim>& cell = job.query.grid.cells()[c];
        share.members.clear();
        for (Index m = cell.begin; m < cell.end; ++m)
            if (order[m] < job.owned) share.members.push_back(order[m]);
        if (share.members.empty()) continue;
        // The members' own extent is far tighter than the cell where it is half empty.
        pack_near_targets<Dim>(Extent<Dim>(job.query.position, share.members),
                               job.reach.query_scale * cell.reach + job.reach.skin, job.target, job.reach, share.near);
        if (share.near.index.empty()) continue;
        // Groups of nearly equal size: eleven particles as six and five lie closer together than as eight and three.
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
        list.equal_reach_.insert(list.equal_reach_.end(), share.equal_reach.begin(), share.equal_reach.end());
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
