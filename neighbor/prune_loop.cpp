#include "neighbor/prune_loop.hpp"

#include "neighbor/pack.hpp"

namespace sluice::SLUICE_ISA {
namespace {

/// A cluster's particles, relative to an origin near the block; missing ones lie out of everything's reach.
template <int Dim, class Number>
struct Four {
    static constexpr Number nowhere = sizeof(Number) == 4 ? Number(-1e18) : Number(-1e150);  ///< its square is finite

    alignas(4 * sizeof(Number)) Number x[Dim][4];
    alignas(4 * sizeof(Number)) Number reach[4];

    SLUICE_INLINE void load(const ListedCluster& c, const Index* index, const PruneColumns<Dim>& columns, double scale,
                            const double (&origin)[Dim]) {
        if (c.in_sequence && c.size == 4) {
            for (int k = 0; k < Dim; ++k)
                for (int l = 0; l < 4; ++l)
                    x[k][l] = static_cast<Number>(columns.position[k][c.first + static_cast<Index>(l)] - origin[k]);
            for (int l = 0; l < 4; ++l)
                reach[l] = static_cast<Number>(scale * columns.reach[c.first + static_cast<Index>(l)]);
            return;
        }
        for (int l = 0; l < 4; ++l) {
            const Index i = c.particle(static_cast<Index>(l), index);
            for (int k = 0; k < Dim; ++k) x[k][l] = static_cast<Number>(columns.position[k][i] - origin[k]);
            reach[l] = l < c.size ? static_cast<Number>(scale * columns.reach[i]) : nowhere;
        }
    }
};

/// Count: pairs within their reaches are counted, and positions taken as they are.
template <bool Count, int Dim, class Number>
SLUICE_INLINE std::uint64_t prune(const PruneTask<Dim>& task, const ListView::Block& block) {
    using P = Pack<Number>;
    constexpr int along_i = P::along_i, along_j = P::along_j;
    const Index somewhere = task.list.query[block.queries.begin].particle(0, task.list.query_index);
    double origin[Dim] = {};
    if constexpr (!Count)
        for (int k = 0; k < Dim; ++k) origin[k] = task.query.position[k][somewhere];
    Four<Dim, Number> near[part_size];
    std::uint64_t pairs = 0;
    const ListView& list = task.list;
    for (Index p = block.parts.begin; p < block.parts.end; ++p) {
        const ListView::Part& part = list.part[p];
        const ListedCluster* candidate = list.candidate + part.candidates.begin;
        for (Index c = 0; c < part.candidates.end - part.candidates.begin; ++c)
            near[c].load(candidate[c], list.candidate_index, task.target, task.cut.target_scale, origin);
        for (Index q = block.queries.begin; q < block.queries.end; ++q) {
            Four<Dim, Number> self;
            self.load(list.query[q], list.query_index, task.query, task.cut.query_scale, origin);
            P x_i[4 / along_i][Dim], reach_i[4 / along_i];
            for (int g = 0; g < 4 / along_i; ++g) {
                for (int k = 0; k < Dim; ++k) x_i[g][k] = load_spread<P, along_j>(self.x[k] + g * along_i);
                reach_i[g] = load_spread<P, along_j>(self.reach + g * along_i);
            }
            ListView::Row& row = task.row[part.first_row + (q - block.queries.begin)];
            const std::uint8_t* listed = task.listed + row.begin;
            std::uint8_t* out = task.near + row.begin;
            std::uint32_t count = 0;
            for (std::uint32_t e = 0; e < row.listed; ++e) {
                const Four<Dim, Number>& other = near[listed[e]];
                bool any = false;
                for (int g = 0; g < 4 / along_i; ++g)
                    for (int j = 0; j < 4; j += along_j) {
                        P r2(0);
                        for (int k = 0; k < Dim; ++k) {
                            const P d = x_i[g][k] - load_repeated<P, along_j>(other.x[k] + j);
                            r2 = r2 + d * d;
                        }
                        // Added up in the order in which the limits of boxes are: none is less by a rounding.
                        const P none(0), reach_j = load_repeated<P, along_j>(other.reach + j);
                        const P limit = larger(reach_i[g] + P(task.cut.skin) + reach_j, none);
                        any |= mask_less(r2, limit * limit) != 0;
                        if constexpr (Count) {
                            const P inside = larger(reach_i[g] + reach_j, none);
                            const unsigned mask = mask_less(r2, inside * inside);
                            pairs += static_cast<std::uint64_t>(__builtin_popcount(mask));
                        }
                    }
                out[count] = listed[e];  // without a branch: write always, go on if it counts
                count += any;
            }
            row.near = count;
        }
    }
    return pairs;
}

}  // namespace

template <int Dim>
std::uint64_t prune_block(const PruneTask<Dim>& task, const ListView::Block& block) {
    return task.count ? prune<true, Dim, double>(task, block) : prune<false, Dim, float>(task, block);
}

template <int Dim>
NearBoxes find_near(const BoxColumns<Dim>& boxes, std::size_t first, std::size_t count, const Extent<Dim>& own,
                    const CutOff& cut, std::uint8_t* out) {
    using P = Pack<double>;
    constexpr int lanes = P::lanes;
    const P none(0), reach(cut.query_scale * own.max_reach + cut.skin), scale(cut.target_scale);
    NearBoxes near;
    for (std::size_t c = 0; c < count; c += lanes) {
        P d2(0);
        for (int k = 0; k < Dim; ++k) {
            const P below = load_repeated<P, lanes>(boxes.lo[k].data() + first + c) - P(own.box.hi[k]);
            const P above = P(own.box.lo[k]) - load_repeated<P, lanes>(boxes.hi[k].data() + first + c);
            const P gap = larger(larger(below, above), none);
            d2 = d2 + gap * gap;
        }
        const P max_reach = load_repeated<P, lanes>(boxes.max_reach.data() + first + c);
        const P limit = reach + scale * max_reach;
        const unsigned is_near = mask_less(d2, limit * limit);
        const P spread = max_reach - load_repeated<P, lanes>(boxes.min_reach.data() + first + c);
        const P from_own = max_reach - P(own.max_reach);
        const unsigned unequal = mask_less(none, spread * spread + from_own * from_own);
        near.equal_reach &= (is_near & unequal) == 0;
        for (int l = 0; l < lanes; ++l) {  // without a branch: write always, go on if it counts
            out[near.count] = static_cast<std::uint8_t>(c + static_cast<std::size_t>(l));
            near.count += is_near >> l & 1U;
        }
    }
    return near;
}

template NearBoxes find_near<2>(const BoxColumns<2>&, std::size_t, std::size_t, const Extent<2>&, const CutOff&,
                                std::uint8_t*);
template NearBoxes find_near<3>(const BoxColumns<3>&, std::size_t, std::size_t, const Extent<3>&, const CutOff&,
                                std::uint8_t*);
template std::uint64_t prune_block<2>(const PruneTask<2>&, const ListView::Block&);
template std::uint64_t prune_block<3>(const PruneTask<3>&, const ListView::Block&);

}  // namespace sluice::SLUICE_ISA
