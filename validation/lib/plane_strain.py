"""Plane strain by finite elements: biquadratic, in the reference configuration, St. Venant-Kirchhoff. For references that
have no formula; needs Debian's python3-scipy (sparse matrices), which nothing else does but oscillating_plate's."""
import numpy as np
from scipy import sparse
from scipy.sparse.linalg import spsolve


def graded(elements, power):
    """Nodes of quadratic elements over [0, 1], finer towards 0, with each element's middle node in its middle."""
    ends = np.linspace(0, 1, elements + 1) ** power
    return np.sort(np.concatenate([ends, (ends[1:] + ends[:-1]) / 2]))


def shapes(s):
    return np.array([s * (s - 1) / 2, 1 - s * s, s * (s + 1) / 2]), np.array([s - 0.5, -2 * s, s + 0.5])


class Solid:
    """A mapped lattice of elements; displacements are u[2 node + axis]. Load [N/m] and what is free are the caller's to add to."""

    def __init__(self, x, y, youngs, poisson, density):
        """x, y: of the nodes, (2 along + 1) by (2 across + 1)."""
        self.density = density
        self.nodes = np.arange(x.size).reshape(x.shape)
        self.position = np.stack([x, y], axis=-1).reshape(-1, 2)
        self.elements = np.array([self.nodes[i:i + 3, j:j + 3].ravel()
                                  for i in range(0, x.shape[0] - 1, 2) for j in range(0, x.shape[1] - 1, 2)])
        self.dofs = (2 * self.elements[:, :, None] + np.arange(2)).reshape(len(self.elements), 18)
        self.size = 2 * x.size
        self.free = np.arange(self.size)
        self.shear = youngs / (2 * (1 + poisson))
        self.lame = youngs * poisson / ((1 + poisson) * (1 - 2 * poisson))
        self.integrate()
        self.load = np.zeros(self.size)

    def hold(self, nodes, axes=(0, 1)):
        for axis in axes:
            self.free = np.setdiff1d(self.free, 2 * np.ravel(nodes) + axis)

    def add_weight(self, gravity):
        down = np.zeros(self.size)
        down[1::2] = -gravity
        self.load += self.mass @ down

    def press_on_top(self, pressure):
        """On the last row of nodes, downwards, as long as that is level [Pa]."""
        for k in range(0, self.nodes.shape[0] - 1, 2):
            three = self.nodes[k:k + 3, -1]
            length = self.position[three[2], 0] - self.position[three[0], 0]
            self.load[2 * three + 1] -= pressure * length * np.array([1, 4, 1]) / 6

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
        mass[:, :, 0, :, 0] = mass[:, :, 1, :, 1] = self.density * np.einsum("eg,ga,gb->eab", self.weight, value, value)
        self.mass = self.assembled(mass)

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
        """Displacements [m], by Newton's method with the load in so many parts."""
        u = np.zeros(self.size)
        for part in np.arange(1, loads + 1) / loads:
            change = np.ones(1)
            while np.abs(change).max() > 1e-11:
                force, stiffness = self.inner(u)
                change = spsolve(stiffness[self.free][:, self.free], (part * self.load - force)[self.free])
                u[self.free] += change
        return u.reshape(-1, 2)

    def swinging(self, node, end, step):
        """From rest, by Newmark's trapezoidal rule: rows of time [s] and u_x, u_y of a node [m]."""
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
            rows.append((rows[-1][0] + step, *u.reshape(-1, 2)[node]))
        return np.array(rows)
