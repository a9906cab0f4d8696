#!/usr/bin/python3
"""The gate with the modern preset at 4, 6 and 8 particles across: does it converge, and where to; pressure noise beside
the paper's scheme.

Writes modern.md and modern.svg beside this file. Runs that are done are not run again.
"""
import argparse
import sys
from pathlib import Path

import numpy as np

CASE = Path(__file__).resolve().parent
sys.path.insert(0, str(CASE.parent))

import compare  # noqa: E402
import figures  # noqa: E402
import sweep  # noqa: E402
from gate_outline import GateOutline  # noqa: E402
from lib import runs  # noqa: E402
from lib.curves import faster_than, peak, read_reference, rms  # noqa: E402
from lib.markdown import number, table  # noqa: E402
from lib.run_output import FLUID, RunOutput  # noqa: E402
from lib.scatter import from_linear  # noqa: E402

ACROSS = (4, 6, 8)
QUIET_FROM = 0.05   # s: before it the pressure is that of the water hammer when the gate is let go
PERIODS = (1e-3, 5e-3)  # s: noise is what a moving average over this leaves
NEAR_GATE = 3e-3    # m: water in front of the gate, where the particles' scatter is measured,
HEIGHTS = (0.015, 0.06)  # m above the floor: neither the jet nor the surface
FIT = 2.5           # d: radius of the fit that stands for a smooth pressure


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("folder", nargs="?", default=runs.ROOT / "results" / "elastic_gate_modern", type=Path)
    arguments.add_argument("--sluice", default=runs.SLUICE, type=Path, help="the program to run")
    arguments.add_argument("--threads", default="1")
    options = arguments.parse_args()
    reference = read_reference(CASE / "reference.csv")
    results = [(across, one(options, "modern", across)) for across in ACROSS]
    paper = [(across, one(options, "scene", across, {"method.precision": "mixed", "method.time_stepping": "multi-rate"}))
             for across in ACROSS]
    text = report(results, paper, reference)
    (CASE / "modern.md").write_text(text)
    figures.draw_displacement([(f"sluice, d = s/{across}", run) for across, run in results], reference,
                              compare.experiment_mean(reference), CASE / "modern.svg")
    print(text)


def one(options, scene, across, more=None):
    folder = options.folder / f"{scene}_{across}"
    settings = {"method.spacing": f"{sweep.THICKNESS / across:.10g}", "output.probe_interval": "0.0002", **(more or {})}
    runs.run(CASE / f"{scene}.toml", folder, settings, options.sluice, ["--threads", options.threads])
    return RunOutput(folder)


def report(results, paper, reference):
    mean = compare.experiment_mean(reference)
    parts = ["# Elastic gate with the modern preset\n\nWritten by `validation/elastic_gate/modern.py`. Free end, x away "
             "from the tank and y upwards, in mm.\n",
             "## Horizontal displacement\n\n" + sweep.curve_table(results, reference, mean, "x"),
             "## Vertical displacement\n\n" + sweep.curve_table(results, reference, mean, "y"),
             "## Distance to each source, RMS over 0.04 to 0.36 s\n\n" + sweep.distance_table(results, reference, mean),
             "## Convergence of the peak\n\n" + convergence(results),
             "## Pressure noise\n\n" + noise_text(results, paper),
             "## Run\n\n" + sweep.run_table(results)]
    return "\n".join(parts)


def convergence(results):
    tops = [(across, *peak(run.time, 1e3 * run.probe("free_end.x"))) for across, run in results]
    text = table(["across", "peak x [mm]", "at [s]"], [[a, number(x, 2), number(t, 3)] for a, t, x in tops])
    heights = [x for _, _, x in tops]
    steps = np.diff(heights)
    text += (f"\nFrom one spacing to the next the peak changes by {steps[0]:+.2f} and {steps[1]:+.2f} mm.\n")
    return text


def noise(run, probe, period):
    late = run.time >= QUIET_FROM
    return rms(faster_than(run.time[late], run.probe(probe)[late], period))


def scatter(run, across):
    """RMS over the particles in front of the gate of p less its local linear fit, its median over the frames [Pa]."""
    first = run.frame_near(0.0)
    outline = GateOutline(first, first.points[:, 1].max())
    found = []
    for frame in run.frames():
        if frame.time < QUIET_FROM:
            continue
        fluid = frame.of(FLUID)
        water = frame.points[fluid]
        residual = from_linear(water, frame["pressure"][fluid], FIT * sweep.THICKNESS / across)
        near = outline.place(frame).near_wet_side(water, NEAR_GATE)
        near &= (water[:, 1] > HEIGHTS[0]) & (water[:, 1] < HEIGHTS[1])
        found.append(rms(residual[near & np.isfinite(residual)]))
    return float(np.median(found))


def noise_text(results, paper):
    rows = []
    for (across, modern), (_, old) in zip(results, paper):
        pairs = [("between particles", scatter(old, across), scatter(modern, across))]
        pairs += [(f"{place}, faster than {1e3 * period:g} ms", noise(old, probe, period), noise(modern, probe, period))
                  for place, probe in (("at the gate", "gate_pressure.p"), ("in the tank", "tank_pressure.p"))
                  for period in PERIODS]
        rows += [[f"d = s/{across}", what, number(a, 1), number(b, 1), f"{a / b:.2f}"] for what, a, b in pairs]
    return (f"From {QUIET_FROM:g} s on. *Between particles*: p less a linear fit to the neighbours within {FIT:g} d, for "
            f"those less than {1e3 * NEAR_GATE:g} mm from the gate, {1e3 * HEIGHTS[0]:g} to {1e3 * HEIGHTS[1]:g} mm "
            "above the floor (RMS, median over the frames). *Faster than*: what a "
            "moving average leaves of a probe's pressure, on the gate's wet face 20 mm above its foot, and at (-10, 20) "
            "mm; a probe is a mean over a kernel.\n\n" +
            table(["", "noise", "paper's scheme [Pa]", "modern [Pa]", "ratio"], rows))


if __name__ == "__main__":
    main()
