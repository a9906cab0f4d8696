"""A plate clamped at one end, bending in its plane of strain: beam theories with E' = E/(1 - nu^2) in place of E.

Per metre of width. The shear factor is Reissner's 5/6, of a parabolic shear stress; the one of Timoshenko (1922) for
plane strain, 5(1 + nu')/(6 + 5 nu') with nu' = nu/(1 - nu), is 0.89 at nu = 0.4 and changes a period at L/H = 10 by
0.05 %.
"""
from dataclasses import dataclass

import numpy as np

CANTILEVER = 1.8751040687119611  # kL of the first mode: cos kL cosh kL = -1
SHEAR_FACTOR = 5 / 6


@dataclass(frozen=True)
class Plate:
    length: float   # [m]
    height: float   # [m]
    density: float  # [kg/m^3]
    young: float    # [Pa]
    poisson: float

    @classmethod
    def with_moduli(cls, length, height, density, bulk, shear):
        return cls(length, height, density, 9 * bulk * shear / (3 * bulk + shear),
                   (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear)))

    @property
    def bending_stiffness(self):
        """E' I [N m]"""
        return self.young / (1 - self.poisson ** 2) * self.height ** 3 / 12

    @property
    def stretching_stiffness(self):
        """E' A [N/m]"""
        return self.young / (1 - self.poisson ** 2) * self.height

    @property
    def shear_stiffness(self):
        """kappa G A [N/m]"""
        return SHEAR_FACTOR * self.young / (2 * (1 + self.poisson)) * self.height

    @property
    def bulk_sound_speed(self):
        """sqrt(K/rho) [m/s]"""
        return np.sqrt(self.young / (3 * (1 - 2 * self.poisson)) / self.density)


def thin_plate_period(plate):
    """First mode without shear and rotary inertia [Landau & Lifshitz, Theory of Elasticity, section 25]. [s]"""
    omega = (CANTILEVER / plate.length) ** 2 * np.sqrt(plate.bending_stiffness / (plate.density * plate.height))
    return 2 * np.pi / omega


def timoshenko_period(plate):
    """First mode with shear and rotary inertia [Timoshenko 1921]. [s]

    With deflection w, rotation phi, moment M = E'I phi' and shear force Q = kappa G A (w' - phi), at frequency omega:
      w' = phi + Q/(kappa G A),  phi' = M/(E'I),  M' = -Q - rho I omega^2 phi,  Q' = -rho A omega^2 w
    The frequency is where the part of the transfer matrix exp(B L) from (M, Q) at the clamp, where w = phi = 0, to
    (M, Q) at the free end, where both vanish, is singular.
    """
    length, area, inertia = plate.length, plate.height, plate.height ** 3 / 12

    def determinant(omega):
        mass = plate.density * omega ** 2
        system = length * np.array([[0, 1, 0, 1 / plate.shear_stiffness], [0, 0, 1 / plate.bending_stiffness, 0],
                                    [0, -mass * inertia, 0, -1], [-mass * area, 0, 0, 0]])
        values, vectors = np.linalg.eig(system)
        transfer = (vectors * np.exp(values)) @ np.linalg.inv(vectors)
        return np.linalg.det(transfer[2:, 2:]).real

    thin = 2 * np.pi / thin_plate_period(plate)
    low, high = 0.5 * thin, thin  # shear and rotary inertia can only lower it
    at_low = determinant(low)
    for _ in range(60):
        middle = 0.5 * (low + high)
        if determinant(middle) * at_low > 0:
            low = middle
        else:
            high = middle
    return 4 * np.pi / (low + high)


def linear_tip(plate, gravity):
    """Deflection of the free end under the plate's weight, bending and shear, for small loads. [m]"""
    load = plate.density * gravity * plate.height
    return load * plate.length ** 4 / (8 * plate.bending_stiffness) + load * plate.length ** 2 / (2 * plate.shear_stiffness)


def reissner_tip(plate, gravity, steps=400):
    """(u_x, u_y) of the free end under the plate's weight, at any deflection [Reissner 1972]: the beam stretches,
    shears and bends linearly in its own turned frame t1 = (cos theta, sin theta), t2. [m]

    Force n = (0, -q (L - s)) at arc length s; moment m with m' = -(x' n_y - y' n_x) and m(L) = 0;
      r' = (1 + n.t1/(E'A)) t1 + n.t2/(kappa G A) t2,  theta' = m/(E'I)
    """
    load = plate.density * gravity * plate.height

    def rate(s, state):
        theta, moment = state[2], state[3]
        force = -load * (plate.length - s)
        stretch = 1 + force * np.sin(theta) / plate.stretching_stiffness
        shear = force * np.cos(theta) / plate.shear_stiffness
        x = stretch * np.cos(theta) - shear * np.sin(theta)
        y = stretch * np.sin(theta) + shear * np.cos(theta)
        return np.array([x, y, moment / plate.bending_stiffness, -x * force])

    def end(root_moment):
        state, step = np.array([0, 0, 0, root_moment]), plate.length / steps
        for k in range(steps):  # Runge-Kutta, 4th order: error 1e-10 of the length with 400 steps
            s = k * step
            k1 = rate(s, state)
            k2 = rate(s + step / 2, state + step / 2 * k1)
            k3 = rate(s + step / 2, state + step / 2 * k2)
            k4 = rate(s + step, state + step * k3)
            state = state + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        return state

    low, high = -load * plate.length ** 2 / 2, 0.0  # the lever arm of the load is at most that of the straight plate
    for _ in range(60):
        middle = 0.5 * (low + high)
        if end(middle)[3] < 0:
            low = middle
        else:
            high = middle
    state = end(0.5 * (low + high))
    return state[0] - plate.length, state[1]
