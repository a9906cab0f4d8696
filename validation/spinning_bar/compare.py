#!/usr/bin/python3
"""Runs the spinning bar as a hypoelastic and as a total-Lagrangian solid at 4, 6 and 10 particles across, and as a neo-Hookean
one in 3D: how it swings, its stress, and how far it turns."""
import sys
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from lattice import Bar, Found, middle_stress, softened, stretch  # noqa: E402
from lib import case, convergence, style  # noqa: E402
from lib.case import Errors, Figure, Result, Table  # noqa: E402
from lib.markdown import number  # noqa: E402
from lib.verdict import Verdict  # noqa: E402
from lib.waves import damped_oscillation  # noqa: E402

BAR = Bar(half=0.1, height=0.02, density=1000.0, youngs=2.5e6, spin=25.0)
FREQUENCY = np.pi * BAR.speed / (2 * BAR.half)  # of the first mode [rad/s]
TURN = 1 - 0.8 * (BAR.spin * BAR.half / BAR.speed) ** 2  # what is longer turns slower: mean over many periods
HYPOELASTIC = {"smoothing_length": 1.5, "alpha": 1.0, "artificial_stress": 0.3}  # the scene
TOTAL_LAGRANGIAN = {"method.preset": "modern", "method.smoothing_length": 1.2, "method.courant": 0.9,
                    "method.solid.artificial_viscosity": 0}  # nothing takes energy away
LINEAR_THEORY = Found(frequency=1.0, stretch=1.0, stress=1.0, damping=0.0)
COUNTS, QUICK_COUNTS = (4, 6, 10), (4,)
SERIES = {"hypoelastic": "Hypoelastic", "total_lagrangian": "Total Lagrangian", "neo_hookean": "Neo-Hookean, 3D"}


def elongation(run, terms=8):
    """Of one half over time, linear theory: the stretch at rest less a series of standing waves."""
    k = (2 * np.arange(terms) + 1) * np.pi / (2 * BAR.half)
    waves = 2 * BAR.spin ** 2 / (BAR.half * BAR.speed ** 2 * k ** 4)
    return stretch(BAR, BAR.half) - np.cos(np.outer(run.time, BAR.speed * k)) @ waves


def ends(run):
    """From the left end to the right one: length less that at the start, per half [m], and angle [rad]."""
    x = 2 * BAR.half + run.probe("right.x") - run.probe("left.x")
    y = run.probe("right.y") - run.probe("left.y")
    return 0.5 * np.hypot(x, y) - BAR.half, np.unwrap(np.arctan2(y, x))


def swing(time, value, omega, gamma):
    """(mean, ω, γ) of value = mean + e^(−γt) (a cos ωt + b sin ωt)"""
    for _ in range(6):
        mean = mean_of(time, value, omega, gamma)
        omega, gamma = damped_oscillation(time, value - mean, omega, gamma)
    return mean, omega, gamma


def mean_of(time, value, omega, gamma):
    envelope = np.exp(-gamma * time)
    terms = np.stack([np.ones_like(time), envelope * np.cos(omega * time), envelope * np.sin(omega * time)], axis=1)
    return np.linalg.lstsq(terms, value, rcond=None)[0][0]


def stresses(run):
    """Time, and the middle's stress: along the bar as it lies, across it, shear; then in the axes of space [Pa]."""
    rows = []
    for frame in run.frames():
        angle = np.interp(frame.time, run.time, ends(run)[1])
        along, across = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
        middle = np.abs(frame.points @ along) < 0.1 * BAR.half
        xx, yy, xy = (np.asarray(frame[f"stress_{name}"], dtype=float)[middle].mean() for name in ("xx", "yy", "xy"))
        tensor = np.array([[xx, xy], [xy, yy]])
        rows.append([frame.time, along @ tensor @ along, across @ tensor @ across, along @ tensor @ across, xx, yy, xy])
    return np.array(rows).T


def measure(run, expected):
    length, angle = ends(run)
    mean, omega, gamma = swing(run.time, length, expected.frequency * FREQUENCY, expected.damping)
    time, along, across, shear, *_ = stresses(run)
    scale = middle_stress(BAR)
    return {"frequency": np.hypot(omega, gamma) / FREQUENCY, "stretch": mean / stretch(BAR, BAR.half), "damping": gamma,
            "along": mean_of(time, along, omega, gamma) / scale, "across": np.abs(across).max() / scale,
            "shear": np.abs(shear).max() / scale, "turn": angle[-1] / (BAR.spin * run.time[-1]),
            "CPU": run.summary["cpu_seconds"]}


def plan(quick):
    counts = QUICK_COUNTS if quick else COUNTS
    return (convergence.runs_at("hypoelastic", BAR.height, counts) +
            convergence.runs_at("total_lagrangian", BAR.height, counts, TOTAL_LAGRANGIAN) +
            convergence.runs_at("neo_hookean", BAR.height, QUICK_COUNTS, scene="neo_hookean_3d.toml"))


