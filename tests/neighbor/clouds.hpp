// Sets of points for tests, the same in every run.
#pragma once

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "neighbor/fields.hpp"
#include "tests/neighbor/scopes.hpp"

namespace sluice {

/// Uniform random numbers; a fixed generator, so that a failure can be repeated.
class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double in(double lo, double hi) {
        // Not std::uniform_real_distribution: its result differs between standard libraries.
        return lo + (hi - lo) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
    }
    std::uint64_t bits() { return engine_(); }
    template <int N>
    Vec<N> vector(double lo, double hi) {
        Vec<N> v;
        for (int k = 0; k < N; ++k) v[k] = in(lo, hi);
        return v;
    }

  private:
    std::mt19937_64 engine_;
};

/// n points, uniform in the box [0, side)^Dim.
template <int Dim>
VectorField<Dim> random_cloud(std::size_t n, double side, Random& random) {
    VectorField<Dim> x;
    for (std::size_t i = 0; i < n; ++i) x.push_back(random.vector<Dim>(0, side));
    return x;
}

/// per_axis^Dim points i·d, as a packing makes them: with the ties at the cut-off that only a lattice has.
template <int Dim>
VectorField<Dim> lattice_points(int per_axis, double d) {
    VectorField<Dim> x;
    Vec<Dim> p;
    for (int k = 0; k < (Dim == 3 ? per_axis : 1); ++k)
        for (int j = 0; j < per_axis; ++j)
            for (int i = 0; i < per_axis; ++i) {
                p[0] = i * d;
                p[1] = j * d;
                if (Dim == 3) p[Dim - 1] = k * d;
                x.push_back(p);
            }
    return x;
}

/// Dense heaps with a sparse haze between them.
template <int Dim>
VectorField<Dim> clustered_cloud(std::size_t n, double side, Random& random) {
    VectorField<Dim> x;
    Vec<Dim> centre;
    for (std::size_t i = 0; i < n; ++i) {
        if (i % 50 == 0) centre = random.vector<Dim>(0, side);
        x.push_back(i % 10 == 9 ? random.vector<Dim>(0, side) : centre + random.vector<Dim>(0, 0.02 * side));
    }
    return x;
}

/// The numbers 0 … n − 1 in an order of chance.
inline std::vector<std::size_t> shuffled(std::size_t n, Random& random) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < n; ++i) {
        order.push_back(i);
        std::swap(order[i], order[random.bits() % (i + 1)]);
    }
    return order;
}

/// field[order[0]], field[order[1]], …
template <int N, class Order>
TupleField<N> reordered(const TupleField<N>& field, const Order& order) {
    TupleField<N> result;
    for (const auto i : order) result.push_back(field[i]);
    return result;
}
template <class Order>
ScalarField reordered(const ScalarField& field, const Order& order) {
    ScalarField result;
    for (const auto i : order) result.push_back(field[i]);
    return result;
}

/// Reaches in the ratio 1 : 4.
inline ScalarField random_reach(std::size_t n, double smallest, Random& random) {
    ScalarField h;
    for (std::size_t i = 0; i < n; ++i) h.push_back(random.in(smallest, 4 * smallest));
    return h;
}

}  // namespace sluice
