#!/usr/bin/python3
"""Runs the colliding rings at two spacings: rebound, energy, momentum, how far the rings enter each other."""
import sys
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from lib import case, style  # noqa: E402
from lib.case import Figure, Result, Run, Table  # noqa: E402
from lib.markdown import number  # noqa: E402
from lib.run_output import SOLID  # noqa: E402
from lib.verdict import Verdict  # noqa: E402

SPACINGS = {10: 0.001, 20: 0.0005}  # by particles across a ring [m]
QUICK = {5: 0.002}
SPEED = 5.07  # of each ring [m/s]
MASS = 1010.0 * np.pi * (0.04 ** 2 - 0.03 ** 2)  # of one ring [kg/m]
PARTS = (("total", style.BLACK), ("kinetic", style.BLUE), ("elastic", style.ORANGE), ("contact", style.VERMILION))
MOMENTS = (0.0, 0.004, 0.008, 0.012)  # s, of the picture


def plan(quick):
    return [Run(f"across_{n}", {"method.spacing": d}) for n, d in (QUICK if quick else SPACINGS).items()]


def ring_velocity(frame, ring):
    """Mean velocity along x; all particles of a ring have one mass."""
    mask = frame.of(SOLID) & (frame["body"].astype(int) == ring)
    return float(np.asarray(frame["velocity"], dtype=float)[mask, 0].mean())


def smallest_gap(frame):
    """Between particles of the two rings, near the line of impact."""
    body = frame["body"].astype(int)
    left, right = (frame.points[(body == ring) & (np.abs(frame.points[:, 0]) < 0.01)] for ring in (0, 1))
    if len(left) == 0 or len(right) == 0:
        return np.inf
    return float(np.sqrt(((left[:, None] - right[None]) ** 2).sum(axis=2).min()))


def measure(output, spacing):
    energy, momentum = output.probe("energy.total"), output.probe("momentum.x")
    frames = list(output.frames())
    return {
        "rebound": -ring_velocity(frames[-1], 0) / SPEED,
        "energy": np.abs(energy / energy[0] - 1).max(),
        "contact": (output.probe("energy.contact") / energy[0]).max(),
        "momentum": np.abs(momentum).max() / (MASS * SPEED),
        "gap": min(smallest_gap(frame) for frame in frames) / spacing,
        "CPU [s]": output.summary["cpu_seconds"],
    }


def study(done):
    spacings = QUICK if done.quick else SPACINGS
    measured = {n: measure(run, d) for (n, d), run in zip(spacings.items(), done.runs.values())}
    finest = measured[max(measured)]
    picture, curves = done.folder / "figure.svg", done.folder / "energy.svg"
    draw_rings(list(done.runs.values())[-1], max(measured), picture)
    draw_energy(dict(zip(measured, done.runs.values())), curves)
    rows = [[n, number(m["rebound"], 3), f"{100 * m['energy']:.2f} %", f"{m['momentum']:.0e}", f"{m['gap']:.2f} d",
             f"{100 * m['contact']:.1f} %", number(m["CPU [s]"], 1)] for n, m in measured.items()]
    return Result(
        judge(measured, done.quick),
        errors=[("energy, worst step", f"{100 * finest['energy']:.2f} %"),
                ("momentum, of one ring's", f"{finest['momentum']:.0e}")],
        tables=[Table("Collision", ["across", "rebound, of the speed before", "worst change of energy", "momentum, of one ring's",
                                    "smallest gap", "largest energy of contact", "CPU [s]"], rows)],
        figures=[Figure(picture, "Before, in and after the collision; colour: von Mises stress."),
                 Figure(curves, "Energies over the total at the start. There is no published figure to compare with; the "
                                "total must stay at 1.")])


def judge(measured, quick):
    verdict = Verdict()
    for n, m in measured.items():
        at = f", {n} across"
        verdict.limit("speed of rebound over that before" + at, m["rebound"], "", low=0.3, high=1)
        verdict.limit("worst change of energy" + at, m["energy"], "", high=0.005)
        verdict.limit("worst momentum over one ring's" + at, m["momentum"], "", high=1e-12)
        verdict.limit("smallest gap between particles over d" + at, m["gap"], "", low=0.5)
    if not quick:
        coarse, fine = (m["rebound"] for m in measured.values())
        verdict.limit("difference of the rebounds", abs(coarse - fine), "", high=0.05)
    return verdict


def draw_rings(run, across, path):
    plt = style.use()
    figure, axes = plt.subplots(1, len(MOMENTS), figsize=(8.4, 2.6), sharey=True, layout="constrained")
    frames = [run.frame_near(t) for t in MOMENTS]
    top = 1e-3 * max(np.percentile(frame["von_mises"], 99) for frame in frames)
    for axis, frame in zip(axes, frames):
        x, y = 1e3 * frame.points.T
        axis.set(aspect="equal", xlim=(-105, 105), ylim=(-60, 60), xlabel="x [mm]")
        axis.set_title(f"t = {1e3 * frame.time:.0f} ms", loc="left")
        dots = axis.scatter(x, y, c=1e-3 * frame["von_mises"], s=0.8 * (20 / across) ** 2, linewidths=0, cmap=style.RUBBER,
                            vmin=0, vmax=top)
    axes[0].set_ylabel("y [mm]")
    figure.colorbar(dots, ax=axes, shrink=0.8, label="von Mises stress [kPa]", extend="max")
    style.save(figure, path)


def draw_energy(runs, path):
    plt = style.use()
    figure, axis = plt.subplots(figsize=(6.3, 3.0), layout="constrained")
    dashes = dict(zip(runs, ((0, (2, 1.5)), "solid")[-len(runs):]))
    for n, run in runs.items():
        first = run.probe("energy.total")[0]
        for part, colour in PARTS:
            axis.plot(1e3 * run.time, run.probe(f"energy.{part}") / first, color=colour, linestyle=dashes[n],
                      label=f"{part}, {n} across")
    axis.set(xlabel="time [ms]", ylabel="energy / total at the start", xlim=(0, None))
    axis.grid(color="0.92", linewidth=0.5)
    axis.legend(ncol=2, fontsize=7.5)
    style.save(figure, path)


CASE = case.Case("Colliding rings", FOLDER, "contact of total-Lagrangian solids", "conservation; Gray, Monaghan & Swift 2001",
                 plan, study)

if __name__ == "__main__":
    sys.exit(case.main(CASE))
