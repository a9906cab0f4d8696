#!/usr/bin/python3
"""Runs the colliding rings at two spacings: rebound, energy, momentum, how far the rings enter each other."""
import sys
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from lib import runs  # noqa: E402
from lib.run_output import SOLID, RunOutput  # noqa: E402
from lib.verdict import Verdict  # noqa: E402

SPACINGS = (0.001, 0.0005)  # [m]
SPEED = 5.07  # of each ring [m/s]
MASS = 1010.0 * np.pi * (0.04 ** 2 - 0.03 ** 2)  # of one ring [kg/m]


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


def measure(spacing):
    folder = FOLDER / "results" / f"{spacing:g}"
    runs.run(FOLDER / "scene.toml", folder, {"method.spacing": spacing})
    output = RunOutput(folder)
    energy, momentum = output.probe("energy.total"), output.probe("momentum.x")
    frames = list(output.frames())
    return {
        "rebound": -ring_velocity(frames[-1], 0) / SPEED,
        "energy": np.abs(energy / energy[0] - 1).max(),
        "contact": (output.probe("energy.contact") / energy[0]).max(),
        "momentum": np.abs(momentum).max() / (MASS * SPEED),
        "gap": min(smallest_gap(frame) for frame in frames) / spacing,
    }


def main():
    verdict = Verdict()
    measured = [measure(spacing) for spacing in SPACINGS]
    for spacing, m in zip(SPACINGS, measured):
        at = f", d = {1e3 * spacing:g} mm"
        verdict.limit("speed of rebound over that before" + at, m["rebound"], "", low=0.3, high=1)
        verdict.limit("worst change of energy" + at, m["energy"], "", high=0.005)
        verdict.limit("worst momentum over one ring's" + at, m["momentum"], "", high=1e-12)
        verdict.limit("smallest gap between particles over d" + at, m["gap"], "", low=0.5)
        print(f"largest energy of contact{at}: {m['contact']:.3g} of all")
    verdict.limit("difference of the rebounds", abs(measured[0]["rebound"] - measured[1]["rebound"]), "", high=0.05)
    verdict.print_table()
    return verdict.close("colliding rings")


if __name__ == "__main__":
    sys.exit(main())
