// Ghost particles: copies of other particles behind mirror walls and beyond the sides of a periodic box.
//
// Mirror walls are slip walls made by reflecting the particles in front of them. The ghost of a particle at x across
// the plane (P, n) is at x − 2 ((x − P)·n) n, and its velocity likewise has its normal part reversed; scalars are
// copied. With ghosts as neighbours a particle at the wall sees a full support, no flow through the plane and no
// friction along it.
//
// A periodic box of length L along n has a plane at each side. A particle near one side has a ghost, moved by L n,
// beyond the other.
//
// Where two planes meet, ghosts have ghosts across the later plane, so that a corner is filled.
//
// The table of columns says how a ghost gets each column from its parent (Mirror).
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "kernels/columns/columns.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {

/// What makes ghosts: a mirror wall, or one side of a periodic box.
template <int Dim>
struct GhostPlane {
    Vec<Dim> point;
    Vec<Dim> normal;   ///< unit, into the fluid
    double shift = 0;  ///< length of a periodic box [m]; 0 = mirror
    int partner = -1;  ///< number of the periodic box's other plane

    bool is_mirror() const { return shift == 0; }
    double distance(const Vec<Dim>& x) const { return dot(x - point, normal); }
    Vec<Dim> image_position(const Vec<Dim>& x) const { return x + (is_mirror() ? -2 * distance(x) : shift) * normal; }
    Vec<Dim> image_direction(const Vec<Dim>& v) const { return is_mirror() ? v - 2 * dot(v, normal) * normal : v; }
};

/// Thrown if so many planes lie near the same particles that the paths across them cannot be numbered.
struct TooManyGhostPaths : std::length_error {
    using std::length_error::length_error;
};

/// Which ghosts a set of particles has. Ghost number k stands at index owned + k.
template <int Dim>
class Ghosts {
  public:
    /// Gives a ghost to each of the first `owned` particles that is no farther from a plane than range(i) [m], and
    /// appends the ghosts' positions. Throws TooManyGhostPaths.
    template <class Range>
    void create(const std::vector<GhostPlane<Dim>>& planes, VectorField<Dim>& position, std::size_t owned,
                Range&& range);

    /// Reorders the ghosts: ghost k becomes the one that was at index order[k]. The columns must be reordered likewise.
    void reorder(const Array<Index>& order, std::size_t owned);

    std::size_t count() const { return parent_.size(); }
    /// The owned particle that ghost k is a copy of.
    Index parent(std::size_t k) const { return parent_[k]; }

    /// Resizes a column to hold the ghosts too, with their parents' values.
    template <Mirror M, class Field>
    void extend(Field& field, std::size_t owned) const {
        for_each_component(field, [&](auto& column) { resize_tight(column, owned + count()); });
        follow<M>(field, owned);
    }
    /// Updates the ghosts of a column from their parents.
    template <Mirror M, class Field>
    void follow(Field& field, std::size_t owned) const {
        static_assert(M == Mirror::same || M == Mirror::place || M == Mirror::direction,
                      "ghosts do not have this column");
        if constexpr (M == Mirror::same)
            for_each_component(field, [&](auto& column) {
                parallel_for(count(), [&](std::size_t k) { column[owned + k] = column[parent_[k]]; });
            });
        else if constexpr (M == Mirror::place)
            show(field, owned, [](const GhostPlane<Dim>& p, const Vec<Dim>& x) { return p.image_position(x); });
        else if constexpr (M == Mirror::direction)
            show(field, owned, [](const GhostPlane<Dim>& p, const Vec<Dim>& v) { return p.image_direction(v); });
    }

    /// visit(name, member) for each member; the planes are replaced when ghosts are next created.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("planes", planes_), visit("paths", paths_), visit("parent", parent_), visit("path", path_);
    }

    std::size_t bytes() const { return parent_.capacity() * sizeof(Index) + path_.capacity() * sizeof(PathNumber); }

  private:
    /// The planes crossed from an owned particle to its ghost, in order.
    using Path = std::vector<std::uint32_t>;
    using PathNumber = std::uint16_t;
    static constexpr std::size_t most_paths = std::size_t{std::numeric_limits<PathNumber>::max()} + 1;

    template <class Show>
    void show(VectorField<Dim>& field, std::size_t owned, Show&& across) const {
        parallel_for(count(), [&](std::size_t k) {
            Vec<Dim> value = field[parent_[k]];
            for (const std::uint32_t plane : paths_[path_[k]]) value = across(planes_[plane], value);
            field.set(owned + k, value);
        });
    }
    Vec<Dim> place_of(Vec<Dim> x, PathNumber path) const {
        for (const std::uint32_t plane : paths_[path]) x = planes_[plane].image_position(x);
        return x;
    }
    bool leads_across(PathNumber path, int plane) const {
        return std::find(paths_[path].begin(), paths_[path].end(), static_cast<std::uint32_t>(plane)) !=
               paths_[path].end();
    }
    /// Adds the path that crosses one more plane, and returns its number.
    PathNumber add_path(PathNumber from, std::size_t plane) {
        if (paths_.size() == most_paths)
            throw TooManyGhostPaths(
                "so many mirror walls lie near the same particles that these have ghosts by more than " +
                std::to_string(most_paths - 1) + " ways across them");
        paths_.push_back(paths_[from]);
        paths_.back().push_back(static_cast<std::uint32_t>(plane));
        return static_cast<PathNumber>(paths_.size() - 1);
    }

    std::vector<GhostPlane<Dim>> planes_;
    std::vector<Path> paths_;
    Array<Index> parent_, parent_buffer_;
    Array<PathNumber> path_, path_buffer_;  ///< into paths_
};

template <int Dim>
template <class Range>
void Ghosts<Dim>::create(const std::vector<GhostPlane<Dim>>& planes, VectorField<Dim>& position, std::size_t owned,
                         Range&& range) {
    planes_ = planes;
    paths_.assign(1, {});
    parent_.clear();
    path_.clear();
    position.resize(owned);
    for (std::size_t p = 0; p < planes.size(); ++p) {
        const std::size_t before = owned + count();
        std::vector<PathNumber> onward(paths_.size(), 0);  // from each path across plane p; 0 = not yet gone
        for (std::size_t i = 0; i < before; ++i) {
            const Index owner = i < owned ? static_cast<Index>(i) : parent_[i - owned];
            const PathNumber path = i < owned ? PathNumber{0} : path_[i - owned];
            if (planes[p].distance(place_of(position[owner], path)) > range(owner)) continue;
            if (!planes[p].is_mirror() && leads_across(path, planes[p].partner)) continue;  // it would lead back
            parent_.push_back(owner);
            if (onward[path] == 0) onward[path] = add_path(path, p);
            path_.push_back(onward[path]);
        }
    }
    extend<Mirror::place>(position, owned);
}

template <int Dim>
void Ghosts<Dim>::reorder(const Array<Index>& order, std::size_t owned) {
    parent_buffer_.resize(count());
    path_buffer_.resize(count());
    for (std::size_t k = 0; k < count(); ++k) {
        parent_buffer_[k] = parent_[order[k] - owned];
        path_buffer_[k] = path_[order[k] - owned];
    }
    parent_.swap(parent_buffer_);
    path_.swap(path_buffer_);
}

}  // namespace sluice
