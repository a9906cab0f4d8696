#!/usr/bin/python3
"""Runs the dam break against a box with four and six particles across the box, and compares levels, pressures and the times of
the first impact and of the wave that comes back with the measurement at MARIN.

The quick form has four particles and ends at 0.7 s: first impact, reservoir's level, no water in the box, energy.
"""
import sys
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from lib import case, convergence, style  # noqa: E402
from lib.curves import read_reference  # noqa: E402
from lib.run_output import FLUID  # noqa: E402
from lib.verdict import Verdict  # noqa: E402

BOX, DEPTH, LENGTH = 0.161, 0.55, 3.22   # m: the box's height, the water's depth, the tank's length
CORNERS = np.array([[0.6635, 0.0, 0.2985], [0.8245, 0.161, 0.7015]])  # m: of the box, as in the scene
SHORT = 0.01         # s: a reference value is a mean over this, before and after
IMPACT = 0.394       # s: the lower sensor's pressure passes 1 kPa
TOUCH = 1000.0       # Pa
RISEN = 0.15         # m: level in the reservoir that the wave on its way back lifts the water above,
EMPTIED = 2.0        # s: when it has sunk below that level
BACK = (2.68, 2.77)  # s: the measured level is 0.11 m at the first and 0.20 m at the second
STEADY = (0.9, 2.0)  # s: the box stands in the flow
LEVELS = {"level_2638": "in the reservoir", "level_0992": "before the box"}
PRESSURES = {"front_low": "21 mm above the floor", "front_high": "101 mm above the floor"}
REFERENCE = read_reference(FOLDER / "reference.csv")


def column(name):
    return f"{name}.{'level' if name in LEVELS else 'p'}"


def at_reference(run, name):
    """(reference times, measured, ours): ours as means over SHORT on both sides; only times that the run has."""
    t, value = run.time, run.probe(column(name))
    use = np.isfinite(REFERENCE[name]) & (REFERENCE["t_s"] <= t[-1] - SHORT)
    times = REFERENCE["t_s"][use]
    return times, REFERENCE[name][use], np.array([value[np.abs(t - at) <= SHORT + 1e-6].mean() for at in times])


def first_above(time, value, limit, start=0.0):
    """When the curve passes the limit, by linear interpolation."""
    i = np.flatnonzero((value > limit) & (time > start))
    if i.size == 0 or i[0] == 0:
        return np.nan
    return np.interp(limit, value[i[0] - 1:i[0] + 1], time[i[0] - 1:i[0] + 1])


def level_error(run, name):
    times, theirs, ours = at_reference(run, name)
    before = times < BACK[0]  # a wave that is a little late would count for more than all the rest
    return np.sqrt(((ours - theirs)[before] ** 2).mean()) / DEPTH


def pressure_ratio(run, name):
    times, theirs, ours = at_reference(run, name)
    steady = (times > STEADY[0]) & (times < STEADY[1])
    return ours[steady].mean() / theirs[steady].mean() if steady.any() else np.nan


def measure(run):
    energy, last = run.probe("energy.total"), list(run.frames())[-1]
    x, y = last.points[last["phase"].astype(int) == 0].T
    return {
        "reservoir, RMS": level_error(run, "level_2638"), "before the box, RMS": level_error(run, "level_0992"),
        "impact [s]": first_above(run.time, run.probe("front_low.p"), TOUCH),
        "back [s]": first_above(run.time, run.probe("level_2638.level"), RISEN, start=EMPTIED),
        "p low / measured": pressure_ratio(run, "front_low"), "p high / measured": pressure_ratio(run, "front_high"),
        "highest energy / first": energy.max() / energy[0],
        "lost": run.summary["particles"]["fluid"] - int(np.count_nonzero((x > 0) & (x < LENGTH) & (y > 0))),
    }


