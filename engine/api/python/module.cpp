// The compiled part of the Python module: scenes, runs, errors.
#include <pybind11/stl.h>

#include "engine/api/include/sluice/sluice.hpp"
#include "engine/api/python/bindings.hpp"

namespace py = pybind11;
using namespace pybind11::literals;

namespace sluice::python {
namespace {

void bind_errors(py::module_& m) {
    const auto error = py::exception<std::runtime_error>(m, "Error");
    py::register_exception<SceneError>(m, "SceneError", error);
    py::register_exception<NumericalError>(m, "NumericalError", error);
    py::register_exception<OutputError>(m, "OutputError", error);
    py::register_exception<CheckpointError>(m, "CheckpointError", error);
}

void bind_scene(py::module_& m) {
    using api::Scene;
    const auto representation = [](const Scene& s) { return "<sluice.Scene \"" + s.title() + "\">"; };
    py::class_<Scene>(m, "Scene", "A scene, read and checked.")
        .def_static("from_file", &Scene::from_file, "path"_a, "set"_a = std::vector<std::string>{},
                    "Reads a scene file; `set` holds changes as with --set: [\"method.spacing=0.01\"].")
        .def_static("from_text", &Scene::from_text, "text"_a, "set"_a = std::vector<std::string>{}, "name"_a = "scene",
                    "Reads a scene's text; files that it names are sought beside `name`.")
        .def_property_readonly("title", &Scene::title)
        .def_property_readonly("dimension", &Scene::dimension)
        .def_property_readonly("end_time", &Scene::end_time, "To which a run goes [s].")
        .def_property_readonly("text", &Scene::text, "Canonical TOML, with the changes applied.")
        .def_property_readonly("bodies", &Scene::bodies, "Names; `body` of fluid and solid particles counts them.")
        .def_property_readonly("walls", &Scene::walls, "Names; `body` of wall particles counts them.")
        .def("__repr__", representation);
}

/// The engine notes Ctrl-C for itself while it runs; Python hears of it afterwards.
void finish(const api::RunResult& result) {
    if (result.end == api::RunEnd::failed) throw NumericalError(result.message);
    if (result.end != api::RunEnd::interrupted) return;
    PyErr_SetString(PyExc_KeyboardInterrupt, "the run was stopped; resume goes on with it");
    throw py::error_already_set();
}

api::RunOptions options(std::optional<double> until, int threads, bool progress) {
    return {threads, until, progress ? api::Progress::shown : api::Progress::silent};
}

void bind_run(py::module_& m) {
    m.def(
        "run",
        [](const api::Scene& scene, const std::string& directory, std::optional<double> until, int threads,
           bool progress) {
            api::RunResult result;
            {
                const py::gil_scoped_release released;
                result = api::run(scene, directory, options(until, threads, progress));
            }
            finish(result);
            return result.report;
        },
        "scene"_a, "directory"_a, "until"_a, "threads"_a, "progress"_a);
    m.def(
        "resume",
        [](const std::string& directory, std::optional<double> until, int threads, bool progress) {
            api::RunResult result;
            {
                const py::gil_scoped_release released;
                result = api::resume(directory, options(until, threads, progress));
            }
            finish(result);
            return result.report;
        },
        "directory"_a, "until"_a, "threads"_a, "progress"_a);
}

}  // namespace
}  // namespace sluice::python

PYBIND11_MODULE(_sluice, m) {
    m.attr("__version__") = sluice::api::version();
    sluice::python::bind_errors(m);
    sluice::python::bind_scene(m);
    sluice::python::bind_simulation(m);
    sluice::python::bind_run(m);
}
