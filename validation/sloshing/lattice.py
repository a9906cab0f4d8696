#!/usr/bin/python3
"""How much a square lattice of particles under pressure resists shear, and how much faster a gravity wave gets by it.

A pair's pressure forces at a fixed p derive from the energy 2 p V² W(r). For a displacement u_i = e_ij x_j that keeps the
volume (to second order tr e = e_ij e_ji/2) the lattice's energy per volume is
  E = p/2 (e_ik e_jl T_ijkl − (1 + a) e_ij e_ji),   T_ijkl = V Σ_b W_,ij x_k x_l,   (1 + a) δ_ij = −V Σ_b W_,i x_j
With integrals in place of the sums T_ijkl = δ_ik δ_jl + δ_il δ_jk and a = 0, so E = 0: water does not resist shear. The sums
differ by an amount that h/d and W decide, and that is the same however small d is. For e_xx = −e_yy = e and e_xy = e_yx = s
  E = p/2 (A e² + S s²)
In a wave e and s follow from the displacement ∇(cos kx cosh ky), p = ρg(H − y); E adds to its potential energy ρgη²/2. As the
wave's shape is kept (Rayleigh's quotient), what comes out is an upper bound of the frequency where A and S are positive; with
A < 0 or S < 0 the lattice is unstable and the particles soon lie differently.
"""
import numpy as np

STEP = 1e-4  # d, of the differences that stand for W' and W''


def wendland_c2(q):
    return np.where(q < 2, (1 - q / 2) ** 4 * (2 * q + 1), 0)


def wendland_c4(q):
    return np.where(q < 2, (1 - q / 2) ** 6 * (35 / 12 * q * q + 3 * q + 1), 0)


def quintic_spline(q):
    return ((3 - q) ** 5 * (q < 3) - 6 * (2 - q) ** 5 * (q < 2) + 15 * (1 - q) ** 5 * (q < 1))


def cubic_spline(q):
    return np.where(q < 1, 1 - 1.5 * q * q + 0.75 * q ** 3, np.where(q < 2, 0.25 * (2 - q) ** 3, 0))


def stiffness(shape, smoothing_length, support=3.0):
    """A and S; lengths in units of d."""
    r = np.linspace(0, support * smoothing_length, 200001)
    total = np.sum(shape(r / smoothing_length) * 2 * np.pi * r) * (r[1] - r[0])
    reach = np.arange(-int(support * smoothing_length) - 1, int(support * smoothing_length) + 2)
    x, y = (axis.ravel().astype(float) for axis in np.meshgrid(reach, reach))
    x, y = x[x * x + y * y > 0], y[x * x + y * y > 0]
    r = np.hypot(x, y)
    low, at, high = (shape((r + step) / smoothing_length) / total for step in (-STEP, 0, STEP))
    slope, bend = (high - low) / (2 * STEP), (high - 2 * at + low) / STEP ** 2
    xx, yy = bend * x * x / r ** 2 + slope * y * y / r ** 3, bend * y * y / r ** 2 + slope * x * x / r ** 3
    xy = (bend / r ** 2 - slope / r ** 3) * x * y
    first = -np.sum(slope * x * x / r)
    return (2 * np.sum(xx * x * x) - 2 * np.sum(xy * x * y) - 2 * first,
            np.sum(xx * y * y + yy * x * x + 2 * xy * x * y) - 2 * first)


def frequency_ratio(a, s, wave_number, depth):
    """ω of the wave on the lattice over that in water."""
    y = np.linspace(0, depth, 4001)
    strained = (depth - y) / 2 * wave_number ** 4 * (a * np.cosh(wave_number * y) ** 2 + s * np.sinh(wave_number * y) ** 2) / 2
    raised = (wave_number * np.sinh(wave_number * depth)) ** 2 / 4  # ρ = g = 1
    return np.sqrt(1 + strained.sum() * (y[1] - y[0]) / raised)


def main():
    print("W, h/d: A, S; this tank's first mode; the wave of standing_wave")
    for shape, length in ((wendland_c2, 1.2), (wendland_c2, 1.5), (wendland_c2, 1.8), (wendland_c2, 2.0), (wendland_c4, 1.5),
                          (quintic_spline, 1.5), (cubic_spline, 1.5)):
        a, s = stiffness(shape, length)
        tank, wave = (frequency_ratio(a, s, k, 0.5) for k in (np.pi, 2 * np.pi))
        print(f"{shape.__name__:>14}, {length:.1f}: {a:+.3f}, {s:+.3f}; {tank:.4f}; {wave:.4f}")


if __name__ == "__main__":
    main()
