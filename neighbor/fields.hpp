// Particle state as structure of arrays: every component of every field is one aligned, contiguous column.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

#include "neighbor/vec.hpp"

namespace sluice {

/// Allocates on cache-line boundaries, so that vector loads never straddle a line at a column's start.
template <class T>
struct AlignedAllocator {
    using value_type = T;
    static constexpr std::align_val_t alignment{64};
    AlignedAllocator() = default;
    template <class U>
    AlignedAllocator(const AlignedAllocator<U>&) {}
    T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), alignment)); }
    void deallocate(T* p, std::size_t) { ::operator delete(p, alignment); }
    friend bool operator==(const AlignedAllocator&, const AlignedAllocator&) { return true; }
};

/// One column.
template <class T>
using Array = std::vector<T, AlignedAllocator<T>>;

/// Resizes with little room to spare, where a vector would double its memory.
template <class T>
void resize_tight(Array<T>& column, std::size_t n) {
    if (n > column.capacity()) column.reserve(n + n / 32);
    column.resize(n);
}

using ScalarField = Array<double>;
using Index = std::uint32_t;

/// Dim(Dim+1)/2: the independent components of a symmetric tensor, ordered xx, yy, xy (2D); xx, yy, zz, xy, xz, yz
/// (3D).
template <int Dim>
inline constexpr int sym_components = Dim*(Dim + 1) / 2;

/// A fixed number of columns of equal length, read and written one particle at a time as a small value.
template <int Components>
struct TupleField {
    std::array<ScalarField, Components> c;

    std::size_t size() const { return c[0].size(); }
    void resize(std::size_t n) {
        for (auto& column : c) resize_tight(column, n);
    }
    Vec<Components> operator[](std::size_t i) const {
        Vec<Components> v;
        for (int k = 0; k < Components; ++k) v[k] = c[static_cast<std::size_t>(k)][i];
        return v;
    }
    void set(std::size_t i, const Vec<Components>& v) {
        for (int k = 0; k < Components; ++k) c[static_cast<std::size_t>(k)][i] = v[k];
    }
    void push_back(const Vec<Components>& v) {
        for (int k = 0; k < Components; ++k) c[static_cast<std::size_t>(k)].push_back(v[k]);
    }
};

template <int Dim>
using VectorField = TupleField<Dim>;
template <int Dim>
using SymTensorField = TupleField<sym_components<Dim>>;

}  // namespace sluice
