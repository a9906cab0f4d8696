#!/usr/bin/python3
"""Holds a run of the elastic gate against the published curves: tables, criteria with a verdict, pictures.

The exit code is 0 if every criterion is met, 1 if not, 2 if the run cannot be read.
"""
import argparse
import sys
from pathlib import Path

import numpy as np

CASE = Path(__file__).resolve().parent
sys.path.insert(0, str(CASE.parent))

import figures  # noqa: E402
import measures  # noqa: E402
from lib.curves import faster_than, peak, read_reference, rms, rms_difference  # noqa: E402
from lib.run_output import RunError, RunOutput  # noqa: E402
from lib.verdict import Verdict  # noqa: E402

WINDOW = (0.04, 0.36)   # s: both digitisations of the experiment cover it
SOURCES = (("exp1", "experiment, digitisation 1"), ("exp2", "experiment, digitisation 2"),
           ("mean", "experiment, mean of both"), ("paper_sph", "Antoci 2007, SPH"),
           ("yang2012", "Yang 2012, SPH-FEM"), ("khayyer2018", "Khayyer 2018, ISPH-SPH"),
           ("ng2020", "Ng 2020, SPH-VCPM"))
NOISE_PERIOD = 5e-3     # s: pressure fluctuations are what a moving average over this leaves
ENERGIES = ("kinetic", "potential", "compression", "elastic")


def experiment_mean(reference):
    """Mean of the two digitisations, or the one that has a value."""
    mean = {}
    for component in "xy":
        both = np.array([reference[f"exp1_{component}"], reference[f"exp2_{component}"]])
        count = np.isfinite(both).sum(axis=0)
        mean[component] = np.where(count > 0, np.nansum(both, axis=0) / np.maximum(count, 1), np.nan)
    return mean


def deviations(run, reference, mean):
    """Per source: RMS of x and y, and how far the peak of x is off in height and time. [mm, s]"""
    time = reference["t_s"]
    ours = {c: 1e3 * run.probe(f"free_end.{c}") for c in "xy"}
    our_peak = peak(run.time, ours["x"])
    rows = {}
    for name, _ in SOURCES:
        theirs = {c: mean[c] if name == "mean" else reference[f"{name}_{c}"] for c in "xy"}
        their_peak = peak(time, theirs["x"])
        rows[name] = [rms_difference(run.time, ours[c], time, theirs[c], *WINDOW) for c in "xy"]
        rows[name] += [their_peak[1], our_peak[1] - their_peak[1], our_peak[0] - their_peak[0]]
    return our_peak, rows


def print_deviations(run, our_peak, rows):
    print(f"Free end against published curves, {WINDOW[0]:g} to {WINDOW[1]:g} s; "
          f"peak {our_peak[1]:.1f} mm at {our_peak[0]:.3f} s")
    if run.time[-1] < WINDOW[1]:
        print(f"  (the run ends at {run.time[-1]:.3g} s: too early for the RMS, and the peak is that of its part)")
    print(f"  {'':<28} {'RMS x':>7} {'RMS y':>7}   {'their peak':>10} {'ours off by':>11} {'later by':>9}")
    for name, label in SOURCES:
        rx, ry, top, off, later = rows[name]
        print(f"  {label:<28} {_mm(rx)} {_mm(ry)}   {top:>7.1f} mm {off:>+8.1f} mm {later:>+7.3f} s")


def _mm(value):
    return f"{value:>4.1f} mm" if np.isfinite(value) else f"{'-':>7}"


def judge(run, our_peak, rows, frames):
    verdict = Verdict()
    verdict.limit("RMS of x against the experiment", rows["mean"][0], "mm", high=6)
    verdict.limit("RMS of y against the experiment", rows["mean"][1], "mm", high=4)
    verdict.limit("peak of x", our_peak[1], "mm", low=41, high=51)
    verdict.none_of("water particles inside the gate, worst frame", max(frames.inside, default=None))
    verdict.none_of("water particles behind the gate, worst frame", max(frames.behind, default=None))
    verdict.none_of("water particles gone through it, all frames", sum(frames.tunnelled) if frames.time else None)
    fastest = run.summary.get("max_speed")  # null after a numerical failure
    verdict.limit("fastest water particle, all steps", fastest, "m/s", high=measures.SPEED_LIMIT)
    verdict.limit("momentum lost between water and gate", run.summary.get("momentum_residual"), "", high=1e-12)
    return verdict


