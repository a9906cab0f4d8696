#!/usr/bin/python3
"""Holds the sweep's runs against beam theory, writes results.md; exit code 0 if the criteria are met."""
import argparse
import sys
from pathlib import Path

CASE = Path(__file__).resolve().parent
sys.path.insert(0, str(CASE.parent))

from lib.beams import Plate, timoshenko_period  # noqa: E402
from lib.richardson import richardson  # noqa: E402
from lib.curves import read_reference  # noqa: E402
from lib.markdown import number, table  # noqa: E402
from lib.run_output import RunError, RunOutput  # noqa: E402
from lib.section import bending_ratio  # noqa: E402
from lib.statics import resting_value  # noqa: E402
from lib.verdict import Verdict  # noqa: E402

PLATE = Plate(0.2, 0.02, 1000.0, 1.4e6, 0.4)
RAMP = 0.65  # s, of the scene


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("folder", type=Path, help="folder of sweep.py's runs")
    options = arguments.parse_args()
    across = sorted(int(f.name.split("_")[1]) for f in options.folder.glob("small_*"))
    try:
        return compare(options.folder, across)
    except RunError as error:
        print(f"Cantilever: cannot compare: {error}", file=sys.stderr)
        return 2


def compare(folder, across):
    reference = read_reference(CASE / "reference.csv")
    verdict = Verdict()
    parts = ["# Cantilever: results\n\nWritten by `validation/cantilever/compare.py`. Displacement of the free end at rest, "
             "mm; *swing* is what still swings around it; *section*: what the layers of particles alone would make of the "
             "linear theory (`lib/section.py`).\n"]
    for k, load in enumerate(reference["case"]):
        beam = reference["reissner_x"][k], reference["reissner_y"][k]
        values, rows = [], []
        for n in across:
            run = RunOutput(folder / f"{load}_{n}")
            x, _ = resting_value(run.time, run.probe("tip.x"), RAMP, timoshenko_period(PLATE))
            y, swing = resting_value(run.time, run.probe("tip.y"), RAMP, timoshenko_period(PLATE))
            values.append((1e3 * x, 1e3 * y))
            soft = 1 / bending_ratio(n, "wendland-c2", 1.2, 0.4) - 1
            rows.append([n, number(1e3 * x, 3), number(1e3 * y, 3), f"{100 * (1e3 * y / beam[1] - 1):+.2f} %",
                         f"{100 * soft:+.2f} %", number(1e3 * swing, 3), number(run.summary["cpu_seconds"], 1)])
        order, limit = richardson([1 / n for n in across], [y for _, y in values])
        order_x, limit_x = richardson([1 / n for n in across], [x for x, _ in values])
        rows.append(["extrapolated", number(limit_x, 3), number(limit, 3),
                     f"{100 * (limit / beam[1] - 1):+.2f} %" if limit else "–", "", "", ""])
        rows.append(["beam (Reissner)", number(beam[0], 3), number(beam[1], 3), "", "", "", ""])
        rows.append(["beam, linear", "", number(reference["linear_y"][k], 3), "", "", "", ""])
        parts.append(f"## {load} load, g = {reference['gravity'][k]:g} m/s²\n\n" +
                     table(["across", "u_x", "u_y", "u_y to Reissner", "section", "swing", "CPU [s]"], rows) +
                     f"\nOrder: {number(order, 2)} in u_y, {number(order_x, 2)} in u_x.\n")
        verdict.limit(f"{load} load: u_y, extrapolated / beam", limit / beam[1] if limit else None, "", 0.98, 1.02)
        verdict.limit(f"{load} load: u_y, finest / beam", values[-1][1] / beam[1], "", 0.97, 1.03)
        verdict.limit(f"{load} load: order in u_y", order, "", low=1.5)
        if load == "large":  # under the small load u_x is 0.03 mm
            verdict.limit(f"{load} load: u_x, extrapolated / beam", limit_x / beam[0] if limit_x else None, "", 0.97, 1.03)
    parts.append("## Criteria\n\n" + table(["", "", "wanted", "verdict"], [
        [what, value, wanted, "pass" if ok else "fail"] for what, value, _, wanted, ok in verdict.rows]))
    text = "\n".join(parts)
    (CASE / "results.md").write_text(text)
    print(text)
    verdict.print_table()
    return verdict.close("Cantilever")


if __name__ == "__main__":
    sys.exit(main())
