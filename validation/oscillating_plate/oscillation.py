"""Amplitude and period of the plate's first oscillation, from its free end."""
import numpy as np

from lib.curves import crossings, peak

LENGTH = 0.2           # m
SOUND_SPEED = np.sqrt(3.25e6 / 1000)  # m/s, of the plate


def first_oscillation(run):
    """A/L and T c0/L: A is the first maximum (and the depth of the first trough beside it); T the time from the start, where the end passes zero upwards, to its
    second upward pass. None for a value that the run does not reach."""
    time, y = run.time, run.probe("free_end.y")
    down = crossings(time, y, upward=False)
    up = crossings(time, y, upward=True)
    up = up[up > down[0]] if len(down) else up[:0]
    result = {"amplitude": None, "trough": None, "period": None}
    if len(down):
        result["amplitude"] = peak(time[time < down[0]], y[time < down[0]])[1] / LENGTH
    if len(up):
        half = (time > down[0]) & (time < up[0])
        result["trough"] = peak(time[half], -y[half])[1] / LENGTH
        result["period"] = up[0] * SOUND_SPEED / LENGTH
    return result