def print_measured(run, frames):
    print("Measured, without a limit")
    p = run.probe("gate_pressure.p")
    for period in (NOISE_PERIOD, 10 * NOISE_PERIOD):
        noise = rms(faster_than(run.time, p, period))
        print(f"  pressure noise at the gate: {noise:.1f} Pa RMS about a moving average over {1e3 * period:g} ms "
              f"(the pressure there is {np.nanmax(p):.0f} Pa at most)")
    if frames.time:
        worst = int(np.argmax(frames.clumped))
        print(f"  clumping, share of the pairs within {measures.REACH:g} d that are closer than {measures.CLOSE:g} d: "
              f"{_clumped_at(frames, 0.2)}worst {100 * frames.clumped[worst]:.3f} % at {frames.time[worst]:.2f} s")
        print(f"  water within half a spacing of the gate's outermost particles, worst frame: "
              f"{max(frames.within_surface)}")
        for time in (0.2, 0.4):
            print_film(run, frames, time)
    print_energy(run)
    summary = run.summary
    print(f"  cost: {_number(summary.get('cpu_seconds'))} s of CPU time, {_number(summary.get('wall_seconds'))} s by "
          f"the clock, {summary.get('steps', '-')} steps")


def _clumped_at(frames, time):
    if frames.time[-1] < time - 1e-6:
        return ""
    i = int(np.argmin(np.abs(np.array(frames.time) - time)))
    return f"{100 * frames.clumped[i]:.3f} % at {frames.time[i]:.2f} s, "


def print_film(run, frames, time):
    if frames.time[-1] < time - 1e-6:
        return
    i = int(np.argmin(np.abs(np.array(frames.time) - time)))
    levels = [name for name in run.probes if name.startswith("level.")]
    level = np.interp(frames.time[i], run.time, run.probe(levels[0])) if levels else np.nan
    film = frames.film_top[i]
    print(f"  film on gate and wall at {frames.time[i]:.2f} s: up to {1e3 * film:.0f} mm, "
          f"{1e3 * (film - level):+.0f} mm against the level in the tank ({1e3 * level:.0f} mm)")


def print_energy(run):
    parts = {name: run.probes[f"energy.{name}"] for name in ENERGIES if f"energy.{name}" in run.probes}
    if not parts:
        return
    total = sum(parts.values())
    shares = ", ".join(f"{name} {value[-1] - value[0]:+.3f}" for name, value in parts.items())
    print(f"  energy from start to end [J/m]: {shares}; together {total[-1] - total[0]:+.3f} "
          f"({100 * (total[-1] - total[0]) / abs(total[0]):+.1f} % of the {total[0]:.2f} at the start)")


def _number(value):
    return "-" if value is None else f"{value:.0f}"


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("folder", help="folder of the run")
    arguments.add_argument("--quiet", action="store_true", help="only the criteria and the verdict, no pictures")
    options = arguments.parse_args()
    try:
        return compare(RunOutput(options.folder), options.quiet)
    except RunError as error:
        print(f"Elastic gate: cannot compare: {error}", file=sys.stderr)
        return 2


def compare(run, quiet):
    reference = read_reference(CASE / "reference.csv")
    mean = experiment_mean(reference)
    our_peak, rows = deviations(run, reference, mean)
    frames = measures.measure(run) if len(run.frame_times()) else measures.GateMeasures()
    if not quiet:
        print_deviations(run, our_peak, rows)
        print_measured(run, frames)
        print("Criteria")
    verdict = judge(run, our_peak, rows, frames)
    verdict.print_table()
    if not quiet:
        figures.draw_displacement([("sluice", run)], reference, mean, run.folder / "displacement.svg")
        print(f"Pictures: {run.folder / 'displacement.svg'}")
        if frames.time:
            figures.draw_flow(run, run.folder / "flow.png")
            figures.draw_stress(run, run.folder / "stress.png")
            print(f"          {run.folder / 'flow.png'}\n          {run.folder / 'stress.png'}")
    return verdict.close("Elastic gate")


if __name__ == "__main__":
    sys.exit(main())
