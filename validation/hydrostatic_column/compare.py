#!/usr/bin/python3
"""Runs the hydrostatic column at three spacings: pressure, rest and level over 10 s."""
import sys
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from lib import case, convergence, style  # noqa: E402
from lib.run_output import FLUID  # noqa: E402
from lib.verdict import Verdict  # noqa: E402

G, DEPTH, WIDTH, DENSITY = 9.81, 0.5, 0.25, 1000.0
FLOOR_PRESSURE = DENSITY * G * DEPTH
POTENTIAL = 0.5 * DENSITY * G * DEPTH ** 2 * WIDTH  # above the floor [J/m]
LAST = 5.0  # s: means are taken from here to the end


def profile(run):
    """Heights and pressures of all particles in the frames from LAST on."""
    frames = [frame for frame in run.frames() if frame.time >= LAST - 1e-9]
    fluid = [frame.of(FLUID) for frame in frames]
    return (np.concatenate([frame.points[mask, 1] for frame, mask in zip(frames, fluid)]),
            np.concatenate([np.asarray(frame["pressure"], dtype=float)[mask] for frame, mask in zip(frames, fluid)]))


def measure(run):
    """The floor's pressure is the profile's linear fit at y = 0: a probe there is the mean over a one-sided support."""
    y, p = profile(run)
    slope, at_floor = np.polyfit(y, p, 1)
    exact = DENSITY * G * (DEPTH - y)
    energy, t = run.probe("energy.kinetic"), run.time
    level = run.probe("level.level")
    late = t >= LAST
    return {
        "floor pressure": abs(at_floor / FLOOR_PRESSURE - 1),
        "pressure, L2": np.sqrt(((p - exact) ** 2).mean()) / FLOOR_PRESSURE,
        "level": np.abs(level[late] - DEPTH).max() / DEPTH,
        "floor p / exact": at_floor / FLOOR_PRESSURE,
        "slope / exact": -slope / (DENSITY * G),
        "highest E / E pot": energy.max() / POTENTIAL,
        "log10 of it": np.log10(energy.max() / POTENTIAL),
        "log10, last 5 s": np.log10(energy[late].max() / POTENTIAL),
        "fastest [mm/s]": 1e3 * run.summary["max_speed"],
    }


def judge(study):
    verdict = Verdict()
    verdict.limit("pressure at the floor, finest: off by", 100 * study.finest["floor pressure"], "%", high=1)
    verdict.limit("pressure, L2 error, finest", 100 * study.finest["pressure, L2"], "%", high=1)
    verdict.limit("level, worst of the last 5 s, finest", 100 * study.finest["level"], "%", high=1)
    verdict.limit("log10 of E kin / E pot, last 5 s, finest", study.finest["log10, last 5 s"], "", high=-6)
    study.require_order(verdict, "pressure, L2")
    return verdict


def draw(study, path):
    plt = style.use()
    figure, (left, right) = plt.subplots(1, 2, figsize=(7.2, 3.2), layout="constrained", width_ratios=(1.4, 1))
    for run, count, colour in zip(study.runs, study.counts, (style.ORANGE, style.SKY, style.BLUE)):
        energy = run.probe("energy.kinetic")
        left.semilogy(run.time[energy > 0], energy[energy > 0] / POTENTIAL, color=colour, linewidth=0.8,
                      label=f"H/d = {count}")
        y, p = profile(run)
        right.plot((p - DENSITY * G * (DEPTH - y)) / FLOOR_PRESSURE * 100, y, ".", markersize=1, color=colour)
    left.set_xlabel("time [s]")
    left.set_ylabel("kinetic energy / potential energy")
    left.legend()
    right.set_xlabel("p − ρ g (H − y) [% of the floor's]")
    right.set_ylabel("y [m]")
    style.save(figure, path)


CASE = convergence.Case(
    "Hydrostatic column", FOLDER, "water at rest stays at rest, with its pressure", "p = ρ g (H − y)",
    across=("H/d", DEPTH), counts=(20, 40, 80),
    errors=("floor pressure", "pressure, L2", "level"),
    others=(("floor p / exact", 4), ("slope / exact", 4), ("log10 of it", 1), ("log10, last 5 s", 1), ("fastest [mm/s]", 1)),
    measure=measure, judge=judge, draw=draw,
    caption="Left: kinetic energy over the potential energy above the floor. Right: error of the pressure in the last five seconds.",
    quick_counts=(20,), quick_limits={"pressure, L2": 0.01, "level": 0.01, "log10, last 5 s": -5.5})

if __name__ == "__main__":
    sys.exit(case.main(CASE))
