"""Curves against time: published ones from a CSV file, and what is measured on them."""
import csv

import numpy as np


def read_reference(path):
    """Columns of a CSV file with `#` comments; an empty cell is NaN, a column of words stays words."""
    with open(path, newline="") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    table = {}
    for name, *cells in zip(*rows):
        try:
            table[name] = np.array([float(cell) if cell.strip() else np.nan for cell in cells])
        except ValueError:
            table[name] = cells
    return table


def rms_difference(time, value, reference_time, reference, start, end):
    """RMS of `value` against `reference` at the reference's own times in [start, end]; NaN if the run is too short."""
    use = (reference_time >= start - 1e-9) & (reference_time <= end + 1e-9) & np.isfinite(reference)
    if not use.any() or len(time) < 2 or time[-1] < reference_time[use][-1] - 1e-3:
        return np.nan
    return np.sqrt(np.mean((np.interp(reference_time[use], time, value) - reference[use]) ** 2))


def peak(time, value):
    """(time, value) of the largest sample, refined by the parabola through its neighbours."""
    good = np.isfinite(value)
    time, value = time[good], value[good]
    i = int(np.argmax(value))
    if i == 0 or i == len(value) - 1:
        return time[i], value[i]
    a, b, c = np.polyfit(time[i - 1:i + 2] - time[i], value[i - 1:i + 2], 2)
    if a >= 0:
        return time[i], value[i]
    return time[i] - b / (2 * a), c - b * b / (4 * a)


def crossings(time, value, upward):
    """Times at which the curve passes zero in one direction, by linear interpolation."""
    before, after = value[:-1], value[1:]
    sign = 1 if upward else -1
    i = np.flatnonzero((sign * before < 0) & (sign * after >= 0))
    return time[i] + (time[i + 1] - time[i]) * before[i] / (before[i] - after[i])


def faster_than(time, value, period):
    """What is left of a signal after a centred moving average over `period`: its noise of higher frequency.

    The average lets everything slower than 0.44/period pass by half or more, and nothing at 1/period.
    Half a period is cut off at both ends, where the average lacks samples.
    """
    if len(time) < 3:
        return np.empty(0)
    width = max(3, 2 * int(round(period / np.median(np.diff(time)) / 2)) + 1)
    if len(value) <= width:
        return np.empty(0)
    average = np.convolve(value, np.full(width, 1 / width), mode="valid")
    return value[width // 2:-(width // 2)] - average


def rms(value):
    value = np.asarray(value)
    return float(np.sqrt(np.mean(value ** 2))) if value.size else np.nan
