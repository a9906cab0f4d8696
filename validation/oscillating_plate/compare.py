#!/usr/bin/python3
"""Holds a run of the oscillating plate against the paper and thin-plate theory; exit code 0 if the criteria are met."""
import argparse
import sys
from pathlib import Path

import numpy as np

CASE = Path(__file__).resolve().parent
sys.path.insert(0, str(CASE.parent))

from lib import style  # noqa: E402
from lib.curves import read_reference  # noqa: E402
from lib.markdown import number  # noqa: E402
from lib.run_output import RunError, RunOutput  # noqa: E402
from lib.verdict import Verdict  # noqa: E402
from oscillation import LENGTH, SOUND_SPEED, first_oscillation  # noqa: E402


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("folder", help="folder of the run")
    options = arguments.parse_args()
    try:
        return compare(RunOutput(options.folder))
    except RunError as error:
        print(f"Oscillating plate: cannot compare: {error}", file=sys.stderr)
        return 2


def compare(run):
    reference = read_reference(CASE / "reference.csv")
    ours = first_oscillation(run)
    print("First oscillation of the free end          A/L   T c0/L")
    print(f"  {'sluice':<34} {number(ours['amplitude'], 4):>10} {number(ours['period'], 2):>8}")
    for name, amplitude, period in zip(reference["source"], reference["amplitude"], reference["period"]):
        print(f"  {name:<34} {amplitude:>10.4f} {period:>8.2f}")
    print(f"  (first trough: A/L {number(ours['trough'], 4)})")
    verdict = Verdict()
    verdict.limit("A/L", ours["amplitude"], "", low=0.118, high=0.134)
    verdict.limit("T c0/L", ours["period"], "", low=78, high=87)
    verdict.print_table()
    draw(run, reference, run.folder / "oscillation.svg")
    print(f"Picture: {run.folder / 'oscillation.svg'}")
    return verdict.close("Oscillating plate")


def draw(run, reference, path):
    plt = style.use()
    figure, axis = plt.subplots(figsize=(6.3, 3.2), layout="constrained")
    t = np.linspace(0, run.time[-1], 600)
    colours = {"paper_sph": (style.ORANGE, "Antoci 2007 (its A and T)"), "thin_plate": (style.GREEN, "thin-plate theory")}
    for name, amplitude, period in zip(reference["source"], reference["amplitude"], reference["period"]):
        colour, label = colours[name]
        axis.plot(t * SOUND_SPEED / LENGTH, amplitude * np.sin(2 * np.pi * t * SOUND_SPEED / LENGTH / period),
                  color=colour, linestyle=(0, (5, 2)), linewidth=1.2, label=label)
    axis.plot(run.time * SOUND_SPEED / LENGTH, run.probe("free_end.y") / LENGTH, color=style.BLUE, linewidth=2, label="sluice")
    axis.set_xlabel("time t c0/L")
    axis.set_ylabel("free end, y/L")
    axis.grid(color="0.92", linewidth=0.5)
    axis.set_axisbelow(True)
    axis.set_xlim(0, None)
    axis.set_ylim(-0.16, 0.19)
    axis.legend(loc="upper right", ncol=3, fontsize=8)
    style.save(figure, path)


if __name__ == "__main__":
    sys.exit(main())
