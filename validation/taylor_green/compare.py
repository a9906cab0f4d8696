#!/usr/bin/python3
"""Runs the Taylor-Green vortices at three spacings and compares with the solution of the Navier-Stokes equations."""
import sys
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from lib import case, convergence, style  # noqa: E402
from lib.verdict import Verdict  # noqa: E402

U, K, NU, DENSITY = 1.0, 2 * np.pi, 0.01, 1.0


def decay(t):
    """Of the velocity."""
    return np.exp(-2 * NU * K ** 2 * t)


def velocity(points, t):
    x, y = K * points.T
    return U * decay(t) * np.stack([-np.cos(x) * np.sin(y), np.sin(x) * np.cos(y)], axis=1)


def pressure(points, t):
    x, y = K * points.T
    return -0.25 * DENSITY * (U * decay(t)) ** 2 * (np.cos(2 * x) + np.cos(2 * y))


def measure(run):
    """At the end: L2 errors, each over the exact field's own norm; pressures without their means."""
    frame = list(run.frames())[-1]
    exact = velocity(frame.points, frame.time)
    error = np.asarray(frame["velocity"], dtype=float)[:, :2] - exact
    p, exact_p = np.asarray(frame["pressure"], dtype=float), pressure(frame.points, frame.time)
    energy = run.probe("energy.kinetic")
    t = run.time[-1]
    rate = -np.log(energy[-1] / energy[0]) / t
    return {
        "velocity, L2": np.sqrt((error ** 2).sum() / (exact ** 2).sum()),
        "decay rate of the energy": abs(rate / (4 * NU * K ** 2) - 1),
        "rate / exact": rate / (4 * NU * K ** 2),
        "E / exact": energy[-1] / (energy[0] * decay(t) ** 2),
        "pressure noise / exact RMS": np.std(p - exact_p) / np.std(exact_p),
        "mean p [Pa]": p.mean(),
    }


def judge(study):
    verdict = Verdict()
    verdict.limit("L2 error of the velocity, finest", 100 * study.finest["velocity, L2"], "%", high=2)
    verdict.limit("decay rate of the energy, finest: off by", 100 * study.finest["decay rate of the energy"], "%", high=2)
    study.require_order(verdict, "velocity, L2")
    return verdict


def draw(study, path):
    plt = style.use()
    figure, (left, right) = plt.subplots(1, 2, figsize=(7.2, 3.4), layout="constrained", width_ratios=(1.3, 1))
    t = study.runs[-1].time
    left.semilogy(t, 0.25 * DENSITY * U ** 2 * decay(t) ** 2, color=style.BLACK, linewidth=2.4, label="exact")
    for run, count, colour in zip(study.runs, study.counts, (style.ORANGE, style.SKY, style.BLUE)):
        left.semilogy(run.time, run.probe("energy.kinetic"), color=colour, label=f"L/d = {count}")
    left.set_xlabel("time [s]")
    left.set_ylabel("kinetic energy [J/m]")
    left.legend()
    frame = list(study.runs[-1].frames())[-1]
    p = np.asarray(frame["pressure"], dtype=float)
    limit = np.abs(pressure(frame.points, frame.time)).max()
    dots = right.scatter(*frame.points.T, c=p - p.mean(), s=0.6, linewidths=0, cmap=style.SIGNED, vmin=-limit, vmax=limit)
    right.set(aspect="equal", xlim=(0, 1), ylim=(0, 1), xticks=(0, 1), yticks=(0, 1),
              title=f"p − mean [Pa], L/d = {study.counts[-1]}")
    figure.colorbar(dots, ax=right, shrink=0.7)
    style.save(figure, path)


CASE = convergence.Case(
    "Taylor-Green vortices", FOLDER, "the fluid without walls: viscosity, shifting, pressure", "the solution of the Navier–Stokes equations",
    across=("L/d", 1.0), counts=(50, 100, 200),
    errors=("velocity, L2", "decay rate of the energy"),
    others=(("E / exact", 4), ("pressure noise / exact RMS", 3), ("mean p [Pa]", 2)),
    measure=measure, judge=judge, draw=draw,
    caption="Left: decay of the kinetic energy against the exact one. Right: pressure at the end with the finest spacing.",
    quick_counts=(50, 100), quick_limits={"velocity, L2": 0.01, "decay rate of the energy": 0.01})

if __name__ == "__main__":
    sys.exit(case.main(CASE))
