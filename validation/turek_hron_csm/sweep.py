#!/usr/bin/python3
"""CSM1, CSM2 and CSM3 at 5, 7, 10 and 16 particles across; writes results.md beside this file; exit code 0
if the criteria are met. Runs that are done are not run again.
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
STIFF = "materials.elastic.youngs_modulus"
# CSM2 is four times as stiff and swings twice as fast; CSM3 feels gravity from the start, for two periods and a half.
CASES = {
    "csm1": {},
    "csm2": {STIFF: 5.6e6, "constants.ramp": 1.0, "output.end": 1.6},
    "csm3": {"acceleration": '["0", "-2"]', "output.end": 2.7},
}


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("folder", nargs="?", default=runs.ROOT / "results" / "turek_hron_csm", type=Path)
    arguments.add_argument("--sluice", default=runs.SLUICE, type=Path, help="the program to run")
    arguments.add_argument("--threads", default="1")
    options = arguments.parse_args()
    for across in ACROSS:
        for case, changes in CASES.items():
            settings = {"method.spacing": f"{HEIGHT / across:.10g}", **changes}
            runs.run(CASE / "scene.toml", options.folder / f"{case}_{across}", settings, options.sluice,
                     ["--threads", options.threads])
    return compare.compare(options.folder, ACROSS)


if __name__ == "__main__":
    sys.exit(main())
