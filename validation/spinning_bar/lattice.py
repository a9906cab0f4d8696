"""The bar as the hypoelastic scheme's sums have it, at rest in the turning frame: linear, before any run.

Near a surface the plain sums of momentum (kernels/terms/symmetric_stress.hpp) and of density lack neighbours, only the
velocity gradient is corrected; and artificial stress takes tension away. So the bar is softer than its material by a part of
first order in h/H. With displacements u, v of the particles of a square lattice:
  G = Σ_j V (u_j − u_i) ⊗ ∇W,  L = G M⁻¹,  σ = K tr G I + 2μ (sym L − tr L/3 I)
  ρ a_i = Σ_j V (σ_i + σ_j − e f⁴ (τ_i + τ_j)) ∇W
where τ is the tension σ_xx along the bar.
"""
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Bar:
    half: float       # a = L/2 [m]
    height: float     # [m]
    density: float
    youngs: float     # nu = 0
    spin: float       # Ω [rad/s]

    @property
    def speed(self):
        return np.sqrt(self.youngs / self.density)


@dataclass(frozen=True)
class Found:
    """Over what linear theory has."""
    frequency: float
    stretch: float    # of the half at rest
    stress: float     # in the middle, at rest
    damping: float    # [1/s]


def softened(bar, across, smoothing_length, alpha, artificial_stress):
    """The preset's cubic spline and exponent 4. smoothing_length in spacings."""
    d = bar.height / across
    x, y = places(bar, d)
    h, volume, n = smoothing_length * d, d * d, len(x)
    dx, dy = x[:, None] - x, y[:, None] - y
    r = np.hypot(dx, dy)
    np.fill_diagonal(r, np.inf)
    slope = -30 / (7 * np.pi) * (np.maximum(1 - r / h / 2, 0) ** 2 - np.maximum(1 - r / h, 0) ** 2) / h ** 3
    per_length = volume * slope / r
    gx, gy = per_length * dx, per_length * dy
    plain_x, plain_y = differences(gx), differences(gy)
    moment = -np.array([[(dx * gx).sum(1), (dx * gy).sum(1)], [(dy * gx).sum(1), (dy * gy).sum(1)]])
    inverse = np.linalg.inv(moment.transpose(2, 0, 1))
    along = plain_x * inverse[:, 0, 0, None] + plain_y * inverse[:, 1, 0, None]
    up = plain_x * inverse[:, 0, 1, None] + plain_y * inverse[:, 1, 1, None]

    none, bulk, shear = np.zeros((n, n)), bar.youngs / 3, bar.youngs / 2
    of_density = bulk * np.hstack([plain_x, plain_y])
    xx, yy, xy = np.hstack([along, none]), np.hstack([none, up]), 0.5 * np.hstack([up, along])
    mean = (xx + yy) / 3
    stress_xx, stress_yy, stress_xy = of_density + 2 * shear * (xx - mean), of_density + 2 * shear * (yy - mean), 2 * shear * xy
    share = artificial_stress * (shape(r / h) / shape(1 / smoothing_length)) ** 4
    force = np.vstack([sums(gx) @ stress_xx + sums(gy) @ stress_xy - sums(share * gx) @ stress_xx,
                       sums(gx) @ stress_xy + sums(gy) @ stress_yy])
    stiffness = -force / bar.density

    k = np.pi / (2 * bar.half)
    exact, sine = (bar.speed * k) ** 2, np.sin(k * x)
    mode = np.concatenate([sine, np.zeros(n)])
    # The mode next to it; a bar that moves as a whole has no stiffness: a millionth is added for the state at rest.
    for _ in range(3):
        mode = np.linalg.solve(stiffness - 0.8 * exact * np.eye(2 * n), mode)
        mode /= np.linalg.norm(mode)
    rest = np.linalg.solve(stiffness + 1e-6 * exact * np.eye(2 * n), np.concatenate([bar.spin ** 2 * x, np.zeros(n)]))
    last, middle = x > bar.half - 0.6 * d, np.abs(x) < 0.1 * bar.half
    # Along the bar; half of it, because only approaching pairs feel artificial viscosity.
    viscous = differences(alpha * np.sqrt(bulk / bar.density) * h / (r ** 2 + 0.01 * h * h) * per_length * dx * dx)
    return Found(np.sqrt(mode @ stiffness @ mode / exact), rest[:n][last].mean() / stretch(bar, x[last][0]),
                 (stress_xx @ rest)[middle].mean() / middle_stress(bar), 0.25 * sine @ viscous @ sine / (sine @ sine))


def places(bar, d):
    x = np.arange(-bar.half + d / 2, bar.half, d)
    y = np.arange(-bar.height / 2 + d / 2, bar.height / 2, d)
    return (a.ravel() for a in np.meshgrid(x, y, indexing="ij"))


def shape(q):
    """Of the cubic spline, over a constant."""
    return np.maximum(2 - q, 0) ** 3 - 4 * np.maximum(1 - q, 0) ** 3


def differences(weight):
    """Σ_j w_ij (u_j − u_i) as a matrix."""
    return weight - np.diag(weight.sum(1))


def sums(weight):
    """Σ_j w_ij (s_j + s_i)"""
    return weight + np.diag(weight.sum(1))


def stretch(bar, x):
    """Displacement at rest, linear theory."""
    return (bar.spin / bar.speed) ** 2 / 2 * (bar.half ** 2 * x - x ** 3 / 3)


def middle_stress(bar):
    return 0.5 * bar.density * (bar.spin * bar.half) ** 2
