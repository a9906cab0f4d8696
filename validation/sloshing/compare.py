#!/usr/bin/python3
"""Runs the swayed tank below, near and above its first natural frequency at three spacings, and compares the elevation at the
wall and the water's centre of mass with linear theory; the same with moving walls; and once far from linear.

The quick form is the run near resonance alone, at H/d = 20 and 40 and for 3 s, with wider criteria, and with moving walls at 20.
"""
import sys
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from lib import case, convergence, style  # noqa: E402
from lib.case import Errors, Figure, Result, Run  # noqa: E402
from lib.run_output import FLUID  # noqa: E402
from lib.verdict import Verdict  # noqa: E402
import theory  # noqa: E402
from theory import DEPTH, LENGTH  # noqa: E402

COUNTS, QUICK_COUNTS = (20, 40, 80), (20, 40)
CHECKED_AT = 40                 # H/d of the moving walls and of the large amplitude
SWAYED = {0.5: 0.15, 0.9: 0.036, 1.5: 0.15}  # ω/ω1: F [m/s²], for 10 to 15 mm at the wall, 3 % of the depth
NEAR = 0.9
SUPPORT = 3.0                   # d: 2h, width of a level probe's strip on each side (h = 1.5 d)
LARGE = {"constants.omega": "5.317", "constants.F": "1.413",  # A = 50 mm at the natural frequency
         "method.expected_speed": "4.0", "materials.water.sound_speed": "40.0", "output.end": "4.0"}
STILL = '["0", "0"]'
COLOURS = (style.ORANGE, style.SKY, style.BLUE)


def constants(ratio):
    return {"constants.omega": f"{ratio * theory.natural_frequency():.6g}", "constants.F": f"{SWAYED[ratio]:g}"}


def wall_level(run):
    """Elevation over the strip at the left wall [m]. A probe's level is mass over ρ0, which the water's own weight raises by
    H g H/(2 c0²); so it is taken from the first."""
    value = run.probe("wall.level")
    return run.time, value - value[0]


def centre(run):
    """Times, and x of the water's centre of mass in each frame, less L/2; all particles have one mass."""
    times, at = [], []
    for frame in run.frames():
        times.append(frame.time)
        at.append(frame.points[frame.of(FLUID), 0].mean() - LENGTH / 2)
    return np.array(times), np.array(at)


def l2(value, exact):
    return np.sqrt(((value - exact) ** 2).sum() / (exact ** 2).sum())


def spacing_of(run):
    return np.sqrt(LENGTH * DEPTH / run.summary["particles"]["fluid"])


def measure_at(ratio):
    force, omega = SWAYED[ratio], float(constants(ratio)["constants.omega"])

    def measure(run):
        t, wall = wall_level(run)
        exact = theory.response(t, force, omega, theory.level(0, SUPPORT * spacing_of(run)))
        at, x = centre(run)
        stiffness, damping = theory.fit(at, x, force, omega, theory.centre_of_mass)
        moved = theory.response(at, force, omega, theory.centre_of_mass)
        return {"wall, L2": l2(wall, exact), "centre of mass, L2": l2(x, moved),
                "wall / theory": (wall * exact).sum() / (exact ** 2).sum(), "highest / theory": wall.max() / exact.max(),
                "ω1 / theory": stiffness, "damping [1/s]": damping}

    return measure


def scene_at(ratio):
    return convergence.Measured(
        f"ω = {ratio:g} ω1", ("H/d", DEPTH), errors=("centre of mass, L2", "wall, L2"),
        others=(("wall / theory", 3), ("highest / theory", 3), ("ω1 / theory", 4), ("damping [1/s]", 3)),
        measure=measure_at(ratio))


def plan(quick):
    if quick:
        near = convergence.runs_at(f"ratio_{NEAR:g}", DEPTH, QUICK_COUNTS, {**constants(NEAR), "output.end": "3.0"})
        return near + both_ways(QUICK_COUNTS[0], {"output.end": "3.0"})
    swayed = [run for ratio in SWAYED for run in convergence.runs_at(f"ratio_{ratio:g}", DEPTH, COUNTS, constants(ratio))]
    return swayed + both_ways(CHECKED_AT) + [Run("large", {convergence.SPACING: f"{DEPTH / CHECKED_AT:.10g}", **LARGE})]


def both_ways(count, changes=()):
    """Walls that move, and the same tank seen from within."""
    outside = {convergence.SPACING: f"{DEPTH / count:.10g}", **constants(NEAR), **dict(changes)}
    inside = {**outside, **{f"walls.{name}.motion.displacement": STILL for name in ("floor", "left", "right")},
              "acceleration": '["F*sin(omega*t)", "0"]', "bodies.water.velocity": STILL}
    return [Run("moving_walls", outside, "moving.toml"), Run("fixed_walls", inside, "moving.toml")]


def compare_frames(outside, inside):
    """Centre of mass relative to the tank: walls that move, and the same tank seen from within."""
    omega = float(constants(NEAR)["constants.omega"])
    (t, x), (_, within) = centre(outside), centre(inside)
    return t, x - SWAYED[NEAR] / omega ** 2 * np.sin(omega * t), within


