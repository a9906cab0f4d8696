#include "neighbor/prune_loop.hpp"

#include "neighbor/pack.hpp"

namespace sluice::SLUICE_ISA {
namespace {

using P = Pack<double>;
constexpr int lanes = P::lanes;
constexpr int along_j = lanes < 4 ? lanes : 4;  ///< candidates' particles in a register
constexpr int along_i = lanes / along_j;        ///< the query's

/// A cluster's particles; missing ones lie out of everything's reach.
template <int Dim>
struct Four {
    alignas(32) double x[Dim][4];
    alignas(32) double reach[4];

    SLUICE_INLINE void load(const ListedCluster& c, const Index* index, const PruneColumns<Dim>& columns, double scale) {
        for (int l = 0; l < 4; ++l) {
            const bool there = l < c.size;
            const Index t = c.first + (there ? static_cast<Index>(l) : 0);
            const Index i = c.in_sequence ? t : index[t];
            for (int k = 0; k < Dim; ++k) x[k][l] = columns.position[k][i];
            reach[l] = there ? scale * columns.reach[i] : -1e300;
        }
    }
};

}  // namespace

template <int Dim>
std::uint64_t prune_block(const PruneTask<Dim>& task, const ListView::Block& block) {
    Four<Dim> near[part_size];
    std::uint64_t pairs = 0;
    const ListView& list = task.list;
    for (Index p = block.parts.begin; p < block.parts.end; ++p) {
        const ListView::Part& part = list.part[p];
        const ListedCluster* candidate = list.candidate + part.candidates.begin;
        for (Index c = 0; c < part.candidates.end - part.candidates.begin; ++c)
            near[c].load(candidate[c], list.candidate_index, task.target, task.cut.target_scale);
        for (Index q = block.queries.begin; q < block.queries.end; ++q) {
            Four<Dim> self;
            self.load(list.query[q], list.query_index, task.query, task.cut.query_scale);
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
                const Four<Dim>& other = near[listed[e]];
                bool any = false;
                for (int g = 0; g < 4 / along_i; ++g)
                    for (int j = 0; j < 4; j += along_j) {
                        P r2(0);
                        for (int k = 0; k < Dim; ++k) {
                            const P d = x_i[g][k] - load_repeated<P, along_j>(other.x[k] + j);
                            r2 = r2 + d * d;
                        }
                        const P none(0), support = larger(reach_i[g] + load_repeated<P, along_j>(other.reach + j), P(-1e200));
                        const P limit = larger(support + P(task.cut.skin), none), inside = larger(support, none);
                        any |= any_less(r2, limit * limit);
                        pairs += static_cast<std::uint64_t>(count_less(r2, inside * inside));
                    }
                out[count] = listed[e];  // without a branch: write always, go on if it counts
                count += any;
            }
            row.near = count;
        }
    }
    return pairs;
}

template std::uint64_t prune_block<2>(const PruneTask<2>&, const ListView::Block&);
template std::uint64_t prune_block<3>(const PruneTask<3>&, const ListView::Block&);

}  // namespace sluice::SLUICE_ISA
