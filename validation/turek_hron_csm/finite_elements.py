#!/usr/bin/python3
"""CSM1, CSM2 and CSM3 by finite elements of our own; writes reference_finite_elements.csv (half an hour).

A second opinion, with the cylinder's arc as the bar's end, and for CSM3 with the periods that we compare: its published
mean and amplitude are those of the last of ten seconds, and depend on how the second mode stands just then. Biquadratic
elements in the reference configuration, St. Venant-Kirchhoff in plane strain, Newmark's trapezoidal rule, Newton's
method. Needs Debian's python3-scipy (sparse matrices).
"""
import sys
from pathlib import Path

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import spsolve

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from lib.curves import crossings, peak  # noqa: E402

DENSITY, POISSON, GRAVITY = 1000.0, 0.4, 2.0
STATIC_MESH, SWING_MESH, STEP, END = (60, 4), (36, 2), 0.002, 3.1  # elements along and across; s
HEADER = f"""# Point A, mm and Hz, by finite elements (finite_elements.py): {STATIC_MESH[0]} x {STATIC_MESH[1]} biquadratic elements; csm3:
# {SWING_MESH[0]} x {SWING_MESH[1]}, steps of {STEP} s; (max + min)/2 and (max - min)/2 of the second period between falling passes of the middle.
case,u_x,u_x_amplitude,u_y,u_y_amplitude,frequency
"""


def shapes(s):
    return np.array([s * (s - 1) / 2, 1 - s * s, s * (s + 1) / 2]), np.array([s - 0.5, -2 * s, s + 0.5])


