#include "engine/step/neighborhood.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

/// Skin over the smallest smoothing length of its medium. A thicker skin means fewer builds but more to prune; the
/// optimum is flat.
constexpr double skin_over_h = 0.8;

/// Particles in a full cell: 8² or 4³.
constexpr double cell_particles = 64;

double smallest(const ScalarField& h) { return h.empty() ? 1.0 : *std::min_element(h.begin(), h.end()); }
double largest(const ScalarField& h) { return h.empty() ? 1.0 : *std::max_element(h.begin(), h.end()); }

SkinAccount skin_for(const ScalarField& h) { return SkinAccount(skin_over_h * smallest(h), smallest(h)); }

std::string name_of(const PairingKey& key) {
    std::string name = std::string(name_of(key.query)) + "_" + std::string(name_of(key.target));
    if (key.targets == Targets::own) name += "_own";
    if (key.targets == Targets::ghosts) name += "_ghosts";
    return key.range.empty() ? name : name + "_from_" + std::to_string(key.range.first);
}

}  // namespace

template <int Dim>
Neighborhood<Dim>::Neighborhood(State<Dim>& state, const Effects& effects, double h_over_d, double support)
    : state_(state),
      effects_(effects),
      cell_over_h_(std::pow(cell_particles, 1.0 / Dim) / h_over_d),
      support_(support),
      fluid_skin_(skin_for(state.fluid.smoothing_length)),
      solid_skin_(skin_for(state.solid.smoothing_length)),
      coupling_skin_(skin_over_h * state.min_h, state.min_h) {}

/// A range that is all of a set counts as the set.
template <int Dim>
PartRange Neighborhood<Dim>::within(SetId set, const PartRange& range) const {
    return range.size() == state_[set].owned ? PartRange{} : range;
}

template <int Dim>
Pairing& Neighborhood<Dim>::pair(const PairingKey& asked) {
    PairingKey key = asked;
    key.range = within(key.query, asked.range);
    for (Pairing& known : pairings_)
        if (known.key == key && !known.derived) return known;
    return pairings_.emplace_back(Pairing{key, name_of(key)});
}

template <int Dim>
Pairing& Neighborhood<Dim>::derive(const Pairing& from, const std::string& name) {
    Pairing& made = pairings_.emplace_back(Pairing{from.key, from.name + "_" + name});
    made.derived = true;
    return made;
}

template <int Dim>
typename Neighborhood<Dim>::Grids& Neighborhood<Dim>::grids_of(SetId set, const PartRange& part) {
    const PartRange range = within(set, part);
    for (Grids& known : grids_)
        if (known.set == set && known.range.first == range.first && known.range.last == range.last) return known;
    return grids_.emplace_back(Grids{set, range});
}

template <int Dim>
CutOff Neighborhood<Dim>::cut_off(Reach reach, double skin) const {
    switch (reach) {
        case Reach::mean:
            return {skin, half_support(), half_support()};
        case Reach::of_query:
            return {skin, support_, 0};
        case Reach::of_target:
            return {skin, 0, support_};
    }
    return {};
}

template <int Dim>
void Neighborhood<Dim>::build() {
    if (effects_.has(Effect::fixed_wall)) sort_walls();
    build_for_good();
    build_solid();
    build_fluid();
    build_coupling();
}

template <int Dim>
void Neighborhood<Dim>::expect_motion(double of_fluid, double of_solid, double of_solid_substep) {
    fluid_skin_.expect_motion(of_fluid);
    solid_skin_.expect_motion(of_solid_substep);
    coupling_skin_.expect_motion(0.5 * (of_fluid + of_solid));
}

template <int Dim>
void Neighborhood<Dim>::add_motion(double of_fluid, double of_solid) {
    fluid_skin_.add_motion(of_fluid);
    // The skin allows for twice this: for the sum of both motions, not for twice the larger.
    coupling_skin_.add_motion(0.5 * (of_fluid + of_solid));
}

template <int Dim>
void Neighborhood<Dim>::update() {
    bool rebuilt = refresh_solid();
    if (fluid_skin_.outdated()) {
        build_fluid();
        rebuilt = true;
    } else if (fluid_skin_.prune_due())
        prune(Upkeep::with_fluid, fluid_skin_.prune());
    if (rebuilt || coupling_skin_.outdated()) build_coupling();
}

template <int Dim>
void Neighborhood<Dim>::update_solid() {
    if (refresh_solid()) build_coupling();
}

