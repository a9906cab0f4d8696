"""The static state of an undamped body whose load has come slowly."""
import numpy as np


def resting_value(time, value, start, period):
    """(mean, amplitude) of what swings around rest after `start`: the best c + a cos wt + b sin wt, of all w between
    0.6 and 1.4 times 2 pi/`period`. Needs samples over a period or so; (NaN, NaN) if there are fewer."""
    use = time >= start
    if not use.any() or time[-1] - start < 0.8 * period:
        return np.nan, np.nan
    t, v = time[use] - start, value[use]
    best = None
    for omega in 2 * np.pi / period * np.linspace(0.6, 1.4, 161):
        basis = np.column_stack([np.ones_like(t), np.cos(omega * t), np.sin(omega * t)])
        solution = np.linalg.lstsq(basis, v, rcond=None)[0]
        error = np.sum((basis @ solution - v) ** 2)
        if best is None or error < best[0]:
            best = (error, solution[0], np.hypot(*solution[1:]))
    return best[1], best[2]
