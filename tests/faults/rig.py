"""What the trials have in common: runs that can be stopped, disks that can be slowed, and what must hold afterwards."""
import filecmp
import json
import os
import subprocess
import sys
import time
from pathlib import Path

SKIPPED = 77
HERE = Path(__file__).resolve().parent
GATE = HERE.parent / "engine" / "scenes" / "small_gate.toml"
# Some 350 steps, with a frame, a row and a checkpoint every few of them.
OFTEN = {"output.frame_interval": 0.004, "output.probe_interval": 0.001, "output.checkpoint_interval": 0.0012}
PATIENCE = 120   # [s] what has not happened by then has failed


def demand(condition, words):
    if not condition:
        raise SystemExit(f"FAILED: {words}")


def wait_until(happened, words):
    start = time.monotonic()
    while not happened():
        demand(time.monotonic() - start < PATIENCE, f"waited in vain until {words}")
        time.sleep(0.01)


class Run:
    """A run in the background; its words go into a file."""

    def __init__(self, program, *arguments, log):
        self.log = Path(log)
        with open(self.log, "wb") as out:
            self.process = subprocess.Popen([program, "run", *map(str, arguments)], stdout=out, stderr=out)

    def words(self):
        return self.log.read_text(errors="replace")

    def ended(self):
        return self.process.poll() is not None

    def wait(self):
        return self.process.wait(PATIENCE)

    def signal(self, number):
        self.process.send_signal(number)

    def expect(self, code):
        got = self.wait()
        demand(got == code, f"{' '.join(self.process.args)}: returned {got}, expected {code}\n{self.words()[-2000:]}")
        return self.words()


class Runs:
    """Starts runs of one scene, each first one as whoever resumes it would have started it."""

    def __init__(self, program, scratch, scene=GATE, until=0.03, settings=OFTEN):
        self.program, self.scratch, self.until = program, scratch, until
        self.start = [scene]
        for key, value in settings.items():
            self.start += ["--set", f"{key}={value}"]

    def new(self, folder, *more, until=None):
        return Run(self.program, *self.start, "--until", until or self.until, "-o", folder, *more, log=self.scratch / "log")

    def resume(self, folder, *more):
        return Run(self.program, "--resume", folder, *more, log=self.scratch / "log")

    def go_on(self, folder, real=None, *more):
        """From the last checkpoint; from the start if there is none. `real`: the folder past the disk that is tried."""
        some = any((Path(real or folder) / "checkpoints").glob("step_*.h5"))
        return self.resume(folder, *more) if some else self.new(folder, *more)


def status(folder):
    file = Path(folder) / "summary.json"
    return json.loads(file.read_text())["status"] if file.exists() else None


def same(whole, other):
    """Frames, their list and probes are equal to the byte, and nothing unfinished lies about."""
    names = sorted(p.relative_to(whole) for p in [*whole.glob("frames/*"), whole / "probes.csv"])
    found = sorted(p.relative_to(other) for p in [*other.glob("frames/*"), other / "probes.csv"])
    demand(names == found, f"{other}: found {[str(n) for n in found]}, expected {[str(n) for n in names]}")
    for name in names:
        demand(filecmp.cmp(whole / name, other / name, shallow=False), f"{other / name} is not that of {whole}")
    demand(not list(other.rglob("*.part")), f"{other}: a part of a file is left")


def readable(folder, whole):
    """What a run that did not end has left: whole rows, whole frames, a list of frames that are there."""
    probes = folder / "probes.csv"
    if probes.exists():
        rows, all_rows = probes.read_bytes(), (whole / "probes.csv").read_bytes()
        demand(all_rows.startswith(rows), f"{probes}: other rows than those of {whole}")
        demand(rows.endswith(b"\n") or not rows, f"{probes}: its last row is torn")
    for frame in folder.glob("frames/*.hdf"):
        demand(filecmp.cmp(whole / "frames" / frame.name, frame, shallow=False), f"{frame} is not that of {whole}")
    series = folder / "frames" / "frames.hdf.series"
    if series.exists():
        for entry in json.loads(series.read_text())["files"]:
            demand((series.parent / entry["name"]).exists(), f"{series}: names {entry['name']}, which is not there")
    status(folder)


class Disk:
    """A folder `path` that shows `real` as slowly and faultily as `rules` say."""

    def __init__(self, scratch):
        self.real, self.path, self.file = scratch / "real", scratch / "disk", scratch / "rules.json"
        self.real.mkdir(), self.path.mkdir()
        self.rules()
        self.server = subprocess.Popen([sys.executable, HERE / "disk.py", self.real, self.path, self.file])
        while not os.path.ismount(self.path):
            if self.server.poll() is not None:
                print("skipped: no FUSE here")
                raise SystemExit(SKIPPED)
            time.sleep(0.02)

    def rules(self, *rules):
        part = self.file.with_suffix(".part")
        part.write_text(json.dumps(rules))
        part.rename(self.file)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.rules()
        subprocess.run(["fusermount", "-u", "-z", self.path], check=False)
        self.server.wait(PATIENCE)