class Bar:
    """The bar as a mesh that is finer towards the cylinder; displacements are u[2 node + axis]."""

    def __init__(self, along, across, youngs):
        ends = np.linspace(0, 1, along + 1) ** 1.5
        place = np.sort(np.concatenate([ends, (ends[1:] + ends[:-1]) / 2]))
        y = np.linspace(0.19, 0.21, 2 * across + 1)
        root = 0.2 + np.sqrt(0.05 ** 2 - (y - 0.2) ** 2)
        nodes = np.arange(len(place) * len(y)).reshape(len(place), len(y))
        x = root + (0.6 - root) * place[:, None]
        self.position = np.stack([x, np.broadcast_to(y, x.shape)], axis=-1).reshape(-1, 2)
        self.elements = np.array([nodes[2 * i:2 * i + 3, 2 * j:2 * j + 3].ravel()
                                  for i in range(along) for j in range(across)])
        self.dofs = (2 * self.elements[:, :, None] + np.arange(2)).reshape(len(self.elements), 18)
        self.size, self.tip = 2 * len(self.position), nodes[-1, across]
        self.free = np.setdiff1d(np.arange(self.size), np.concatenate([2 * nodes[0], 2 * nodes[0] + 1]))
        self.shear = youngs / (2 * (1 + POISSON))
        self.lame = youngs * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
        self.integrate()

    def integrate(self):
        points, weights = np.polynomial.legendre.leggauss(3)
        value, slope, weight = [], [], []
        for s, ws in zip(points, weights):
            for t, wt in zip(points, weights):
                (f, df), (g, dg) = shapes(s), shapes(t)
                value.append(np.outer(f, g).ravel())
                slope.append(np.stack([np.outer(df, g).ravel(), np.outer(f, dg).ravel()], axis=1))
                weight.append(ws * wt)
        value, slope, weight = map(np.array, (value, slope, weight))
        jacobian = np.einsum("gak,eai->egik", slope, self.position[self.elements])
        self.gradient = np.einsum("gak,egki->egai", slope, np.linalg.inv(jacobian))
        self.weight = np.linalg.det(jacobian) * weight
        mass = np.zeros((len(self.elements), 9, 2, 9, 2))
        mass[:, :, 0, :, 0] = mass[:, :, 1, :, 1] = DENSITY * np.einsum("eg,ga,gb->eab", self.weight, value, value)
        self.mass = self.assembled(mass)
        down = np.zeros(self.size)
        down[1::2] = -GRAVITY
        self.load = self.mass @ down

    def assembled(self, blocks):
        rows, columns = np.repeat(self.dofs, 18, axis=1).ravel(), np.tile(self.dofs, (1, 18)).ravel()
        return sparse.coo_matrix((blocks.ravel(), (rows, columns)), shape=(self.size, self.size)).tocsc()

    def inner(self, u):
        """Inner forces and their derivative."""
        deformation = np.eye(2) + np.einsum("eai,egaj->egij", u.reshape(-1, 2)[self.elements], self.gradient)
        strain = 0.5 * (np.einsum("egki,egkj->egij", deformation, deformation) - np.eye(2))
        stress = 2 * self.shear * strain + self.lame * np.trace(strain, axis1=2, axis2=3)[..., None, None] * np.eye(2)
        force = np.zeros(self.size)
        np.add.at(force, self.dofs.ravel(),
                  np.einsum("egik,egkj,egaj,eg->eai", deformation, stress, self.gradient, self.weight).ravel())
        change = np.einsum("egki,egaj->egijak", deformation, self.gradient)
        change = 0.5 * (change + change.swapaxes(2, 3))
        answer = 2 * self.shear * change
        answer[:, :, 0, 0] += self.lame * (change[:, :, 0, 0] + change[:, :, 1, 1])
        answer[:, :, 1, 1] += self.lame * (change[:, :, 0, 0] + change[:, :, 1, 1])
        stiffness = np.einsum("egijak,egijbl,eg->eakbl", change, answer, self.weight, optimize=True)
        of_stress = np.einsum("egai,egij,egbj,eg->eab", self.gradient, stress, self.gradient, self.weight, optimize=True)
        stiffness[:, :, 0, :, 0] += of_stress
        stiffness[:, :, 1, :, 1] += of_stress
        return force, self.assembled(stiffness)

    def at_rest(self, loads=4):
        u = np.zeros(self.size)
        for part in np.arange(1, loads + 1) / loads:
            change = np.ones(1)
            while np.abs(change).max() > 1e-11:
                force, stiffness = self.inner(u)
                change = spsolve(stiffness[self.free][:, self.free], (part * self.load - force)[self.free])
                u[self.free] += change
        return 1e3 * u.reshape(-1, 2)[self.tip]

    def swinging(self, end, step):
        """Rows of time [s] and u_x, u_y [mm] of point A."""
        u, v, a = np.zeros((3, self.size))
        inertia = self.mass[self.free][:, self.free]
        a[self.free] = spsolve(inertia, self.load[self.free])
        rows = [(0.0, 0.0, 0.0)]
        while rows[-1][0] < end:
            start = u + step * v + 0.25 * step ** 2 * a
            u, change = start + 0.25 * step ** 2 * a, np.ones(1)
            while np.abs(change).max() > 1e-10:
                force, stiffness = self.inner(u)
                rest = self.load - force - self.mass @ (u - start) / (0.25 * step ** 2)
                change = spsolve(stiffness[self.free][:, self.free] + inertia / (0.25 * step ** 2), rest[self.free])
                u[self.free] += change
            before, a = a, (u - start) / (0.25 * step ** 2)
            v = v + 0.5 * step * (before + a)
            rows.append((rows[-1][0] + step, *1e3 * u.reshape(-1, 2)[self.tip]))
        return np.array(rows)


def second_period(rows):
    time, x, y = rows.T
    start, end = crossings(time, y - 0.5 * (y.max() + y.min()), upward=False)[1:3]
    use, values = (time >= start) & (time <= end), []
    for u in (x, y):
        top, bottom = peak(time[use], u[use])[1], -peak(time[use], -u[use])[1]
        values += [(top + bottom) / 2, (top - bottom) / 2]
    return values + [1 / (end - start)]


def main():
    rest = [Bar(*STATIC_MESH, youngs).at_rest() for youngs in (1.4e6, 5.6e6)]
    lines = [f"csm{k + 1},{x:.4f},,{y:.4f},," for k, (x, y) in enumerate(rest)]
    lines.append("csm3," + ",".join(f"{v:.4f}" for v in second_period(Bar(*SWING_MESH, 1.4e6).swinging(END, STEP))))
    (FOLDER / "reference_finite_elements.csv").write_text(HEADER + "\n".join(lines) + "\n")
    print(HEADER + "\n".join(lines))


if __name__ == "__main__":
    main()
