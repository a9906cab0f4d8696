#include "engine/step/couplings/contact_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sluice {
namespace {

/// Skin over the smallest smoothing length, as for other lists (neighborhood.cpp).
constexpr double skin_over_h = 0.8;
/// Edge of the cells over the longest smoothing length: contact is a layer of particles, of which few fill a cell.
constexpr double cell_over_h = 4;

template <int Dim>
Box<Dim> box_of(const VectorField<Dim>& position, const Array<Index>& members) {
    Box<Dim> box;
    for (const Index i : members) box.add(position[i]);
    return box;
}

template <int Dim>
double distance(const Box<Dim>& box, const Vec<Dim>& x) {
    return std::sqrt(distance2(box, Box<Dim>(x, x)));
}

}  // namespace

template <int Dim>
void ContactParticles<Dim>::clear() {
    solid.clear();
    body.clear();
    for (auto& column : position.c) column.clear();
    volume.clear();
    smoothing_length.clear();
    finish();
}

template <int Dim>
void ContactParticles<Dim>::add(const ParticleSet<Dim>& phase, std::size_t i, double reference_volume) {
    solid.push_back(static_cast<Index>(i));
    body.push_back(phase.body[i]);
    position.push_back(phase.position[i]);
    volume.push_back(reference_volume);
    smoothing_length.push_back(phase.smoothing_length[i]);
}

template <int Dim>
void ContactParticles<Dim>::finish() {
    density.assign(size(), 0);
    pressure.assign(size(), 0);
    for (auto& column : force_density.c) column.assign(size(), 0);
}

template <int Dim>
std::size_t ContactParticles<Dim>::bytes() const {
    std::size_t reals = volume.capacity() + smoothing_length.capacity() + density.capacity() + pressure.capacity();
    for (std::size_t k = 0; k < Dim; ++k) reals += position.c[k].capacity() + force_density.c[k].capacity();
    return solid.capacity() * sizeof(Index) + body.capacity() * sizeof(std::uint16_t) + reals * sizeof(double);
}

template <int Dim>
ContactSearch<Dim>::ContactSearch(State<Dim>& state, const Neighborhood<Dim>& neighbors, double support)
    : state_(state), neighbors_(neighbors), support_(support) {
    const ScalarField& h = state.solid.smoothing_length;
    if (h.empty()) return;
    const auto [least, most] = std::minmax_element(h.begin(), h.end());
    double longest = *most;
    for (const double of_wall : state.wall.smoothing_length) longest = std::max(longest, of_wall);
    reach_ = support * 0.5 * (*most + longest);
    skin_ = skin_over_h * *least;
    cell_ = cell_over_h * longest;
    at_planes.resize(state.ghost_planes.size());
}

template <int Dim>
bool ContactSearch<Dim>::outdated() const {
    return builds_ == 0 || 2 * moved_ > room_ || solid_layout_ != neighbors_.solid_layout() ||
           wall_layout_ != neighbors_.wall_layout();
}

template <int Dim>
void ContactSearch<Dim>::update() {
    if (outdated()) build();
}

template <int Dim>
void ContactSearch<Dim>::build() {
    if (builds_ == 0 || solid_layout_ != neighbors_.solid_layout()) sort_into_groups();
    solid_layout_ = neighbors_.solid_layout();
    wall_layout_ = neighbors_.wall_layout();
    moved_ = 0;
    room_ = std::numeric_limits<double>::infinity();
    list_bodies();
    list_walls();
    list_planes();
    ++builds_;
}

template <int Dim>
bool ContactSearch<Dim>::is_near(double gap) {
    room_ = std::min(room_, std::max(gap, skin_));
    return gap < skin_;
}

template <int Dim>
void ContactSearch<Dim>::sort_into_groups() {
    members_.clear();
    if (state_.solid_group.empty()) return;
    members_.resize(state_.solid_group.size());
    for (std::size_t i = 0; i < state_.solid.owned; ++i)
        members_[static_cast<std::size_t>(state_.solid_group[state_.solid.body[i]])].push_back(static_cast<Index>(i));
    std::erase_if(members_, [](const Array<Index>& m) { return m.empty(); });
    if (bodies.empty()) find_moduli();
}

template <int Dim>
void ContactSearch<Dim>::find_moduli() {
    for (const Array<Index>& members : members_) {
        modulus_.push_back(std::numeric_limits<double>::infinity());
        for (const Index i : members)
            modulus_.back() =
                std::min(modulus_.back(), state_.solid_materials.of_body(state_.solid.body[i]).law.wave_modulus());
    }
    std::vector<double> found;
    for (std::size_t a = 0; a < members_.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) found.push_back(modulus_between(a, b));
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for (const double modulus : found) bodies.push_back({modulus, {}, {}});
}

template <int Dim>
bool ContactSearch<Dim>::select(const Array<Index>& members, const std::vector<Box<Dim>>& boxes,
                                ContactParticles<Dim>& to) {
    const std::size_t before = to.size();
    for (const Index i : members) {
        const Vec<Dim> x = state_.solid.position[i];
        const auto near = [&](const Box<Dim>& box) { return distance(box, x) < reach_ + skin_; };
        if (std::any_of(boxes.begin(), boxes.end(), near)) to.add(state_.solid, i, volume_of(i));
    }
    return to.size() > before;
}

