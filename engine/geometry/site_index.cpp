#include "engine/geometry/site_index.hpp"

#include <algorithm>

namespace sluice {

SiteIndex::SiteIndex(const std::vector<Site>& sites) {
    for (const Site& s : sites)
        for (std::size_t k = 0; k < 3; ++k) size_[k] = std::max(size_[k], s[k] + 1);
    particle_.assign(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2], none);
    for (std::size_t i = 0; i < sites.size(); ++i) particle_[place(sites[i])] = static_cast<std::int32_t>(i);
}

std::int32_t SiteIndex::particle_at(const Site& s) const {
    for (std::size_t k = 0; k < 3; ++k)
        if (s[k] < 0 || s[k] >= size_[k]) return none;
    return particle_[place(s)];
}

}  // namespace sluice