def judge(verdict, studies_at, frames, large):
    """Away from resonance 5 % of the centre of mass, 15 % of the level, which is counted from particles of half the wave's
    height. Near it an error e of ω1 is one of 2e/(1 − 0.9²) in amplitude: 1 % makes 11 %, so 15 %."""
    for ratio, study in studies_at.items():
        at = f"ω = {ratio:g} ω1: "
        verdict.limit(at + "centre of mass, L2", 100 * study.finest["centre of mass, L2"], "%", high=15 if ratio == NEAR else 5)
        verdict.limit(at + "elevation at the wall, L2", 100 * study.finest["wall, L2"], "%", high=20 if ratio == NEAR else 15)
    verdict.limit("natural frequency / theory", studies_at[NEAR].finest["ω1 / theory"], "", low=0.99, high=1.01)
    judge_both_ways(verdict, frames, 3)
    first, last = large.frame_near(0), list(large.frames())[-1]
    verdict.none_of("large amplitude: particles lost, or outside the tank",
                    abs(len(last.points) - len(first.points)) + outside_tank(last))


def judge_both_ways(verdict, frames, high):
    """One flow, seen from two frames: what differs is the walls' ghosts."""
    verdict.limit("moving walls against acceleration, centre of mass, L2", 100 * l2(frames[1], frames[2]), "%", high=high)


def outside_tank(frame):
    x, y = frame.points.T
    return int(np.count_nonzero((x < 0) | (x > LENGTH) | (y < 0) | ~np.isfinite(x)))


def judge_quick(verdict, study, frames):
    """At H/d = 40 after 3 s: theory within 20 %, first natural frequency within 3 %. Moving walls at H/d = 20: the difference
    is 0.9 %, and 1.2 % with the sign of the walls' acceleration wrong in their pressure."""
    verdict.limit("centre of mass, L2", 100 * study.finest["centre of mass, L2"], "%", high=15)
    verdict.limit("elevation at the wall, L2", 100 * study.finest["wall, L2"], "%", high=30)
    verdict.limit("natural frequency / theory", study.finest["ω1 / theory"], "", low=0.97, high=1.03)
    judge_both_ways(verdict, frames, 1.05)


def draw_elevation(axis, ratio, study):
    for run, count, colour in zip(study.runs, study.counts, COLOURS):
        t, wall = wall_level(run)
        axis.plot(t, 1e3 * wall, color=colour, linewidth=1, label=f"H/d = {count}")
    strip = theory.level(0, SUPPORT * spacing_of(run))
    exact = theory.response(t, SWAYED[ratio], float(constants(ratio)["constants.omega"]), strip)
    axis.plot(t, 1e3 * exact, color=style.BLACK, linewidth=0.9, linestyle=(0, (4, 2)), label="linear theory")
    axis.set(title=f"ω = {ratio:g} ω₁", xlabel="time [s]")


def draw(studies_at, path):
    plt = style.use()
    count = len(studies_at)
    figure, axes = plt.subplots(1, count, figsize=(3.2 * count + 0.4, 2.8), layout="constrained", sharey=True, squeeze=False)
    for axis, (ratio, study) in zip(axes[0], studies_at.items()):
        draw_elevation(axis, ratio, study)
    axes[0][0].set_ylabel("elevation at the wall [mm]")
    axes[0][0].legend(fontsize=7, loc="upper left", ncol=2)
    axes[0][0].set_ylim(-20, 26)
    style.save(figure, path)


def draw_large(run, path):
    """The tank at six times, coloured by speed."""
    plt = style.use()
    frames = [run.frame_near(t) for t in (1.2, 1.8, 2.4, 2.8, 3.2, 3.8)]
    figure, axes = plt.subplots(2, 3, figsize=(8, 5), layout="constrained", sharex=True, sharey=True)
    for axis, frame in zip(axes.flat, frames):
        axis.scatter(*frame.points.T, c=frame.speed(), s=2, linewidths=0, cmap=style.WATER, vmin=0, vmax=2.5)
        axis.set(aspect="equal", xlim=(0, LENGTH), ylim=(0, 1.2), title=f"t = {frame.time:.1f} s")
    style.save(figure, path)


def study(done):
    verdict, picture = Verdict(), done.folder / "figure.svg"
    counts, ratios = (QUICK_COUNTS, (NEAR,)) if done.quick else (COUNTS, SWAYED)
    at = {ratio: convergence.study_at(scene_at(ratio), f"ratio_{ratio:g}", counts, done) for ratio in ratios}
    draw(at, picture)
    figures = [Figure(picture, "Elevation at the wall against linear theory, below, near and above the natural frequency.", "figure.svg")]
    frames = compare_frames(done.runs["moving_walls"], done.runs["fixed_walls"])
    if done.quick:
        judge_quick(verdict, at[NEAR], frames)
    else:
        judge(verdict, at, frames, done.runs["large"])
        draw_large(done.runs["large"], done.folder / "large.svg")
        figures.append(Figure(done.folder / "large.svg", "Far from linear: 50 mm at the natural frequency; colour: speed."))
    return Result(
        verdict, tables=[of.table(of.case.title) for of in at.values()], figures=figures,
        errors=[(f"{name}, {of.case.title}", f"{convergence.percent(of.finest[name])} %")
                for _, of in sorted(at.items(), key=lambda item: item[0] != NEAR) for name in of.case.errors],
        convergence=[Errors(f"{of.case.title}: centre of mass", list(counts), [v["centre of mass, L2"] for v in of.values])
                     for of in at.values()])


CASE = case.Case("Sloshing", FOLDER, "driven waves; a tank that moves and one seen from within",
                 "linear theory, Faltinsen 1978", plan, study)

if __name__ == "__main__":
    sys.exit(case.main(CASE))
