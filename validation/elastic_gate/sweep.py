#!/usr/bin/python3
"""The gate at 4, 6 and 8 particles across: tip against experiment, paper and later codes, noise and cost; and at 6 in
both precisions, with one rate for both media and with a rate of its own for each.

Writes results.md beside this file. Runs that are done are not run again.
"""
import argparse
import sys
from pathlib import Path

import numpy as np

CASE = Path(__file__).resolve().parent
sys.path.insert(0, str(CASE.parent))

import compare  # noqa: E402
import measures  # noqa: E402
from lib import runs  # noqa: E402
from lib.curves import faster_than, read_reference, rms  # noqa: E402
from lib.markdown import number, table  # noqa: E402
from lib.run_output import RunOutput  # noqa: E402

THICKNESS = 0.005
ACROSS = (4, 6, 8)
REFERENCE_ACROSS = 6
VARIANTS = [(precision, rate) for precision in ("double", "mixed") for rate in ("single-rate", "multi-rate")]
TIMES = (0.04, 0.08, 0.12, 0.16, 0.20, 0.24, 0.28, 0.32, 0.36)


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("folder", nargs="?", default=runs.ROOT / "results" / "elastic_gate_sweep", type=Path)
    arguments.add_argument("--sluice", default=runs.SLUICE, type=Path, help="the program to run")
    arguments.add_argument("--threads", default="1")
    options = arguments.parse_args()
    reference = read_reference(CASE / "reference.csv")
    results = []
    for across in ACROSS:
        folder = options.folder / f"across_{across}"
        settings = {"method.spacing": f"{THICKNESS / across:.10g}"}
        runs.run(CASE / "scene.toml", folder, settings, options.sluice, ["--threads", options.threads])
        results.append((across, RunOutput(folder)))
    variants = [(precision, rate, RunOutput(variant(options, precision, rate))) for precision, rate in VARIANTS]
    text = report(results, variants, reference)
    (CASE / "results.md").write_text(text)
    print(text)


def variant(options, precision, rate):
    folder = options.folder / f"{precision}_{rate}"
    settings = {"method.precision": precision, "method.time_stepping": rate}
    runs.run(CASE / "scene.toml", folder, settings, options.sluice, ["--threads", options.threads])
    return folder


def report(results, variants, reference):
    mean = compare.experiment_mean(reference)
    parts = ["# Elastic gate: results\n\nWritten by `validation/elastic_gate/sweep.py`. Free end, x away from the tank "
             "and y upwards, in mm.\n"]
    parts.append("## Horizontal displacement\n\n" + curve_table(results, reference, mean, "x"))
    parts.append("## Vertical displacement\n\n" + curve_table(results, reference, mean, "y"))
    parts.append("## Distance to each source, RMS over 0.04 to 0.36 s\n\n" + distance_table(results, reference, mean))
    parts.append("## Run\n\n" + run_table(results))
    parts.append("## Precision and time stepping\n\n"
                 f"At d = s/{REFERENCE_ACROSS}; distances to double precision at one rate, over the whole run.\n\n" +
                 variant_table(variants))
    return "\n".join(parts)


def curve_table(results, reference, mean, component):
    rows = []
    for across, run in results:
        values = 1e3 * np.interp(TIMES, run.time, run.probe(f"free_end.{component}"))
        rows.append([f"sluice, d = s/{across}"] + [number(v, 1) for v in values])
    for name, label in compare.SOURCES:
        if name in ("exp1", "exp2"):
            continue
        column = mean[component] if name == "mean" else reference[f"{name}_{component}"]
        good = np.isfinite(column)
        values = np.interp(TIMES, reference["t_s"][good], column[good], right=np.nan)
        rows.append([label] + [number(v, 1) for v in values])
    return table(["t [s]"] + [f"{t:.2f}" for t in TIMES], rows)


def distance_table(results, reference, mean):
    rows = []
    for across, run in results:
        top, deviation = compare.deviations(run, reference, mean)
        rows.append([f"d = s/{across}", f"{top[1]:.1f} at {top[0]:.3f} s"] +
                    [f"{number(deviation[name][0], 1)} / {number(deviation[name][1], 1)}" for name, _ in compare.SOURCES])
    return table(["x / y [mm]", "peak of x"] + [label for _, label in compare.SOURCES], rows)


def run_table(results):
    rows = []
    for across, run in results:
        frames, s = measures.measure(run), run.summary
        noise = rms(faster_than(run.time, run.probe("gate_pressure.p"), compare.NOISE_PERIOD))
        film = [frames.film_top[int(np.argmin(np.abs(np.array(frames.time) - t)))] -
                np.interp(t, run.time, run.probe("level.level")) for t in (0.2, 0.4)]
        rows.append([f"d = s/{across}", sum(s["particles"][kind] for kind in ("fluid", "solid", "wall")), s["steps"], number(s["cpu_seconds"], 0),
                     number(s["max_speed"], 2), f"{s['momentum_residual']:.0e}", number(noise, 0),
                     number(100 * max(frames.clumped), 2), f"{1e3 * film[0]:+.0f} / {1e3 * film[1]:+.0f}",
                     max(frames.inside), max(frames.behind), sum(frames.tunnelled)])
    return table(["", "particles", "steps", "CPU [s]", "fastest water [m/s]", "momentum residual",
                  "pressure noise at the gate [Pa RMS]", "fluid pairs closer than 0.5 d [%]",
                  "film above the level at 0.2 / 0.4 s [mm]", "inside", "behind", "gone through"], rows)


def variant_table(variants):
    base = variants[0][2]
    rows = []
    for precision, rate, run in variants:
        s = run.summary
        apart = np.hypot(*[np.interp(base.time, run.time, run.probe(f"free_end.{c}")) - base.probe(f"free_end.{c}")
                           for c in "xy"])
        x = run.probe("free_end.x")
        noise = rms(faster_than(run.time, run.probe("gate_pressure.p"), compare.NOISE_PERIOD))
        lost = s["energy"]["initial"]["total"] - s["energy"]["final"]["total"]
        rows.append([f"{precision}, {rate}", s["steps"], s["solid_substeps"], number(s["cpu_seconds"], 1),
                     f"{1e3 * x.max():.2f} at {run.time[x.argmax()]:.3f} s", f"{1e3 * apart.max():.2g}",
                     f"{1e3 * rms(apart):.2g}", f"{s['momentum_residual']:.0e}", number(noise, 0), number(lost, 3)])
    return table(["", "steps", "solid steps in each", "CPU [s]", "peak x [mm]", "tip, largest distance [mm]", "RMS [mm]",
                  "momentum residual", "noise at the gate [Pa RMS]", "energy lost [J/m]"], rows)


if __name__ == "__main__":
    main()
