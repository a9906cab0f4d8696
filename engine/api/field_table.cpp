#include "engine/api/field_table.hpp"

#include <algorithm>
#include <array>

#include "engine/state/visit.hpp"

namespace sluice::api {
namespace {

/// What is of use outside; the engine's other columns are its own affair.
constexpr std::array<FieldInfo, 14> public_fields{{{"position", "m"},
                                                   {"velocity", "m/s"},
                                                   {"acceleration", "m/s^2"},
                                                   {"density", "kg/m^3"},
                                                   {"pressure", "Pa"},
                                                   {"mass", "kg; kg/m in 2D"},
                                                   {"volume", "m^3; m^2 in 2D"},
                                                   {"smoothing_length", "m"},
                                                   {"id", "1"},
                                                   {"body", "1"},
                                                   {"clamped", "1"},
                                                   {"reference_position", "m"},
                                                   {"deformation", "1"},
                                                   {"deviatoric_stress", "Pa"}}};

/// visit(name, column) for each column that holds something.
template <int Dim, class Visit>
void visit_medium(const sluice::Simulation<Dim>& simulation, Medium medium, Visit&& visit) {
    const auto all_of = [&](const auto& phase) {
        using Phase = std::remove_cvref_t<decltype(phase)>;
        if (phase.owned == 0) return;
        visit_columns(const_cast<Phase&>(phase), [&](std::string_view name, const auto& column) {  // only read
            if (column.size() >= phase.owned) visit(name, column, phase.owned);
        });
    };
    if (medium == Medium::fluid) all_of(simulation.fluid());
    if (medium == Medium::solid) all_of(simulation.solid());
    if (medium == Medium::wall) all_of(simulation.wall());
}

/// The pressure of a total-Lagrangian solid follows from its deformation; its column is not kept up to date.
bool is_stale(const Effects& effects, Medium medium, std::string_view field) {
    return medium == Medium::solid && field == "pressure" && effects.has(Effect::total_lagrangian);
}

}  // namespace

template <int Dim>
std::vector<FieldInfo> fields_of(const sluice::Simulation<Dim>& simulation, Medium medium) {
    std::vector<FieldInfo> found;
    for (const FieldInfo& info : public_fields) {
        if (is_stale(simulation.effects(), medium, info.name)) continue;
        bool held = false;
        visit_medium(simulation, medium,
                     [&](std::string_view name, const auto&, std::size_t) { held |= name == info.name; });
        if (held) found.push_back(info);
    }
    return found;
}

template <int Dim>
std::vector<RawColumn> columns_of(const sluice::Simulation<Dim>& simulation, Medium medium, std::string_view field) {
    std::vector<RawColumn> columns;
    visit_medium(simulation, medium, [&](std::string_view name, const auto& column, std::size_t owned) {
        using Value = typename std::remove_cvref_t<decltype(column)>::value_type;
        if (name == field) columns.push_back({column_type<Value>(), column.data(), owned});
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
