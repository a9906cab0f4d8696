#!/usr/bin/python3
"""Runs the plate under water at 4, 6 and 8 particles across: sag, load, level, rest."""
import sys
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from lib import case, convergence, style  # noqa: E402
from lib.run_output import FLUID  # noqa: E402
from lib.verdict import Verdict  # noqa: E402

G, DENSITY = 9.81, 1000.0
PLATE = 2700.0 * G * 0.05       # its own weight, over 1 m [N/m]
SAG = 0.07065e-3 / (DENSITY * G * 2.0 + PLATE)  # m per N/m, finite_elements.py
THIN_PLATE = 0.9710             # of that: q L^4/(384 D), without shear, what others compare with
SHALLOW = 0.2                   # m, of the quick form: there the pressure changes by 8 % over one spacing


def depth_of(run):
    return round(run.probe("level.level")[0], 1)  # 2 m, or 0.2 m; the probe reads half a percent too much


def load_of(run):
    """The water's weight, over 1 m [N/m]."""
    return DENSITY * G * depth_of(run)


def lowest_pressure(run):
    """Of the water's lowest layer, over that of its depth; mean of the frames in the run's second half."""
    found, depth = [], depth_of(run)
    for frame in run.frames():
        if frame.time < 0.5 * run.time[-1]:
            continue
        fluid = frame.of(FLUID)
        y, p = frame.points[fluid, 1], np.asarray(frame["pressure"], dtype=float)[fluid]
        low = y < np.sqrt(depth / len(y))  # one spacing
        found.append(np.mean(p[low] / (DENSITY * G * (depth - y[low]))))
    return np.mean(found)


def measure(run):
    # Over whole periods of the column, 4 H/c0.
    use, exact = run.time >= 0.4 * run.time[-1], SAG * (load_of(run) + PLATE)
    sag, load = -run.probe("middle.y")[use], -run.probe("load.y")[use]
    borne = sag.mean() / (SAG * (load.mean() + PLATE))
    return {
        "sag": abs(sag.mean() / exact - 1),
        "sag under its load": abs(borne - 1),
        "load": abs(load.mean() / load_of(run) - 1),
        "sag [mm]": 1e3 * sag.mean(),
        "sag / exact": sag.mean() / exact,
        "sag / thin plate": sag.mean() / (THIN_PLATE * exact),
        "load, RMS of what swings [%]": 100 * load.std() / load_of(run),
        "pressure at the plate / ρ g h": lowest_pressure(run),
        "level [m]": run.probe("level.level")[use].mean(),
        "fastest [mm/s]": 1e3 * run.summary["max_speed"],
    }


def judge(study):
    verdict = Verdict()
    verdict.limit("sag, finest: off by", 100 * study.finest["sag"], "%", high=3)
    verdict.limit("load, finest: off by", 100 * study.finest["load"], "%", high=1)
    verdict.limit("pressure at the plate / ρ g h, finest", study.finest["pressure at the plate / ρ g h"], "", 0.98, 1.02)
    study.require_order(verdict, "sag under its load")
    return verdict


def judge_quick(study):
    verdict = Verdict()
    # 1.015 is what the same plate has under its own weight alone.
    verdict.limit("sag / plane elasticity, H/d = 3", study.finest["sag / exact"], "", 0.99, 1.04)
    verdict.limit("load, H/d = 3: off by", 100 * study.finest["load"], "%", high=2)
    verdict.limit("pressure at the plate / ρ g h, H/d = 3", study.finest["pressure at the plate / ρ g h"], "", 0.97, 1.03)
    return verdict


def draw(study, path):
    plt = style.use()
    figure, (top, bottom) = plt.subplots(2, 1, figsize=(6.3, 4.6), sharex=True, layout="constrained")
    for run, count, colour in zip(study.runs, study.counts, style.COARSE_TO_FINE[-len(study.runs):]):
        top.plot(run.time, 1e3 * run.probe("middle.y"), color=colour, linewidth=0.8, label=f"{count} across")
        bottom.plot(run.time, -1e-3 * run.probe("load.y"), color=colour, linewidth=0.8)
    weight = load_of(study.runs[-1])
    top.axhline(-1e3 * SAG * (weight + PLATE), color=style.BLACK, linewidth=0.8, linestyle=(0, (5, 2)), label="plane elasticity")
    bottom.axhline(1e-3 * weight, color=style.BLACK, linewidth=0.8, linestyle=(0, (5, 2)))
    bottom.set_ylim(0.9e-3 * weight, 1.1e-3 * weight)
    top.set_ylabel("middle, y [mm]")
    bottom.set_ylabel("load [kN/m]")
    bottom.set_xlabel("time [s]")
    top.legend(fontsize=8)
    for axis in (top, bottom):
        axis.grid(color="0.92", linewidth=0.5)
    style.save(figure, path)


CASE = convergence.Case(
    "Water on an elastic plate", FOLDER, "coupling at rest: load, sag, and the pressure of water beside an elastic floor",
    "Fourey et al. 2017; plane elasticity",
    across=("H/d", 0.05), counts=(4, 6, 8), errors=("sag", "sag under its load", "load"),
    others=(("sag [mm]", 5), ("sag / thin plate", 3), ("load, RMS of what swings [%]", 2),
            ("pressure at the plate / ρ g h", 4), ("level [m]", 4), ("fastest [mm/s]", 1)),
    measure=measure, judge=judge, draw=draw,
    caption="The plate's middle and the water's load on it, from water put at once on a flat plate; dashed: at rest.",
    quick_counts=(3,), judge_quick=judge_quick, quick_settings={
        "bodies.water.shape": f"{{box = {{min = [0.0, 0.0], max = [1.0, {SHALLOW}]}}}}",
        "bodies.water.hydrostatic_surface": SHALLOW, "output.end": 0.1, "output.frame_interval": 0.01})

if __name__ == "__main__":
    sys.exit(case.main(CASE))
