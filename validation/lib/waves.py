"""A damped oscillation as a few numbers."""
import numpy as np


def damped_oscillation(time, value, omega, gamma):
    """(ω, γ) of value = e^(−γt) (a cos ωt + b sin ωt), least squares by Gauss and Newton from the ω and γ that are expected."""
    for _ in range(30):
        envelope, c, s = np.exp(-gamma * time), np.cos(omega * time), np.sin(omega * time)
        a, b = np.linalg.lstsq(np.stack([envelope * c, envelope * s], axis=1), value, rcond=None)[0]
        model = envelope * (a * c + b * s)
        jacobian = np.stack([envelope * c, envelope * s, time * envelope * (b * c - a * s), -time * model], axis=1)
        step = np.linalg.lstsq(jacobian, value - model, rcond=None)[0]
        omega, gamma = omega + step[2], gamma + step[3]
    return omega, gamma