/// Returns true if the solid's particles have changed their places in memory.
template <int Dim>
bool Neighborhood<Dim>::refresh_solid() {
    if (state_.hypoelastic.empty()) return false;
    if (solid_skin_.outdated()) {
        build_solid();
        return true;
    }
    if (solid_skin_.prune_due()) prune(Upkeep::with_solid, solid_skin_.prune());
    return false;
}

template <int Dim>
void Neighborhood<Dim>::sort(SetId id, const PartRange& range) {
    ParticleSet<Dim>& set = state_[id];
    Grid& grid = grids_of(id, range).own;
    const PartRange of = range.empty() ? PartRange{0, set.owned} : range;
    grid.build(set.position, of.first, of.last, cell_of(id), set.smoothing_length);
    set.reorder(grid.order(), of.first);
    grid.particles_were_sorted(of.first);
}

template <int Dim>
double Neighborhood<Dim>::cell_of(SetId set) const {
    switch (set) {
        case SetId::fluid:
        case SetId::solid:
        case SetId::wall:
            return cell_over_h_ * largest(state_[set].smoothing_length);
        case SetId::elements:
        case SetId::boundary:
            return cell_over_h_ * state_.max_h;
    }
    return 0;
}

template <int Dim>
void Neighborhood<Dim>::sort_walls() {
    if (effects_.has(Effect::moving_wall)) wrap_walls();
    sort(SetId::wall);
    ++wall_layout_;
    make_ghosts(SetId::wall, fluid_skin_.skin());
}

template <int Dim>
void Neighborhood<Dim>::number_solids() {
    ++solid_layout_;
    solid_index_of_id_.update(state_.solid.id, state_.solid.owned);
}

template <int Dim>
void Neighborhood<Dim>::build_fluid() {
    if (state_.fluid.owned == 0) return;
    wrap_fluid();
    sort(SetId::fluid);
    if (effects_.has(Effect::moving_wall)) sort_walls();
    make_ghosts(SetId::fluid, fluid_skin_.skin());
    search(Upkeep::with_fluid);
    fluid_skin_.was_built();
    prune(Upkeep::with_fluid, fluid_skin_.prune());
    ++builds_;
}

template <int Dim>
void Neighborhood<Dim>::build_solid() {
    if (state_.hypoelastic.empty()) return;
    sort(SetId::solid, state_.hypoelastic);
    number_solids();
    search(Upkeep::with_solid);
    solid_skin_.was_built();
    prune(Upkeep::with_solid, solid_skin_.prune());
}

template <int Dim>
void Neighborhood<Dim>::build_for_good() {
    if (state_.hyperelastic.empty()) return;
    sort(SetId::solid, state_.hyperelastic);
    number_solids();
    search(Upkeep::for_good);
    prune(Upkeep::for_good, 0);
}

template <int Dim>
void Neighborhood<Dim>::search(Upkeep upkeep) {
    double skin = 0;
    switch (upkeep) {
        case Upkeep::with_fluid:
            skin = fluid_skin_.skin();
            break;
        case Upkeep::with_solid:
            skin = solid_skin_.skin();
            break;
        case Upkeep::coupling:
        case Upkeep::for_good:
            break;
    }
    for (Pairing& pairing : pairings_) {
        const PairingKey& key = pairing.key;
        if (key.upkeep != upkeep || pairing.derived) continue;
        Grids& of = grids_of(key.target, key.range);
        std::vector<const Grid*> targets;
        if (key.targets != Targets::ghosts) targets.push_back(&of.own);
        if (key.targets != Targets::own && key.range.empty()) targets.push_back(&of.ghosts);
        search_.build(grids_of(key.query, key.range).own, targets, cut_off(key.reach, skin), pairing.list);
        if (pairing.searched) pairing.searched();
    }
}

template <int Dim>
void Neighborhood<Dim>::prune(Upkeep upkeep, double skin) {
    for (Pairing& pairing : pairings_)
        if (pairing.key.upkeep == upkeep)
            search_.prune(places_of(pairing.key.query), places_of(pairing.key.target), cut_off(pairing.key.reach, skin),
                          pairing.list);
}

template <int Dim>
void Neighborhood<Dim>::prune_for_good(Pairing& pairing) {
    search_.prune(places_of(pairing.key.query), places_of(pairing.key.target), cut_off(pairing.key.reach, 0),
                  pairing.list);
}

