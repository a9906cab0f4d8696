#!/usr/bin/python3
"""The largest stable method.courant of a total-Lagrangian solid, and the energy's drift below it.

A short plate with rough initial velocities, so that the shortest waves are there from the start; unstable is what ends
in a failure or has ten times its energy after STEPS steps. (Stable runs gain a tenth near the limit and keep it: what
kick-drift-kick keeps differs from the energy by a part (omega dt/2)^2, which is near 1 for the shortest waves.) Writes
results_stability.md beside this file.
"""
import json
import sys
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from lib import runs  # noqa: E402
from lib.beams import Plate, timoshenko_period  # noqa: E402
from lib.markdown import number, table  # noqa: E402
from lib.run_output import RunOutput  # noqa: E402

HEIGHT, ACROSS = 0.02, 8
LENGTH = 0.04          # m, of the short plate
STEPS = 5000           # beyond the limit by 1 %, the shortest waves grow by a quarter per step
SPEED = 0.01           # m/s: strains of 1e-4
PERIODS = 50
KERNELS = ("cubic-spline", "wendland-c2")
SMOOTHING = (1.2, 1.5, 2.0)
# sin of something fast is as good as noise on a lattice; the factors are primes over an irrational.
ROUGH = f'["{SPEED} * sin(7919e2*x*sqrt(2) + 6101e2*y*sqrt(3))", "{SPEED} * sin(5591e2*x*sqrt(5) + 8831e2*y*sqrt(7))"]'
LAW = {"materials.elastic.model": "st-venant-kirchhoff", "method.solid.artificial_viscosity": 0, "output.frame_interval": 0}


def main():
    options = runs.sweep_parser(__doc__, "plate_stability").parse_args()
    parts = ["# Oscillating plate: stability and energy\n\nWritten by `validation/oscillating_plate/stability.py`; Δt = "
             "courant · min(h, 1.2 d)/c with c = √((λ + 2μ)/ρ), ν = 0.4, kick-drift-kick.\n",
             "## Largest stable method.courant\n\nBetween the two numbers: the first ran, the second did not.\n",
             table(["", *(f"h/d = {s}" for s in SMOOTHING)], [[kernel] + [limit(options, kernel, s) for s in SMOOTHING] for kernel in KERNELS]),
             f"## Energy over {PERIODS} periods\n\nSix across, L/H = 10, v_L0 = 0.01 c₀: relative to what was given. *Span*: "
             "largest less smallest. *Drift*: mean over the last five periods less mean over the first five.\n",
             table(["", "h/d", "courant", "span", "drift", "steps"], [drift(options, *case) for case in DRIFTS])]
    text = "\n".join(parts)
    (FOLDER / "results_stability.md").write_text(text)
    print(text)


DRIFTS = [(kernel, s, c) for kernel, s in (("wendland-c2", 1.5),) for c in (0.9, 0.7)]


def limit(options, kernel, smoothing):
    """By bisection to 0.03; method.courant ends at 2."""
    if stable(options, kernel, smoothing, 2.0):
        return "2 or more"
    low, high = 0.5, 2.0
    while high - low > 0.03:
        middle = round(0.5 * (low + high), 3)
        if stable(options, kernel, smoothing, middle):
            low = middle
        else:
            high = middle
    return f"{low:.2f} – {high:.2f}"


def stable(options, kernel, smoothing, courant):
    plate = Plate.with_moduli(LENGTH, HEIGHT, 1000.0, 3.25e6, 0.715e6)
    speed = np.sqrt((3.25e6 + 4 / 3 * 0.715e6) / plate.density)
    end = STEPS * courant * smoothing * HEIGHT / ACROSS / speed
    settings = {**LAW, "method.smoothing_function": kernel, "method.smoothing_length": smoothing, "method.courant": courant,
                "method.spacing": HEIGHT / ACROSS, "bodies.plate.shape.box.max": f"[{LENGTH}, {HEIGHT / 2}]",
                "probes.free_end.at": f"[{LENGTH}, 0]", "bodies.plate.velocity": ROUGH, "output.end": f"{end:.4g}",
                "output.probe_interval": f"{end / 50:.4g}"}
    folder = options.folder / f"{kernel}_{smoothing}_{courant}"
    runs.run(FOLDER / "scene.toml", folder, settings, options.sluice, ["--threads", options.threads])
    summary = json.loads((folder / "summary.json").read_text())
    if summary["status"] != "done":
        return False
    return summary["energy"]["final"]["total"] < 10 * summary["energy"]["initial"]["total"]


def drift(options, kernel, smoothing, courant):
    plate = Plate.with_moduli(10 * HEIGHT, HEIGHT, 1000.0, 3.25e6, 0.715e6)
    period = 1.1 * timoshenko_period(plate)  # six across, the plate is softer than theory
    settings = {**LAW, "method.smoothing_function": kernel, "method.smoothing_length": smoothing, "method.courant": courant,
                "method.spacing": f"{HEIGHT / 6:.10g}", "output.end": f"{PERIODS * period:.4g}",
                "output.probe_interval": f"{period / 50:.4g}"}
    folder = options.folder / f"energy_{kernel}_{smoothing}_{courant}"
    runs.run(FOLDER / "scene.toml", folder, settings, options.sluice, ["--threads", options.threads])
    run = RunOutput(folder)
    total = run.probe("energy.total") / run.probe("energy.total")[0] - 1
    early, late = total[run.time < 5 * period].mean(), total[run.time > run.time[-1] - 5 * period].mean()
    return [kernel, smoothing, courant, f"{total.max() - total.min():.1e}", f"{late - early:+.1e}", number(run.summary["steps"], 0)]


if __name__ == "__main__":
    main()
