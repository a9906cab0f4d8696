// Which particle of a packing stands at which lattice site.
#pragma once

#include <vector>

#include "engine/geometry/packing.hpp"

namespace sluice {

inline Site moved(Site site, std::size_t axis, std::int32_t by) {
    site[axis] += by;
    return site;
}

/// A table over the smallest box that holds all sites.
class SiteIndex {
  public:
    static constexpr std::int32_t none = -1;

    explicit SiteIndex(const std::vector<Site>& sites);

    /// The particle's number in the packing, or `none`.
    std::int32_t particle_at(const Site& s) const;
    bool taken(const Site& s) const { return particle_at(s) != none; }

  private:
    std::size_t place(const Site& s) const {
        return (static_cast<std::size_t>(s[2]) * size_[1] + s[1]) * size_[0] + s[0];
    }
    Site size_{};
    std::vector<std::int32_t> particle_;
};

}  // namespace sluice
