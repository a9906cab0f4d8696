#!/usr/bin/python3
"""The plate as a total-Lagrangian solid, at small amplitude: period against beam theory, order, kernels, slenderness.

Writes results_total_lagrangian.md and total_lagrangian.svg beside this file; exit code 0 if the criteria are met. Runs
that are done are not run again.
"""
import argparse
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np

CASE = Path(__file__).resolve().parent
sys.path.insert(0, str(CASE.parent))

from lib import runs, style  # noqa: E402
from lib.beams import Plate, thin_plate_period, timoshenko_period  # noqa: E402
from lib.richardson import richardson  # noqa: E402
from lib.curves import crossings, read_reference  # noqa: E402
from lib.markdown import number, table  # noqa: E402
from lib.run_output import RunOutput  # noqa: E402
from lib.section import bending_ratio  # noqa: E402
from lib.verdict import Verdict  # noqa: E402

HEIGHT = 0.02          # m
SMALL, PAPER = 0.001, 0.01  # initial speed of the free end over c0
CUBIC, WENDLAND = "cubic-spline", "wendland-c2"
ON_COLUMN = "on a column"


@dataclass(frozen=True)
class Series:
    slenderness: int
    kernel: str
    smoothing_length: float
    across: tuple
    speed: float = SMALL
    held: str = "between columns"  # where the clamp's edge, x = 0, lies

    @property
    def plate(self):
        return Plate.with_moduli(self.slenderness * HEIGHT, HEIGHT, 1000.0, 3.25e6, 0.715e6)

    @property
    def label(self):
        return (f"L/H = {self.slenderness}, {self.kernel}, h = {self.smoothing_length} d" +
                (f", clamp's edge {self.held}" if self.held == ON_COLUMN else ""))

    @property
    def folder(self):
        return (f"slender_{self.slenderness}_{self.kernel}_{self.smoothing_length}_{self.speed}" +
                ("_on_column" if self.held == ON_COLUMN else ""))

    def softness(self, across):
        """What the layers of particles alone do to the period."""
        return bending_ratio(across, self.kernel, self.smoothing_length, self.plate.poisson) ** -0.5

    def root(self, point):
        """By how much the plate seems longer, in spacings: what the layers leave of the difference to plane elasticity."""
        expected = exact(self) * self.softness(point.across)
        return (np.sqrt(point.period / expected) - 1) * self.slenderness * point.across


SERIES = (
    Series(10, CUBIC, 1.5, (6, 10, 20), PAPER),
    Series(10, CUBIC, 1.5, (6, 10, 20)),
    Series(10, CUBIC, 1.2, (6, 10, 20)),
    Series(10, WENDLAND, 1.5, (6, 10, 20)),
    Series(10, WENDLAND, 1.2, (6, 10, 20, 30)),
    Series(20, CUBIC, 1.5, (6, 10, 14)),
    Series(20, WENDLAND, 1.2, (6, 10, 20)),
    Series(40, WENDLAND, 1.2, (4, 5, 6)),
    Series(10, CUBIC, 1.5, (6, 10, 16), SMALL, ON_COLUMN),
    Series(10, WENDLAND, 1.2, (6, 10, 16), SMALL, ON_COLUMN),
)


@dataclass(frozen=True)
class Point:
    across: int
    period: float   # T c0/L
    cpu: float      # s


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("folder", nargs="?", default=runs.ROOT / "results" / "oscillating_plate_tl", type=Path)
    arguments.add_argument("--sluice", default=runs.SLUICE, type=Path, help="the program to run")
    arguments.add_argument("--threads", default="1")
    options = arguments.parse_args()
    measured = [(series, [measure(options, series, n) for n in series.across]) for series in SERIES]
    verdict = judge(measured)
    text = report(measured, verdict)
    (CASE / "results_total_lagrangian.md").write_text(text)
    print(text)
    verdict.print_table()
    draw(measured, CASE / "total_lagrangian.svg")
    return verdict.close("Oscillating plate, total Lagrangian")


def measure(options, series, across):
    """The run's first period: from the start, where the end passes zero upwards, to its second upward pass."""
    plate = series.plate
    # A third longer than theory, as the coarse plates are up to a sixth softer in period.
    settings = {
        "method.spacing": f"{HEIGHT / across:.10g}", "method.smoothing_length": series.smoothing_length,
        "method.smoothing_function": series.kernel, "method.solid.artificial_viscosity": 0,
        "materials.elastic.model": "st-venant-kirchhoff", "constants.L": plate.length, "constants.vL0": series.speed,
        "bodies.plate.shape.box.max": f"[{plate.length}, {HEIGHT / 2}]", "probes.free_end.at": f"[{plate.length}, 0]",
        "output.frame_interval": 0, "output.end": f"{1.33 * timoshenko_period(plate):.3g}",
    }
    if series.held == ON_COLUMN:
        settings |= clamp_on_column(plate, across)
    folder = options.folder / f"{series.folder}_across_{across}"
    runs.run(CASE / "scene.toml", folder, settings, options.sluice, ["--threads", options.threads])
    run = RunOutput(folder)
    y = run.probe("free_end.y")
    up, down = crossings(run.time, y, upward=True), crossings(run.time, y, upward=False)
    up = up[up > down[0]] if len(down) else up[:0]
    period = up[0] * plate.bulk_sound_speed / plate.length if len(up) else np.nan
    return Point(across, period, run.summary["cpu_seconds"])


