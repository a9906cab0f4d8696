// Simulations and their particles in Python.
#include "engine/api/include/sluice/simulation.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <chrono>

#include "engine/api/python/bindings.hpp"

namespace py = pybind11;
using namespace pybind11::literals;

namespace sluice::python {
namespace {

py::dtype dtype_of(api::ColumnType type) {
    switch (type) {
        case api::ColumnType::uint64:
            return py::dtype::of<std::uint64_t>();
        case api::ColumnType::uint16:
            return py::dtype::of<std::uint16_t>();
        case api::ColumnType::uint8:
            return py::dtype::of<std::uint8_t>();
        case api::ColumnType::float64:
            return py::dtype::of<double>();
    }
    throw std::logic_error("a column of particles has no type");
}

/// An array over memory that `owner` keeps alive.
template <class Owner>
py::array array_over(const py::dtype& type, std::vector<py::ssize_t> shape, const void* data, Owner owner) {
    const py::capsule keeper(new Owner(std::move(owner)), [](void* p) { delete static_cast<Owner*>(p); });
    return py::array(type, std::move(shape), {}, data, keeper);
}

py::array view_of(const api::Column& column) {
    py::array view =
        array_over(dtype_of(column.type()), {static_cast<py::ssize_t>(column.size())}, column.data(), column.memory());
    view.attr("setflags")("write"_a = false);
    return view;
}

/// A vector becomes an array without being copied.
template <class T>
py::array array_from(std::vector<T> values, std::vector<py::ssize_t> shape) {
    const auto kept = std::make_shared<std::vector<T>>(std::move(values));
    return array_over(py::dtype::of<T>(), std::move(shape), kept->data(), kept);
}

/// Signals are looked for between steps, but not so often that taking the interpreter's lock would be felt.
class SignalCheck {
  public:
    bool operator()() {
        const auto now = Clock::now();
        if (now - last_ < std::chrono::milliseconds(50)) return true;
        last_ = now;
        const py::gil_scoped_acquire locked;
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        return true;
    }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
};

/// A simulation that other Python threads may ask while one steps it: they are refused, not crashed.
class Simulation {
  public:
    Simulation(const api::Scene& scene, int threads) : simulation_(scene, threads) {}

    template <class Advance>
    void advance(Advance&& advance) {
        refuse_if_busy();
        busy_ = true;
        const struct Free {
            bool& busy;
            ~Free() { busy = false; }  // after the lock has been taken again
        } free{busy_};
        const py::gil_scoped_release released;
        advance(simulation_, api::GoOn(SignalCheck()));
    }
    const api::Simulation& at_rest() const {
        refuse_if_busy();
        return simulation_;
    }

  private:
    void refuse_if_busy() const {
        if (busy_) throw std::runtime_error("the simulation is being stepped by another thread");
    }
    api::Simulation simulation_;
    bool busy_ = false;  ///< written with the interpreter's lock held
};

/// What `simulation.fluid` is: fields by name.
struct Particles {
    std::shared_ptr<Simulation> simulation;
    api::Medium medium;

