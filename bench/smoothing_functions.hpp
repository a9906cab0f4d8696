// The smoothing functions that are measured. A new one takes a line here.
#pragma once

#include "kernels/smoothing.hpp"

/// row(name, class) for each.
#define SLUICE_SMOOTHING_FUNCTIONS(row)                                                                     \
    row("cubic_spline", CubicSpline<3>) row("wendland_c2", WendlandC2<3>) row("wendland_c4", WendlandC4<3>) \
        row("quintic_spline", QuinticSpline<3>)
