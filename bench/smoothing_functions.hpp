// The smoothing functions that are measured. A new one takes a line here.
#pragma once

#include "kernels/smoothing.hpp"

/// row(name, class) for each.
#define SLUICE_SMOOTHING_FUNCTIONS(row) row("cubic_spline", CubicSpline<3>)