    std::vector<std::string> names() const { return simulation->at_rest().fields(medium); }
    bool has(const std::string& name) const {
        const std::vector<std::string> all = names();
        return std::find(all.begin(), all.end(), name) != all.end();
    }
    api::Field field(const std::string& name) const {
        try {
            return simulation->at_rest().field(medium, name);
        } catch (const std::out_of_range& error) {
            throw py::key_error(error.what());
        }
    }
    py::object views(const std::string& name) const {
        const api::Field found = field(name);
        if (found.columns.size() == 1) return view_of(found.columns[0]);
        py::tuple components(found.columns.size());
        for (std::size_t k = 0; k < found.columns.size(); ++k) components[k] = view_of(found.columns[k]);
        return components;
    }
};

py::dict to_dict(const api::Energy& e) {
    return py::dict("kinetic"_a = e.kinetic, "potential"_a = e.potential, "compression"_a = e.compression,
                    "elastic"_a = e.elastic, "contact"_a = e.contact, "total"_a = e.total());
}

py::dict to_dict(api::Frame frame) {
    const auto n = static_cast<py::ssize_t>(frame.id.size());
    py::dict dict("points"_a = array_from(std::move(frame.points), {n, 3}),
                  "velocity"_a = array_from(std::move(frame.velocity), {n, 3}),
                  "phase"_a = array_from(std::move(frame.phase), {n}),
                  "body"_a = array_from(std::move(frame.body), {n}), "id"_a = array_from(std::move(frame.id), {n}));
    for (auto& scalar : frame.scalars) dict[scalar.name.c_str()] = array_from(std::move(scalar.value), {n});
    return dict;
}

py::dict probes_of(const api::Simulation& simulation) {
    py::dict dict;
    const std::vector<std::string> names = simulation.probe_names();
    const std::vector<double> values = simulation.probe_values();
    for (std::size_t k = 0; k < names.size(); ++k) dict[names[k].c_str()] = values[k];
    return dict;
}

void bind_particles(py::module_& m) {
    py::class_<Particles>(m, "Particles", "The particles of one medium: a mapping from names of fields to arrays.")
        .def("__getitem__", &Particles::views, "name"_a,
             "A read-only array over the simulation's own memory; a tuple of arrays, one per component, for vectors "
             "and tensors. It keeps the values of this moment, also when the simulation steps on.")
        .def("__contains__", &Particles::has)
        .def("__iter__", [](const Particles& p) { return py::iter(py::cast(p.names())); })
        .def("__len__", [](const Particles& p) { return p.names().size(); })
        .def("keys", &Particles::names)
        .def(
            "unit", [](const Particles& p, const std::string& name) { return p.field(name).unit; }, "name"_a)
        .def_property_readonly(
            "count", [](const Particles& p) { return p.simulation->at_rest().particles(p.medium); },
            "Number of particles.");
}

/// A property that the simulation is asked for when it is not being stepped.
template <class Get>
auto asked(Get get) {
    return [get](const Simulation& s) { return get(s.at_rest()); };
}

}  // namespace

void bind_simulation(py::module_& m) {
    bind_particles(m);
    const auto particles = [](api::Medium medium) {
        return [medium](const std::shared_ptr<Simulation>& s) { return Particles{s, medium}; };
    };
    py::class_<Simulation, std::shared_ptr<Simulation>>(m, "Simulation", "A scene that is stepped through time.")
        .def(py::init<const api::Scene&, int>(), "scene"_a, "threads"_a = 0,
             "Places the particles; threads: 0 = as many as OpenMP offers.")
        .def(
            "step", [](Simulation& s, std::uint64_t n) { s.advance([n](auto& sim, auto go) { sim.advance(n, go); }); },
            "n"_a = 1, "Takes n steps. Ctrl-C ends it between two of them.")
        .def(
            "advance_to",
            [](Simulation& s, double t) { s.advance([t](auto& sim, auto go) { sim.advance_to(t, go); }); }, "time"_a,
            "Steps until this time is reached within half a step [s].")
        .def_property_readonly("fluid", particles(api::Medium::fluid))
        .def_property_readonly("solid", particles(api::Medium::solid))
        .def_property_readonly("wall", particles(api::Medium::wall))
        .def_property_readonly("scene", asked([](const api::Simulation& s) { return s.scene(); }))
        .def_property_readonly("time", asked([](const api::Simulation& s) { return s.time(); }), "[s]")
        .def_property_readonly("time_step", asked([](const api::Simulation& s) { return s.time_step(); }), "[s]")
        .def_property_readonly("steps", asked([](const api::Simulation& s) { return s.steps(); }))
        .def_property_readonly("energy", asked([](const api::Simulation& s) { return to_dict(s.energy()); }),
                               "By form [J; J/m in 2D].")
        .def_property_readonly("momentum", asked([](const api::Simulation& s) { return s.momentum(); }),
                               "Of all moving particles [kg m/s].")
        .def_property_readonly("probes", asked(probes_of), "Values of now, named as in probes.csv.")
        .def_property_readonly("warnings", asked([](const api::Simulation& s) { return s.warnings(); }),
                               "What has looked wrong so far.")
        .def("frame", asked([](const api::Simulation& s) { return to_dict(s.frame()); }),
             "A copy of what a frame written now would hold, fluid, solid and walls, each by rising id.");
}

}  // namespace sluice::python
