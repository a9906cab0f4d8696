#!/usr/bin/env python3
"""What whole runs cost with two builds of sluice, scene by scene.

bench/step_times.py OLD_SLUICE NEW_SLUICE
    Eight scenes, each some seconds of one thread's CPU time, to the same simulated time with both programs; frames are not
    written. The programs take turns, and who goes first changes from round to round, so that a machine whose speed drifts slows
    both alike; ratios are those of neighbouring runs. With the same program twice they show the noise.

Time is the process's CPU time, placing the particles and the end included. Where the programs took different numbers of steps
the table says so: then the ratio is no longer that of a step.
"""

import argparse
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
from dataclasses import dataclass, field

import table

ROOT = pathlib.Path(__file__).resolve().parents[1]


@dataclass(frozen=True)
class Scene:
    name: str
    path: str
    until: float  # simulated time [s]
    changes: dict = field(default_factory=dict)


SCENES = [
    Scene("water 2D", "engine/scene/templates/dam-break.toml", 0.45),
    Scene("water 3D", "engine/scene/templates/dam-break-3d.toml", 0.5),
    Scene("total-Lagrangian solid 2D", "validation/colliding_rings/scene.toml", 0.02, {"method.spacing": 0.0008}),
    Scene("total-Lagrangian solid 3D", "validation/spinning_bar/neo_hookean_3d.toml", 0.045, {"method.spacing": 0.0025}),
    Scene("hypoelastic solid", "validation/spinning_bar/scene.toml", 0.4),
    Scene("gate, paper", "validation/elastic_gate/scene.toml", 0.06, {"method.spacing": 0.00125}),
    Scene("gate, modern", "engine/scene/templates/elastic-gate.toml", 0.08),
    Scene("gate 3D", "validation/elastic_gate_3d/modern.toml", 0.014, {"method.spacing": 0.0025}),
]


@dataclass(frozen=True)
class Cost:
    cpu: float                # [s]
    steps: int
    bytes_per_particle: float


def run(binary, scene, share, folder):
    command = [binary, "run", ROOT / scene.path, "-o", folder, "--threads", "1", "--until", f"{share * scene.until:.9g}"]
    changes = {**scene.changes, "output.frame_interval": 0, "output.checkpoint_minutes": 0}
    command += [word for key, value in changes.items() for word in ("--set", f"{key}={value}")]
    with open(folder / "said.txt", "w") as said:
        process = subprocess.Popen(command, stdout=said, stderr=said, env={**os.environ, "OMP_NUM_THREADS": "1"})
        _, status, usage = os.wait4(process.pid, 0)  # for the time of this process alone
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit code {process.returncode}\n{(folder / 'said.txt').read_text()}")
    summary = json.loads((folder / "summary.json").read_text())
    return Cost(usage.ru_utime + usage.ru_stime, summary["steps"],
                summary["memory_bytes"] / sum(summary["particles"][medium] for medium in ("fluid", "solid", "wall")))


def measure(scene, binaries, options):
    """[(cost of the old one, of the new one), …], a pair per round."""
    pairs = []
    for number in range(options.rounds):
        with tempfile.TemporaryDirectory() as folder:
            order = (0, 1) if number % 2 == 0 else (1, 0)
            pair = {which: run(binaries[which], scene, options.share, pathlib.Path(folder)) for which in order}
        pairs.append((pair[0], pair[1]))
    return pairs


def row(name, pairs):
    ratios = [new.cpu / old.cpu for old, new in pairs]
    old, new = pairs[0]
    steps = f"{old.steps}" if old.steps == new.steps else f"{old.steps} | {new.steps}: NOT THE SAME"
    times = [statistics.median(pair[which].cpu for pair in pairs) for which in (0, 1)]
    return [name, steps, f"{times[0]:.2f}", f"{times[1]:.2f}", f"{statistics.median(ratios):.3f}",
            f"{min(ratios):.3f} … {max(ratios):.3f}", f"{old.bytes_per_particle:.0f}", f"{new.bytes_per_particle:.0f}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old", type=pathlib.Path, help="a program `sluice`")
    parser.add_argument("new", type=pathlib.Path, help="the other one")
    parser.add_argument("--scenes", default="", metavar="PATTERN", help="only those with this in their names; a regular expression")
    parser.add_argument("--rounds", type=int, default=5, help="of each scene (default: 5)")
    parser.add_argument("--share", type=float, default=1.0, help="of the simulated time of each scene (default: 1)")
    options = parser.parse_args()
    binaries = [options.old.resolve(), options.new.resolve()]
    rows, medians = [], []
    for scene in SCENES:
        if re.search(options.scenes, scene.name):
            pairs = measure(scene, binaries, options)
            medians.append(statistics.median(new.cpu / old.cpu for old, new in pairs))
            rows.append(row(scene.name, pairs))
            print(f"{scene.name}: {medians[-1]:.3f}", file=sys.stderr)
    table.print_table(f"CPU time of one thread, medians of {options.rounds} rounds",
                      ["scene", "steps", "old s", "new s", "new/old", "range", "old bytes/particle", "new"], rows)
    if medians:
        print(f"\n{len(medians)} scenes, geometric mean of new/old {statistics.geometric_mean(medians):.3f}")


if __name__ == "__main__":
    main()
