#!/usr/bin/python3
"""The sensitivities of the paper's section 2.4: spacing, artificial stress e, artificial viscosity alpha, filter theta.

Writes sensitivity.md beside this file. Runs that are done are not run again.
"""
import sys
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from lib import runs  # noqa: E402
from lib.curves import read_reference  # noqa: E402
from lib.markdown import number, table  # noqa: E402
from lib.run_output import RunOutput  # noqa: E402
from oscillation import first_oscillation  # noqa: E402

HEIGHT = 0.02
SPACING, STRESS, VISCOSITY, FILTER, SMOOTHING = (
    "method.spacing", "method.solid.artificial_stress", "method.solid.artificial_viscosity",
    "method.solid.velocity_filter", "method.smoothing_length")
SHORT = {STRESS: "e", VISCOSITY: "alpha", FILTER: "theta", SMOOTHING: "h/d"}
GROUPS = (
    ("Spacing (alpha = 0.1, e = 0.3, h = 1.5 d)", [(6, {}), (10, {}), (20, {})]),
    ("Artificial stress", [(10, {STRESS: e}) for e in (0, 0.1, 0.3, 0.5)]),
    ("Artificial viscosity, e = 0.3", [(10, {VISCOSITY: a}) for a in (0.01, 0.03, 0.05, 0.1, 0.5, 1.0)]),
    ("Little artificial viscosity with less artificial stress",
     [(10, {VISCOSITY: 0.01, STRESS: e}) for e in (0, 0.1, 0.2)]),
    ("Velocity filter, applied to the solid", [(10, {FILTER: t}) for t in (1.0, 0.999, 0.99, 0.92)]),
    ("Smoothing length", [(10, {SMOOTHING: h}) for h in (1.2, 1.5, 1.8)]),
    ("As in the gate: alpha = 1, e = 0.3", [(n, {VISCOSITY: 1.0}) for n in (6, 10, 20)]),
)


def main():
    options = runs.sweep_parser(__doc__, "oscillating_plate_sensitivity").parse_args()
    reference = read_reference(FOLDER / "reference.csv")
    parts = ["# Oscillating plate: sensitivities\n\nWritten by `validation/oscillating_plate/sensitivity.py`. First oscillation "
             "of the free end; the paper does not say which spacing and which h its values belong to. With e = 0.3 and "
             "hardly any artificial viscosity the plate's root breaks up, at the same time for any time step (Courant "
             "0.9, 0.6, 0.3): the artificial stress drives short waves that only viscosity damps.\n"]
    for title, cases in GROUPS:
        rows = [row(options, across, changes) for across, changes in cases]
        rows += [[name, "", number(a, 4), "", number(t, 2), ""]
                 for name, a, t in zip(reference["source"], reference["amplitude"], reference["period"])]
        parts.append(f"## {title}\n\n" + table(["", "across", "A/L", "first trough /L", "T c0/L", "CPU [s]"], rows))
    text = "\n".join(parts)
    (FOLDER / "sensitivity.md").write_text(text)
    print(text)


def row(options, across, changes):
    label = ", ".join(f"{SHORT[key]} = {value}" for key, value in changes.items()) or "as in the scene"
    name = "_".join([f"across_{across}"] + [f"{SHORT[k].replace('/', '')}_{v}" for k, v in changes.items()])
    settings = {SPACING: f"{HEIGHT / across:.10g}", **changes, "output.frame_interval": 0}
    folder = options.folder / name
    runs.run(FOLDER / "scene.toml", folder, settings, options.sluice, ["--threads", options.threads])
    run = RunOutput(folder)
    if run.summary["status"] != "done":
        return [label, across, f"breaks down at t = {run.summary['simulated_time']:.3f} s", "–", "–", "–"]
    first = first_oscillation(run)
    return [label, across, number(first["amplitude"], 4), number(first["trough"], 4), number(first["period"], 2),
            number(run.summary["cpu_seconds"], 1)]


if __name__ == "__main__":
    main()
