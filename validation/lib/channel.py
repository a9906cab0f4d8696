"""Flows between two plates from rest, u(y, t): what Poiseuille and Couette flow share."""
import numpy as np

from lib import convergence, style
from lib.run_output import FLUID
from lib.verdict import Verdict

SPEED, WIDTH, NU = 1.0, 1.0, 0.1
EARLY = 0.5     # s, L²/(20 ν): the flow from the walls has just met
TERMS = 200     # of the series; at EARLY the third is below 1e-5 of the first


def of_fluid(frame):
    """y, u and v of the fluid's particles."""
    fluid = frame.of(FLUID)
    velocity = np.asarray(frame["velocity"], dtype=float)[fluid]
    return frame.points[fluid, 1], velocity[:, 0], velocity[:, 1]


def errors(frame, exact):
    y, u, v = of_fluid(frame)
    return np.sqrt(((u - exact(y, frame.time)) ** 2).mean()) / SPEED, np.abs(v).max() / SPEED


def make_case(title, folder, proves, exact):
    def measure(run):
        early, _ = errors(run.frame_near(EARLY), exact)
        last = list(run.frames())[-1]
        late, across = errors(last, exact)
        y, u, _ = of_fluid(last)
        return {"u at 0.5 s, L2": early, "u at the end, L2": late, "mean u / exact": u.mean() / exact(y, last.time).mean(),
                "fastest across, of U": across}

    def judge(study):
        verdict = Verdict()
        verdict.limit("L2 error of u at 0.5 s / U, finest", 100 * study.finest["u at 0.5 s, L2"], "%", high=1)
        verdict.limit("L2 error of u at the end / U, finest", 100 * study.finest["u at the end, L2"], "%", high=1)
        study.require_order(verdict, "u at 0.5 s, L2")
        study.require_order(verdict, "u at the end, L2")
        return verdict

    def draw(study, path):
        plt = style.use()
        figure, axis = plt.subplots(figsize=(5.2, 3.6), layout="constrained")
        y = np.linspace(0, WIDTH, 201)
        for time in (EARLY, 2 * EARLY, study.runs[-1].frame_times()[-1]):
            axis.plot(exact(y, time), y, color=style.BLACK, linewidth=0.8, label="exact" if time == EARLY else None)
            for run, count, colour, size in zip(study.runs, study.counts, (style.ORANGE, style.SKY, style.BLUE), (4, 3, 1)):
                at, u, _ = of_fluid(run.frame_near(time))
                axis.plot(u, at, ".", markersize=size, color=colour, label=f"L/d = {count}" if time == EARLY else None)
        axis.set_xlabel("u [m/s]")
        axis.set_ylabel("y [m]")
        axis.legend()
        style.save(figure, path)

    return convergence.Case(
        title, folder, proves, "series in time", across=("L/d", WIDTH), counts=(20, 40, 80),
        errors=("u at 0.5 s, L2", "u at the end, L2"), others=(("mean u / exact", 4), ("fastest across, of U", 4)),
        measure=measure, judge=judge, draw=draw,
        caption=f"Velocity across the channel at {EARLY:g} s, {2 * EARLY:g} s and the end, every particle, against the series.",
        quick_counts=(20,), quick_limits={"u at 0.5 s, L2": 0.005, "u at the end, L2": 0.01})
