#!/usr/bin/python3
"""The gate with the modern preset at 4, 6 and 8 particles across: does it converge, and where to; pressure noise beside
the paper's scheme at 6 across.

Writes modern.md beside this file. Runs that are done are not run again.
"""
import argparse
import sys
from pathlib import Path

import numpy as np

CASE = Path(__file__).resolve().parent
sys.path.insert(0, str(CASE.parent))

import compare  # noqa: E402
import sweep  # noqa: E402
from lib import runs  # noqa: E402
from lib.curves import faster_than, peak, read_reference, rms  # noqa: E402
from lib.markdown import number, table  # noqa: E402
from lib.run_output import RunOutput  # noqa: E402

ACROSS = (4, 6, 8)
QUIET_FROM = 0.05   # s: before it the pressure is that of the water hammer when the gate is let go
PERIODS = (2e-3, 5e-3, 2e-2)  # s: noise is what a moving average over this leaves


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


def noise(run, period, probe="tank_pressure.p"):
    late = run.time >= QUIET_FROM
    return rms(faster_than(run.time[late], run.probe(probe)[late], period))


def noise_text(results, paper):
    rows = []
    for (across, modern), (_, old) in zip(results, paper):
        for period in PERIODS:
            a, b = noise(old, period), noise(modern, period)
            rows.append([f"d = s/{across}", f"{1e3 * period:g}", number(a, 1), number(b, 1), f"{a / b:.1f}"])
    return (f"At (-10, 20) mm, from {QUIET_FROM:g} s on: RMS of what a moving average over some time leaves.\n\n" +
            table(["", "average over [ms]", "paper's scheme [Pa]", "modern [Pa]", "ratio"], rows))


if __name__ == "__main__":
    main()
