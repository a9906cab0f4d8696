#!/usr/bin/python3
"""Runs the cantilever under a small and a large load at 5, 7, 10 and 16 particles across; compares with beam theory."""
import sys
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from lib import case, style  # noqa: E402
from lib.beams import Plate, timoshenko_period  # noqa: E402
from lib.case import Errors, Figure, Result, Run, Table  # noqa: E402
from lib.curves import read_reference  # noqa: E402
from lib.markdown import number  # noqa: E402
from lib.richardson import richardson  # noqa: E402
from lib.section import bending_ratio  # noqa: E402
from lib.statics import resting_value  # noqa: E402
from lib.verdict import Verdict  # noqa: E402

PLATE = Plate(0.2, 0.02, 1000.0, 1.4e6, 0.4)
RAMP = 0.65  # s, of the scene
ACROSS = (5, 7, 10, 16)
LOADS = {"small": 1.0, "large": 16.0}  # gravity [m/s²]
QUICK_ACROSS = 5
QUICK_LIMITS = 0.92, 1.08  # u_y over the beam's: at 5 across the root makes it 6 % too large (README)


def plan(quick):
    return [Run(f"{load}_{n}", {"method.spacing": f"{PLATE.height / n:.10g}", "constants.g": LOADS[load]})
            for n in ((QUICK_ACROSS,) if quick else ACROSS) for load in LOADS]


def tip(run):
    """(u_x, u_y, swing of u_y) of the free end at rest [mm]."""
    x, _ = resting_value(run.time, run.probe("tip.x"), RAMP, timoshenko_period(PLATE))
    y, swing = resting_value(run.time, run.probe("tip.y"), RAMP, timoshenko_period(PLATE))
    return 1e3 * x, 1e3 * y, 1e3 * swing


def beams():
    """load -> {reissner_x, reissner_y, linear_y} [mm]"""
    reference = read_reference(FOLDER / "reference.csv")
    return {load: {name: reference[name][k] for name in ("reissner_x", "reissner_y", "linear_y")}
            for k, load in enumerate(reference["case"])}


def study(done):
    across = [QUICK_ACROSS] if done.quick else list(ACROSS)
    found = {load: [tip(done.runs[f"{load}_{n}"]) for n in across] for load in LOADS}
    cpu = {load: [done.runs[f"{load}_{n}"].summary["cpu_seconds"] for n in across] for load in LOADS}
    verdict, exact = Verdict(), beams()
    for load, tips in found.items():
        (judge_quick if done.quick else judge)(verdict, load, across, tips, exact[load])
    off = {load: [abs(y / exact[load]["reissner_y"] - 1) for _, y, _ in tips] for load, tips in found.items()}
    picture = done.folder / "figure.svg"
    draw(done, across, exact, picture)
    return Result(
        verdict, errors=[(f"u_y, {load} load", f"{100 * off[load][-1]:.2f} %") for load in LOADS],
        tables=[load_table(load, across, found[load], cpu[load], exact[load]) for load in LOADS],
        figures=[Figure(picture, "Free end under the small and the large load, against Reissner's beam at rest (dashed). The "
                                 "beam's own error is of the order of 1 % (grey).")],
        convergence=[Errors(f"u_y, {load} load", across, off[load]) for load in LOADS])


def limits(across, tips):
    """(order, extrapolated value) of u_x and of u_y."""
    if len(across) < 3:
        return (None, None), (None, None)
    return tuple(richardson([1 / n for n in across], [t[k] for t in tips]) for k in (0, 1))


def judge(verdict, load, across, tips, beam):
    (_, limit_x), (order, limit) = limits(across, tips)
    verdict.limit(f"{load} load: u_y, extrapolated / beam", limit / beam["reissner_y"] if limit else None, "", 0.98, 1.02)
    verdict.limit(f"{load} load: u_y, finest / beam", tips[-1][1] / beam["reissner_y"], "", 0.97, 1.03)
    verdict.limit(f"{load} load: order in u_y", order, "", low=1.5)
    if load == "large":  # under the small load u_x is 0.03 mm
        verdict.limit(f"{load} load: u_x, extrapolated / beam", limit_x / beam["reissner_x"] if limit_x else None, "",
                      0.97, 1.03)


def judge_quick(verdict, load, across, tips, beam):
    verdict.limit(f"{load} load: u_y / beam, {across[-1]} across", tips[-1][1] / beam["reissner_y"], "",
                  *QUICK_LIMITS)


def load_table(load, across, tips, cpu, beam):
    rows = []
    for n, (x, y, swing), seconds in zip(across, tips, cpu):
        soft = 1 / bending_ratio(n, "wendland-c2", 1.2, PLATE.poisson) - 1
        rows.append([n, number(x, 3), number(y, 3), f"{100 * (y / beam['reissner_y'] - 1):+.2f} %", f"{100 * soft:+.2f} %",
                     number(swing, 3), number(seconds, 1)])
    (order_x, limit_x), (order, limit) = limits(across, tips)
    if len(across) > 2:
        rows.append(["extrapolated", number(limit_x, 3), number(limit, 3),
                     f"{100 * (limit / beam['reissner_y'] - 1):+.2f} %" if limit else "–", "", "", ""])
    rows.append(["beam (Reissner)", number(beam["reissner_x"], 3), number(beam["reissner_y"], 3), "", "", "", ""])
    rows.append(["beam, linear", "", number(beam["linear_y"], 3), "", "", "", ""])
    return Table(f"{load.capitalize()} load, g = {LOADS[load]:g} m/s²",
                 ["across", "u_x [mm]", "u_y [mm]", "u_y to Reissner", "section", "swing [mm]", "CPU [s]"], rows,
                 f"Free end at rest. Order: {number(order, 2)} in u_y, {number(order_x, 2)} in u_x. *Swing*: what still "
                 "swings around rest; *section*: what the layers of particles alone would make of the linear theory "
                 "(`lib/section.py`).")


def draw(done, across, exact, path):
    plt = style.use()
    figure, axes = plt.subplots(2, 1, figsize=(6.3, 4.6), sharex=True, layout="constrained")
    for axis, load in zip(axes, LOADS):
        beam = exact[load]["reissner_y"]
        axis.axhspan(0.99 * beam, 1.01 * beam, color="0.8", linewidth=0)
        axis.axhline(beam, color=style.BLACK, linewidth=0.8, linestyle=(0, (5, 2)))
        for n, colour in zip(across, style.COARSE_TO_FINE[-len(across):]):
            run = done.runs[f"{load}_{n}"]
            axis.plot(run.time, 1e3 * run.probe("tip.y"), color=colour, label=f"{n} across")
        axis.set_ylabel(f"{load} load: u_y [mm]")
        axis.grid(color="0.92", linewidth=0.5)
        axis.set_xlim(0, np.max(run.time))
    axes[0].legend(loc="upper right", fontsize=8)
    axes[1].set_xlabel("time [s]")
    style.save(figure, path)


CASE = case.Case("Cantilever", FOLDER, "the total-Lagrangian solid at rest, small and large load",
                 "Timoshenko and Reissner beams", plan, study)

if __name__ == "__main__":
    sys.exit(case.main(CASE))
