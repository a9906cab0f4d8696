#include "engine/api/field_table.hpp"

#include "engine/scene/rules/effects.hpp"

namespace sluice::api {
namespace {

template <int Dim>
const ParticleSet<Dim>& set_of(const sluice::Simulation<Dim>& simulation, Medium medium) {
    switch (medium) {
        case Medium::fluid:
            return simulation.fluid();
        case Medium::solid:
            return simulation.solid();
        case Medium::wall:
            return simulation.wall();
    }
    __builtin_unreachable();
}

/// visit(info, column) for each component of each column that programs may see and that holds something.
template <int Dim, class Visit>
void visit_open(const ParticleSet<Dim>& set, Visit&& visit) {
    if (set.owned == 0) return;
    for_each_array(set, [&](const ColumnInfo& info, const auto& column) {
        if (info.access != Access::internal && column.size() >= set.owned) visit(info, column);
    });
}

/// The pressure of a total-Lagrangian solid follows from its deformation; its column is not kept up to date.
bool is_stale(const Effects& effects, Medium medium, sluice::Column column) {
    return medium == Medium::solid && column == sluice::Column::pressure && effects.has(Effect::total_lagrangian);
}

}  // namespace

template <int Dim>
std::vector<FieldInfo> fields_of(const sluice::Simulation<Dim>& simulation, Medium medium) {
    std::vector<FieldInfo> found;
    visit_open(set_of(simulation, medium), [&](const ColumnInfo& info, const auto&) {
        if (is_stale(simulation.effects(), medium, info.column)) return;
        if (found.empty() || found.back().name != info.name) found.push_back({info.name, info.unit});
    });
    return found;
}

template <int Dim>
std::vector<RawColumn> columns_of(const sluice::Simulation<Dim>& simulation, Medium medium, std::string_view field) {
    const ParticleSet<Dim>& set = set_of(simulation, medium);
    std::vector<RawColumn> columns;
    visit_open(set, [&](const ColumnInfo& info, const auto& column) {
        using Value = typename std::remove_cvref_t<decltype(column)>::value_type;
        if (info.name == field) columns.push_back({column_type<Value>(), column.data(), set.owned});
    });
    return columns;
}

#define SLUICE_INSTANTIATE(Dim)                                                             \
    template std::vector<FieldInfo> fields_of<Dim>(const sluice::Simulation<Dim>&, Medium); \
    template std::vector<RawColumn> columns_of<Dim>(const sluice::Simulation<Dim>&, Medium, std::string_view);
SLUICE_INSTANTIATE(2)
SLUICE_INSTANTIATE(3)
#undef SLUICE_INSTANTIATE

}  // namespace sluice::api
