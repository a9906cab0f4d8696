// Where a fixed wall is no face any more, but wall all around.
#pragma once

#include <vector>

#include "engine/simulation/simulation.hpp"

namespace sluice {

/// Tells which fluid particles have gone through the face of a fixed wall: those that the walls' shapes surround by
/// `depth`.
///
/// How near a wall's particles are does not tell it. A grain of spray settles up to 0.4 spacings deep in a face, where
/// it rests or slides on, and passes the first layer's particles at less than 0.2 spacings; one that goes through can
/// do so between four of them, 0.7 spacings from each.
template <int Dim>
class InsideWalls {
  public:
    explicit InsideWalls(const Simulation<Dim>& simulation);

    bool operator()(const Vec<Dim>& x) const;

    /// Of the first layer's particles it is half a spacing; grains that settle stay above them. [spacings of the wall]
    static constexpr double depth = 0.6;

  private:
    struct Part {
        const Shape* shape;
        double depth;           ///< [m]
        Vec<Dim> displacement;  ///< since the start [m]
    };
    bool in_any(const Vec<Dim>& x) const;

    std::vector<Part> parts_;
};

extern template class InsideWalls<2>;
extern template class InsideWalls<3>;

}  // namespace sluice
