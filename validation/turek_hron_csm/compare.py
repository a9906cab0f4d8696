#!/usr/bin/python3
"""Holds the sweep's runs against the published values, writes results.md; exit code 0 if the criteria are met."""
import argparse
import sys
from pathlib import Path

import numpy as np

CASE = Path(__file__).resolve().parent
sys.path.insert(0, str(CASE.parent))

from lib import style  # noqa: E402
from lib.beams import Plate, reissner_tip, timoshenko_period  # noqa: E402
from lib.richardson import richardson  # noqa: E402
from lib.curves import crossings, peak, read_reference  # noqa: E402
from lib.markdown import number, table  # noqa: E402
from lib.run_output import RunError, RunOutput  # noqa: E402
from lib.section import bending_ratio  # noqa: E402
from lib.statics import resting_value  # noqa: E402
from lib.verdict import Verdict  # noqa: E402

YOUNG = {"csm1": 1.4e6, "csm2": 5.6e6, "csm3": 1.4e6}  # Pa
RAMP = {"csm1": 2.0, "csm2": 1.0}                      # s, of the scene and of sweep.py
COLUMNS = ("u_x", "u_x_amplitude", "u_y", "u_y_amplitude", "frequency")
TARGET = 0.03  # of each published value, for the finest run
SMALL = {"csm2": ("u_x",)}  # 0.5 mm, half a spacing of the finest run: reported, not judged at that spacing


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("folder", type=Path, help="folder of sweep.py's runs")
    options = arguments.parse_args()
    across = sorted({int(f.name.split("_")[1]) for f in options.folder.glob("csm?_*")})
    try:
        return compare(options.folder, across)
    except RunError as error:
        print(f"Turek-Hron CSM: cannot compare: {error}", file=sys.stderr)
        return 2


def bar(case):
    return Plate(0.35, 0.02, 1000.0, YOUNG[case], 0.4)


def at_rest(run, case):
    result = {}
    for axis in "xy":
        value, swing = resting_value(run.time, run.probe(f"a.{axis}"), RAMP[case], timoshenko_period(bar(case)))
        result[f"u_{axis}"], result[f"swing_{axis}"] = 1e3 * value, 1e3 * swing
    return result


def swinging(run):
    """Mean, amplitude and frequency over the last period, which y's last two downward passes of its middle enclose."""
    time, x, y = run.time, run.probe("a.x"), run.probe("a.y")
    down = crossings(time, y - 0.5 * (y.max() + y.min()), upward=False)
    if len(down) < 2:
        return {name: np.nan for name in COLUMNS}
    last = (time >= down[-2]) & (time <= down[-1])
    result = {"frequency": 1 / (down[-1] - down[-2])}
    for name, u in (("u_x", x), ("u_y", y)):
        top, bottom = 1e3 * peak(time[last], u[last])[1], -1e3 * peak(time[last], -u[last])[1]
        result[name], result[f"{name}_amplitude"] = (top + bottom) / 2, (top - bottom) / 2
    return result


def measure(run, case):
    return swinging(run) if case == "csm3" else at_rest(run, case)


def compare(folder, all_across):
    reference = read_reference(CASE / "reference.csv")
    verdict, parts = Verdict(), [
        "# Turek–Hron CSM: results\n\nWritten by `validation/turek_hron_csm/compare.py`. Point A, mm and Hz; *section*: "
        "by how much the layers of particles alone make the bar too soft (`lib/section.py`).\n"]
    for k, case in enumerate(reference["case"]):
        done = finished(folder, case, all_across)
        across, runs = list(done), list(done.values())
        found = [measure(run, case) for run in runs]
        columns = [c for c in COLUMNS if np.isfinite(reference[c][k])]
        published = {c: reference[c][k] for c in columns}
        parts.append(f"## {case.upper()}\n\n" + case_table(case, across, runs, found, published) + notes(case, found))
        judge(verdict, case, across, found, published)
    parts.append("## Criteria\n\n" + table(["", "", "wanted", "verdict"], [
        [what, value, wanted, "pass" if ok else "fail"] for what, value, _, wanted, ok in verdict.rows]))
    text = "\n".join(parts)
    (CASE / "results.md").write_text(text)
    print(text)
    verdict.print_table()
    draw(folder, all_across, CASE / "point_a.svg")
    return verdict.close("Turek-Hron CSM")


