#include "engine/api/include/sluice/simulation.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "engine/api/field_table.hpp"
#include "engine/run/output/frame_table.hpp"
#include "engine/run/output/probes.hpp"
#include "engine/run/watch/watch.hpp"
#include "engine/scene/scene.hpp"
#include "engine/scene/table/suggestion.hpp"
#include "engine/simulation/simulation.hpp"

namespace sluice::api {
namespace {

/// As in a run.
constexpr std::uint64_t steps_per_look = 50;

constexpr std::string_view name_of(Medium medium) {
    switch (medium) {
        case Medium::fluid:
            return "fluid";
        case Medium::solid:
            return "solid";
        case Medium::wall:
            return "walls";
    }
    return {};
}

/// Whose memory a column is: at first the simulation's, later its holders'.
struct Hold {
    std::shared_ptr<const void> memory;
};

}  // namespace

/// What both dimensions have in common.
struct Simulation::Impl {
    Impl(const Scene& s, int n) : scene(s), threads(n) {}
    virtual ~Impl() = default;
    virtual void step() = 0;
    virtual void check() = 0;

    virtual double time() const = 0;
    virtual double time_step() const = 0;
    virtual std::uint64_t steps() const = 0;
    virtual Energy energy() const = 0;
    virtual std::array<double, 3> momentum() const = 0;
    virtual std::vector<std::string> probe_names() const = 0;
    virtual std::vector<double> probe_values() const = 0;
    virtual std::vector<std::string> warnings() const = 0;
    virtual std::size_t memory_bytes() const = 0;
    virtual std::size_t particles(Medium medium) const = 0;
    virtual std::vector<FieldInfo> fields(Medium medium) const = 0;
    virtual std::vector<RawColumn> columns(Medium medium, std::string_view field) const = 0;
    virtual Frame frame() const = 0;
    virtual std::shared_ptr<const void> part_with(const void* column) = 0;

    void use_threads() const {
        if (threads > 0) omp_set_num_threads(threads);
    }

    /// Before the particles change: columns that callers still hold become theirs; the simulation continues on copies.
    void let_go() {
        for (const auto& [data, weak] : holds)
            if (const auto hold = weak.lock()) hold->memory = part_with(data);
        holds.clear();
    }

    Scene scene;
    int threads;
    std::map<const void*, std::weak_ptr<Hold>> holds;  ///< of the columns that were handed out since the last step
};

template <int Dim>
struct Simulation::ImplOf : Simulation::Impl {
    ImplOf(const Scene& s, int n) : Impl(s, n), simulation(s.checked()), watch(simulation), probes(simulation) {}

    void step() override {
        simulation.step();
        if (simulation.work().steps % steps_per_look == 0) watch.look(simulation);
    }
    void check() override { watch.check(simulation); }

    double time() const override { return simulation.time(); }
    double time_step() const override { return simulation.time_step(); }
    std::uint64_t steps() const override { return simulation.work().steps; }
    Energy energy() const override {
        const EnergyBalance e = simulation.energy();
        return {e.kinetic, e.potential, e.compression, e.elastic, e.contact};
    }
    std::array<double, 3> momentum() const override {
        std::array<double, 3> sum{};
        const Vec<Dim> p = simulation.momentum();
        std::copy(p.c.begin(), p.c.end(), sum.begin());
        return sum;
    }
    std::vector<std::string> probe_names() const override { return probes.columns(); }
    std::vector<double> probe_values() const override { return probes.sample(simulation); }
    std::vector<std::string> warnings() const override {
        std::vector<std::string> texts;
        for (const Warning& warning : watch.warnings()) texts.push_back(warning.message);
        return texts;
    }
    std::size_t memory_bytes() const override { return simulation.memory_bytes(); }
    std::size_t particles(Medium medium) const override {
        switch (medium) {
            case Medium::fluid:
                return simulation.fluid().owned;
            case Medium::solid:
                return simulation.solid().owned;
            case Medium::wall:
                return simulation.wall().owned;
        }
        return 0;
    }
    std::vector<FieldInfo> fields(Medium medium) const override { return fields_of(simulation, medium); }
    std::vector<RawColumn> columns(Medium medium, std::string_view field) const override {
        return columns_of(simulation, medium, field);
    }
    Frame frame() const override {
        FrameTable table = frame_table(simulation.fluid(), simulation.solid(), simulation.wall(),
                                       simulation.solid_materials(), simulation.hyperelastic());
        Frame frame{std::move(table.points), std::move(table.velocity), {},
                    std::move(table.medium), std::move(table.body),     std::move(table.id)};
        for (FrameScalar& scalar : table.scalars) frame.scalars.push_back({scalar.name, std::move(scalar.value)});
        return frame;
    }
    std::shared_ptr<const void> part_with(const void* column) override { return simulation.part_with(column); }

