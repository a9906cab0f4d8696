#!/usr/bin/python3
"""Runs on a disk that is slow, hangs, or answers with errors: nothing is lost, and the results are the same.

    slow_disk.py PROGRAM [--seed N] [--kills N]

77 = skipped: no FUSE (python3-fusepy, /dev/fuse) here.
"""
import argparse
import json
import os
import random
import shutil
import signal
import tempfile
import time
from pathlib import Path

from rig import SKIPPED, Disk, Runs, demand, readable, same, status, wait_until

SLOW = ({"ops": ["write"], "seconds": 0.002, "rate": 2e6}, {"ops": ["fsync"], "seconds": 0.03},
        {"ops": ["rename"], "seconds": 0.01}, {"ops": ["open", "close", "unlink", "list"], "seconds": 0.003})
FRAME = "frames/frame_0002"


def fresh(disk):
    disk.rules()
    shutil.rmtree(disk.real / "run", ignore_errors=True)


def slow(runs, disk, whole):
    disk.rules(*SLOW)
    runs.new(disk.path / "run").expect(0)
    same(whole, disk.real / "run")


def hang(runs, disk, whole):
    """While a frame is stuck, the steps go on to the end."""
    disk.rules({"ops": ["write"], "match": FRAME, "hang": True})
    run = runs.new(disk.path / "run")
    wait_until(lambda: " 9" in run.words() and "% |" in run.words().split(" 9")[-1], "the steps are done")
    demand(not run.ended() and not (disk.real / "run" / f"{FRAME}.hdf").exists(), "the disk did not hang")
    disk.rules()
    run.expect(0)
    same(whole, disk.real / "run")


def stopped(runs, disk, whole):
    """Ctrl-C while the disk hangs: what waits is written, then the run ends; it goes on as if nothing had been."""
    disk.rules({"ops": ["write"], "match": FRAME, "hang": True})
    run = runs.new(disk.path / "run", until=100)
    wait_until(lambda: (disk.real / "run" / f"{FRAME}.hdf.part").exists(), "the third frame is begun")
    run.signal(signal.SIGINT)
    disk.rules(*SLOW)
    run.expect(130)
    summary = json.loads((disk.real / "run" / "summary.json").read_text())
    demand(summary["status"] == "interrupted", f"the summary tells: {summary['status']}")
    until = summary["simulated_time"] + 0.005
    runs.resume(disk.path / "run", "--until", until).expect(0)
    whole = whole.with_name("longer")
    runs.new(whole, until=until).expect(0)
    same(whole, disk.real / "run")


def killed(runs, disk, whole, chance, kills):
    done = 0
    while done < kills:
        disk.rules(*SLOW)
        run = runs.go_on(disk.path / "run", disk.real / "run", "--threads", chance.choice((1, 2)))
        time.sleep(chance.uniform(0, 1.5))
        run.signal(signal.SIGKILL)
        run.wait()
        done += 1
        readable(disk.real / "run", whole)
        if status(disk.real / "run") == "done":
            same(whole, disk.real / "run")
            fresh(disk)
    disk.rules()
    runs.go_on(disk.path / "run", disk.real / "run").expect(0)
    same(whole, disk.real / "run")
    return f"{kills} kills"


WORDS = {"EIO": "Input/output error", "ENOSPC": "No space left on device", "EDQUOT": "Disk quota exceeded",
         "ESTALE": "Stale file handle", "EROFS": "Read-only file system"}
# Where it happens, and the first of its operations that is refused.
PLACES = [("write", "frames/", 2), ("write", "probes.csv", 7), ("write", "checkpoints/", 9), ("write", "summary.json", 2),
          ("fsync", "frames/", 3), ("fsync", "probes.csv", 4), ("fsync", "checkpoints/", 5), ("fsync", "summary.json", 1),
          ("close", "frames/", 3), ("close", "checkpoints/", 2), ("close", "summary.json", 2),
          ("rename", "frames/", 2), ("rename", "checkpoints/", 3), ("rename", "summary.json", 2),
          ("open", "frames/", 3), ("open", "checkpoints/", 3), ("unlink", "checkpoints/", 1),
          ("fsync", "probes.csv", 25), ("write", "", 40), ("fsync", "", 30)]


