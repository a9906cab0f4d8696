"""How soft a plate of n layers of particles is in bending, before any run.

A particle's deformation gradient is the best linear fit to its neighbours' places (kernels/total_lagrangian_passes.hpp).
In bending, u_x = -curvature * x * y, the fit gives du_x/dx = -curvature * y_mean, where
  y_mean = sum_b w_ab X_ab^2 y_b / sum_b w_ab X_ab^2
is the height of the particle's neighbours: its own inside, lower in the layers within a support of the surface, where
the neighbours lie on one side. So these layers carry less stress than they should, and the stiffness is
  E' I_n = E' d sum_a y_mean_a^2   in place of   E' H^3/12.
The outer layers are a support 2h thick, y_mean is wrong by a part of h there: the error is of second order in h/H.
"""
import numpy as np


def _cubic_spline(q):
    """-W'(q)/q over a constant"""
    outer, inner = np.maximum(1 - q / 2, 0), np.maximum(1 - q, 0)
    return (outer ** 2 - inner ** 2) / q


def _wendland_c2(q):
    return np.maximum(1 - q / 2, 0) ** 3


WEIGHT = {"cubic-spline": _cubic_spline, "wendland-c2": _wendland_c2}


def bending_ratio(layers, smoothing_function, smoothing_length):
    """I_n/I; smoothing_length in spacings."""
    reach = int(np.ceil(2 * smoothing_length))
    along = np.arange(1, reach + 1)  # the column of the particle itself has X = 0, both sides are alike
    layer = np.arange(layers)
    up = layer[None, :] - layer[:, None]
    distance = np.sqrt(along[:, None, None] ** 2 + up[None] ** 2)
    weight = (WEIGHT[smoothing_function](distance / smoothing_length) * along[:, None, None] ** 2).sum(axis=0)
    y = (layer + 0.5) / layers - 0.5
    mean = weight @ y / weight.sum(axis=1)
    return 12 * (mean ** 2).sum() / layers
