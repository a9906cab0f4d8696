#!/usr/bin/python3
"""Every validation scene takes the same steps, to the bit, with 1, 2, 3 and 4 threads, and when it is stopped and resumed from a
checkpoint with another number of threads: its last frame and its probes after some steps are compared byte by byte.
Usage: determinism.py PROGRAM [SCENE...]; exit code 0 if all are the same.
"""
import filecmp
import subprocess
import sys
import tempfile
from pathlib import Path

VALIDATION = Path(__file__).resolve().parents[1] / "validation"
STEPS = 15   # lists are built anew and pruned within them, and solids take up to a hundred steps of their own
THREADS = (1, 2, 3, 4)
# The resumed run: stopped at the second of these parts of the way, its last checkpoint being at the first.
CHECKPOINT, STOP = 0.35, 0.6


def time_step(program, scene):
    checked = subprocess.run([program, "check", scene], check=True, capture_output=True, text=True).stdout
    return float(next(line.split()[2] for line in checked.splitlines() if line.startswith("time step")))


def run(scene, *command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"{scene}: the run failed:\n{done.stderr[-2000:]}")


def start(program, scene, end, threads, folder, until=None):
    run(scene, program, "run", scene, "-o", folder, "--threads", str(threads), "--until", f"{until or end:.10g}",
        "--set", f"output.frame_interval={end:.10g}", "--set", "output.checkpoint_minutes=0",
        "--set", f"output.checkpoint_interval={CHECKPOINT * end:.10g}")


def start_and_resume(program, scene, end, folder):
    start(program, scene, end, 2, folder, until=STOP * end)
    run(scene, program, "run", "--resume", folder, "--threads", "3", "--until", f"{end:.10g}")


def results(folder):
    return [sorted((folder / "frames").glob("frame_*.hdf"))[-1], folder / "probes.csv"]


def same(one, other):
    return all(filecmp.cmp(a, b, shallow=False) for a, b in zip(results(one), results(other)))


def differs(program, scene):
    """What gives other results than one thread does."""
    end = STEPS * time_step(program, scene)
    with tempfile.TemporaryDirectory() as scratch:
        one, other = Path(scratch) / "one", Path(scratch) / "other"
        start(program, scene, end, 1, one)
        found = []
        for threads in THREADS[1:]:
            start(program, scene, end, threads, other)
            found += [] if same(one, other) else [f"with {threads} threads"]
        start_and_resume(program, scene, end, other)
        return found + ([] if same(one, other) else ["when resumed"])


def main():
    program, *scenes = sys.argv[1:]
    scenes = [Path(scene) for scene in scenes] or sorted(VALIDATION.glob("*/*.toml"))
    failed = 0
    for scene in scenes:
        others = differs(program, scene)
        failed += bool(others)
        print(f"{'DIFFERS ' + ', '.join(others) if others else 'same':<8} {scene}", flush=True)
    print(f"determinism: {len(scenes) - failed} of {len(scenes)} scenes the same with {THREADS} threads, and when resumed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
