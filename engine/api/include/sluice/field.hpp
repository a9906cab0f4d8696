// Fields of particles as they lie in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "sluice/export.hpp"

namespace sluice::api {

enum class Medium { fluid, solid, wall };

enum class ColumnType { float64, uint64, uint16, uint8 };

template <class T>
constexpr ColumnType column_type() {
    static_assert(std::is_same_v<T, double> || std::is_unsigned_v<T>);
    if constexpr (std::is_same_v<T, double>) return ColumnType::float64;
    return sizeof(T) == 8 ? ColumnType::uint64 : sizeof(T) == 2 ? ColumnType::uint16 : ColumnType::uint8;
}

/// One component of a field: a number per particle, in the simulation's own memory.
///
/// A column never changes and never dangles. Steps move particles and bring them into another order; if somebody still
/// holds a column when the next step begins, its memory becomes his, with the values of that time, and the simulation
/// goes on with a copy. So let go of columns before stepping on, or pay a copy of each that you hold.
class SLUICE_API Column {
  public:
    Column(ColumnType type, std::shared_ptr<const void> memory, const void* data, std::size_t size)
        : type_(type), memory_(std::move(memory)), data_(data), size_(size) {}

    ColumnType type() const { return type_; }
    std::size_t size() const { return size_; }
    const void* data() const { return data_; }
    /// Keeps the values readable, whatever becomes of the simulation.
    const std::shared_ptr<const void>& memory() const { return memory_; }

    /// Throws std::logic_error if the column is not of this type.
    template <class T = double>
    std::span<const T> values() const {
        if (column_type<T>() != type_) throw std::logic_error("a column of particles is read as another type");
        return {static_cast<const T*>(data_), size_};
    }

  private:
    ColumnType type_;
    std::shared_ptr<const void> memory_;
    const void* data_;
    std::size_t size_;
};

/// Vectors have a column for each axis, symmetric tensors xx, yy, xy (2D) or xx, yy, zz, xy, xz, yz (3D), others one
/// for each entry, row by row.
struct Field {
    std::string name;
    std::string unit;
    std::vector<Column> columns;
};

/// All particles as a frame's file has them: fluid, solid, walls, each by rising id, in single precision.
struct Frame {
    struct Scalar {
        std::string name;
        std::vector<float> value;  ///< NaN where there is none
    };
    std::vector<float> points;        ///< x, y, z of each particle [m]; z = 0 in 2D
    std::vector<float> velocity;      ///< likewise [m/s]
    std::vector<Scalar> scalars;      ///< pressure and density; with solids also stress and strain
    std::vector<std::uint8_t> phase;  ///< 0 fluid, 1 solid, 2 wall
    std::vector<std::uint16_t> body;  ///< of the scene's bodies, for walls of its walls
    std::vector<std::uint64_t> id;    ///< number within the medium; never changes, and there may be gaps
};

}  // namespace sluice::api
