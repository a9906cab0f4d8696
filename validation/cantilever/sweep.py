#!/usr/bin/python3
"""Small and large load at 5, 7, 10 and 16 particles across; writes results.md beside this file; exit code 0 if the
criteria are met. Runs that are done are not run again.
"""
import argparse
import sys
from pathlib import Path

CASE = Path(__file__).resolve().parent
sys.path.insert(0, str(CASE.parent))

import compare  # noqa: E402
from lib import runs  # noqa: E402

HEIGHT = 0.02  # m
ACROSS = (5, 7, 10, 16)
LOADS = {"small": 1.0, "large": 16.0}  # gravity [m/s^2]


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("folder", nargs="?", default=runs.ROOT / "results" / "cantilever", type=Path)
    arguments.add_argument("--sluice", default=runs.SLUICE, type=Path, help="the program to run")
    arguments.add_argument("--threads", default="1")
    options = arguments.parse_args()
    for across in ACROSS:
        for load, gravity in LOADS.items():
            settings = {"method.spacing": f"{HEIGHT / across:.10g}", "constants.g": gravity}
            runs.run(CASE / "scene.toml", options.folder / f"{load}_{across}", settings, options.sluice,
                     ["--threads", options.threads])
    return compare.compare(options.folder, ACROSS)


if __name__ == "__main__":
    sys.exit(main())
