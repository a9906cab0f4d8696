// Which columns of the particles other programs see, and in which units.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/api/include/sluice/field.hpp"
#include "engine/simulation/simulation.hpp"

namespace sluice::api {

struct FieldInfo {
    std::string_view name;
    std::string_view unit;
};

/// A column before anybody holds it.
struct RawColumn {
    ColumnType type;
    const void* data;
    std::size_t size;
};

/// The fields that the medium has in this scene.
template <int Dim>
std::vector<FieldInfo> fields_of(const sluice::Simulation<Dim>& simulation, Medium medium);

/// A field's columns, without the particles' images.
template <int Dim>
std::vector<RawColumn> columns_of(const sluice::Simulation<Dim>& simulation, Medium medium, std::string_view field);

}  // namespace sluice::api
