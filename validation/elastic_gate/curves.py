"""The free end against the published curves."""
from pathlib import Path

import numpy as np

from lib.curves import peak, read_reference, rms_difference

WINDOW = (0.04, 0.36)   # s: both digitisations of the experiment cover it
SOURCES = (("exp1", "experiment, digitisation 1"), ("exp2", "experiment, digitisation 2"),
           ("mean", "experiment, mean of both"), ("paper_sph", "Antoci 2007, SPH"),
           ("yang2012", "Yang 2012, SPH-FEM"), ("khayyer2018", "Khayyer 2018, ISPH-SPH"),
           ("ng2020", "Ng 2020, SPH-VCPM"))
NOISE_PERIOD = 5e-3     # s: pressure fluctuations are what a moving average over this leaves


def published():
    """(columns of reference.csv, the experiment's mean)"""
    reference = read_reference(Path(__file__).resolve().parent / "reference.csv")
    return reference, experiment_mean(reference)


def experiment_mean(reference):
    """Mean of the two digitisations, or the one that has a value."""
    mean = {}
    for component in "xy":
        both = np.array([reference[f"exp1_{component}"], reference[f"exp2_{component}"]])
        count = np.isfinite(both).sum(axis=0)
        mean[component] = np.where(count > 0, np.nansum(both, axis=0) / np.maximum(count, 1), np.nan)
    return mean


def deviations(run, reference, mean, window=WINDOW):
    """Per source: RMS of x and y, and how far the peak of x is off in height and time. [mm, s]"""
    time = reference["t_s"]
    ours = {c: 1e3 * run.probe(f"free_end.{c}") for c in "xy"}
    our_peak = peak(run.time, ours["x"])
    rows = {}
    for name, _ in SOURCES:
        theirs = {c: mean[c] if name == "mean" else reference[f"{name}_{c}"] for c in "xy"}
        their_peak = peak(time, theirs["x"])
        rows[name] = [rms_difference(run.time, ours[c], time, theirs[c], *window) for c in "xy"]
        rows[name] += [their_peak[1], our_peak[1] - their_peak[1], our_peak[0] - their_peak[0]]
    return our_peak, rows
