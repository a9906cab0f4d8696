// A set of particles: a medium, a wall or a boundary. All sets have this one type; each allocates only the columns that
// the scene's effects need.
#pragma once

#include "engine/particles/ghosts.hpp"
#include "engine/scene/effects/set_id.hpp"

namespace sluice {

/// Particles from index `owned` on are ghosts; they take their parents' values when a column is refreshed.
template <int Dim>
struct ParticleSet : Columns<Dim> {
    std::size_t owned = 0;
    Ghosts<Dim> ghosts;

    /// Number of particles, ghosts included.
    std::size_t size() const { return this->position.size(); }

    /// Updates the ghosts of these columns: refresh_ghosts(column::position, column::velocity).
    template <Column... C>
    void refresh_ghosts(ColumnTag<C>... columns) {
        (ghosts.template follow<info_of(C).mirror>((*this)[columns], owned), ...);
    }
    /// Resizes all columns that ghosts have to hold them, with their parents' values.
    void extend_ghosts() {
        for_each_field(*this, [&](auto tag, auto& field) {
            constexpr Mirror mirror = info_of(decltype(tag)::column).mirror;
            if constexpr (mirror != Mirror::none) {
                if (owned > 0 && size_of(field) >= owned) ghosts.template extend<mirror>(field, owned);
            }
        });
    }

    /// Reorders order.size() particles from `first` on: particle first + k becomes the one that was at order[k]. Drops
    /// the ghosts.
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
