"""How soft a plate of n layers of particles is in bending, before any run: a plate of no end under a constant moment.

A particle's deformation gradient is the best linear fit to its neighbours' places (kernels/passes/total_lagrangian_passes.hpp).
In bending, u_x = -curvature * x * y, the fit gives du_x/dx = -curvature * y_mean, where
  y_mean = sum_b w_ab X_ab^2 y_b / sum_b w_ab X_ab^2
is the height of the particle's neighbours: its own inside, nearer to the middle in the layers within a support of the
surface, where the neighbours lie on one side. So these layers carry less stress than they should. They are a support
thick, and y_mean is wrong by a part of h there: the stiffness is short by a part of second order in h/H.

On the other hand the hourglass control resists what is not linear, and so it resists bending, again by (h/H)^2.
"""
import numpy as np


def _cubic_spline(q):
    """-W'(q)/q over a constant"""
    outer, inner = np.maximum(1 - q / 2, 0), np.maximum(1 - q, 0)
    return (outer ** 2 - inner ** 2) / q


def _wendland_c2(q):
    return np.maximum(1 - q / 2, 0) ** 3


WEIGHT = {"cubic-spline": _cubic_spline, "wendland-c2": _wendland_c2}


def bending_ratio(layers, smoothing_function, smoothing_length, poisson, hourglass=0.85):
    """Bending stiffness over E'I; smoothing_length in spacings, hourglass = zeta in units of 2 mu.

    The least energy per column, for curvature 1, over the displacements v of the layers along y:
      u_x = -x y,  u_y = x^2/2 + v(y)
    A quadratic form in v: a least-squares problem with a row per stress and one per neighbour.
    """
    weight_of = WEIGHT[smoothing_function]
    reach = int(np.ceil(2 * smoothing_length))
    lattice = [(i, j) for i in range(-reach, reach + 1) for j in range(-reach, reach + 1) if (i, j) != (0, 0)]
    # Weights such that the inner particles have M = 1, as the smoothing functions' own do to a percent.
    scale = sum(weight_of(np.hypot(i, j) / smoothing_length) * i * i for i, j in lattice)
    young = 1.0
    mu, lam = young / (2 * (1 + poisson)), young * poisson / ((1 + poisson) * (1 - 2 * poisson))
    height = np.arange(layers) - (layers - 1) / 2
    rows, right = [], []

    def add(square_root_of_weight, row, constant):
        rows.append(square_root_of_weight * row)
        right.append(-square_root_of_weight * constant)

    for a in range(layers):
        near = [(i, a + j, weight_of(np.hypot(i, j) / smoothing_length) / scale) for i, j in lattice if 0 <= a + j < layers]
        xx = sum(w * i * i for i, b, w in near)
        yy = sum(w * (b - a) ** 2 for i, b, w in near)
        strain_x = -sum(w * i * i * height[b] for i, b, w in near) / xx
        strain_y, fixed_y = np.zeros(layers), 0.0  # of v, and of x^2/2
        for i, b, w in near:
            g = w * (b - a) / yy
            strain_y[b] += g
            strain_y[a] -= g
            fixed_y += g * i * i / 2
        # mu (e_x^2 + e_y^2) + lambda/2 (e_x + e_y)^2
        add(np.sqrt(mu), np.zeros(layers), strain_x)
        add(np.sqrt(mu), strain_y, fixed_y)
        add(np.sqrt(lam / 2), strain_y, strain_x + fixed_y)
        for i, b, w in near:  # zeta mu w |u_ab - F X_ab|^2
            stiff = np.sqrt(max(hourglass, 0) * mu * w)
            add(stiff, np.zeros(layers), -i * height[b] - strain_x * i)
            beyond = -strain_y * (b - a)
            beyond[b] += 1
            beyond[a] -= 1
            add(stiff, beyond, i * i / 2 - fixed_y * (b - a))
    matrix, right = np.array(rows), np.array(right)
    v = np.linalg.lstsq(matrix, right, rcond=None)[0]
    energy = np.sum((matrix @ v - right) ** 2)
    return 2 * energy / (young / (1 - poisson ** 2) * layers ** 3 / 12)