def study(done):
    verdict, tables, errors, lines = Verdict(), [], [], []
    for name, title in SERIES.items():
        counts = QUICK_COUNTS if done.quick or name == "neo_hookean" else COUNTS
        expected = [softened(BAR, n, **HYPOELASTIC) if name == "hypoelastic" else LINEAR_THEORY for n in counts]
        found = [measure(done.runs[f"{name}_{n}"], e) for n, e in zip(counts, expected)]
        judge(verdict, title, found[-1], expected[-1])
        tables.append(table(title, counts, found, expected))
        errors += [(f"{title}: {what}", f"{100 * (found[-1][what] - 1):+.2f} %") for what in ("frequency", "stretch")]
        if len(counts) > 1 or done.quick:
            lines.append(Errors(f"{title}: frequency", list(counts), [abs(value["frequency"] - 1) for value in found]))
    picture, finest = done.folder / "figure.svg", (QUICK_COUNTS if done.quick else COUNTS)[-1]
    draw(done.runs[f"hypoelastic_{finest}"], done.runs[f"total_lagrangian_{finest}"], picture)
    return Result(verdict, errors, tables, [Figure(
        picture, "Above: how much longer a half is, five periods of theory (dashed). Below: stress in the middle of the "
                 "hypoelastic bar, in the axes of space, over that at rest; dashed: its tension, along the bar as it lies.",
        "figure.svg")], lines)


def judge(verdict, title, found, expected):
    """Finest spacing, against what is expected: the lattice's, or linear theory."""
    verdict.limit(f"{title}: turned / expected", found["turn"] / (1 - (1 - TURN) * expected.stretch), "", 0.9995, 1.0005)
    verdict.limit(f"{title}: frequency / expected", found["frequency"] / expected.frequency, "", 0.995, 1.005)
    verdict.limit(f"{title}: stretch / expected", found["stretch"] / expected.stretch, "", 0.99, 1.01)
    verdict.limit(f"{title}: stress along / expected", found["along"] / expected.stress, "", 0.98, 1.02)
    verdict.limit(f"{title}: stress across, largest", found["across"], "", high=0.04)
    verdict.limit(f"{title}: shear, largest", found["shear"], "", high=0.02)
    if expected.damping:
        verdict.limit(f"{title}: damping / expected", found["damping"] / expected.damping, "", 0.95, 1.05)


def table(title, counts, found, expected):
    def both(value, wanted):
        return f"{value:.4f} ({wanted:.4f})"

    return Table(title, ["across", "ω / theory", "stretch / theory", "stress along", "across", "shear", "turned", "γ [1/s]",
                         "CPU [s]"], [
        [n, both(f["frequency"], e.frequency), both(f["stretch"], e.stretch), both(f["along"], e.stress),
         number(f["across"], 3), number(f["shear"], 3), number(f["turn"], 5), f"{f['damping']:.3f} ({e.damping:.3f})",
         number(f["CPU"], 1)] for n, f, e in zip(counts, found, expected)],
        "In brackets what is expected: linear theory, or what the lattice's sums make of it. Stresses are those of the middle "
        "over ρ Ω² a²/2; along the bar as it lies then: mean; across and shear: the largest of all frames.")


def draw(hypoelastic, total_lagrangian, path):
    plt = style.use()
    figure, (top, bottom) = plt.subplots(2, 1, figsize=(6.3, 4.6), layout="constrained")
    for run, name, colour in ((total_lagrangian, "total Lagrangian", style.ORANGE), (hypoelastic, "hypoelastic", style.BLUE)):
        top.plot(1e3 * run.time, 1e3 * ends(run)[0], color=colour, label=name, linewidth=1)
    dashed = {"color": style.BLACK, "linewidth": 0.8, "linestyle": (0, (5, 2))}
    top.plot(1e3 * run.time, 1e3 * elongation(run), label="linear theory", **dashed)
    top.set_xlim(0, 5e3 * 2 * np.pi / FREQUENCY)
    top.set_xlabel("time [ms]")
    top.set_ylabel("longer by [mm]")
    time, along, _, _, xx, yy, xy = stresses(hypoelastic)
    angle = np.interp(time, hypoelastic.time, ends(hypoelastic)[1])
    turned = (np.cos(angle) ** 2, np.sin(angle) ** 2, np.sin(angle) * np.cos(angle))
    for value, share, name, colour in zip((xx, yy, xy), turned, ("σ xx", "σ yy", "σ xy"),
                                          (style.BLUE, style.VERMILION, style.ORANGE)):
        bottom.plot(1e3 * time, value / middle_stress(BAR), color=colour, label=name, linewidth=1)
        bottom.plot(1e3 * time, along * share / middle_stress(BAR), **dashed)
    bottom.set_xlim(0, 1e3 * time[-1])
    bottom.set_xlabel("time [ms]")
    bottom.set_ylabel("stress")
    for axis in (top, bottom):
        axis.grid(color="0.92", linewidth=0.5)
        axis.set_ylim(top=1.25 * axis.get_ylim()[1])
        axis.legend(fontsize=8, loc="upper center", ncol=3)
    style.save(figure, path)


CASE = case.Case("Spinning bar", FOLDER, "a stressed solid that turns: the side to which a hypoelastic stress turns",
                 "linear theory", plan, study)

if __name__ == "__main__":
    sys.exit(case.main(CASE))