def clamp_on_column(plate, across):
    """The last held column stands on x = 0, and the last cell ends at x = L: a column more or less half a spacing, so
    that the spacing along the plate is H/across (1 - H/(2 L across))."""
    along = round(plate.length * across / HEIGHT)
    spacing = plate.length / (along + 0.5)
    return {"method.spacing": f"{spacing:.12g}",
            "bodies.plate.shape.box.min": f"[{-(across + 0.5) * spacing:.12g}, {-HEIGHT / 2}]",
            "bodies.plate.clamp.box.min": f"[{-(across + 0.5) * spacing:.12g}, {-HEIGHT / 2}]",
            "bodies.plate.clamp.box.max": f"[{0.5 * spacing:.12g}, {HEIGHT / 2}]"}


def theory(series):
    scale = series.plate.bulk_sound_speed / series.plate.length
    return timoshenko_period(series.plate) * scale, thin_plate_period(series.plate) * scale


def exact(series):
    """T c0/L in plane elasticity: at the clamp the plate cannot contract, as Timoshenko's beam can."""
    found = read_reference(CASE / "reference_plane_elasticity.csv")
    return theory(series)[0] * found["fine"][found["slenderness"] == series.slenderness][0]


def extrapolated(points):
    """Of series that go to ten across or more; coarser ones are no asymptotic series (the tables' section column)."""
    if points[-1].across < 10:
        return None, None
    return richardson([1 / p.across for p in points], [p.period for p in points])


def judge(measured):
    verdict = Verdict()
    for series, points in measured:
        if series.speed != SMALL or points[-1].across < 10:
            continue
        order, limit = extrapolated(points)
        beam = theory(series)[0]
        verdict.limit(f"{series.label}: extrapolated T / Timoshenko", limit / beam if limit else None, "",
                      low=0.99, high=1.01)
        verdict.limit(f"{series.label}: order", order, "", low=1.5)
    for series, points in measured:
        if series == Series(10, WENDLAND, 1.2, series.across):  # the finest that all series share
            at20 = next(p.period for p in points if p.across == 20)
            verdict.limit(f"{series.label}: T / Timoshenko at 20 across", at20 / theory(series)[0], "", low=0.98, high=1.02)
    return verdict


def report(measured, verdict):
    parts = ["# Oscillating plate, total Lagrangian: results\n\nWritten by `validation/oscillating_plate/total_lagrangian.py`. "
             "T c₀/L of the first period, v_L0 = 0.001 c₀ unless said otherwise. *Section*: what the layers of particles "
             "alone do to the period, √(I/I_n) (`lib/section.py`). *Root*: by how many spacings the plate would have to be "
             "longer to make up for the rest of the difference to plane elasticity.\n"]
    for series, points in measured:
        beam, thin = theory(series)
        order, limit = extrapolated(points)
        rows = []
        for p in points:
            rows.append([p.across, number(p.period, 2), f"{100 * (p.period / beam - 1):+.2f} %",
                         f"{100 * (series.softness(p.across) - 1):+.2f} %", f"{series.root(p):+.2f}", number(p.cpu, 1)])
        name = series.label + (", v_L0 = 0.01 c₀ (the paper's)" if series.speed == PAPER else "")
        found = (f"Order {order:.2f}, extrapolated {limit:.2f} ({100 * (limit / beam - 1):+.2f} % to Timoshenko, "
                     f"{100 * (limit / exact(series) - 1):+.2f} % to plane elasticity)."
                 if order else "No order: too coarse, or not monotonic.")
        parts.append(f"## {name}\n\n" + table(["across", "T c₀/L", "to Timoshenko", "section", "root [d]", "CPU [s]"], rows) +
                     f"\nTimoshenko {beam:.2f}, thin plate {thin:.2f}, plane elasticity {exact(series):.2f}. {found}\n")
    parts.append("## Criteria\n\n" + table(["", "", "wanted", "verdict"], [
        [what, value, wanted, "pass" if ok else "fail"] for what, value, _, wanted, ok in verdict.rows]))
    return "\n".join(parts)


def draw(measured, path):
    plt = style.use()
    figure, axis = plt.subplots(figsize=(6.3, 3.4), layout="constrained")
    colours = {(CUBIC, 1.5): style.BLUE, (CUBIC, 1.2): style.SKY, (WENDLAND, 1.5): style.VERMILION, (WENDLAND, 1.2): style.ORANGE}
    markers = {10: "o", 20: "s", 40: "^"}
    for series, points in measured:
        if series.speed != SMALL or series.held == ON_COLUMN:
            continue
        beam, colour = theory(series)[0], colours[series.kernel, series.smoothing_length]
        across = np.array([p.across for p in points])
        axis.loglog(across, [p.period / beam - 1 for p in points], markers[series.slenderness], color=colour,
                    markersize=5, label=series.label)
        if series.slenderness == 10:
            every = np.arange(6, 33)
            axis.loglog(every, [series.softness(n) - 1 for n in every],
                        color=colour, linewidth=0.9)
    guide = np.array([10, 30])
    axis.loglog(guide, 0.012 * (10 / guide) ** 2, color=style.BLACK, linewidth=0.8, linestyle=(0, (5, 2)))
    axis.text(16, 0.0034, "second order", fontsize=8)
    axis.set_xlabel("particles across")
    axis.set_ylabel("period / Timoshenko − 1")
    axis.set_xticks([6, 10, 20, 30], ["6", "10", "20", "30"])
    axis.minorticks_off()
    axis.grid(color="0.92", linewidth=0.5)
    axis.set_axisbelow(True)
    axis.legend(loc="upper right", fontsize=7)
    axis.set_title("points: runs; lines: section of the layers of particles alone", loc="left")
    style.save(figure, path)


if __name__ == "__main__":
    sys.exit(main())
