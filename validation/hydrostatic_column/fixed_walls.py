#!/usr/bin/python3
"""Runs the hydrostatic column between fixed walls at three spacings: pressure, rest and level over 10 s."""
import sys
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER.parent), str(FOLDER)]

import compare  # noqa: E402
from lib import case, convergence  # noqa: E402


def measure(run):
    """And the pressure of the lowest layer, over that of its depth: what the floor's ghosts make of gravity."""
    y, p = compare.profile(run)
    frame = list(run.frames())[-1]
    spacing = np.sqrt(compare.DEPTH * compare.WIDTH / frame.of(compare.FLUID).sum())
    low = y < spacing
    values = compare.measure(run)
    values["lowest layer"] = abs(np.mean(p[low] / (compare.DENSITY * compare.G * (compare.DEPTH - y[low]))) - 1)
    return values


CASE = convergence.Case(
    "Hydrostatic column between fixed walls", FOLDER, "fixed ghosts hold water at rest, with its pressure", "p = ρ g (H − y)",
    across=compare.CASE.across, counts=compare.CASE.counts, errors=("floor pressure", "pressure, L2", "level", "lowest layer"),
    others=compare.CASE.others, measure=measure, judge=compare.judge, draw=compare.draw, caption=compare.CASE.caption,
    quick_counts=(20,), quick_limits={"pressure, L2": 0.01, "level": 0.015, "lowest layer": 0.02, "log10, last 5 s": -5},
    part="fixed_walls", scene="fixed_walls.toml")

if __name__ == "__main__":
    sys.exit(case.main(CASE))
