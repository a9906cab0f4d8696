#!/usr/bin/python3
"""The gate at 4, 6 and 8 particles across: tip against experiment, paper and later codes, noise and cost; and at 6 in
both precisions, with one rate for both media and with a rate of its own for each.

Writes sweep.md beside this file. Runs that are done are not run again.
"""
import sys
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

import curves  # noqa: E402
import tables  # noqa: E402
from lib import runs  # noqa: E402
from lib.curves import faster_than, rms  # noqa: E402
from lib.markdown import number, table  # noqa: E402
from lib.run_output import RunOutput  # noqa: E402

THICKNESS = 0.005
ACROSS = (4, 6, 8)
REFERENCE_ACROSS = 6
VARIANTS = [(precision, rate) for precision in ("double", "mixed") for rate in ("single-rate", "multi-rate")]


def main():
    options = runs.sweep_parser(__doc__, "elastic_gate_sweep").parse_args()
    reference, mean = curves.published()
    results = []
    for across in ACROSS:
        folder = options.folder / f"across_{across}"
        settings = {"method.spacing": f"{THICKNESS / across:.10g}"}
        runs.run(FOLDER / "scene.toml", folder, settings, options.sluice, ["--threads", options.threads])
        results.append((across, RunOutput(folder)))
    variants = [(precision, rate, RunOutput(variant(options, precision, rate))) for precision, rate in VARIANTS]
    text = report(results, variants, reference, mean)
    (FOLDER / "sweep.md").write_text(text)
    print(text)


def variant(options, precision, rate):
    folder = options.folder / f"{precision}_{rate}"
    settings = {"method.precision": precision, "method.time_stepping": rate}
    runs.run(FOLDER / "scene.toml", folder, settings, options.sluice, ["--threads", options.threads])
    return folder


def report(results, variants, reference, mean):
    parts = ["# Elastic gate: spacing, precision, time stepping\n\nWritten by `validation/elastic_gate/sweep.py`.\n"]
    for t in (tables.curve_table(results, reference, mean, "x"), tables.curve_table(results, reference, mean, "y"),
              tables.distance_table(results, reference, mean), tables.run_table(results)):
        parts.append(f"## {t.title}\n\n{table(t.header, t.rows)}")
    parts.append("## Precision and time stepping\n\n"
                 f"At d = s/{REFERENCE_ACROSS}; distances to double precision at one rate, over the whole run.\n\n" +
                 variant_table(variants))
    return "\n".join(parts)


def variant_table(variants):
    base = variants[0][2]
    rows = []
    for precision, rate, run in variants:
        s = run.summary
        apart = np.hypot(*[np.interp(base.time, run.time, run.probe(f"free_end.{c}")) - base.probe(f"free_end.{c}")
                           for c in "xy"])
        x = run.probe("free_end.x")
        noise = rms(faster_than(run.time, run.probe("gate_pressure.p"), curves.NOISE_PERIOD))
        lost = s["energy"]["initial"]["total"] - s["energy"]["final"]["total"]
        rows.append([f"{precision}, {rate}", s["steps"], s["solid_substeps"], number(s["cpu_seconds"], 1),
                     f"{1e3 * x.max():.2f} at {run.time[x.argmax()]:.3f} s", f"{1e3 * apart.max():.2g}",
                     f"{1e3 * rms(apart):.2g}", f"{s['momentum_residual']:.0e}", number(noise, 0), number(lost, 3)])
    return table(["", "steps", "solid steps in each", "CPU [s]", "peak x [mm]", "tip, largest distance [mm]", "RMS [mm]",
                  "momentum residual", "noise at the gate [Pa RMS]", "energy lost [J/m]"], rows)


if __name__ == "__main__":
    main()