template <int Dim>
void Neighborhood<Dim>::build_coupling() {
    for (const Placing& placing : placing_) {
        placing.place();
        grid_copies(placing.set);
    }
    for (Pairing& pairing : pairings_)
        if (pairing.key.upkeep == Upkeep::coupling) search_coupling(pairing);
    coupling_skin_.was_built();
}

/// Builds the grids of particles that a coupling places, or that have moved since they were sorted, and of their
/// ghosts.
template <int Dim>
void Neighborhood<Dim>::grid_copies(SetId id) {
    ParticleSet<Dim>& set = state_[id];
    // Elements have no smoothing length of their own.
    const bool reaches = id != SetId::elements;
    grids_of(id).own.build(set.position, 0, set.owned, cell_of(id),
                           reaches ? std::span<const double>(set.smoothing_length) : std::span<const double>());
    if (id != SetId::solid) make_ghosts(id, coupling_skin_.skin());
}

template <int Dim>
void Neighborhood<Dim>::search_coupling(Pairing& pairing) {
    const PairingKey& key = pairing.key;
    if (key.targets == Targets::ghosts && !has_ghosts()) return;
    Grids& of = grids_of(key.target);
    const std::array<const Grid*, 1> targets{key.targets == Targets::ghosts ? &of.ghosts : &of.own};
    const CutOff cut = cut_off(key.reach, coupling_skin_.skin());
    CutOff wide = cut;
    wide.skin += fluid_skin_.motion() + solid_skin_.motion();  // the grids are as old as the particles' lists
    search_.build(grids_of(key.query).own, targets, wide, pairing.list);
    search_.prune(places_of(key.query), places_of(key.target), cut, pairing.list);
}

/// Between builds particles may be outside, as that is where their lists have them.
template <int Dim>
void Neighborhood<Dim>::wrap_fluid() {
    auto& fluid = state_.fluid;
    for (const GhostPlane<Dim>& plane : state_.ghost_planes) {
        if (plane.is_mirror()) continue;
        parallel_for(fluid.owned, [&](std::size_t i) {
            const Vec<Dim> x = fluid.position[i];
            if (plane.distance(x) < 0) fluid.position.set(i, plane.image_position(x));
        });
    }
}

/// The same for particles of walls that have moved along.
template <int Dim>
void Neighborhood<Dim>::wrap_walls() {
    auto& wall = state_.wall;
    for (const GhostPlane<Dim>& plane : state_.ghost_planes) {
        if (plane.is_mirror()) continue;
        const Vec<Dim> shift = plane.shift * plane.normal;
        parallel_for(wall.owned, [&](std::size_t i) {
            if (plane.distance(wall.position[i]) >= 0) return;
            wall.position.set(i, wall.position[i] + shift);
            wall.initial_position.set(i, wall.initial_position[i] + shift);
        });
    }
}

/// A particle at distance s from the plane has its ghost at −s; the nearest particle that can feel it is on the plane.
template <int Dim>
void Neighborhood<Dim>::make_ghosts(SetId id, double skin) {
    if (!has_ghosts()) return;
    ParticleSet<Dim>& set = state_[id];
    Grid& grid = grids_of(id).ghosts;
    const bool reaches = id != SetId::elements;
    const double own = reaches ? half_support() : 0, of_others = reaches ? half_support() : support_;
    const double farthest = of_others * state_.max_h + skin;
    set.ghosts.create(state_.ghost_planes, set.position, set.owned,
                      [&](std::size_t i) { return own * set.smoothing_length[i] + farthest; });
    set.ghosts.template extend<Mirror::same>(set.smoothing_length, set.owned);
    grid.build(set.position, set.owned, set.size(), cell_of(id),
               reaches ? std::span<const double>(set.smoothing_length) : std::span<const double>());
    set.ghosts.reorder(grid.order(), set.owned);
    grid.particles_were_sorted(set.owned);
    set.extend_ghosts();
}

template <int Dim>
std::size_t Neighborhood<Dim>::bytes() const {
    std::size_t sum = 0;
    for (const Pairing& pairing : pairings_) sum += pairing.list.bytes();
    for (const Grids& grids : grids_) sum += grids.own.bytes() + grids.ghosts.bytes();
    for (const SetId set : all_sets) sum += state_[set].ghosts.bytes();
    return sum;
}

template class Neighborhood<2>;
template class Neighborhood<3>;

}  // namespace sluice
