#!/usr/bin/python3
"""Runs the wave of sound at three spacings with the modern preset, also with density diffusion, and with the paper's."""
import sys
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from lib import case, convergence, style  # noqa: E402
from lib.case import Errors, Figure, Result, Table  # noqa: E402
from lib.curves import crossings  # noqa: E402
from lib.markdown import number  # noqa: E402
from lib.run_output import FLUID  # noqa: E402
from lib.verdict import Verdict  # noqa: E402
from lib.waves import damped_oscillation  # noqa: E402

K, C, ALPHA = 2 * np.pi, 1.0, 0.5
H = 1.3                # h/d
PAPER = {"method.preset": "paper", "method.fluid.velocity_filter": 1, "method.fluid.artificial_viscosity": ALPHA}
DIFFUSION = {"method.fluid.density_diffusion": "fourtakas"}  # continuity is another loop then; it damps too
COUNTS, QUICK_COUNTS = (25, 50, 100), (50,)


def slope(smoothing_function, q):
    """W'(q) in two dimensions, with h = 1."""
    if smoothing_function == "wendland-c2":
        return -35 / (4 * np.pi) * q * np.maximum(1 - q / 2, 0) ** 3
    return -30 / (7 * np.pi) * (np.maximum(1 - q / 2, 0) ** 2 - np.maximum(1 - q, 0) ** 2)


def on_lattice(smoothing_function, count):
    """Frequency over c k of a wave on a square lattice: the sums of continuity and of pressure each have the factor
    sum_j V (-dW/dx) sin(k x)/k, which is 1 for the integral."""
    h = H / count
    n = np.arange(-3, 4)
    x, y = (a.ravel() / count for a in np.meshgrid(n, n))
    r = np.hypot(x, y)
    x, r = x[r > 0], r[r > 0]
    return np.sum(-slope(smoothing_function, r / h) / h ** 3 * x / r * np.sin(K * x) / K) / count ** 2


def damping(count):
    """Of artificial viscosity. For waves of compression its nu' is alpha c h/8 (lap v + 2 grad div v) in two dimensions, 3 alpha c
    h/8 along the wave [Monaghan 2005, section 8.2], and half of that because only approaching pairs feel it; gamma = k^2 nu'/2."""
    return 0.5 * K * K * 0.5 * 3 / 8 * ALPHA * C * H / count


def amplitudes(run):
    time, share = [], []
    for frame in run.frames():
        fluid = frame.of(FLUID)
        u, shape = np.asarray(frame["velocity"], dtype=float)[fluid, 0], np.sin(K * frame.points[fluid, 0])
        time.append(frame.time)
        share.append((u * shape).sum() / (shape ** 2).sum())
    return np.array(time), np.array(share)


def measure(run, count, smoothing_function):
    time, value = amplitudes(run)
    exact = damping(count)
    period = np.diff(crossings(time, value, upward=True)).mean()  # so that the fit finds it, however wrong it is
    omega, gamma = damped_oscillation(time, value, 2 * np.pi / period, exact)
    ratio = np.hypot(omega, gamma) / (K * C)  # of the wave without damping
    return {"frequency": ratio / on_lattice(smoothing_function, count) - 1, "frequency / c k": ratio,
            "damping": gamma / exact - 1, "CPU [s]": run.summary["cpu_seconds"]}


def plan(quick):
    counts = QUICK_COUNTS if quick else COUNTS
    return (convergence.runs_at("modern", 1.0, counts) + convergence.runs_at("diffusion", 1.0, counts, DIFFUSION) +
            convergence.runs_at("paper", 1.0, counts, PAPER))


def study(done):
    counts = QUICK_COUNTS if done.quick else COUNTS
    verdict, tables, errors, lines = Verdict(), [], [], []
    for name, smoothing_function in (("modern", "wendland-c2"), ("diffusion", "wendland-c2"), ("paper", "cubic-spline")):
        values = [measure(done.runs[f"{name}_{n}"], n, smoothing_function) for n in counts]
        for what, limit in (("frequency", 0.5), ("damping", 5))[:1 if name == "diffusion" else 2]:
            verdict.limit(f"{name}: {what}, finest: off by", 100 * abs(values[-1][what]), "%", high=limit)
            errors.append((f"{name}: {what}", f"{100 * values[-1][what]:+.2f} %"))
        lines.append(Errors(f"{name}: damping", list(counts), [abs(v["damping"]) for v in values]))
        tables.append(Table(name, ["L/d", "ω / c k", "of the lattice", "off [%]", "γ off [%]", "CPU [s]"], [
            [n, number(v["frequency / c k"], 4), number(on_lattice(smoothing_function, n), 4),
             number(100 * v["frequency"], 2), number(100 * v["damping"], 2), number(v["CPU [s]"], 2)]
            for n, v in zip(counts, values)], "ω without damping; *of the lattice*: what the sums at this h/d give."))
    picture = done.folder / "figure.svg"
    draw(done.runs[f"modern_{counts[-1]}"], done.runs[f"paper_{counts[-1]}"], counts[-1], picture)
    return Result(verdict, errors, tables, [Figure(picture, "The wave's share in the velocity, over its start, at the finest "
                                                            "spacing; dashed: the envelope of theory.")], lines)


def draw(modern, paper, count, path):
    plt = style.use()
    figure, axis = plt.subplots(figsize=(6.3, 2.6), layout="constrained")
    for run, name, colour in ((modern, "modern", style.BLUE), (paper, "paper", style.ORANGE)):
        time, value = amplitudes(run)
        axis.plot(time, value / value[0], color=colour, label=name, linewidth=1)
    for sign in (1, -1):
        axis.plot(time, sign * np.exp(-damping(count) * time), color=style.BLACK, linewidth=0.8, linestyle=(0, (5, 2)))
    axis.set_xlabel("time [s]")
    axis.set_ylabel("amplitude")
    axis.grid(color="0.92", linewidth=0.5)
    axis.legend(fontsize=8)
    style.save(figure, path)


CASE = case.Case("Standing wave of sound", FOLDER, "continuity, state equation and artificial viscosity by themselves",
                 "linear theory", plan, study)

if __name__ == "__main__":
    sys.exit(case.main(CASE))
