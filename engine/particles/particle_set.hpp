// A set of particles: what a medium, a wall or a boundary is made of. All sets are of one type; each holds only the
// columns that the scene's effects need, the others stay empty.
#pragma once

#include "engine/particles/ghosts.hpp"
#include "engine/scene/effects/set_id.hpp"

namespace sluice {

/// Particles beyond `owned` are ghosts, which follow their parents when a column is refreshed.
template <int Dim>
struct ParticleSet : Columns<Dim> {
    std::size_t owned = 0;
    Ghosts<Dim> ghosts;

    /// With ghosts.
    std::size_t size() const { return this->position.size(); }

    /// Ghosts of these columns follow their parents: refresh_ghosts(column::position, column::velocity).
    template <Column... C>
    void refresh_ghosts(ColumnTag<C>... columns) {
        (ghosts.template follow<info_of(C).mirror>((*this)[columns], owned), ...);
    }
    /// Gives ghosts of all columns that they have their size and their parents' values.
    void extend_ghosts() {
        for_each_field(*this, [&](auto tag, auto& field) {
            constexpr Mirror mirror = info_of(decltype(tag)::column).mirror;
            if constexpr (mirror != Mirror::none) {
                if (owned > 0 && size_of(field) >= owned) ghosts.template extend<mirror>(field, owned);
            }
        });
    }

    /// Brings the particles first, first + 1, … into another order, of which there are as many as in `order`: particle
    /// first + k is then the one that was at order[k]. Ghosts are dropped.
    void reorder(const Array<Index>& order, std::size_t first);

  private:
    template <class Field>
    static std::size_t size_of(const Field& field) {
        return field.size();
    }
};

extern template struct ParticleSet<2>;
extern template struct ParticleSet<3>;

}  // namespace sluice
