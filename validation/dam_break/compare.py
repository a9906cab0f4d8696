#!/usr/bin/python3
"""Runs the two dam breaks at three spacings: front on a long floor against Martin & Moyce, pressures on the end wall against
Lobovský et al.

The quick form has H/d = 30 and 40 alone, with criteria that hold at these spacings: the front's speed while friction is small,
the time of arrival, a pressure on the wall that agrees with the head of the arriving water, energy before the impact.
"""
import sys
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from lib import case, convergence, style  # noqa: E402
from lib.case import Figure, Result  # noqa: E402
from lib.curves import read_reference  # noqa: E402
from lib.run_output import FLUID  # noqa: E402
from lib.verdict import Verdict  # noqa: E402

G, DENSITY = 9.81, 1000.0
HEIGHT, WALL = 0.3, 1.61        # Lobovský: of the water, of the tank [m]
WIDTH = 0.05715                 # Martin & Moyce: a; the column is 2a high [m]
WATER_TIME = np.sqrt(HEIGHT / G)        # t* = 1 of Lobovský
FRONT_TIME = np.sqrt(WIDTH / (2 * G))   # t* = 1 of Martin & Moyce
COUNTS, QUICK_COUNTS = (30, 60, 120), (30, 40)
NEAR, FAR = (1.474, 4.134), (4.134, 13.97)  # z*, points of the reference: before and after friction is seen
PLATEAU = (3.6, 3.75)           # t*: where the spread of the experiment's steady pressure was read off
COVERED = (2.7, 3.75)           # t*: the upper sensor is under water
SHORT = 0.06                    # t*, 10 ms: over this pressures are averaged (README)
BEFORE_WALL = (0.09, 0.13)      # m, distance to the wall where the head of the arriving water is taken
COLOURS = (style.ORANGE, style.SKY, style.BLUE)

FRONT = read_reference(FOLDER / "reference_front.csv")
LOW, HIGH = (read_reference(FOLDER / f"reference_{name}.csv") for name in ("3mm", "30mm"))
SPREAD = {name: limits for name, *limits in zip(*read_reference(FOLDER / "reference_3mm_spread.csv").values())}


def foremost(frame, spacing):
    """The foremost particle that has another within two spacings, plus half a spacing [m]: no lone droplet."""
    x, y = frame.points[frame.of(FLUID)].T
    for i in np.argsort(x)[::-1]:
        if np.count_nonzero(np.hypot(x - x[i], y - y[i]) < 2 * spacing) > 1:
            return x[i] + spacing / 2
    return np.nan


def front_curve(run):
    """t* and z*."""
    spacing = np.sqrt(2 * WIDTH ** 2 / run.summary["particles"]["fluid"])
    return run.frame_times() / FRONT_TIME, np.array([foremost(frame, spacing) for frame in run.frames()]) / WIDTH


def measure_front(run):
    t, z = front_curve(run)
    ours, theirs = (lambda at: np.interp(at, z, t)), (lambda at: np.interp(at, FRONT["z_star"], FRONT["t_star"]))
    speed = {name: (end - start) / (ours(end) - ours(start)) for name, (start, end) in (("near", NEAR), ("far", FAR))}
    return {
        "ahead at z* = 4.1 [t*]": theirs(NEAR[1]) - ours(NEAR[1]),
        "ahead at 14 [t*]": theirs(FAR[1]) - ours(FAR[1]),
        "speed near": speed["near"], "near / theirs": speed["near"] * (theirs(NEAR[1]) - theirs(NEAR[0])) / np.ptp(NEAR),
        "speed far": speed["far"], "far / theirs": speed["far"] * (theirs(FAR[1]) - theirs(FAR[0])) / np.ptp(FAR),
    }


