#include "engine/scene/rules/effect_fields.hpp"

#include "engine/scene/effects/set_id.hpp"
#include "kernels/columns/column_table.hpp"

namespace sluice {
namespace {

std::size_t bytes_of_number(Rank rank) {
    switch (rank) {
        case Rank::scalar:
        case Rank::vector:
        case Rank::symmetric:
        case Rank::full:
            return sizeof(double);
        case Rank::id:
            return sizeof(std::uint64_t);
        case Rank::number:
            return sizeof(std::uint16_t);
        case Rank::flag:
            return sizeof(std::uint8_t);
    }
    return 0;
}

}  // namespace

template <int Dim>
std::vector<ColumnBytes> column_bytes_of(const EffectInfo& effect) {
    std::vector<ColumnBytes> columns;
    for (const SetId set : all_sets)
        for (const ColumnInfo& info : column_table)
            if (effect.columns.has(set, info.column))
                columns.push_back(
                    {name_of(set), info.name,
                     static_cast<std::size_t>(components_of<Dim>(info.rank)) * bytes_of_number(info.rank)});
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
