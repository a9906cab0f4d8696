"""Tables of several gate runs side by side: (particles across, run) from the coarsest to the finest."""
import numpy as np

import curves
import measures
from lib.case import Table
from lib.curves import faster_than, rms
from lib.markdown import number

TIMES = (0.04, 0.08, 0.12, 0.16, 0.20, 0.24, 0.28, 0.32, 0.36)


def curve_table(results, reference, mean, component):
    rows = []
    for across, run in results:
        values = 1e3 * np.interp(TIMES, run.time, run.probe(f"free_end.{component}"), right=np.nan)
        rows.append([f"sluice, d = s/{across}"] + [number(v, 1) for v in values])
    for name, label in curves.SOURCES:
        if name in ("exp1", "exp2"):
            continue
        column = mean[component] if name == "mean" else reference[f"{name}_{component}"]
        good = np.isfinite(column)
        values = np.interp(TIMES, reference["t_s"][good], column[good], right=np.nan)
        rows.append([label] + [number(v, 1) for v in values])
    direction = {"x": "horizontal, away from the tank", "y": "vertical, upwards"}[component]
    return Table(f"Free end, {direction} [mm]", ["t [s]"] + [f"{t:.2f}" for t in TIMES], rows)


def distance_table(results, reference, mean):
    rows = []
    for across, run in results:
        top, deviation = curves.deviations(run, reference, mean)
        rows.append([f"d = s/{across}", f"{top[1]:.1f} at {top[0]:.3f} s"] +
                    [f"{number(deviation[name][0], 1)} / {number(deviation[name][1], 1)}" for name, _ in curves.SOURCES])
    return Table("Distance to each source, RMS over 0.04 to 0.36 s",
                 ["x / y [mm]", "peak of x"] + [label for _, label in curves.SOURCES], rows)


def run_table(results):
    rows = []
    for across, run in results:
        frames, s = measures.measure(run), run.summary
        noise = rms(faster_than(run.time, run.probe("gate_pressure.p"), curves.NOISE_PERIOD))
        film = [frames.film_top[int(np.argmin(np.abs(np.array(frames.time) - t)))] -
                np.interp(t, run.time, run.probe("level.level")) for t in (0.2, 0.4)]
        particles = sum(s["particles"][phase] for phase in ("fluid", "solid", "wall"))
        rows.append([f"d = s/{across}", particles, s["steps"], number(s["cpu_seconds"], 0), number(s["max_speed"], 2),
                     f"{s['momentum_residual']:.0e}", number(noise, 0),
                     number(100 * max(frames.clumped), 2), f"{1e3 * film[0]:+.0f} / {1e3 * film[1]:+.0f}",
                     max(frames.inside), max(frames.behind), sum(frames.tunnelled)])
    return Table("Run", ["", "particles", "steps", "CPU [s]", "fastest water [m/s]", "momentum residual",
                         "pressure noise at the gate [Pa RMS]", "fluid pairs closer than 0.5 d [%]",
                         "film above the level at 0.2 / 0.4 s [mm]", "inside", "behind", "gone through"], rows)
