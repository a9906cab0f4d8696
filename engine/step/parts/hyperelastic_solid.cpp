#include "engine/step/parts/hyperelastic_solid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/step/balances.hpp"
#include "engine/step/coupling.hpp"
#include "engine/step/parts/largest_eigenvalue.hpp"
#include "engine/step/parts/resting.hpp"
#include "engine/step/parts/solid_motion.hpp"

namespace sluice {
namespace {

/// Up to this α the usual Courant number leaves enough room for what viscosity takes from the step.
constexpr double modest_viscosity = 0.1;

/// How much shorter the step of a total-Lagrangian solid must be with artificial viscosity α, whose forces lag by half
/// a step: √(1 + ζ²) − ζ of the undamped limit [Belytschko, Liu & Moran 2000, section 6.2.9], ζ the damping ratio of
/// the fastest mode. ζ = α/6 bounds what was measured on a bent, shaken block (h = 1.5 d): stable up to a Courant
/// number of 0.95, 0.9, 0.85, 0.75, 0.5 with α = 0, 0.5, 1, 2, 4. Beside a clamp that cuts cells it is up to four times
/// as large as inside; hence half of the fastest damping, as pairs that part are not damped. (A polygon with a clamp,
/// α = 1: stable up to 0.5 without that.)
double damped_step_ratio(double artificial_viscosity, double fastest_mode, double fastest_damping) {
    const double ratio = std::max(artificial_viscosity / 6, 0.5 * fastest_damping / (2 * fastest_mode));
    return std::sqrt(1 + ratio * ratio) - ratio;
}

/// Bodies in contact are stiffer where they touch than the fastest mode of the bodies alone. Colliding rings run up to
/// 0.85 of its limit and break down at 0.9.
constexpr double contact_step_ratio = 0.85;

}  // namespace

template <int Dim>
HyperelasticSolid<Dim>::HyperelasticSolid(StepContext<Dim>& context)
    : c_(context),
      all_(context.neighbors.pair(
          {SetId::solid, SetId::solid, Upkeep::for_good, Targets::own, Reach::mean, context.state.hyperelastic})) {
    const MaterialConstants& material = c_.state.solid_materials.front();
    const double alpha = c_.has(Effect::solid_viscosity) ? c_.scene.method.solid.artificial_viscosity : 0.0;
    viscosity_ = {alpha, material.eos.sound_speed, material.eos.density, c_.has(Effect::several_solids)};
    laws_ =
        c_.state.solid_materials.by_body(c_.scene.bodies.size(), [](const MaterialConstants& of) { return of.law; });
    if (c_.has(Effect::clamp)) moving_ = &c_.neighbors.derive(all_, "moving");
}

template <int Dim>
void HyperelasticSolid<Dim>::start() {
    auto& solid = c_.state.solid;
    const double control = c_.has(Effect::hourglass_control) ? c_.scene.method.solid.hourglass_control : 0.0;
    std::vector<double> stiffness;  // one, or one per body, as laws_
    for (const Hyperelastic& law : laws_) stiffness.push_back(control * 2 * law.mu);
    elastic_correction<Dim>(view_of(solid), all_.list, stiffness, c_.method, solid.gradient_correction,
                            solid.hourglass_stiffness);
    if (c_.has(Effect::clamp_extension)) {
        const double h = *std::max_element(solid.smoothing_length.begin(), solid.smoothing_length.end());
        behind_clamp_ = {c_.scene, solid, all_.list, c_.method.smoothing.support * h};
        behind_clamp_.share_energy(solid);
    }
    elastic_forces({});
    if (moving_) {
        leave_out_resting<Dim>(solid, behind_clamp_.rigid(), behind_clamp_.extended(), all_.list, moving_->list);
        c_.neighbors.prune_for_good(all_);  // positions are those of the reference configuration still
        c_.neighbors.prune_for_good(*moving_);
    }
    fastest_mode_ = find_fastest_mode();
    if (viscosity_.artificial_viscosity > modest_viscosity) fastest_damping_ = find_fastest_damping();
    update_stress();
    update_density();
}

template <int Dim>
void HyperelasticSolid<Dim>::limit_step(std::vector<CourantLimit>& limits) const {
    const auto& solid = c_.state.solid;
    for (const MaterialConstants& material : c_.state.solid_materials) {
        double h = std::numeric_limits<double>::infinity();
        for (std::size_t i = part().first; i < part().last; ++i)
            if (c_.state.solid_materials.of_body(solid.body[i]).number == material.number)
                h = std::min(h, solid.smoothing_length[i]);
        if (!std::isfinite(h)) continue;  // of solids of another model
        // Nothing damps the fastest waves, as viscosity does in the hypoelastic solid.
        const double fastest = std::sqrt(material.law.wave_modulus() / material.eos.density);
        const double dt = fastest_mode_ > 0 ? stable_step() : 1.0 * c_.scene.method.courant * h / fastest;
        limits.push_back({SetId::solid, c_.scene.materials[material.number].name, dt, h, fastest, 0});
    }
}

template <int Dim>
double HyperelasticSolid<Dim>::stable_step() const {
    double dt = c_.scene.method.courant * 2 / fastest_mode_;
    if (c_.has(Effect::contact)) dt *= contact_step_ratio;
    if (c_.has(Effect::solid_viscosity))
        dt *= damped_step_ratio(c_.scene.method.solid.artificial_viscosity, fastest_mode_, fastest_damping_);
    return dt;
}

template <int Dim>
void HyperelasticSolid<Dim>::begin_step() {
    follow_steady_load(c_, part());
    push(0.5 * c_.plan.dt);
    begin_solid_motion(c_, part());
}

template <int Dim>
void HyperelasticSolid<Dim>::end_step() {
    if (moving().size() > 0) update_density();
    end_solid_motion(c_, part(), FluidPush::before_and_after);
}

template <int Dim>
void HyperelasticSolid<Dim>::last_kick() {
    push(0.5 * c_.plan.dt);
}

template <int Dim>
double HyperelasticSolid<Dim>::move(int) {
    if (moving().size() == 0) return 0;
    kick();
    const double moved = drift();
    for (const auto& coupling : c_.couplings) coupling->solid_has_moved(moved);
    return moved;
}

template <int Dim>
void HyperelasticSolid<Dim>::finish_move() {
    if (moving().size() == 0) return;
    update_stress();
    kick();
}

template <int Dim>
void HyperelasticSolid<Dim>::kick() {
    const auto scope = c_.timer.measure(StepPhase::update);
    auto& solid = c_.state.solid;
    const Vec<Dim> gravity = c_.state.gravity;
    const double half = 0.5 * dt();
    const bool loaded = bears_steady_load(c_);
    parallel_for(part(), [&](std::size_t i) {
        if (solid.clamped[i]) return;
        Vec<Dim> acceleration = solid.acceleration[i] + gravity;
        if (loaded) acceleration += solid.steady_acceleration[i];
        solid.velocity.set(i, solid.velocity[i] + half * acceleration);
    });
}

template <int Dim>
void HyperelasticSolid<Dim>::push(double interval) {
    if (!is_coupled(c_)) return;
    const auto scope = c_.timer.measure(StepPhase::update);
    auto& solid = c_.state.solid;
    const bool loaded = bears_steady_load(c_);
    parallel_for(part(), [&](std::size_t i) {
        if (solid.clamped[i]) return;
        Vec<Dim> impulse = solid.interface_acceleration[i];
        if (loaded) impulse -= solid.steady_acceleration[i];
        solid.velocity.set(i, solid.velocity[i] + interval * impulse);
    });
}

template <int Dim>
double HyperelasticSolid<Dim>::drift() {
    const auto scope = c_.timer.measure(StepPhase::update);
    auto& solid = c_.state.solid;
    const double step = dt();
    return step * std::sqrt(nonnegative_max(part(), [&](std::size_t i) {
               const Vec<Dim> v = solid.velocity[i];
               solid.position.set(i, solid.position[i] + step * v);
               return norm2(v);
           }));
}

template <int Dim>
void HyperelasticSolid<Dim>::update_stress() {
    c_.pairs += elastic_forces(viscosity_);
    for (const auto& coupling : c_.couplings) coupling->push_solid(part());
}

template <int Dim>
std::uint64_t HyperelasticSolid<Dim>::elastic_forces(const ElasticViscosity& viscosity) {
    auto& solid = c_.state.solid;
    const auto view = view_of(solid);
    behind_clamp_.displace(solid);
    std::uint64_t pairs = 0;
    {
        const auto scope = c_.timer.measure(StepPhase::gradient_pass);
        pairs += elastic_deformation<Dim>(view, all_.list, laws_, c_.method, solid.deformation, solid.corrected_stress);
    }
    const auto scope = c_.timer.measure(StepPhase::solid_pass);
    parallel_for(part(), [&](std::size_t i) { solid.acceleration.set(i, {}); });
    pairs += elastic_momentum<Dim>(view, moving(), viscosity, c_.method, solid.acceleration);
    behind_clamp_.hand_over(solid);
    return pairs;
}

template <int Dim>
double HyperelasticSolid<Dim>::find_fastest_mode() {
    auto& solid = c_.state.solid;
    const std::size_t n = part().size(), first = part().first;
    // Displacements of 1e-6 h in the mean: linear in six digits, and far above the rounding of positions.
    const double mass = ordered_sum<double>(part(), [&](std::size_t i) { return solid.mass[i]; });
    const double amplitude = 1e-6 * solid.smoothing_length[0] * std::sqrt(mass);
    const PhaseTimer timer = c_.timer;
    const VectorField<Dim> start = solid.position;
    const double fastest = largest_eigenvalue(Dim * n, [&](std::span<const double> x, std::span<double> y) {
        // Masses on both sides, so that the operator is symmetric: y = √m a(x/√m).
        parallel_for(n, [&](std::size_t n_th) {
            const std::size_t i = first + n_th;
            Vec<Dim> u;
            for (int k = 0; k < Dim; ++k) u[k] = solid.clamped[i] ? 0.0 : x[Dim * n_th + static_cast<std::size_t>(k)];
            solid.position.set(i, start[i] + (amplitude / std::sqrt(solid.mass[i])) * u);
        });
        elastic_forces({});
        parallel_for(n, [&](std::size_t n_th) {
            const std::size_t i = first + n_th;
            const double scale = solid.clamped[i] ? 0.0 : -std::sqrt(solid.mass[i]) / amplitude;
            for (int k = 0; k < Dim; ++k)
                y[Dim * n_th + static_cast<std::size_t>(k)] = scale * solid.acceleration[i][k];
        });
    });
    solid.position = start;
    c_.timer = timer;
    return std::sqrt(fastest);
}

template <int Dim>
double HyperelasticSolid<Dim>::find_fastest_damping() {
    auto& solid = c_.state.solid;
    const std::size_t n = part().size(), first = part().first;
    const PhaseTimer timer = c_.timer;
    const VectorField<Dim> start = solid.velocity;
    // Pairs that approach for v, and those that approach for −v; what is elastic cancels.
    const auto decelerate = [&](std::span<const double> x, std::span<double> y, double sign) {
        parallel_for(n, [&](std::size_t n_th) {
            const std::size_t i = first + n_th;
            const double scale = solid.clamped[i] ? 0.0 : sign / std::sqrt(solid.mass[i]);
            Vec<Dim> v;
            for (int k = 0; k < Dim; ++k) v[k] = scale * x[Dim * n_th + static_cast<std::size_t>(k)];
            solid.velocity.set(i, v);
        });
        elastic_forces(viscosity_);
        parallel_for(n, [&](std::size_t n_th) {
            const std::size_t i = first + n_th;
            const double scale = solid.clamped[i] ? 0.0 : -sign * std::sqrt(solid.mass[i]);
            for (int k = 0; k < Dim; ++k)
                y[Dim * n_th + static_cast<std::size_t>(k)] += scale * solid.acceleration[i][k];
        });
    };
    const double fastest = largest_eigenvalue(Dim * n, [&](std::span<const double> x, std::span<double> y) {
        std::fill(y.begin(), y.end(), 0.0);
        decelerate(x, y, 1);
        decelerate(x, y, -1);
    });
    solid.velocity = start;
    c_.timer = timer;
    return fastest;
}

template <int Dim>
void HyperelasticSolid<Dim>::update_density() {
    const auto scope = c_.timer.measure(StepPhase::update);
    auto& solid = c_.state.solid;
    parallel_for(part(), [&](std::size_t i) {
        const double j = tensor_of<Dim>(solid.deformation[i]).determinant();
        solid.density[i] = solid.mass[i] / (solid.volume[i] * std::max(j, Hyperelastic::expansion_volume));
    });
}

template <int Dim>
double HyperelasticSolid<Dim>::hourglass_energy() const {
    if (!c_.has(Effect::hourglass_control)) return 0;
    auto& solid = c_.state.solid;
    ScalarField energy(solid.owned);
    behind_clamp_.displace(solid);
    sluice::hourglass_energy<Dim>(view_of(solid), all_.list, c_.method, energy);
    behind_clamp_.put_back(solid);
    return ordered_sum<double>(part(), [&](std::size_t i) { return energy[i]; });
}

template <int Dim>
void HyperelasticSolid<Dim>::add_energy(EnergyBalance& e) const {
    const auto& solid = c_.state.solid;
    add_motion(solid, part(), c_.state.gravity, e);
    e.elastic += with_materials(c_.state.solid_materials, solid.body, [&](const auto& material) {
        return ordered_sum<double>(part(), [&](std::size_t i) {
            const double share = solid.elastic_share.size() > 0 ? solid.elastic_share[i] : 1.0;
            return share * solid.volume[i] *
                   material(i).law.template energy_density<Dim>(tensor_of<Dim>(solid.deformation[i]));
        });
    });
    e.elastic += hourglass_energy();
}

template <int Dim>
Vec<Dim> HyperelasticSolid<Dim>::momentum() const {
    return momentum_of(c_.state.solid, part());
}

template class HyperelasticSolid<2>;
template class HyperelasticSolid<3>;

}  // namespace sluice
