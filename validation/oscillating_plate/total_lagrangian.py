#!/usr/bin/python3
"""Runs the plate as a total-Lagrangian solid, at small amplitude: period against beam theory, order, kernels, slenderness."""
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from lib import case, style  # noqa: E402
from lib.beams import Plate, thin_plate_period, timoshenko_period  # noqa: E402
from lib.case import Errors, Figure, Result, Run, Table  # noqa: E402
from lib.curves import crossings, read_reference  # noqa: E402
from lib.markdown import number  # noqa: E402
from lib.richardson import richardson  # noqa: E402
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
                (f", clamp's edge {self.held}" if self.held == ON_COLUMN else "") +
                (", v_L0 = 0.01 c₀ (the paper's)" if self.speed == PAPER else ""))

    @property
    def is_main(self):
        """Smoothed as in the other cases of solids, at small amplitude, clamped as the scene is."""
        return (self.kernel, self.smoothing_length, self.speed, self.held) == (WENDLAND, 1.2, SMALL, "between columns")

    def run_name(self, across):
        return (f"slender_{self.slenderness}_{self.kernel}_{self.smoothing_length}_{self.speed}" +
                ("_on_column" if self.held == ON_COLUMN else "") + f"_across_{across}")

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
QUICK = (Series(10, WENDLAND, 1.2, (6,)), Series(10, WENDLAND, 1.2, (6,), SMALL, ON_COLUMN))
QUICK_LIMITS = 0.965, 1.035  # T over Timoshenko's: at 6 across it is 1.025, and 1.008 with the clamp's edge on a column


@dataclass(frozen=True)
class Point:
    across: int
    period: float   # T c0/L
    cpu: float      # s


def plan(quick):
    return [Run(series.run_name(n), settings(series, n)) for series in series_of(quick) for n in series.across]


def series_of(quick):
    return QUICK if quick else SERIES


def settings(series, across):
    plate = series.plate
    # A third longer than theory, as the coarse plates are up to a sixth softer in period.
    values = {
        "method.spacing": f"{HEIGHT / across:.10g}", "method.smoothing_length": series.smoothing_length,
        "method.smoothing_function": series.kernel, "method.solid.artificial_viscosity": 0,
        "materials.elastic.model": "st-venant-kirchhoff", "constants.L": plate.length, "constants.vL0": series.speed,
        "bodies.plate.shape.box.max": f"[{plate.length}, {HEIGHT / 2}]", "probes.free_end.at": f"[{plate.length}, 0]",
        "output.frame_interval": 0, "output.end": f"{1.33 * timoshenko_period(plate):.3g}",
    }
    if series.held == ON_COLUMN:
        values |= clamp_on_column(plate, across)
    return values


def clamp_on_column(plate, across):
    """A column stands on the clamp's surface, x = 0, and the last cell ends at x = L: a column more or less half a spacing, so
    that the spacing along the plate is H/across (1 - H/(2 L across))."""
    along = round(plate.length * across / HEIGHT)
    spacing = plate.length / (along + 0.5)
    return {"method.spacing": f"{spacing:.12g}",
            "bodies.plate.shape.box.min": f"[{-(across + 0.5) * spacing:.12g}, {-HEIGHT / 2}]",
            "bodies.plate.clamp.box.min": f"[{-(across + 0.5) * spacing:.12g}, {-HEIGHT / 2}]",
            "bodies.plate.clamp.box.max": f"[0.0, {HEIGHT / 2}]"}


def measure(run, series, across):
    """The run's first period: from the start, where the end passes zero upwards, to its second upward pass."""
    plate, y = series.plate, run.probe("free_end.y")
    up, down = crossings(run.time, y, upward=True), crossings(run.time, y, upward=False)
    up = up[up > down[0]] if len(down) else up[:0]
    period = up[0] * plate.bulk_sound_speed / plate.length if len(up) else np.nan
    return Point(across, period, run.summary["cpu_seconds"])


def study(done):
    measured = [(series, [measure(done.runs[series.run_name(n)], series, n) for n in series.across])
                for series in series_of(done.quick)]
    picture = done.folder / "figure.svg"
    draw(measured, picture)
    main = [(series, points) for series, points in measured if series.is_main and (done.quick or points[-1].across >= 20)]
    return Result(
        judge_quick(measured) if done.quick else judge(measured),
        errors=[(f"period, L/H = {series.slenderness}, {points[-1].across} across",
                 f"{100 * (points[-1].period / theory(series)[0] - 1):+.2f} %") for series, points in main],
        tables=[series_table(series, points) for series, points in measured],
        figures=[Figure(picture, "Period over that of Timoshenko's beam. Points: runs; lines: what the section of the layers of "
                                 "particles alone would do; dashed: second order. Plane elasticity is 0.5 % below Timoshenko.")],
        convergence=[Errors(f"{series.label}, to plane elasticity", [p.across for p in points],
                            [abs(p.period / exact(series) - 1) for p in points]) for series, points in main],
        measures={"T c0/L": number(main[0][1][-1].period, 2)})


def theory(series):
    scale = series.plate.bulk_sound_speed / series.plate.length
    return timoshenko_period(series.plate) * scale, thin_plate_period(series.plate) * scale


def exact(series):
    """T c0/L in plane elasticity: at the clamp the plate cannot contract, as Timoshenko's beam can."""
    found = read_reference(FOLDER / "reference_plane_elasticity.csv")
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


def judge_quick(measured):
    verdict = Verdict()
    for series, points in measured:
        verdict.limit(f"{series.label}: T / Timoshenko, {points[-1].across} across", points[-1].period / theory(series)[0], "",
                      *QUICK_LIMITS)
    return verdict


def series_table(series, points):
    beam, thin = theory(series)
    order, limit = extrapolated(points)
    rows = [[p.across, number(p.period, 2), f"{100 * (p.period / beam - 1):+.2f} %",
             f"{100 * (series.softness(p.across) - 1):+.2f} %", f"{series.root(p):+.2f}", number(p.cpu, 1)] for p in points]
    found = (f"Order {order:.2f}, extrapolated {limit:.2f} ({100 * (limit / beam - 1):+.2f} % to Timoshenko, "
             f"{100 * (limit / exact(series) - 1):+.2f} % to plane elasticity)."
             if order else "No order: too coarse, or not monotonic.")
    return Table(series.label, ["across", "T c₀/L", "to Timoshenko", "section", "root [d]", "CPU [s]"], rows,
                 f"Timoshenko {beam:.2f}, thin plate {thin:.2f}, plane elasticity {exact(series):.2f}. {found}")


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
    axis.set_xlabel("particles across")
    axis.set_ylabel("period / Timoshenko − 1")
    axis.set_xticks([6, 10, 20, 30], ["6", "10", "20", "30"])
    axis.minorticks_off()
    axis.grid(color="0.92", linewidth=0.5)
    axis.set_axisbelow(True)
    axis.legend(loc="upper right", fontsize=7)
    style.save(figure, path)


CASE = case.Case("Oscillating plate, total Lagrangian", FOLDER, "the total-Lagrangian solid: period, order, smoothing functions",
                 "Timoshenko's beam; plane elasticity", plan, study, part="total_lagrangian")

if __name__ == "__main__":
    sys.exit(case.main(CASE))
