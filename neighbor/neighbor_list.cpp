#include "neighbor/neighbor_list.hpp"

#include <omp.h>

#include <algorithm>
#include <array>

#include "neighbor/isa.hpp"
#include "neighbor/parallel.hpp"
#include "neighbor/prune_loop.hpp"

namespace sluice {
namespace {

/// The members of a grid's cluster as a list holds them: a run of indices, or indices of their own.
template <int Dim>
ListedCluster listed(const ClusterGrid<Dim>& grid, std::size_t cluster, Array<Index>& index) {
    const Range t = grid.particles(cluster);
    const auto size = static_cast<std::uint8_t>(t.size());
    if (grid.is_sorted()) return {grid.particle(t.begin), size, true};
    const Index* member = grid.order().data() + t.begin;
    bool in_sequence = true;
    for (Index l = 1; l < t.size(); ++l) in_sequence = in_sequence && member[l] == member[0] + l;
    if (in_sequence) return {member[0], size, true};
    const auto first = static_cast<Index>(index.size());
    index.insert(index.end(), member, member + t.size());
    return {first, size, false};
}

template <int Dim>
void set_box(BoxColumns<Dim>& columns, std::size_t n, const Extent<Dim>& e) {
    for (int k = 0; k < Dim; ++k) {
        columns.lo[k][n] = e.box.lo[k];
        columns.hi[k][n] = e.box.hi[k];
    }
    columns.min_reach[n] = e.min_reach;
    columns.max_reach[n] = e.max_reach;
}

}  // namespace

Range NeighborList::share(int k, int n) const {
    const auto bound = [&](int s) {
        const std::uint64_t upto = cluster_pairs() * static_cast<std::uint64_t>(s) / static_cast<std::uint64_t>(n);
        return static_cast<Index>(std::lower_bound(work_.begin(), work_.end(), upto) - work_.begin());
    };
    return {k == 0 ? 0 : bound(k), k + 1 == n ? static_cast<Index>(blocks()) : bound(k + 1)};
}

std::size_t NeighborList::bytes() const {
    return block_.capacity() * sizeof(ListView::Block) + part_.capacity() * sizeof(ListView::Part) +
           (query_.capacity() + candidate_.capacity()) * sizeof(ListedCluster) +
           row_.capacity() * sizeof(ListView::Row) + listed_.capacity() + near_.capacity() + equal_reach_.capacity() +
           (query_index_.capacity() + candidate_index_.capacity()) * sizeof(Index) +
           work_.capacity() * sizeof(std::uint64_t);
}

std::size_t NeighborList::loop_bytes() const {
    return block_.size() * sizeof(ListView::Block) + part_.size() * sizeof(ListView::Part) +
           query_.size() * (sizeof(ListedCluster) + sizeof(std::uint8_t)) + candidate_.size() * sizeof(ListedCluster) +
           row_.size() * sizeof(ListView::Row) + cluster_pairs() * sizeof(std::uint8_t);
}

std::uint64_t NeighborList::pairs_of_clusters(const ListView::Block& block) const {
    std::uint64_t work = 0;
    for (Index p = block.parts.begin; p < block.parts.end; ++p)
        for (Index q = 0; q < block.queries.size(); ++q) work += row_[part_[p].first_row + q].near;
    return work;
}

void NeighborList::clear() {
    block_.clear();
    part_.clear();
    query_.clear();
    candidate_.clear();
    row_.clear();
    listed_.clear();
    near_.clear();
    equal_reach_.clear();
    query_index_.clear();
    candidate_index_.clear();
    work_.clear();
    size_ = 0;
    pairs_ = 0;
    counted_ = false;
}

template <int Dim>
void NeighborSearch<Dim>::search_block(const Job& job, std::size_t block, Share& share) {
    const Extent<Dim>& own = job.query.block_extent(block);
    share.near_grid.clear();
    share.near_cluster.clear();
    const double cut = job.cut.query_scale * own.max_reach + job.cut.skin;
    for (std::size_t g = 0; g < job.targets.size(); ++g) {
        const ClusterGrid<Dim>& target = *job.targets[g];
        target.blocks_near(own.box, cut, job.cut.target_scale, [&](std::size_t b) {
            const Range clusters = target.clusters(b);
            for (Index c = clusters.begin; c < clusters.end; ++c) {
                const Extent<Dim>& e = target.cluster_extent(c);
                const double limit = cut + job.cut.target_scale * e.max_reach;
                if (!(distance2(own.box, e.box) < limit * limit)) continue;
                share.near_grid.push_back(static_cast<Index>(g));
                share.near_cluster.push_back(c);
            }
        });
    }
    const std::size_t candidates = share.near_cluster.size();
    if (candidates == 0) return;
    share.near_box.resize((candidates + box_multiple - 1) / box_multiple * box_multiple);
    for (std::size_t n = 0; n < share.near_box.size(); ++n)
        set_box(share.near_box, n,
                n < candidates ? job.targets[share.near_grid[n]]->cluster_extent(share.near_cluster[n])
                               : Extent<Dim>{Box<Dim>{}, 0, 0});
    const Range clusters = job.query.clusters(block);
    ListView::Block made;
    made.queries.begin = static_cast<Index>(share.query.size());
    for (Index q = clusters.begin; q < clusters.end; ++q) {
        share.query.push_back(listed(job.query, q, share.query_index));
        share.equal_reach.push_back(job.query.cluster_extent(q).min_reach == job.query.cluster_extent(q).max_reach);
        share.size += share.query.back().size;
    }
    made.queries.end = static_cast<Index>(share.query.size());
    made.parts.begin = static_cast<Index>(share.part.size());
    for (std::size_t first = 0; first < candidates; first += part_size)
        list_part(job, clusters, first, std::min<std::size_t>(first + part_size, candidates), share);
    made.parts.end = static_cast<Index>(share.part.size());
    share.block.push_back(made);
}

template <int Dim>
void NeighborSearch<Dim>::list_part(const Job& job, Range clusters, std::size_t first_near, std::size_t last_near,
                                    Share& share) {
    ListView::Part part;
    part.candidates.begin = static_cast<Index>(share.candidate.size());
    part.first_row = static_cast<std::uint32_t>(share.row.size());
    for (std::size_t n = first_near; n < last_near; ++n)
        share.candidate.push_back(
            listed(*job.targets[share.near_grid[n]], share.near_cluster[n], share.candidate_index));
    part.candidates.end = static_cast<Index>(share.candidate.size());
    const std::size_t count = last_near - first_near;
    for (Index q = clusters.begin; q < clusters.end; ++q) {
        ListView::Row row;
        row.begin = share.entry.size();
        share.entry.resize(row.begin + count + box_multiple);
        const NearBoxes near = job.find_near(share.near_box, first_near, count, job.query.cluster_extent(q), job.cut,
                                             share.entry.data() + row.begin);
        row.listed = row.near = near.count;
        share.entry.resize(row.begin + near.count);
        share.row.push_back(row);
        share.equal_reach[share.equal_reach.size() - clusters.size() + (q - clusters.begin)] &= near.equal_reach;
    }
    share.part.push_back(part);
}

template <int Dim>
void NeighborSearch<Dim>::join(const std::vector<Share>& shares, NeighborList& list) {
    list.clear();
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    const auto reserve = [&shares](auto& to, auto Share::*part) {
        std::size_t n = 0;
        for (const Share& s : shares) n += (s.*part).size();
        to.reserve(n);
    };
    reserve(list.block_, &Share::block);
    reserve(list.part_, &Share::part);
    reserve(list.query_, &Share::query);
    reserve(list.candidate_, &Share::candidate);
    reserve(list.row_, &Share::row);
    reserve(list.listed_, &Share::entry);
    reserve(list.equal_reach_, &Share::equal_reach);
    for (const Share& s : shares) {
        const auto parts = static_cast<Index>(list.part_.size()), queries = static_cast<Index>(list.query_.size());
        const auto candidates = static_cast<Index>(list.candidate_.size());
        const auto rows = static_cast<std::uint32_t>(list.row_.size());
        const std::uint64_t entries = list.listed_.size();
        const auto query_indices = static_cast<Index>(list.query_index_.size());
        const auto candidate_indices = static_cast<Index>(list.candidate_index_.size());
        for (const ListView::Block& b : s.block)
            list.block_.push_back(
                {{b.queries.begin + queries, b.queries.end + queries}, {b.parts.begin + parts, b.parts.end + parts}});
        for (const ListView::Part& p : s.part)
            list.part_.push_back(
                {{p.candidates.begin + candidates, p.candidates.end + candidates}, p.first_row + rows});
        for (const ListedCluster& c : s.query)
            list.query_.push_back({c.first + (c.in_sequence ? 0 : query_indices), c.size, c.in_sequence});
        for (const ListedCluster& c : s.candidate)
            list.candidate_.push_back({c.first + (c.in_sequence ? 0 : candidate_indices), c.size, c.in_sequence});
        for (const ListView::Row& r : s.row) list.row_.push_back({r.begin + entries, r.listed, r.near});
        append(list.listed_, s.entry);
        append(list.equal_reach_, s.equal_reach);
        append(list.query_index_, s.query_index);
        append(list.candidate_index_, s.candidate_index);
        list.size_ += s.size;
    }
    list.near_ = list.listed_;
}

template <int Dim>
void NeighborSearch<Dim>::build(const ClusterGrid<Dim>& query, std::span<const ClusterGrid<Dim>* const> targets,
                                const CutOff& cut, NeighborList& list) {
    const Job job{query, targets, cut, SLUICE_OF_ISA(active_isa(), find_near<Dim>)};
    const std::size_t blocks = query.blocks();
    const int threads = query.size() > parallel_threshold ? omp_get_max_threads() : 1;
    std::vector<Share> shares(static_cast<std::size_t>(threads));
    // Consecutive shares, each searched by one thread in order: the list is the same for any number of threads.
    const auto share_of = [&](int s) {
        return blocks * static_cast<std::size_t>(s) / static_cast<std::size_t>(threads);
    };
    {
        const WatchedLoop loop;
#pragma omp parallel num_threads(threads) if (threads > 1)
        {
            const WatchedShare watched(loop);
#pragma omp for schedule(static, 1) nowait
            for (int t = 0; t < threads; ++t)
                for (std::size_t b = share_of(t); b < share_of(t + 1); ++b)
                    search_block(job, b, shares[static_cast<std::size_t>(t)]);
        }
    }
    join(shares, list);
}

template <int Dim>
void NeighborSearch<Dim>::prune(const Set& query, const Set& target, const CutOff& cut, NeighborList& list) {
    PruneTask<Dim> task;
    for (int k = 0; k < Dim; ++k) {
        task.query.position[k] = query.position.c[static_cast<std::size_t>(k)].data();
        task.target.position[k] = target.position.c[static_cast<std::size_t>(k)].data();
    }
    task.query.reach = query.reach.data();
    task.target.reach = target.reach.data();
    task.cut = cut;
    task.count = !list.counted_;
    // In single precision, relative to the block: a hair more than asked for, so that nothing is lost to rounding.
    constexpr double rounding = 1e-5;
    if (!task.count) {
        task.cut.query_scale *= 1 + rounding;
        task.cut.target_scale *= 1 + rounding;
        task.cut.skin *= 1 + rounding;
    }
    task.list = list.view();
    task.row = list.row_.data();
    task.listed = list.listed_.data();
    task.near = list.near_.data();
    const auto loop = SLUICE_OF_ISA(active_isa(), prune_block<Dim>);
    const auto blocks = static_cast<std::int64_t>(list.blocks());
    list.work_.resize(list.blocks());
    std::uint64_t pairs = 0;
    {
        const WatchedLoop watched;
#pragma omp parallel reduction(+ : pairs) if (list.size() > parallel_threshold)
        {
            const WatchedShare share(watched);
#pragma omp for schedule(dynamic, 4) nowait
            for (std::int64_t b = 0; b < blocks; ++b) {
                const ListView::Block& block = list.block_[static_cast<std::size_t>(b)];
                pairs += loop(task, block);
                list.work_[static_cast<std::size_t>(b)] = list.pairs_of_clusters(block);
            }
        }
    }
    for (std::size_t b = 1; b < list.blocks(); ++b) list.work_[b] += list.work_[b - 1];
    const bool same_set = &query.position == &target.position;
    const std::uint64_t themselves = same_set ? list.size() : 0;  // each found itself, if its position is a number
    if (task.count) list.pairs_ = pairs > themselves ? pairs - themselves : 0;
    list.counted_ = true;
}

template class NeighborSearch<2>;
template class NeighborSearch<3>;

}  // namespace sluice
