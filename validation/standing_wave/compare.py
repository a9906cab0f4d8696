#!/usr/bin/python3
"""Runs the standing wave at three spacings and compares its period and damping with linear theory."""
import sys
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from lib import case, convergence, style  # noqa: E402
from lib.verdict import Verdict  # noqa: E402
from lib.waves import damped_oscillation  # noqa: E402

G, K, DEPTH, NU = 9.81, 2 * np.pi, 0.5, 0.002


def exact_rate():
    """n = −γ + iω of the linearised Navier-Stokes equations, with v = 0 and slip at the floor:
    (n + 2νk²)² + g k tanh kH − 4 ν² k³ m tanh kH / tanh mH = 0,   m² = k² + n/ν
    [Lamb 1932, art. 349, there for deep water]. Newton's method, from potential flow: n = −2νk² + i √(g k tanh kH).
    """
    def balance(n):
        m, depth = np.sqrt(K * K + n / NU), np.tanh(K * DEPTH)
        return (n + 2 * NU * K * K) ** 2 + G * K * depth - 4 * NU ** 2 * K ** 3 * m * depth / np.tanh(m * DEPTH)

    n = -2 * NU * K ** 2 + 1j * np.sqrt(G * K * np.tanh(K * DEPTH))
    for _ in range(20):
        n -= balance(n) / ((balance(n + 1e-6) - balance(n - 1e-6)) / 2e-6)
    return n


OMEGA, DAMPING = exact_rate().imag, -exact_rate().real


def mode(points):
    """Velocity of the standing wave where its surface moves with 1 m/s."""
    x, y = points.T
    scale = 1 / np.sinh(K * DEPTH)
    return scale * np.stack([-np.cosh(K * y) * np.sin(K * x), np.sinh(K * y) * np.cos(K * x)], axis=1)


def amplitudes(run):
    """Times [s], and the share of the wave in the velocities [m/s]: least squares over the particles of each frame."""
    time, share = [], []
    for frame in run.frames():
        v, shape = np.asarray(frame["velocity"], dtype=float)[:, :2], mode(frame.points)
        time.append(frame.time)
        share.append((v * shape).sum() / (shape ** 2).sum())
    return np.array(time), np.array(share)


def measure(run):
    time, share = amplitudes(run)
    omega, gamma = damped_oscillation(time, share, OMEGA, DAMPING)
    exact = np.exp(-DAMPING * time) * np.cos(OMEGA * time) * share[0]
    return {
        "period": abs(OMEGA / omega - 1),
        "damping": abs(gamma / DAMPING - 1),
        "period / exact": OMEGA / omega,
        "damping / exact": gamma / DAMPING,
        "velocity of the wave, L2": np.sqrt(((share - exact) ** 2).sum() / (exact ** 2).sum()),
    }


def judge(study):
    verdict = Verdict()
    verdict.limit("period, finest: off by", 100 * study.finest["period"], "%", high=1)
    verdict.limit("damping, finest: off by", 100 * study.finest["damping"], "%", high=10)
    study.require_order(verdict, "velocity of the wave, L2")
    return verdict


def draw(study, path):
    plt = style.use()
    figure, axis = plt.subplots(figsize=(6.3, 3.2), layout="constrained")
    for run, count, colour in zip(study.runs, study.counts, (style.ORANGE, style.SKY, style.BLUE)):
        time, share = amplitudes(run)
        axis.plot(time, share / share[0], color=colour, label=f"H/d = {count}")
    axis.plot(time, np.exp(-DAMPING * time) * np.cos(OMEGA * time), color=style.BLACK, linestyle=(0, (4, 2)),
              label="linear theory")
    axis.set_xlabel("time [s]")
    axis.set_ylabel("velocity of the wave / first")
    axis.grid(color="0.92", linewidth=0.5)
    axis.set_ylim(-1.1, 1.4)
    axis.legend(ncol=4, loc="upper right", fontsize=8)
    style.save(figure, path)


CASE = convergence.Case(
    "Standing wave", FOLDER, "gravity waves, viscosity at a free surface", "the linearised Navier–Stokes equations",
    across=("H/d", DEPTH), counts=(20, 40, 80),
    errors=("velocity of the wave, L2", "period", "damping"),
    others=(("period / exact", 4), ("damping / exact", 3)), measure=measure, judge=judge, draw=draw,
    caption="The wave's share of the particles' velocities against linear theory.",
    quick_counts=(20,), quick_limits={"velocity of the wave, L2": 0.03, "damping": 0.05})

if __name__ == "__main__":
    sys.exit(case.main(CASE))
