#!/usr/bin/python3
"""Runs that are killed at random moments go on to the same bits, also if two were started in one folder; checkpoints that
are damaged are told from those that are not.

    kills.py PROGRAM [--kills N] [--damages N] [--seed N]
"""
import argparse
import random
import shutil
import signal
import tempfile
import time
from collections import Counter
from pathlib import Path

from rig import OFTEN, Runs, demand, readable, same, status

LOCKED = "another run writes into this folder"


class Killed:
    """One preset's run, killed again and again."""

    def __init__(self, program, scratch, preset, chance):
        scratch.mkdir()
        self.runs = Runs(program, scratch, settings={**OFTEN, "method.preset": preset})
        self.whole, self.folder, self.chance, self.counts = scratch / "whole", scratch / "run", chance, Counter()
        self.runs.new(self.whole, "--threads", 1).expect(0)
        start = time.monotonic()
        self.runs.new(scratch / "timed").expect(0)
        self.seconds = time.monotonic() - start   # of a run, so that kills fall into all of it

    def start(self):
        return self.runs.go_on(self.folder, None, "--threads", self.chance.choice((1, 2)))

    def again(self):
        """Once more, then killed; every third time there are two, of which one is refused."""
        runs = [self.start()]
        if self.chance.random() < 1 / 3:
            time.sleep(self.chance.uniform(0, 0.1))
            runs[0].log.rename(runs[0].log.with_name("log of the first"))
            runs[0].log = runs[0].log.with_name("log of the first")
            runs.append(self.start())
        time.sleep(self.chance.uniform(0, self.seconds))
        for run in runs:
            run.signal(signal.SIGKILL)
        codes = [run.wait() for run in runs]
        self.counts["killed"] += codes.count(-signal.SIGKILL)
        self.counts["done before"] += codes.count(0)
        for run, code in zip(runs, codes):
            if code not in (0, -signal.SIGKILL):
                demand(code == 3 and len(runs) == 2 and LOCKED in run.words(), f"returned {code}: {run.words()}")
                self.counts["refused beside another"] += 1
        readable(self.folder, self.whole)
        if status(self.folder) == "done":
            self.compare()

    def compare(self):
        same(self.whole, self.folder)
        self.counts["whole runs of the same bits"] += 1
        shutil.rmtree(self.folder)

    def end(self):
        if self.folder.exists():
            self.runs.go_on(self.folder).expect(0)
            self.compare()


def damage(file, chance):
    """What a disk or a copy may do to a file; says which."""
    data = bytearray(file.read_bytes())
    kind = chance.choice(("cut short", "a bit turned", "a block of zeros", "a block of another place", "lengthened"))
    at, before = chance.randrange(len(data)), bytes(data)
    if chance.random() < 1 / 4:
        at = chance.randrange(min(1024, len(data)))   # its header, and what comes soon after it
    if kind == "cut short":
        del data[at:]
    elif kind == "a bit turned":
        data[at] ^= 1 << chance.randrange(8)
    elif kind == "lengthened":
        data += bytes(chance.randrange(1, 5000))
    else:
        at -= at % 512
        other = chance.randrange(0, len(data), 512)
        block = bytes(512) if kind == "a block of zeros" else data[other:other + 512]
        data[at:at + len(block)] = block[:len(data) - at]
    file.write_bytes(data)
    return kind if data != before else None


def damaged(program, scratch, count, chance):
    """Both checkpoints damaged: refused. Every fiftieth time only the newer one: the other is gone on from."""
    scratch.mkdir()
    runs, whole, kept, folder = Runs(program, scratch), scratch / "whole", scratch / "kept", scratch / "run"
    runs.new(whole).expect(0)
    shutil.copytree(whole, kept)
    (kept / "summary.json").unlink()   # it would say that there is nothing to go on with
    counts = Counter()
    trials = 0
    while trials < count:
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(kept, folder)
        files = sorted((folder / "checkpoints").glob("step_*.h5"))
        one = trials % 50 == 0
        kinds = [damage(file, chance) for file in (files[-1:] if one else files)]
        if None in kinds:
            continue
        trials += 1
        counts.update(kinds)
        run = runs.resume(folder)
        words = run.expect(0 if one else 2)
        demand(words.count("is damaged") == len(kinds), f"{kinds}: says {words}")
        if one:
            same(whole, folder)
            counts["gone on from the one before"] += 1
    return counts


def main():
    options = argparse.ArgumentParser()
    options.add_argument("program")
    options.add_argument("--kills", type=int, default=100)
    options.add_argument("--damages", type=int, default=500)
    options.add_argument("--seed", type=int, default=1)
    options = options.parse_args()
    chance = random.Random(options.seed)
    with tempfile.TemporaryDirectory() as scratch:
        scratch = Path(scratch)
        for preset in ("paper", "modern"):
            killed = Killed(options.program, scratch / preset, preset, chance)
            while killed.counts["killed"] < (options.kills + 1) // 2:
                killed.again()
            killed.end()
            print(f"{preset}: {dict(killed.counts)}", flush=True)
        print(f"damaged: {dict(damaged(options.program, scratch / 'damaged', options.damages, chance))}")
    print("kills: all as expected")


if __name__ == "__main__":
    main()