def finished(folder, case, across):
    """The runs that are there and have come to their end, by particles across."""
    runs = {n: RunOutput(folder / f"{case}_{n}") for n in across if (folder / f"{case}_{n}" / "summary.json").exists()}
    return {n: run for n, run in runs.items() if run.summary["status"] == "done"}


def limit_of(across, found, column):
    if len(across) < 3:
        return None, None
    return richardson([1 / n for n in across], [f[column] for f in found])


def case_table(case, across, runs, found, published):
    def cell(value, column):
        if value is None or not np.isfinite(value):
            return "–"
        return f"{value:.3f} ({100 * (value / published[column] - 1):+.1f} %)"

    rows = [[n] + [cell(f[c], c) for c in published] +
            [f"{100 * (1 / bending_ratio(n, 'wendland-c2', 1.2, 0.4) - 1):+.1f} %", number(run.summary["cpu_seconds"], 0)]
            for n, f, run in zip(across, found, runs)]
    limits = {c: limit_of(across, found, c) for c in published}
    rows.append(["order"] + [number(limits[c][0], 2) for c in published] + ["", ""])
    rows.append(["extrapolated"] + [cell(limits[c][1], c) for c in published] + ["", ""])
    rows.append(["Turek & Hron"] + [f"{published[c]:g}" for c in published] + ["", ""])
    if case != "csm3":
        beam = dict(zip(("u_x", "u_y"), 1e3 * np.array(reissner_tip(bar(case), 2.0))))
        rows.append(["beam of 0.35 m (Reissner)"] + [cell(beam[c], c) for c in published] + ["", ""])
    return table(["across", *published, "section", "CPU [s]"], rows)


def notes(case, found):
    if case == "csm3":
        return ""
    return f"\nStill swinging at the end: ±{max(f['swing_y'] for f in found):.2f} mm in y at the most.\n"


def judge(verdict, case, across, found, published):
    for column, value in published.items():
        order, limit = limit_of(across, found, column)
        name = f"{case.upper()} {column}"
        verdict.limit(f"{name}: extrapolated / published", limit / value if limit else None, "", 1 - TARGET, 1 + TARGET)
        if column not in SMALL.get(case, ()):
            verdict.limit(f"{name}: finest / published", found[-1][column] / value, "", 1 - TARGET, 1 + TARGET)


def draw(folder, across, path):
    plt = style.use()
    figure, axes = plt.subplots(3, 1, figsize=(6.3, 6.2), layout="constrained")
    reference = read_reference(CASE / "reference.csv")
    colours = (style.GREEN, style.SKY, style.ORANGE, style.BLUE)
    for k, (axis, case) in enumerate(zip(axes, reference["case"])):
        low, high = (reference["u_y"][k],) * 2
        if case == "csm3":
            low, high = low - reference["u_y_amplitude"][k], high + reference["u_y_amplitude"][k]
        for level in {low, high}:
            axis.axhline(level, color=style.BLACK, linewidth=0.8, linestyle=(0, (5, 2)))
        for (n, run), colour in zip(finished(folder, case, across).items(), colours):
            axis.plot(run.time, 1e3 * run.probe("a.y"), color=colour, label=f"{n} across")
        axis.set_ylabel(f"{case.upper()}: u_y(A) [mm]")
        axis.grid(color="0.92", linewidth=0.5)
        axis.set_xlim(0, None)
    axes[0].legend(loc="upper right", fontsize=8)
    axes[0].set_title("dashed: Turek & Hron", loc="left")
    axes[-1].set_xlabel("time [s]")
    style.save(figure, path)


if __name__ == "__main__":
    sys.exit(main())
