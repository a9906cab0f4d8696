"""Linear potential flow in a rectangular tank that is swayed from rest [Faltinsen 1978; Ibrahim 2005, section 2.2].

In the tank's frame the water feels f(t) = F sin ωt along x. With φ = Σ a_n(t) cos k_n x cosh k_n y / cosh k_n H,
η = Σ b_n(t) cos k_n x and x − L/2 = Σ c_n cos k_n x (c_n = −4L/(nπ)² for odd n, 0 for even n), kinematics and dynamics at
the surface, η_t = φ_y and φ_t + g η = f (x − L/2), give an oscillator for each mode:
  b_n″ + 2 γ_n b_n′ + ω_n² b_n = c_n k_n tanh(k_n H) F sin ωt,  b_n(0) = b_n′(0) = 0,  ω_n² = g k_n tanh k_n H
Potential flow has γ = 0. To see what a run does instead, `stiffness` multiplies all ω_n, and γ_n = damping n (the first
mode is what counts; n² as in a viscous wave would make the last ones creep).
"""
import numpy as np

G, LENGTH, DEPTH = 9.81, 1.0, 0.5
MODES = 61  # the amplitude of b_n falls as n^-2 at least: the last is below 0.1 % of the first


def natural_frequency(n=1):
    k = n * np.pi / LENGTH
    return np.sqrt(G * k * np.tanh(k * DEPTH))


def response(time, force, omega, weight, stiffness=1.0, damping=0.0):
    """Σ_n weight(k_n) b_n(t)."""
    total = np.zeros_like(time)
    for n in range(1, MODES + 1, 2):
        k, gamma = n * np.pi / LENGTH, damping * n
        natural = stiffness * natural_frequency(n)
        drive = -4 * LENGTH / (np.pi * n) ** 2 * k * np.tanh(k * DEPTH) * force
        steady = drive / (natural ** 2 - omega ** 2 + 2j * gamma * omega)  # of e^(iωt), of which the imaginary part counts
        start, rate = -steady.imag, -(1j * omega * steady).imag            # the free part cancels it at t = 0
        free = np.sqrt(natural ** 2 - gamma ** 2)
        total = total + weight(k) * ((steady * np.exp(1j * omega * time)).imag + np.exp(-gamma * time) * (
            start * np.cos(free * time) + (rate + gamma * start) / free * np.sin(free * time)))
    return total


def level(left, right):
    """Mean elevation over left < x < right."""
    return lambda k: (np.sin(k * right) - np.sin(k * left)) / (k * (right - left))


def centre_of_mass(k):
    """x of the water's centre of mass less L/2: ∫ (x − L/2) cos kx dx / (L H), odd modes."""
    return -2 / k ** 2 / (LENGTH * DEPTH)


def fit(time, value, force, omega, weight):
    """(stiffness, damping) of the response nearest to `value`: Gauss and Newton, with differences for derivatives."""
    at = np.array([1.0, 0.01])
    for _ in range(20):
        now = response(time, force, omega, weight, *at)
        slopes = [(response(time, force, omega, weight, *(at + step)) - now) / step.max()
                  for step in (np.array([1e-5, 0]), np.array([0, 1e-5]))]
        at = at + np.linalg.lstsq(np.stack(slopes, axis=1), value - now, rcond=None)[0]
    return at
