#!/usr/bin/python3
"""How far the instruction sets are apart: every validation scene takes some steps with each one that this processor has, and
the places of all particles are compared with those of the plain one. Bits differ, as sums are taken four, eight or sixteen
at a time; more than rounding would be a fault. Usage: instruction_sets.py PROGRAM [SCENE...]; exit code 0 if all are close.
"""
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np

VALIDATION = Path(__file__).resolve().parents[1] / "validation"
STEPS = 15
SETS = ("baseline", "avx2", "avx512")
# In spacings, after STEPS steps: some hundred roundings of places of up to a hundred spacings, 1e-14 each; in mixed precision
# of accelerations, which in that time move a particle by a few thousandths of a spacing, 1e-7 of that each.
BOUND = {"double": 1e-9, "mixed": 1e-5}


def checked(program, scene):
    """Time step [s], precision, and the smallest spacing [m]."""
    text = subprocess.run([program, "check", scene], check=True, capture_output=True, text=True).stdout.splitlines()
    step = float(next(line.split()[2] for line in text if line.startswith("time step")))
    precision = next(line.split()[1] for line in text if line.startswith("precision"))
    first = next(k for k, line in enumerate(text) if line.startswith("body"))
    bodies = text[first + 1:text.index("", first)]
    return step, precision, min(float(line.split()[-2]) for line in bodies)


def places(program, scene, end, name, folder):
    """Of fluid and solid particles, by id; None if this processor lacks the instruction set."""
    done = subprocess.run([program, "run", scene, "-o", folder, "--isa", name, "--threads", "1", "--until", f"{end:.10g}", "--set",
                           f"output.checkpoint_interval={0.9 * end:.10g}", "--set", "output.frame_interval=0"],
                          capture_output=True, text=True)
    if done.returncode == 2 and "--isa" in done.stderr:
        return None
    if done.returncode != 0:
        raise SystemExit(f"{scene}: the run failed:\n{done.stderr[-2000:]}")
    found = []
    with h5py.File(sorted((folder / "checkpoints").glob("step_*.h5"))[-1]) as file:
        for phase in ("fluid", "solid"):
            columns = file.get(f"simulation/{phase}", {})
            ids = np.asarray(columns.get("id", []))
            names = [n for n in ("position", "position_1", "position_2") if n in columns]
            if len(ids):
                found.append(np.stack([np.asarray(columns[n])[:len(ids)] for n in names], axis=1)[np.argsort(ids)])
    return np.concatenate(found)


def main():
    program, *scenes = sys.argv[1:]
    scenes = [Path(scene) for scene in scenes] or sorted(VALIDATION.glob("*/*.toml"))
    failed, worst = 0, dict.fromkeys(BOUND, 0.0)
    for scene in scenes:
        step, precision, spacing = checked(program, scene)
        with tempfile.TemporaryDirectory() as scratch:
            of_set = {name: places(program, scene, STEPS * step, name, Path(scratch) / name) for name in SETS}
        apart = {name: np.abs(x - of_set["baseline"]).max() / spacing for name, x in of_set.items() if x is not None}
        worst[precision] = max(worst[precision], *apart.values())
        close = max(apart.values()) <= BOUND[precision]
        failed += not close
        print(f"{'close' if close else 'APART':<6} {precision:<7}", *(f"{n} {v:.1e}" for n, v in apart.items() if n != "baseline"),
              scene, flush=True)
    print("instruction sets: " + ", ".join(f"{name} precision at most {value:.1e} spacings apart" for name, value in worst.items()) +
          f" after {STEPS} steps; {len(scenes) - failed} of {len(scenes)} scenes close")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
