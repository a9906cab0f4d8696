#include "engine/particles/joined_bodies.hpp"

#include <algorithm>

#include "neighbor/box.hpp"
#include "neighbor/neighbor_list.hpp"

namespace sluice {
namespace {

/// Gap between surfaces over the mean spacing below which bodies are joined: lattices that share an edge have none;
/// those of shapes that share one may have half of one here and there, but not everywhere.
constexpr double joined_gap = 0.25;

/// Whether any two points of the two sets are within a distance of each other.
bool are_within(const Packing& a, const Packing& b, double distance) {
    const auto field = [](const Packing& p) {
        VectorField<3> x;
        for (const Point& point : p.position) x.push_back({point});
        return x;
    };
    const VectorField<3> places_a = field(a), places_b = field(b);
    ClusterGrid<3> grid_a, grid_b;
    // A few particles to a cell.
    grid_a.build(places_a, 0, places_a.size(), 4 * distance);
    grid_b.build(places_b, 0, places_b.size(), 4 * distance);
    const ScalarField no_reach_a(places_a.size(), 0.0), reach_b(places_b.size(), distance);
    const ClusterGrid<3>* const targets = &grid_b;
    NeighborSearch<3> search;
    NeighborList list;
    search.build(grid_a, {&targets, 1}, {distance, 0, 0}, list);
    search.prune({places_a, no_reach_a}, {places_b, reach_b}, {0, 0, 1}, list);  // pairs are counted without the skin
    return list.pairs() > 0;
}

template <int Dim>
bool are_near(const std::vector<Box<Dim>>& box, double reach) {
    for (std::size_t a = 0; a < box.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            if (distance2(box[a], box[b]) < reach * reach) return true;  // empty boxes are far from everything
    return false;
}

Box<3> box_of(const Packing& p) {
    Box<3> box;
    for (const Point& x : p.position) box.add(Vec<3>{x});
    return box;
}

}  // namespace

std::vector<int> join_bodies(const Scene& scene, const std::vector<Packing>& packings) {
    const std::size_t n = scene.bodies.size();
    std::vector<int> group(n, no_group);
    std::vector<Box<3>> box(n);
    int groups = 0, hypoelastic = no_group;
    for (std::size_t a = 0; a < n; ++a) {
        const Material& material = scene.materials[scene.bodies[a].material];
        if (material.kind != MaterialKind::solid) continue;
        if (material.model == SolidModel::hypoelastic) {
            if (hypoelastic == no_group) hypoelastic = groups++;
            group[a] = hypoelastic;
            continue;
        }
        group[a] = groups++;
        box[a] = box_of(packings[a]);
        for (std::size_t b = 0; b < a; ++b) {
            if (group[b] == no_group || group[b] == group[a] || group[b] == hypoelastic) continue;
            const double limit = 0.5 * (1 + joined_gap) * (scene.bodies[a].spacing + scene.bodies[b].spacing);
            if (distance2(box[a], box[b]) >= limit * limit || !are_within(packings[a], packings[b], limit)) continue;
            const int from = group[a], to = group[b];
            std::replace(group.begin(), group.end(), from, to);
        }
    }
    return group;
}

template <int Dim>
void part_references(const std::vector<int>& group_of_body, double reach, const PartRange& hyperelastic,
                     ParticleSet<Dim>& solid) {
    std::vector<Box<Dim>> box(group_of_body.size());
    for (std::size_t i = hyperelastic.first; i < hyperelastic.last; ++i)
        box[static_cast<std::size_t>(group_of_body[solid.body[i]])].add(solid.reference_position[i]);
    if (!are_near(box, reach)) return;
    // The groups are put in a row along x; the first stays where it is.
    std::vector<double> shift(box.size(), 0);
    bool first = true;
    double end = 0;
    for (std::size_t g = 0; g < box.size(); ++g) {
        if (box[g].lo[0] > box[g].hi[0]) continue;
        if (!first) shift[g] = end + reach - box[g].lo[0];
        end = box[g].hi[0] + shift[g];
        first = false;
    }
    for (std::size_t i = hyperelastic.first; i < hyperelastic.last; ++i)
        solid.reference_position.c[0][i] += shift[static_cast<std::size_t>(group_of_body[solid.body[i]])];
}

template void part_references<2>(const std::vector<int>&, double, const PartRange&, ParticleSet<2>&);
template void part_references<3>(const std::vector<int>&, double, const PartRange&, ParticleSet<3>&);

}  // namespace sluice
