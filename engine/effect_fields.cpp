#include "engine/effect_fields.hpp"

#include "engine/state/visit.hpp"

namespace sluice {
namespace {

template <class Phase>
void add_columns(const EffectInfo& effect, std::string_view name, Phase phase, std::vector<ColumnBytes>& to) {
    visit_columns(phase, [&](std::string_view column, auto& values) {
        if (!effect.needs(name, column)) return;
        const bool new_column = to.empty() || to.back().phase != name || to.back().column != column;
        if (new_column) to.push_back({name, column, 0});
        to.back().bytes += sizeof(values[0]);  // the columns of a tuple share its name
    });
}

}  // namespace

template <int Dim>
std::vector<ColumnBytes> column_bytes_of(const EffectInfo& effect) {
    std::vector<ColumnBytes> columns;
    add_columns(effect, "fluid", FluidPhase<Dim>{}, columns);
    add_columns(effect, "solid", SolidPhase<Dim>{}, columns);
    add_columns(effect, "wall", WallPhase<Dim>{}, columns);
    add_columns(effect, "elements", InterfaceElements<Dim>{}, columns);
    add_columns(effect, "boundary", BoundaryParticles<Dim>{}, columns);
    return columns;
}

template <int Dim>
std::vector<FieldBytes> field_bytes(const EffectInfo& effect) {
    std::vector<FieldBytes> sums;
    for (const ColumnBytes& c : column_bytes_of<Dim>(effect)) {
        if (sums.empty() || sums.back().phase != c.phase) sums.push_back({c.phase, 0});
        sums.back().bytes += c.bytes;
    }
    return sums;
}

template std::vector<ColumnBytes> column_bytes_of<2>(const EffectInfo&);
template std::vector<ColumnBytes> column_bytes_of<3>(const EffectInfo&);
template std::vector<FieldBytes> field_bytes<2>(const EffectInfo&);
template std::vector<FieldBytes> field_bytes<3>(const EffectInfo&);

}  // namespace sluice
