// Images of particles: behind mirror walls, and beyond the sides of a periodic box.
//
// Mirror walls are slip walls made by reflecting the particles in front of them. The image of a particle at x across
// the plane (P, n) is at x − 2 ((x − P)·n) n, and its velocity likewise has its normal part reversed; scalars are
// copied. With images as neighbours a particle at the wall sees a full support, no flow through the plane and no
// friction along it.
//
// A periodic box of length L along n has a plane at either side; what is near one has an image moved by L n, so that it
// stands beyond the other.
//
// Where two planes meet, images are imaged again across the later plane, so that a corner is filled.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "neighbor/fields.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {

template <int Dim>
struct ImagePlane {
    Vec<Dim> point;
    Vec<Dim> normal;   ///< unit, into the fluid
    double shift = 0;  ///< length of a periodic box [m]; 0 = mirror
    int partner = -1;  ///< number of the periodic box's other plane

    bool is_mirror() const { return shift == 0; }
    double distance(const Vec<Dim>& x) const { return dot(x - point, normal); }
    Vec<Dim> image_position(const Vec<Dim>& x) const { return x + (is_mirror() ? -2 * distance(x) : shift) * normal; }
    Vec<Dim> image_direction(const Vec<Dim>& v) const { return is_mirror() ? v - 2 * dot(v, normal) * normal : v; }
};

/// Which images a set of particles has. Image number k stands at index owned + k.
template <int Dim>
class Images {
  public:
    /// Decides the images of the first `owned` particles: those no farther from a plane than range(i), and appends
    /// their positions. [m]
    template <class Range>
    void create(const std::vector<ImagePlane<Dim>>& planes, VectorField<Dim>& position, std::size_t owned,
                Range&& range);

    /// Brings the images into another order: image k is then the one that was at index order[k]. The columns must be
    /// refreshed after it.
    void reorder(const Array<Index>& order, std::size_t owned);

    std::size_t count() const { return parent_.size(); }
    /// The owned particle that image k shows.
    Index parent(std::size_t k) const { return parent_[k]; }

    /// Appends copies of the parents' entries.
    template <class T>
    void extend(Array<T>& column, std::size_t owned) const {
        resize_tight(column, owned + count());
        refresh(column, owned);
    }
    /// Copies a scalar from each parent.
    template <class T>
    void refresh(Array<T>& column, std::size_t owned) const {
        parallel_for(count(), [&](std::size_t k) { column[owned + k] = column[parent_[k]]; });
    }
    void refresh_positions(VectorField<Dim>& field, std::size_t owned) const {
        reflect(field, owned, [](const ImagePlane<Dim>& p, const Vec<Dim>& x) { return p.image_position(x); });
    }
    void refresh_directions(VectorField<Dim>& field, std::size_t owned) const {
        reflect(field, owned, [](const ImagePlane<Dim>& p, const Vec<Dim>& v) { return p.image_direction(v); });
    }
    /// visit(name, member) for all that decides the images; the planes are given anew with the next ones.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("planes", planes_), visit("paths", paths_), visit("parent", parent_), visit("path", path_);
    }

    std::size_t bytes() const { return parent_.capacity() * sizeof(Index) + path_.capacity() * sizeof(std::uint16_t); }

  private:
    /// Planes that lead from an owned particle to an image, the first one first.
    using Path = std::vector<std::uint8_t>;

    template <class Reflect>
    void reflect(VectorField<Dim>& field, std::size_t owned, Reflect&& reflect_once) const {
        parallel_for(count(), [&](std::size_t k) {
            Vec<Dim> value = field[parent_[k]];
            for (const std::uint8_t plane : paths_[path_[k]]) value = reflect_once(planes_[plane], value);
            field.set(owned + k, value);
        });
    }
    Vec<Dim> place_of(Vec<Dim> x, std::uint16_t path) const {
        for (const std::uint8_t plane : paths_[path]) x = planes_[plane].image_position(x);
        return x;
    }

    bool leads_across(std::uint16_t path, int plane) const {
        return std::find(paths_[path].begin(), paths_[path].end(), plane) != paths_[path].end();
    }

    std::vector<ImagePlane<Dim>> planes_;
    std::vector<Path> paths_;
    Array<Index> parent_, parent_buffer_;
    Array<std::uint16_t> path_, path_buffer_;  ///< into paths_
};

template <int Dim>
template <class Range>
void Images<Dim>::create(const std::vector<ImagePlane<Dim>>& planes, VectorField<Dim>& position, std::size_t owned,
                         Range&& range) {
    planes_ = planes;
    paths_.assign(1, {});
    parent_.clear();
    path_.clear();
    position.resize(owned);
    for (std::size_t p = 0; p < planes.size(); ++p) {
        const std::size_t before = owned + count();
        std::vector<std::uint16_t> onward(paths_.size(), 0);  // from each path across plane p; 0 = not yet gone
        for (std::size_t i = 0; i < before; ++i) {
            const Index owner = i < owned ? static_cast<Index>(i) : parent_[i - owned];
            const std::uint16_t path = i < owned ? std::uint16_t{0} : path_[i - owned];
            if (planes[p].distance(place_of(position[owner], path)) > range(owner)) continue;
            if (!planes[p].is_mirror() && leads_across(path, planes[p].partner)) continue;  // would lead back
            parent_.push_back(owner);
            if (onward[path] == 0) {
                onward[path] = static_cast<std::uint16_t>(paths_.size());
                paths_.push_back(paths_[path]);
                paths_.back().push_back(static_cast<std::uint8_t>(p));
            }
            path_.push_back(onward[path]);
        }
    }
    position.resize(owned + count());
    refresh_positions(position, owned);
}

template <int Dim>
void Images<Dim>::reorder(const Array<Index>& order, std::size_t owned) {
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