template <int Dim>
void ContactSearch<Dim>::list_bodies() {
    const std::size_t groups = members_.size();
    std::vector<Box<Dim>> box;
    for (const auto& members : members_) box.push_back(box_of(state_.solid.position, members));
    std::vector<std::vector<std::size_t>> near(groups);
    for (std::size_t a = 0; a < groups; ++a)
        for (std::size_t b = 0; b < a; ++b) {
            if (!is_near(std::sqrt(distance2(box[a], box[b])) - reach_)) continue;
            near[a].push_back(b);
            near[b].push_back(a);
        }
    for (BodyContact<Dim>& contact : bodies) list_contact(box, near, contact);
}

template <int Dim>
void ContactSearch<Dim>::list_contact(const std::vector<Box<Dim>>& box,
                                      const std::vector<std::vector<std::size_t>>& near, BodyContact<Dim>& contact) {
    const std::size_t groups = members_.size();
    const auto meets = [&](std::size_t a, std::size_t b) { return modulus_between(a, b) == contact.modulus; };
    ContactParticles<Dim>& particles = contact.particles;
    particles.clear();
    contact.lists.clear();
    grids_.assign(groups, {});
    for (std::size_t g = 0; g < groups; ++g) {
        std::vector<Box<Dim>> boxes;
        for (const std::size_t other : near[g])
            if (meets(g, other)) boxes.push_back(box[other]);
        const std::size_t first = particles.size();
        if (select(members_[g], boxes, particles))
            grids_[g].build(particles.position, first, particles.size(), cell_, particles.smoothing_length);
    }
    particles.finish();
    const CutOff cut{skin_, 0.5 * support_, 0.5 * support_};
    // Targets are a set of their own, so that particles are not among their own candidates.
    const VectorField<Dim> places = particles.position;
    const Set queries{particles.position, particles.smoothing_length}, others{places, particles.smoothing_length};
    for (std::size_t g = 0; g < groups; ++g) {
        std::vector<const Grid*> targets;
        for (const std::size_t other : near[g])
            if (meets(g, other) && grids_[other].size() > 0) targets.push_back(&grids_[other]);
        if (grids_[g].size() == 0 || targets.empty()) continue;
        NeighborList list;
        search_.build(grids_[g], targets, cut, list);
        search_.prune(queries, others, cut, list);
        if (list.blocks() > 0) contact.lists.push_back(std::move(list));
    }
}

template <int Dim>
void ContactSearch<Dim>::list_walls() {
    const auto& wall = state_.wall;
    at_walls.clear();
    wall_list.clear();
    if (wall.position.size() == 0) return;
    std::vector<Box<Dim>> boxes;  // by the walls' numbers
    for (std::size_t i = 0; i < wall.owned; ++i) {
        boxes.resize(std::max<std::size_t>(boxes.size(), wall.body[i] + 1U));
        boxes[wall.body[i]].add(wall.position[i]);
    }
    for (std::size_t i = 0; i < state_.solid.owned; ++i) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Box<Dim>& box : boxes) nearest = std::min(nearest, distance(box, state_.solid.position[i]));
        if (is_near(nearest - reach_)) at_walls.add(state_.solid, i, volume_of(i));
    }
    at_walls.finish();
    if (at_walls.size() == 0) return;
    at_wall_grid_.build(at_walls.position, 0, at_walls.size(), cell_, at_walls.smoothing_length);
    wall_grid_.build(wall.position, 0, wall.position.size(), cell_, wall.smoothing_length);
    const CutOff cut{skin_, 0.5 * support_, 0.5 * support_};
    const Grid* const target = &wall_grid_;
    search_.build(at_wall_grid_, {&target, 1}, cut, wall_list);
    search_.prune({at_walls.position, at_walls.smoothing_length}, {wall.position, wall.smoothing_length}, cut,
                  wall_list);
}

template <int Dim>
void ContactSearch<Dim>::list_planes() {
    const auto& solid = state_.solid;
    for (std::size_t p = 0; p < at_planes.size(); ++p) {
        at_planes[p].clear();
        const GhostPlane<Dim>& plane = state_.ghost_planes[p];
        if (!plane.is_mirror()) continue;
        // Contact begins closer than a smoothing length: half a spacing (contact.cpp).
        for (std::size_t i = 0; i < solid.owned; ++i)
            if (is_near(plane.distance(solid.position[i]) - solid.smoothing_length[i]))
                at_planes[p].push_back(static_cast<Index>(i));
    }
}

template <int Dim>
std::size_t ContactSearch<Dim>::bytes() const {
    std::size_t sum = at_walls.bytes() + wall_list.bytes() + at_wall_grid_.bytes() + wall_grid_.bytes();
    for (const BodyContact<Dim>& contact : bodies) {
        sum += contact.particles.bytes();
        for (const NeighborList& list : contact.lists) sum += list.bytes();
    }
    for (const Grid& grid : grids_) sum += grid.bytes();
    for (const auto* sets : {&members_, &at_planes})
        for (const Array<Index>& set : *sets) sum += set.capacity() * sizeof(Index);
    return sum;
}

template struct ContactParticles<2>;
template struct ContactParticles<3>;
template class ContactSearch<2>;
template class ContactSearch<3>;

}  // namespace sluice
