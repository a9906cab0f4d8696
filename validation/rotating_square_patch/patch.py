"""The rotating square as incompressible water without viscosity: vorticity stays −2Ω everywhere, so that
  u = Ω (y, −x) + ∇φ,   Δφ = 0,   φ + iψ' = W(z) = Σ_k c_k z^(4k)   (four-fold symmetry; z = x + iy)
With the stream function ψ = Ω r²/2 + ψ', Euler's equation integrates to [Batchelor 1967, section 7.5, unsteady]
  φ_t + |u|²/2 − 2Ω ψ + p/ρ = C(t)
so that on the surface, p = 0, each point moves with u and carries Dφ/Dt = −|u|²/2 + 2Ωψ + u·∇φ, up to a constant. W follows
from φ on the surface by least squares, and the pressure inside from φ_t, harmonic too, known on the surface.

Two exact facts to hold it against: p(0) at the centre is −0.147343 ρΩ²L² (the torsion of a square bar), and a corner, where ∇p
vanishes as long as it is one, flies straight on: (L/√2) √(1 + Ω²t²) from the centre. Units: Ω = L = ρ = 1.
With 12 terms area, corner and centre's pressure are the same to four digits as with 30 until t = 1; after 1.3 the
sum of powers is no longer good for the arms.
"""
import numpy as np

POWERS = 4 * np.arange(13)
POINTS, STEP = 200, 0.01
UNTIL = 1.0


class Series:
    """Re Σ c_k (z/R)^(4k), least squares from values on the surface."""

    def __init__(self, z, value):
        self.scale = np.abs(z).max()
        powers = (z[:, None] / self.scale) ** POWERS
        matrix = np.concatenate([powers.real, -powers.imag[:, 1:]], axis=1)
        weight = np.sqrt(np.gradient(np.cumsum(np.r_[0, np.abs(np.diff(z))])) + 1e-6)  # by length of surface
        found = np.linalg.lstsq(matrix * weight[:, None], value * weight, rcond=1e-12)[0]
        self.c = found[:len(POWERS)].astype(complex)
        self.c[1:] += 1j * found[len(POWERS):]

    def __call__(self, z):
        return ((z[..., None] / self.scale) ** POWERS) @ self.c

    def derivative(self, z):
        return ((z[..., None] / self.scale) ** np.maximum(POWERS - 1, 0)) @ (POWERS * self.c) / self.scale


class Patch:
    """The flow at one time: a side of the square between two corners, and φ on it."""

    def __init__(self, z, phi):
        self.z, self.phi = z, phi
        self.w = Series(z, phi)
        u = self.velocity(z)
        self.unsteady = -0.5 * np.abs(u) ** 2 + 2 * self.stream(z)  # φ_t − C on the surface
        self.phi_t = Series(z, self.unsteady)
        self.rates = u, self.unsteady + (u * self.w.derivative(z)).real

    def velocity(self, z):
        """u + iv"""
        return z.imag - 1j * z.real + np.conj(self.w.derivative(z))

    def stream(self, z):
        return 0.5 * np.abs(z) ** 2 + self.w(z).imag - self.w.c[0].imag

    def pressure(self, z):
        return -self.phi_t(z).real - 0.5 * np.abs(self.velocity(z)) ** 2 + 2 * self.stream(z)

    def outline(self):
        """All four sides, closed."""
        return np.concatenate([self.z * 1j ** k for k in range(4)] + [self.z[:1]])


def solution(until=UNTIL):
    """(time, Patch) at every step, by the fourth-order Runge-Kutta method."""
    side = 0.5 + 0.5j * np.sin(np.linspace(-np.pi / 2, np.pi / 2, POINTS))
    state, steps = [Patch(side, np.zeros(POINTS))], int(round(until / STEP))
    for _ in range(steps):
        z, phi = state[-1].z, state[-1].phi
        k1 = state[-1].rates
        k2 = Patch(z + STEP / 2 * k1[0], phi + STEP / 2 * k1[1]).rates
        k3 = Patch(z + STEP / 2 * k2[0], phi + STEP / 2 * k2[1]).rates
        k4 = Patch(z + STEP * k3[0], phi + STEP * k3[1]).rates
        z, phi = (old + STEP / 6 * (a + 2 * b + 2 * c + d) for old, a, b, c, d in zip((z, phi), k1, k2, k3, k4))
        state.append(Patch(z, phi))
    return STEP * np.arange(steps + 1), state


def square_pressure(x, y, terms=200):
    """At t = 0 and Ω = L = ρ = 1, Δp = 2 and p = 0 on the sides [Timoshenko & Goodier, art. 109]:
    p = −2 (½(¼ − y²) − Σ_{n odd} 4/(πn)³ (−1)^((n−1)/2) cos nπy cosh nπx / cosh nπ/2)"""
    bar = 0.5 * (0.25 - y * y)
    for n in range(1, terms, 2):
        ratio = np.exp(n * np.pi * (np.abs(x) - 0.5)) * (1 + np.exp(-2 * n * np.pi * np.abs(x))) / (1 + np.exp(-n * np.pi))
        bar = bar - 4 / (np.pi * n) ** 3 * (-1) ** ((n - 1) // 2) * np.cos(n * np.pi * y) * ratio
    return -2 * bar