def judge(study):
    """Levels within 4 % of the depth and times within 5 %, a particle or so at these spacings. Pressures of the steady flow
    around the box within 30 %: water without friction is faster. The first impact's peak is not compared (README)."""
    verdict, at = Verdict(), study.finest
    for name, error in (("level_2638", "reservoir, RMS"), ("level_0992", "before the box, RMS")):
        verdict.limit(f"level {LEVELS[name]}, RMS / {DEPTH:g} m", 100 * at[error], "%", high=4)
    verdict.limit("first impact", at["impact [s]"], "s", low=0.95 * IMPACT, high=1.05 * IMPACT)
    verdict.limit("wave back in the reservoir", at["back [s]"], "s", low=0.95 * BACK[0], high=1.05 * BACK[1])
    for name, ratio in (("front_low", "p low / measured"), ("front_high", "p high / measured")):
        verdict.limit(f"pressure {PRESSURES[name]}, {STEADY[0]:g} to {STEADY[1]:g} s / measured", at[ratio], "",
                      low=0.7, high=1.3)
    judge_kept(verdict, at)
    return verdict


def judge_kept(verdict, at):
    verdict.limit("highest energy / first", at["highest energy / first"], "", high=1.001)
    verdict.none_of("particles lost", at["lost"])


def inside_box(frame, margin):
    """Water particles that are deeper in the box than the margin [m]."""
    water = frame.in_space[frame.of(FLUID)]
    return int(np.count_nonzero(((water > CORNERS[0] + margin) & (water < CORNERS[1] - margin)).all(axis=1)))


def judge_quick(study):
    """At rest water particles stand half a spacing outside the box. The impact brings some up to a quarter inside; without the
    ghosts' own pressure they go on to 0.8."""
    verdict, at = Verdict(), study.finest
    last = list(study.runs[-1].frames())[-1]
    verdict.none_of("half a spacing inside the box at the end", inside_box(last, 0.5 * BOX / study.counts[-1]))
    verdict.limit("level in the reservoir, RMS / 0.55 m", 100 * at["reservoir, RMS"], "%", high=3)
    verdict.limit("first impact", at["impact [s]"], "s", low=0.9 * IMPACT, high=1.1 * IMPACT)
    judge_kept(verdict, at)
    return verdict


def draw(study, path):
    plt = style.use()
    figure, axes = plt.subplots(2, 2, figsize=(7.4, 4.6), layout="constrained", sharex=True)
    for axis, name in zip(axes.flat, (*LEVELS, *PRESSURES)):
        scale = 1 if name in LEVELS else 1e-3
        for run, count, colour in zip(study.runs, study.counts, (style.SKY, style.BLUE)):
            axis.plot(run.time, scale * run.probe(column(name)), color=colour, linewidth=0.9, label=f"{count} across the box")
        axis.plot(REFERENCE["t_s"], scale * REFERENCE[name], "o", color=style.BLACK, markersize=3, label="measured")
        axis.set_title(f"level {LEVELS[name]} [m]" if name in LEVELS else f"pressure {PRESSURES[name]} [kPa]")
        if name in PRESSURES:
            axis.set(ylim=(-1, 13), xlabel="time [s]")
    axes[0][0].legend(fontsize=8)
    style.save(figure, path)


CASE = convergence.Case(
    "Dam break against a box, 3D", FOLDER, "3D: fluid, mirror walls, fixed ghosts", "Kleefsman 2005, SPHERIC test 2",
    across=("across", BOX), counts=(4, 6), errors=("reservoir, RMS", "before the box, RMS"),
    others=(("impact [s]", 3), ("back [s]", 2), ("p low / measured", 2), ("p high / measured", 2),
            ("highest energy / first", 4), ("lost", 0)),
    measure=measure, judge=judge, draw=draw, stored="figure.svg", settings={"output.end": "3.0", "output.frame_interval": "0.5"},
    caption="Levels in the reservoir and before the box, pressures on the box, against the measurement at MARIN (dots).",
    quick_counts=(4,), quick_settings={"output.end": "0.7", "output.frame_interval": "0.35"}, judge_quick=judge_quick)

if __name__ == "__main__":
    sys.exit(case.main(CASE))