def refused(runs, disk, whole, op, match, after, error):
    """From its `after`th time on an operation fails, until somebody mends the disk."""
    fresh(disk)
    what = f"{error} from {op} in {match or 'any file'} after {after}"
    disk.rules({"ops": [op], "match": match, "after": after, "error": error})
    words = runs.new(disk.path / "run").expect(3)
    demand(WORDS[error] in words and str(disk.path / "run") in words, f"{what}: says {words[-400:]}")
    real = disk.real / "run"
    demand(status(real) in ("failed", None), f"{what}: the summary says {status(real)}")
    readable(real, whole)
    demand(op == "unlink" or not list(real.rglob("*.part")), f"{what}: a part of a file is left")
    disk.rules()
    runs.go_on(disk.path / "run", real).expect(0)
    same(whole, real)


def late(runs, disk):
    """What a disk takes at first and refuses afterwards is told, also in a run that writes no checkpoint."""
    fresh(disk)
    disk.rules({"ops": ["fsync"], "match": "probes.csv", "error": "EIO"})
    words = runs.new(disk.path / "run", "--set", "output.checkpoint_interval=0", "--set", "output.checkpoint_minutes=0").expect(3)
    demand("probes.csv: cannot write: Input/output error" in words, words)
    demand(status(disk.real / "run") == "failed", "a run that lost its rows is done")


def dead(runs, disk, whole, after):
    """Nothing can be changed any more, as on a disk that the system has made read-only."""
    fresh(disk)
    disk.rules({"ops": ["write", "fsync", "open", "rename", "unlink", "truncate", "mkdir"], "after": after, "error": "EROFS"})
    words = runs.new(disk.path / "run").expect(3)
    demand(WORDS["EROFS"] in words, words)
    disk.rules()
    readable(disk.real / "run", whole)
    runs.go_on(disk.path / "run", disk.real / "run").expect(0)
    same(whole, disk.real / "run")


def main():
    options = argparse.ArgumentParser()
    options.add_argument("program")
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--kills", type=int, default=20)
    options.add_argument("--quick", action="store_true", help="each kind once: half a minute")
    options = options.parse_args()
    try:
        import fusepy  # noqa: F401 - the disk needs it
    except (ImportError, OSError):
        fusepy = None
    if fusepy is None or not os.access("/dev/fuse", os.W_OK):
        print("skipped: no FUSE here (python3-fusepy, fuse3, /dev/fuse)")
        return SKIPPED
    chance = random.Random(options.seed)
    with tempfile.TemporaryDirectory() as scratch, Disk(Path(scratch)) as disk:
        runs, whole = Runs(options.program, Path(scratch)), Path(scratch) / "whole"
        runs.new(whole).expect(0)
        for trial in (slow, hang, stopped):
            fresh(disk)
            trial(runs, disk, whole)
            print(f"{trial.__name__}: as expected", flush=True)
        fresh(disk)
        print("killed:", killed(runs, disk, whole, chance, 3 if options.quick else options.kills), flush=True)
        errors = ["EIO", "ENOSPC"] if options.quick else list(WORDS)[:4]
        for k, (op, match, after) in enumerate(PLACES):
            for error in errors[k % 2:k % 2 + 1] if options.quick else errors:
                refused(runs, disk, whole, op, match, after, error)
                print(f"refused: {error} from {op} in {match or 'any file'}: as expected", flush=True)
        late(runs, disk)
        print("late: as expected", flush=True)
        for after in (3, 40, 90):
            dead(runs, disk, whole, after)
            print(f"dead after {after}: as expected", flush=True)
    print("slow_disk: all as expected")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