    sluice::Simulation<Dim> simulation;
    Watch<Dim> watch;
    Probes<Dim> probes;
};

Simulation::Simulation(const Scene& scene, int threads) {
    if (threads > 0) omp_set_num_threads(threads);
    if (scene.dimension() == 2)
        impl_ = std::make_shared<ImplOf<2>>(scene, threads);
    else
        impl_ = std::make_shared<ImplOf<3>>(scene, threads);
}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::advance(std::uint64_t steps, const GoOn& go_on) {
    impl_->use_threads();
    for (std::uint64_t k = 0; k < steps; ++k) {
        impl_->let_go();
        impl_->step();
        if (go_on && !go_on()) break;
    }
    impl_->check();
}

void Simulation::advance_to(double time, const GoOn& go_on) {
    if (!std::isfinite(time))
        throw std::invalid_argument(fmt::format("advance_to: found {}, expected a time [s]", time));
    impl_->use_threads();
    while (impl_->time() < time - impl_->time_step() / 2) {
        impl_->let_go();
        impl_->step();
        if (go_on && !go_on()) break;
    }
    impl_->check();
}

std::vector<std::string> Simulation::warnings() const { return impl_->warnings(); }
const Scene& Simulation::scene() const { return impl_->scene; }
double Simulation::time() const { return impl_->time(); }
double Simulation::time_step() const { return impl_->time_step(); }
std::uint64_t Simulation::steps() const { return impl_->steps(); }
Energy Simulation::energy() const { return impl_->energy(); }
std::array<double, 3> Simulation::momentum() const { return impl_->momentum(); }
std::vector<std::string> Simulation::probe_names() const { return impl_->probe_names(); }
std::vector<double> Simulation::probe_values() const { return impl_->probe_values(); }
std::size_t Simulation::memory_bytes() const { return impl_->memory_bytes(); }
std::size_t Simulation::particles(Medium medium) const { return impl_->particles(medium); }
Frame Simulation::frame() const { return impl_->frame(); }

std::vector<std::string> Simulation::fields(Medium medium) const {
    std::vector<std::string> names;
    for (const FieldInfo& info : impl_->fields(medium)) names.emplace_back(info.name);
    return names;
}

Field Simulation::field(Medium medium, const std::string& name) const {
    for (const FieldInfo& info : impl_->fields(medium)) {
        if (info.name != name) continue;
        Field field{name, std::string(info.unit), {}};
        for (const RawColumn& raw : impl_->columns(medium, name)) {
            std::weak_ptr<Hold>& known = impl_->holds[raw.data];
            std::shared_ptr<Hold> hold = known.lock();
            if (!hold) known = hold = std::make_shared<Hold>(Hold{impl_});
            field.columns.emplace_back(raw.type, std::move(hold), raw.data, raw.size);
        }
        return field;
    }
    const std::vector<std::string> names = fields(medium);
    if (names.empty()) throw std::out_of_range(fmt::format("{}: this scene has no such particles", name_of(medium)));
    throw std::out_of_range(fmt::format("{}: found the field \"{}\", expected {}{}", name_of(medium), name,
                                        one_of(names), did_you_mean(name, names)));
}

}  // namespace sluice::api
