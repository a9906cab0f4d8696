#!/usr/bin/python3
"""Every validation scene takes the same steps, to the bit, with 1, 2, 3 and 4 threads: its last frame and its probes after
some steps are compared byte by byte. Usage: determinism.py PROGRAM [SCENE...]; exit code 0 if all are the same.
"""
import filecmp
import subprocess
import sys
import tempfile
from pathlib import Path

VALIDATION = Path(__file__).resolve().parents[1] / "validation"
STEPS = 15   # lists are built anew and pruned within them, and solids take up to a hundred steps of their own
THREADS = (1, 2, 3, 4)


def time_step(program, scene):
    checked = subprocess.run([program, "check", scene], check=True, capture_output=True, text=True).stdout
    return float(next(line.split()[2] for line in checked.splitlines() if line.startswith("time step")))


def run(program, scene, end, threads, folder):
    command = [program, "run", scene, "-o", folder, "--threads", str(threads), "--until", f"{end:.10g}",
               "--set", f"output.frame_interval={end:.10g}", "--set", "output.checkpoint_minutes=0"]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"{scene}: the run failed:\n{done.stderr[-2000:]}")


def results(folder):
    return [sorted((folder / "frames").glob("frame_*.hdf"))[-1], folder / "probes.csv"]


def differs(program, scene):
    """The numbers of threads whose results are not those of one thread."""
    end = STEPS * time_step(program, scene)
    with tempfile.TemporaryDirectory() as scratch:
        folders = [Path(scratch) / str(threads) for threads in THREADS]
        for folder, threads in zip(folders, THREADS):
            run(program, scene, end, threads, folder)
        return [threads for folder, threads in zip(folders, THREADS)
                if not all(filecmp.cmp(a, b, shallow=False) for a, b in zip(results(folders[0]), results(folder)))]


def main():
    program, *scenes = sys.argv[1:]
    scenes = [Path(scene) for scene in scenes] or sorted(VALIDATION.glob("*/*.toml"))
    failed = 0
    for scene in scenes:
        others = differs(program, scene)
        failed += bool(others)
        print(f"{'DIFFERS with ' + ', '.join(map(str, others)) + ' threads' if others else 'same':<8} {scene}", flush=True)
    print(f"determinism: {len(scenes) - failed} of {len(scenes)} scenes the same with {THREADS} threads")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
