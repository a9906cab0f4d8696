#!/usr/bin/python3
"""Runs the free elliptical drop at three spacings and compares its semi-axes and pressure with the exact solution."""
import sys
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from lib import case, convergence, style  # noqa: E402
from lib.verdict import Verdict  # noqa: E402

STRAIN, RADIUS, DENSITY = 1.0, 1.0, 1000.0
STEPS_PER_UNIT = 1000  # of Runge and Kutta's fourth order: error below 1e-12


def solution(t_end):
    """Rows (t, A, a, b) of v = (−A x, A y) in an ellipse of semi-axes a and b:
    A' = A² (a² − b²)/(a² + b²), a' = −A a, b' = A b; p = ρ A² a² b²/(a² + b²) (1 − x²/a² − y²/b²).
    """
    def rate(s):
        strain, a, b = s
        return np.array([strain ** 2 * (a * a - b * b) / (a * a + b * b), -strain * a, strain * b])

    n = int(np.ceil(STEPS_PER_UNIT * t_end))
    dt, s = t_end / n, np.array([STRAIN, RADIUS, RADIUS])
    rows = [(0.0, *s)]
    for i in range(n):
        k1 = rate(s)
        k2 = rate(s + 0.5 * dt * k1)
        k3 = rate(s + 0.5 * dt * k2)
        k4 = rate(s + dt * k3)
        s = s + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        rows.append(((i + 1) * dt, *s))
    return np.array(rows)


def pressure(points, strain, a, b):
    shape = 1 - (points[:, 0] / a) ** 2 - (points[:, 1] / b) ** 2
    return DENSITY * strain ** 2 * (a * b) ** 2 / (a * a + b * b) * shape


def semi_axes(frame):
    """From the second moments, ⟨x²⟩ = a²/4 in an ellipse: every particle counts, and those at the tips no more."""
    return 2 * np.sqrt((frame.points ** 2).mean(axis=0))


def measure(run):
    frame = list(run.frames())[-1]
    _, strain, a, b = solution(frame.time)[-1]
    axes = semi_axes(frame)
    p, exact = np.asarray(frame["pressure"], dtype=float), pressure(frame.points, strain, a, b)
    energy = run.probe("energy.kinetic")
    exact_v = strain * frame.points * np.array([-1, 1])
    v = np.asarray(frame["velocity"], dtype=float)[:, :2]
    return {
        "semi-axis b": abs(axes[1] / b - 1),
        "semi-axis a": abs(axes[0] / a - 1),
        "velocity, L2": np.sqrt(((v - exact_v) ** 2).sum() / (exact_v ** 2).sum()),
        "b / exact": axes[1] / b,
        "a / exact": axes[0] / a,
        "a b / R²": axes[0] * axes[1] / RADIUS ** 2,
        "outermost y / b": np.abs(frame.points[:, 1]).max() / b,
        "kinetic energy kept": energy[-1] / energy[0],
        "pressure, L2 / exact": np.sqrt(((p - exact) ** 2).mean() / (exact ** 2).mean()),
    }


def judge(study):
    verdict = Verdict()
    verdict.limit("semi-axis b at t A = 1, finest: off by", 100 * study.finest["semi-axis b"], "%", high=1)
    verdict.limit("semi-axis a at t A = 1, finest: off by", 100 * study.finest["semi-axis a"], "%", high=1)
    study.require_order(verdict, "velocity, L2")
    verdict.limit("kinetic energy kept, finest", study.finest["kinetic energy kept"], "", low=0.99, high=1.01)
    return verdict


def draw(study, path):
    plt = style.use()
    figure, (left, right) = plt.subplots(1, 2, figsize=(7.2, 3.6), layout="constrained", width_ratios=(2.2, 1))
    exact = solution(study.runs[-1].frame_times()[-1])
    left.plot(exact[:, 0], exact[:, 2], color=style.BLACK, linewidth=1, label="exact a and b")
    left.plot(exact[:, 0], exact[:, 3], color=style.BLACK, linewidth=1)
    for run, count, colour, size in zip(study.runs, study.counts, (style.ORANGE, style.SKY, style.BLUE), (7, 5, 3)):
        axes = np.array([semi_axes(frame) for frame in run.frames()])
        for k in (0, 1):
            left.plot(run.frame_times(), axes[:, k], "o", markersize=size, color=colour,
                      label=f"R/d = {count}" if k == 0 else None)
    left.set_xlabel("time t A")
    left.set_ylabel("semi-axis / R")
    left.legend()
    frame = list(study.runs[-1].frames())[-1]
    _, strain, a, b = exact[-1]
    top = pressure(np.zeros((1, 2)), strain, a, b)[0]
    dots = right.scatter(*frame.points.T, c=frame["pressure"], s=0.8, linewidths=0, cmap=style.WATER, vmin=0, vmax=top)
    angle = np.linspace(0, 2 * np.pi, 200)
    right.plot(a * np.cos(angle), b * np.sin(angle), color=style.VERMILION, linewidth=0.8)
    right.set(aspect="equal", xlim=(-0.7, 0.7), xticks=(-0.5, 0, 0.5))
    figure.colorbar(dots, ax=right, shrink=0.7, label="p [Pa], and the exact outline")
    style.save(figure, path)


CASE = convergence.Case(
    "Elliptical drop", FOLDER, "a free surface under large strain", "elliptical drop, ordinary differential equations",
    across=("R/d", RADIUS), counts=(25, 50, 100),
    errors=("velocity, L2", "semi-axis a", "semi-axis b"),
    others=(("a b / R²", 4), ("outermost y / b", 4), ("kinetic energy kept", 4), ("pressure, L2 / exact", 3)),
    measure=measure, judge=judge, draw=draw,
    caption="Left: semi-axes against the exact ones. Right: pressure at the end with the finest spacing, and the exact outline.",
    quick_counts=(25, 50), quick_limits={"velocity, L2": 0.02, "semi-axis b": 0.005})

if __name__ == "__main__":
    sys.exit(case.main(CASE))
