#!/usr/bin/env python3
"""What effects cost scenes that do not use them: a step with the engine of today and with one that lacks them.

bench/effects_off.py OLD_SLUICE NEW_SLUICE
    OLD_SLUICE is built from a commit before the effects came, in a git worktree and with the same build type; 1585d3c is
    the last with the paper's effects alone and one smoothing function.

Effects are chosen at run time, so there is no build of one commit without some of them to compare with. This compares two
commits, and so counts everything else that has changed in between as well: a ratio of 1 says that the effects cost
nothing or that something has paid for them, no more. Water alone and a solid alone run with the paper's preset, which both
know. The binaries take turns; each turn is a long run less a short one, so that reading, placing and writing are left out.
CPU time of one thread. The last columns are the new binary against itself: what differences mean nothing.
"""

import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

HEAD = """title = "Effects off"
dimension = {dimension}
gravity = [{gravity}]
[method]
preset = "paper"
precision = "{precision}"
spacing = {spacing}
expected_speed = 3.0
[output]
end = 1.0
"""

WATER = """[materials.water]
kind = "fluid"
density = 1000.0
sound_speed = 30.0
[bodies.water]
material = "water"
shape = {{box = {{min = [{low}], max = [{high}]}}}}
velocity = ["0.5", "0"{still}]
[walls.floor]
kind = "mirror"
point = [{low}]
normal = [0.0, 1.0{rest}]
"""

SOLID = """[materials.rubber]
kind = "solid"
density = 1100.0
youngs_modulus = 1.2e6
poisson_ratio = 0.4
[bodies.block]
material = "rubber"
shape = {{box = {{min = [{low}], max = [{high}]}}}}
velocity = ["0.1*sin(30*y)", "0"{still}]
"""


def scene_text(medium, dimension, precision):
    """A square of 80 × 80 particles or a cube of 20 × 20 × 20."""
    per_side = 80 if dimension == 2 else 20
    values = {"dimension": dimension, "precision": precision, "spacing": 0.1 / per_side,
              "gravity": ", ".join(["0.0", "-9.81", "0.0"][:dimension]), "low": ", ".join(["0.0"] * dimension),
              "high": ", ".join(["0.1"] * dimension), "still": ', "0"' if dimension == 3 else "",
              "rest": ", 0.0" if dimension == 3 else ""}
    return HEAD.format(**values) + (WATER if medium == "water" else SOLID).format(**values)


def run_until(binary, scene, until, folder):
    """(CPU time [s], steps)."""
    command = [binary, "run", scene, "-o", folder, "--threads", "1", "--until", f"{until:.9g}"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit code {done.returncode}\n{done.stderr}")
    summary = json.loads((folder / "summary.json").read_text())
    return summary["cpu_seconds"], summary["steps"]


class Case:
    """A scene, and the simulated times of its long and short runs."""

    short_steps = 20  # scratch has grown, neighbours have been listed and pruned

    def __init__(self, medium, dimension, precision, folder, binary, seconds):
        self.name = f"{medium}, {dimension}D, {precision}"
        self.folder = folder
        self.scene = folder / f"{medium}{dimension}{precision}.toml"
        self.scene.write_text(scene_text(medium, dimension, precision))
        cpu, steps = run_until(binary, self.scene, 1e-3, folder / "results")
        step = 1e-3 / steps
        self.short = self.short_steps * step
        self.long = self.short + max(seconds / (cpu / steps), self.short_steps) * step

    def step_time(self, binary):
        """CPU time per step. [s]"""
        results = self.folder / "results"
        long_cpu, long_steps = run_until(binary, self.scene, self.long, results)
        short_cpu, short_steps = run_until(binary, self.scene, self.short, results)
        return (long_cpu - short_cpu) / (long_steps - short_steps)


def measure(case, old, new, rounds):
    """The row of the table. Who goes first changes from round to round."""
    old_times, new_times, again = [], [], []
    for number in range(rounds):
        turns = [(old, old_times), (new, new_times), (new, again)]
        for binary, times in turns if number % 2 == 0 else reversed(turns):
            times.append(case.step_time(binary))
    ratios = sorted(b / a for a, b in zip(old_times, new_times))
    control = sorted(b / a for a, b in zip(new_times, again))
    return [case.name, f"{1e6 * statistics.median(old_times):.0f}", f"{1e6 * statistics.median(new_times):.0f}",
            f"{statistics.median(ratios):.3f}", f"{ratios[0]:.3f} … {ratios[-1]:.3f}",
            f"{statistics.median(control):.3f}", f"{control[0]:.3f} … {control[-1]:.3f}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old", type=pathlib.Path, help="a sluice without the effects")
    parser.add_argument("new", type=pathlib.Path, help="a sluice with them")
    parser.add_argument("--rounds", type=int, default=7, help="of each scene (default: 7)")
    parser.add_argument("--seconds", type=float, default=1.0, help="CPU time of a turn (default: 1)")
    options = parser.parse_args()
    old, new = options.old.resolve(), options.new.resolve()
    rows = [["scene", "old µs/step", "new µs/step", "new/old", "range", "new/new", "range"]]
    with tempfile.TemporaryDirectory() as name:
        for medium in ("water", "solid"):
            for dimension in (2, 3):
                for precision in ("double", "mixed"):
                    case = Case(medium, dimension, precision, pathlib.Path(name), new, options.seconds)
                    rows.append(measure(case, old, new, options.rounds))
                    print(case.name, "done", file=sys.stderr)
    widths = [max(len(row[k]) for row in rows) for k in range(len(rows[0]))]
    for row in rows:
        print("  ".join([row[0].ljust(widths[0]), *(cell.rjust(w) for cell, w in zip(row[1:], widths[1:]))]))


if __name__ == "__main__":
    main()
