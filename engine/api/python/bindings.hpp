// The parts of the Python module.
#pragma once

#include <pybind11/pybind11.h>

namespace sluice::python {

void bind_simulation(pybind11::module_& module);

}  // namespace sluice::python
