#include <algorithm>

#include "engine/scene/effects/effect_table.hpp"

namespace sluice {

bool EffectInfo::needs(SetId set, Column of) const {
    const std::string_view phase = name_of(set), column = info_of(of).name;
    for (std::size_t at = 0; at < fields.size();) {
        const std::size_t end = std::min(fields.find(' ', at), fields.size());
        const std::string_view word = fields.substr(at, end - at);
        if (word.size() == phase.size() + 1 + column.size() && word.starts_with(phase) && word.ends_with(column) &&
            word[phase.size()] == '.')
            return true;
        at = end + 1;
    }
    return false;
}

}  // namespace sluice
