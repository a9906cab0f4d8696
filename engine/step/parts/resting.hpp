// Drops the rows of a solid's lists that need no sums.
#pragma once

#include <span>

#include "engine/particles/particle_set.hpp"
#include "neighbor/neighbor_list.hpp"

namespace sluice {

/// Clamped particles never move, so that stress can change only next to particles that do: `all` keeps the rows of
/// particles with such neighbours. `moving` becomes the rows whose forces are needed: those of particles that are not
/// clamped, and of those marked `extended`. The stress of those marked `rigid` is not needed (clamp_extension.hpp).
/// Both marks are by index, or empty.
template <int Dim>
void leave_out_resting(const ParticleSet<Dim>& solid, std::span<const std::uint8_t> rigid,
                       std::span<const std::uint8_t> extended, NeighborList& all, NeighborList& moving) {
    Array<std::uint8_t> moves(solid.owned), stressed(solid.owned);
    for (std::size_t i = 0; i < solid.owned; ++i) moves[i] = !solid.clamped[i];
    all.mark_candidates(moves, stressed);
    for (std::size_t i = 0; i < rigid.size(); ++i) {
        if (rigid[i]) stressed[i] = 0;
        if (extended[i]) moves[i] = 1;
    }
    moving = all;
    moving.keep_queries(moves);
    all.keep_queries(stressed);
}

}  // namespace sluice
