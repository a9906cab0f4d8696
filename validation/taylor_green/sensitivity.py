#!/usr/bin/python3
"""What the Taylor-Green vortices owe to smoothing function and length, particle shifting and the other effects.

Writes sensitivity.md beside this file. Runs that are done are not run again.
"""
import json
import sys
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from compare import CASE  # noqa: E402
from lib import convergence, runs  # noqa: E402
from lib.markdown import number, table  # noqa: E402

FUNCTION, LENGTH, SHIFT, COURANT, FORM = (
    "method.smoothing_function", "method.smoothing_length", "method.fluid.particle_shifting", "method.courant",
    "method.fluid.viscous_form")
SHORT = {FUNCTION: "", LENGTH: "h/d", SHIFT: "A", COURANT: "Courant", FORM: ""}
ALL, COARSE = CASE.counts, CASE.counts[:2]
QUARTER = 0.225  # of the scene's 0.9: four steps between two shifts then last as long as one did

GROUPS = (
    ("Smoothing function, h/d and shifting",
     [(ALL, {FUNCTION: f, LENGTH: h, SHIFT: a}) for f in ("wendland-c2", "quintic-spline") for h in (1.5, 2)
      for a in (2, 8, 16)]),
    ("Steps of a quarter, so that the particles are shifted four times as often by a quarter",
     [(ALL if (h, a) == (1.5, 8) else COARSE, {LENGTH: h, SHIFT: a, COURANT: QUARTER}) for h in (1.5, 2) for a in (2, 4, 8, 16)]),
    ("Effects switched off, and other choices",
     [(COARSE, change) for change in (
         {"effects.particle_shifting": "off"}, {"effects.density_diffusion": "off"},
         {"effects.acoustic_damping": "off"}, {"effects.laminar_viscosity": "off"}, {FORM: "monaghan-gingold"},
         {"materials.water.sound_speed": 20})]),
)


def main():
    parser = runs.sweep_parser(__doc__, "taylor_green_sensitivity")
    parser.add_argument("--no-runs", action="store_true", help="take what is done, and leave the rest open")
    options = parser.parse_args()
    parts = ["# Taylor-Green vortices: sensitivities\n\nWritten by `validation/taylor_green/sensitivity.py`. Per L/d: L2 error of "
             "the velocity in percent, rate of decay of the kinetic energy over the exact one, and last the error of the "
             "pressure (without its mean) over the pressure's own RMS. A dash: not run.\n"]
    for title, cases in GROUPS:
        header = [""] + [f"{what} {n}" for n in ALL for what in ("L2 [%]", "rate", "p")] + ["CPU [s]"]
        parts.append(f"## {title}\n\n" + table(header, [row(options, counts, changes) for counts, changes in cases]))
    text = "\n".join(parts)
    (FOLDER / "sensitivity.md").write_text(text)
    print(text)


def row(options, counts, changes):
    label = ", ".join(name(key, value) for key, value in changes.items())
    folder = options.folder / label.replace(" ", "").replace(",", "_").replace("/", "")
    wanted = counts
    if options.no_runs:
        counts = [count for count in counts if done(folder / f"across_{count}")]
    study = convergence.study_of(CASE, folder, changes, options, counts) if counts else None
    cells = [label]
    for value in study.values if study else ():
        cells += [convergence.percent(value["velocity, L2"]), number(value["rate / exact"], 3),
                  number(value["pressure noise / exact RMS"], 2)]
    cells += ["–"] * (3 * (len(ALL) - len(counts)))
    complete = study and len(counts) == len(wanted)
    return cells + [number(sum(value["CPU [s]"] for value in study.values), 1) if complete else "–"]


def done(folder):
    summary = folder / "summary.json"
    return summary.exists() and json.loads(summary.read_text())["status"] == "done"


def name(key, value):
    return f"{SHORT.get(key, key.split('.')[-1])} {value}".strip()


if __name__ == "__main__":
    main()
