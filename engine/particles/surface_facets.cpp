#include "engine/particles/surface_facets.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "engine/geometry/moving_least_squares.hpp"
#include "engine/geometry/site_index.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

/// Support of a corner's fit in lattice spacings. Sites stand √0.75, √2.75 and √4.75 = 2.18 from a corner. The first
/// two shells are enough in sides and edges of a body; elsewhere the support grows until the particles span space.
constexpr double first_support = 2.1;
/// A body that is two particles thick everywhere spans space within far less.
constexpr double last_support = 10;

/// Particles that can be reached from one by steps between neighbouring sites, without leaving the block of 2n sites
/// a side around a corner. Corner c is the lowest one of the brick of site c.
std::vector<Index> connected(const SiteIndex& lattice, const std::vector<Site>& sites, Index from, const Site& corner,
                             std::int32_t n) {
    std::vector<Index> found{from};
    for (std::size_t next = 0; next < found.size(); ++next)
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const std::int32_t step : {-1, 1}) {
                const Site s = moved(sites[found[next]], axis, step);
                if (s[axis] < corner[axis] - n || s[axis] >= corner[axis] + n) continue;
                const std::int32_t particle = lattice.particle_at(s);
                if (particle == SiteIndex::none) continue;
                const auto i = static_cast<Index>(particle);
                if (std::find(found.begin(), found.end(), i) == found.end()) found.push_back(i);
            }
    std::sort(found.begin(), found.end());
    return found;
}

/// Weights of the linear fit at a corner to the particles connected with one of those around it; empty if these lie in
/// one plane.
std::vector<CornerShare> fit_corner(const SiteIndex& lattice, const std::vector<Site>& sites, Index from,
                                    const Site& corner) {
    for (double support = first_support; support < last_support; support *= 1.2) {
        const auto particles = connected(lattice, sites, from, corner, static_cast<std::int32_t>(support + 0.5));
        std::vector<Vec<3>> offsets;
        for (const Index i : particles) {
            Vec<3> offset;
            for (std::size_t k = 0; k < 3; ++k) offset.c[k] = sites[i][k] + 0.5 - corner[k];
            offsets.push_back(offset);
        }
        const auto shares = least_squares_shares<3>(offsets, {}, support);
        if (!shares) continue;
        std::vector<CornerShare> corner_shares;
        for (const Share& share : *shares) corner_shares.push_back({particles[share.point], share.weight});
        return corner_shares;
    }
    return {};
}

/// Numbers corners as they are first met. A corner is known by its place and the lowest particle of those around it
/// that are connected there.
class CornerNumbers {
  public:
    struct Corner {
        Site place;
        Index lowest;
        friend auto operator<=>(const Corner&, const Corner&) = default;
    };

    Index number_of(const Corner& corner) {
        const auto [entry, is_new] = numbers_.try_emplace(corner, static_cast<Index>(corners_.size()));
        if (is_new) corners_.push_back(corner);
        return entry->second;
    }
    const std::vector<Corner>& all() const { return corners_; }

  private:
    std::map<Corner, Index> numbers_;
    std::vector<Corner> corners_;
};

/// Corners of the side of a site's brick that faces along ±axis, counter-clockwise seen from outside.
std::array<Site, 4> corners_of_side(const Site& site, std::size_t axis, std::int32_t direction) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    const Site a = direction > 0 ? moved(site, axis, 1) : site;
    const Site b = moved(a, u, 1), d = moved(a, v, 1), c = moved(b, v, 1);
    return direction > 0 ? std::array<Site, 4>{a, b, c, d} : std::array<Site, 4>{a, d, c, b};
}

}  // namespace

SurfaceFacets trace_surface(const std::vector<Site>& sites) {
    const SiteIndex lattice(sites);
    SurfaceFacets facets;
    CornerNumbers numbers;
    for (std::size_t i = 0; i < sites.size(); ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const std::int32_t direction : {-1, 1}) {
                if (lattice.taken(moved(sites[i], axis, direction))) continue;
                std::array<Index, 4> face;
                const auto places = corners_of_side(sites[i], axis, direction);
                for (std::size_t c = 0; c < 4; ++c) {
                    const auto around = connected(lattice, sites, static_cast<Index>(i), places[c], 1);
                    face[c] = numbers.number_of({places[c], around.front()});
                }
                facets.faces.push_back(face);
            }
    facets.corners.resize(numbers.all().size());
    parallel_for_heavy(facets.corners.size(), [&](std::size_t c) {
        const auto& corner = numbers.all()[c];
        facets.corners[c] = fit_corner(lattice, sites, corner.lowest, corner.place);
    });
    for (const auto& corner : facets.corners)
        if (corner.empty()) throw std::logic_error("a body in one plane, which find_thin_place should have refused");
    return facets;
}

}  // namespace sluice
