#!/usr/bin/python3
"""Runs the elastic gate with the paper's scheme at the paper's resolution; compares its free end with the published curves.

With --run DIR it takes the run that is in DIR as it is (run.sh does), prints all that is measured and draws beside it. The exit
code is 0 if every criterion is met, 1 if not, 2 if the run cannot be read.
"""
import argparse
import sys
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

import curves  # noqa: E402
import figures  # noqa: E402
import measures  # noqa: E402
from curves import NOISE_PERIOD, SOURCES, WINDOW  # noqa: E402
from lib import case  # noqa: E402
from lib.case import Figure, Result, Run, Table  # noqa: E402
from lib.curves import faster_than, rms  # noqa: E402
from lib.markdown import number  # noqa: E402
from lib.run_output import RunError, RunOutput  # noqa: E402
from lib.verdict import Verdict  # noqa: E402

ENERGIES = ("kinetic", "potential", "compression", "elastic")
QUICK = {"method.spacing": "0.00125", "output.end": 0.1}  # four particles across; nearly to the peak
QUICK_WINDOW = (0.02, 0.1)  # s
QUICK_LIMITS = {"x": 1.2, "y": 1.9}  # mm RMS to the paper's own curve: 0.75 and 1.5; with three quarters of E 1.6 and 2.3


def plan(quick):
    return [Run("paper", QUICK if quick else {})]


def study(done):
    run = done.runs["paper"]
    reference, mean = curves.published()
    window = QUICK_WINDOW if done.quick else WINDOW
    our_peak, rows = curves.deviations(run, reference, mean, window)
    frames = measures.measure(run)
    flow, displacement, stress = (done.folder / name for name in ("flow.png", "displacement.svg", "stress.png"))
    figures.draw_flow(run, flow)
    figures.draw_displacement([("sluice", run)], reference, mean, displacement)
    figures.draw_stress(run, stress)
    return Result(
        judge_quick(run, rows, frames) if done.quick else judge(run, our_peak, rows, frames),
        errors=[(f"free end to {label}, RMS x / y", f"{number(rows[name][0], 1)} / {number(rows[name][1], 1)} mm")
                for name, label in (("mean", "the experiment"), ("paper_sph", "the paper's SPH"))],
        tables=[deviation_table(our_peak, rows, window), energy_table(run)],
        figures=[Figure(flow, "Frames like the paper's Fig. 13: pressure of the water, von Mises stress in the gate.", "flow.png"),
                 Figure(displacement, "Free end of the gate. The experiment's mean of two digitisations with its uncertainty of "
                                      f"± {figures.EXPERIMENT_ERROR:g} mm (grey), the paper's simulation and later ones.",
                        "displacement.svg"),
                 Figure(stress, "Stresses in the gate, like the paper's Figs. 16–18.")],
        measures={} if done.quick else {"peak of x": f"{our_peak[1]:.1f} mm"})


def judge_quick(run, rows, frames):
    verdict = Verdict()
    for i, (component, limit) in enumerate(QUICK_LIMITS.items()):
        verdict.limit(f"RMS of {component} against the paper's SPH, early", rows["paper_sph"][i], "mm", high=limit)
    judge_water(verdict, run, frames)
    return verdict


def deviation_table(our_peak, rows, window):
    return Table(f"Free end, {window[0]:g} to {window[1]:g} s; our peak of x: {our_peak[1]:.1f} mm at {our_peak[0]:.3f} s",
                 ["", "RMS x [mm]", "RMS y [mm]", "their peak [mm]", "ours off by [mm]", "later by [s]"],
                 [[label, number(rx, 1), number(ry, 1), number(top, 1), f"{off:+.1f}", f"{later:+.3f}"]
                  for (_, label), (rx, ry, top, off, later) in zip(SOURCES, rows.values())])


def energy_table(run):
    parts = {name: run.probe(f"energy.{name}") for name in (*ENERGIES, "total")}
    return Table("Energy [J/m]", ["", *parts], [[f"t = {run.time[i]:.2g} s"] + [number(part[i], 3) for part in parts.values()]
                                                 for i in (0, -1)])


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
    judge_water(verdict, run, frames)
    return verdict


def judge_water(verdict, run, frames):
    verdict.none_of("water particles inside the gate, worst frame", max(frames.inside, default=None))
    verdict.none_of("water particles behind the gate, worst frame", max(frames.behind, default=None))
    verdict.none_of("water particles gone through it, all frames", sum(frames.tunnelled) if frames.time else None)
    fastest = run.summary.get("max_speed")  # null after a numerical failure
    verdict.limit("fastest water particle, all steps", fastest, "m/s", high=measures.SPEED_LIMIT)
    verdict.limit("momentum lost between water and gate", run.summary.get("momentum_residual"), "", high=1e-12)


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
    arguments = argparse.ArgumentParser(add_help=False)
    arguments.add_argument("--run", metavar="DIR")
    arguments.add_argument("--quiet", action="store_true", help="only the criteria and the verdict, no pictures")
    options, others = arguments.parse_known_args()
    if options.run is None:
        return case.main(CASE)
    if others:
        arguments.error(f"with --run DIR there is no {others[0]}")
    try:
        return compare(RunOutput(options.run), options.quiet)
    except RunError as error:
        print(f"Elastic gate: cannot compare: {error}", file=sys.stderr)
        return 2


def compare(run, quiet):
    reference, mean = curves.published()
    our_peak, rows = curves.deviations(run, reference, mean)
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


CASE = case.Case("Elastic gate, the paper's scheme", FOLDER, "fluid, solid and interface together",
                 "experiment and simulation of Antoci 2007; Yang 2012; Khayyer 2018; Ng 2020", plan, study)

if __name__ == "__main__":
    sys.exit(main())
