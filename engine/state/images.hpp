// Mirror walls: slip walls made by reflecting the particles in front of them.
//
// The image of a particle at x across the plane (P, n) is at x − 2 ((x − P)·n) n, and its velocity likewise has its
// normal part reversed; scalars are copied. With images as neighbours a particle at the wall sees a full support, no
// flow through the plane and no friction along it. Where two planes meet, images are reflected again across the later
// plane, so that a corner is filled.
#pragma once

#include <vector>

#include "neighbor/fields.hpp"

namespace sluice {

template <int Dim>
struct MirrorPlane {
    Vec<Dim> point;
    Vec<Dim> normal;  ///< unit, into the fluid

    double distance(const Vec<Dim>& x) const { return dot(x - point, normal); }
    Vec<Dim> reflect_position(const Vec<Dim>& x) const { return x - 2 * distance(x) * normal; }
    Vec<Dim> reflect_direction(const Vec<Dim>& v) const { return v - 2 * dot(v, normal) * normal; }
};

/// Which images a set of particles has. Image number k stands at index owned + k and copies a lower index.
template <int Dim>
class Images {
  public:
    /// Decides the images of the first `owned` particles: those no farther from a plane than range(i), and appends
    /// their positions. [m]
    template <class Range>
    void create(const std::vector<MirrorPlane<Dim>>& planes, VectorField<Dim>& position, std::size_t owned,
                Range&& range);

    std::size_t count() const { return parent_.size(); }
    /// Index of the owned particle or earlier image that image k reflects.
    Index parent(std::size_t k) const { return parent_[k]; }

    /// Appends copies of the parents' entries.
    template <class T>
    void extend(Array<T>& column, std::size_t owned) const {
        column.resize(owned + count());
        refresh(column, owned);
    }
    /// Copies a scalar from each parent.
    template <class T>
    void refresh(Array<T>& column, std::size_t owned) const {
        for (std::size_t k = 0; k < count(); ++k) column[owned + k] = column[parent_[k]];
    }
    void refresh_positions(VectorField<Dim>& field, std::size_t owned) const {
        for (std::size_t k = 0; k < count(); ++k)
            field.set(owned + k, planes_[plane_[k]].reflect_position(field[parent_[k]]));
    }
    void refresh_directions(VectorField<Dim>& field, std::size_t owned) const {
        for (std::size_t k = 0; k < count(); ++k)
            field.set(owned + k, planes_[plane_[k]].reflect_direction(field[parent_[k]]));
    }
    std::size_t bytes() const { return parent_.capacity() * (sizeof(Index) + 1); }

  private:
    std::vector<MirrorPlane<Dim>> planes_;
    Array<Index> parent_;
    Array<std::uint8_t> plane_;
};

template <int Dim>
template <class Range>
void Images<Dim>::create(const std::vector<MirrorPlane<Dim>>& planes, VectorField<Dim>& position, std::size_t owned,
                         Range&& range) {
    planes_ = planes;
    parent_.clear();
    plane_.clear();
    position.resize(owned);
    for (std::size_t p = 0; p < planes.size(); ++p) {
        const std::size_t before = position.size();
        for (std::size_t i = 0; i < before; ++i) {
            std::size_t owner = i;
            while (owner >= owned) owner = parent_[owner - owned];
            if (planes[p].distance(position[i]) > range(owner)) continue;
            parent_.push_back(static_cast<Index>(i));
            plane_.push_back(static_cast<std::uint8_t>(p));
            position.push_back(planes[p].reflect_position(position[i]));
        }
    }
}

}  // namespace sluice