def pressure_curve(run, probe, averaged=True):
    """t* and p*."""
    t, p = run.time / WATER_TIME, run.probe(f"{probe}.p") / (DENSITY * G * HEIGHT)
    if averaged:
        width = 2 * int(round(SHORT / np.median(np.diff(t)) / 2)) + 1
        t, p = t[width // 2:-(width // 2)], np.convolve(p, np.full(width, 1 / width), mode="valid")
    return t, p


def within(t, interval):
    return (t >= interval[0]) & (t <= interval[1])


def arriving_head(run):
    """Mean of v²/2g + y + p/ρg over the water shortly before the wall, when the plateau is reached, over H."""
    frame = run.frame_near(np.mean(PLATEAU) * WATER_TIME)
    distance = WALL - frame.points[:, 0]
    near = frame.of(FLUID) & (distance > BEFORE_WALL[0]) & (distance < BEFORE_WALL[1])
    head = frame.speed() ** 2 / (2 * G) + frame.points[:, 1] + np.asarray(frame["pressure"], dtype=float) / (DENSITY * G)
    return head[near].mean() / HEIGHT


def measure_impact(run):
    t, raw = pressure_curve(run, "low", averaged=False)
    hit = np.flatnonzero(raw > SPREAD["peak"][1] / 2)
    energy = run.probe("energy.total")
    before = t < SPREAD["arrival"][0] - 2 * SHORT
    (at, low), (_, high) = pressure_curve(run, "low"), pressure_curve(run, "high")
    plateau, covered = low[within(at, PLATEAU)].mean(), within(HIGH["t_star"], COVERED)
    return {
        "arrival [t*]": t[hit[0]] if hit.size else np.nan,
        "peak 3 mm": low.max(), "first contact": raw.max(), "plateau 3 mm": plateau,
        "peak 30 mm": high[within(at, COVERED)].max(),
        "RMS 30 mm": np.sqrt(((np.interp(HIGH["t_star"], at, high) - HIGH["p_star"])[covered] ** 2).mean()),
        "plateau / head": plateau / arriving_head(run),
        "energy lost before [%]": 100 * (1 - energy[before][-1] / energy[0]),
    }


def judge_front(verdict, value):
    """Near the column friction is small, so the speed is compared; a lag that is constant is the start's (README). Far from it
    the tongue is thin: friction slows the experiment's, 15 %; 2 is the fastest that one without friction runs (Ritter)."""
    verdict.limit("front: speed for z* = 1.5 to 4.1 / theirs", value["near / theirs"], "", low=0.95, high=1.05)
    verdict.limit("front: ahead at z* = 4.1", value["ahead at z* = 4.1 [t*]"], "t*", low=0, high=0.5)
    verdict.limit("front: speed for z* = 4.1 to 14 / theirs", value["far / theirs"], "", low=0.85, high=1.15)
    verdict.limit("front: fastest, in sqrt(2ga)", value["speed far"], "", high=2)


def judge_impact(verdict, value):
    """Arrival within 5 %: friction and the gate's time are missing. Peak and plateau: where 95 % of the experiments lie."""
    arrival = SPREAD["arrival"][1]
    verdict.limit("arrival at the wall", value["arrival [t*]"], "t*", low=0.95 * arrival, high=1.05 * arrival)
    verdict.limit("peak at 3 mm", value["peak 3 mm"], "p*", low=SPREAD["peak"][0], high=SPREAD["peak"][2])
    verdict.limit("plateau at 3 mm", value["plateau 3 mm"], "p*", low=SPREAD["plateau"][0], high=SPREAD["plateau"][2])
    verdict.limit("peak at 30 mm / theirs", value["peak 30 mm"] / HIGH["p_star"][within(HIGH["t_star"], COVERED)].max(), "",
                  low=0.8, high=1.2)
    judge_physics(verdict, value)


def judge_physics(verdict, value):
    """The jet turns upwards in the corner, where its head becomes pressure: 15 % for its unsteadiness. Nothing dissipates before
    the impact but the method: 2 % of all energy."""
    verdict.limit("plateau at 3 mm / head of the arriving water", value["plateau / head"], "", low=0.85, high=1.15)
    verdict.limit("energy lost before the impact", value["energy lost before [%]"], "%", low=-0.1, high=2)


def judge_quick(verdict, front, impact):
    """At H/d = 30 and 40 the tongue is one or two particles thick and the impact noisy: arrival within 10 %, no peak."""
    verdict.limit("front: speed for z* = 1.5 to 4.1 / theirs", front["near / theirs"], "", low=0.9, high=1.1)
    verdict.limit("front: fastest, in sqrt(2ga)", front["speed far"], "", low=1.4, high=2)
    arrival = SPREAD["arrival"][1]
    verdict.limit("arrival at the wall", impact["arrival [t*]"], "t*", low=0.9 * arrival, high=1.1 * arrival)
    verdict.limit("plateau at 3 mm / head of the arriving water", impact["plateau / head"], "", low=0.7, high=1.3)
    verdict.limit("energy lost before the impact", impact["energy lost before [%]"], "%", low=-0.1, high=5)


def draw(front, impact, path):
    plt = style.use()
    figure, (left, low, high) = plt.subplots(1, 3, figsize=(9.6, 3.3), layout="constrained")
    for run, count, colour in zip(front.runs, front.counts, COLOURS):
        left.plot(*front_curve(run), color=colour, label=f"H/d = {count}")
    left.plot(FRONT["t_star"], FRONT["z_star"], "o", color=style.BLACK, markersize=3, label="Martin & Moyce")
    left.set(xlabel="t √(2g/a)", ylabel="front / a")
    for axis, probe, reference, title in ((low, "low", LOW, "3 mm"), (high, "high", HIGH, "30 mm")):
        for run, colour in zip(impact.runs, COLOURS):
            axis.plot(*pressure_curve(run, probe), color=colour, linewidth=0.9)
        axis.plot(reference["t_star"], reference["p_star"], "o-", color=style.BLACK, markersize=2, linewidth=0.6,
                  label="Lobovský et al.")
        axis.set(xlabel="t √(g/H)", ylabel=f"p / ρgH, {title} above the floor", xlim=(2, 4), ylim=(-0.2, 4))
    for value, at in zip(SPREAD["plateau"], ("low", "median", "high")):
        low.plot(PLATEAU, [value, value], color=style.VERMILION, linewidth=1.2 if at == "median" else 0.8)
    low.plot([SPREAD["arrival"][1]] * 2, [SPREAD["peak"][0], SPREAD["peak"][2]], color=style.VERMILION,
             label="95 % of them: peak, plateau")
    for axis in (left, low):
        axis.legend(fontsize=8)
    style.save(figure, path)


FRONT_SCENE = convergence.Measured(
    "Front on a long floor", ("H/d", 2 * WIDTH), errors=(),
    others=(("ahead at z* = 4.1 [t*]", 2), ("ahead at 14 [t*]", 2), ("speed near", 3), ("near / theirs", 3), ("speed far", 3),
            ("far / theirs", 3)), measure=measure_front)
IMPACT_SCENE = convergence.Measured(
    "Impact on the end wall", ("H/d", HEIGHT), errors=(),
    others=(("arrival [t*]", 3), ("peak 3 mm", 2), ("first contact", 1), ("plateau 3 mm", 2), ("peak 30 mm", 2),
            ("RMS 30 mm", 2), ("plateau / head", 2), ("energy lost before [%]", 2)), measure=measure_impact)


def plan(quick):
    counts = QUICK_COUNTS if quick else COUNTS
    return (convergence.runs_at("front", FRONT_SCENE.across[1], counts, scene="front.toml") +
            convergence.runs_at("impact", IMPACT_SCENE.across[1], counts))


def study(done):
    counts = QUICK_COUNTS if done.quick else COUNTS
    front = convergence.study_at(FRONT_SCENE, "front", counts, done)
    impact = convergence.study_at(IMPACT_SCENE, "impact", counts, done)
    verdict = Verdict()
    if done.quick:
        judge_quick(verdict, front.finest, impact.finest)
    else:
        judge_front(verdict, front.finest)
        judge_impact(verdict, impact.finest)
    picture = done.folder / "figure.svg"
    draw(front, impact, picture)
    return Result(
        verdict, tables=[of.table(of.case.title) for of in (front, impact)],
        errors=[("speed of the front, z* = 1.5 to 4.1", f"{100 * (front.finest['near / theirs'] - 1):+.1f} %"),
                ("arrival at the wall", f"{100 * (impact.finest['arrival [t*]'] / SPREAD['arrival'][1] - 1):+.1f} %"),
                ("pressure at 30 mm, RMS", f"{impact.finest['RMS 30 mm']:.2f} ρgH")],
        figures=[Figure(picture, "Front against Martin & Moyce; pressures on the end wall, averaged over 10 ms, against Lobovský et "
                                 "al.: their curves (black), and where 95 % of their experiments lie (red).", "figure.svg")])


CASE = case.Case("Dam break", FOLDER, "front and impact of water, without friction", "Martin & Moyce 1952; Lobovský et al. 2014",
                 plan, study)

if __name__ == "__main__":
    sys.exit(case.main(CASE))
