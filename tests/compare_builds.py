#!/usr/bin/python3
"""Whether two builds of sluice take the same steps, to the bit.

Runs the scenes of validation/, of the templates and of the hard cases with both programs, each to a bounded number of
steps, and compares probes.csv and all frames byte for byte. What one program refuses or breaks off, the other must too,
with the same message. Results are kept in --folder by program, so that a build is not run twice.

Exit code 0 if all are the same.
"""
import argparse
import hashlib
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests" / "hard"))

import case_data  # noqa: E402
from execute import toml_value  # noqa: E402

PARTICLE_STEPS = 2e6  # that a run may take: a second of CPU time, some hundred steps of most scenes
FRAMES = 3            # of each run
FRESH = "done"        # the last line of a run's log, so that one that was cut off is run again


@dataclass
class Scene:
    name: str
    file: Path
    changes: dict


def scenes(quick):
    found = [Scene(str(p.relative_to(ROOT)), p, {}) for folder in ("validation/*", "engine/scene/templates")
             for p in sorted(ROOT.glob(f"{folder}/*.toml"))]
    for case in case_data.load_cases(fast=quick):
        found += [Scene(job.name, job.scene, job.set) for job in case.jobs]
    alike = {f"{scene.file} {scene.changes}": scene for scene in found}  # a case may run one scene twice
    return [scene for scene in alike.values() if "[output]" in scene.file.read_text()]


def end_of(program, scene, settings):
    """Simulated time of about PARTICLE_STEPS, no later than the scene's own end; None if the scene is refused."""
    done = subprocess.run([program, "check", scene.file, *settings], capture_output=True, text=True)
    if done.returncode != 0:
        return None
    lines = done.stdout.splitlines()
    first = next(k for k, line in enumerate(lines) if line.startswith("body"))
    rows = [line.split() for line in lines[first + 1:lines.index("", first)]]
    count = {medium: sum(int(row[-3]) for row in rows if row[-4] == medium) for medium in ("fluid", "solid")}
    step = float(next(line.split()[2] for line in lines if line.startswith("time step")))
    steps, end = next((int(line.split()[2]), float(line.split()[4])) for line in lines if line.startswith("expected steps"))
    substeps = next((int(line.split()[2]) for line in lines if line.startswith("solid sub-steps")), 1)
    affordable = max(20, PARTICLE_STEPS / (count["fluid"] + substeps * count["solid"]))
    return end if affordable >= steps else affordable * step


def run(program, scene, end, folder, threads):
    """Runs a scene into a folder unless it was; what it said, without what differs from run to run."""
    log = folder / "log.txt"
    if log.exists() and log.read_text().endswith(FRESH):
        return
    folder.mkdir(parents=True, exist_ok=True)
    changes = dict(scene.changes)
    changes |= {"output.frame_interval": end / FRAMES, "output.probe_interval": end / 50, "output.checkpoint_minutes": 0}
    settings = [part for key, value in changes.items() for part in ("--set", f"{key}={toml_value(value)}")]
    done = subprocess.run([program, "run", scene.file, "-o", folder / "run", "--threads", str(threads), "--until",
                           f"{end:.10g}", *settings], capture_output=True, text=True)
    said = "\n".join(line for line in done.stderr.splitlines() if "sluice:" in line or "toml:" in line)
    log.write_text(f"{done.returncode}\n{said}\n{FRESH}")


def difference(old, new):
    """What differs between two runs' folders, in words; empty if nothing does."""
    logs = [(folder / "log.txt").read_text() for folder in (old, new)]
    if logs[0] != logs[1]:
        return f"ended otherwise: {logs[0][:300]!r} and {logs[1][:300]!r}"
    names = [sorted(str(p.relative_to(folder)) for p in folder.glob("run/frames/*.hdf")) + ["run/probes.csv"]
             for folder in (old, new)]
    if names[0] != names[1]:
        return f"files {names[0]} and {names[1]}"
    for name in names[0]:
        a, b = old / name, new / name
        if a.exists() != b.exists():
            return f"{name}: only one of them wrote it"
        if a.exists() and a.read_bytes() != b.read_bytes():
            return f"{name}: " + (of_frames(a, b) if name.endswith(".hdf") else of_tables(a, b))
    return ""


def of_tables(a, b):
    lines = [path.read_text().splitlines() for path in (a, b)]
    if lines[0][0] != lines[1][0] or len(lines[0]) != len(lines[1]):
        return "other columns or rows"
    rows = [np.array([[float(x) for x in line.split(",")] for line in table[1:]]) for table in lines]
    row = next(k for k in range(len(rows[0])) if lines[0][k + 1] != lines[1][k + 1])
    return f"from row {row + 1} of {len(rows[0])}; " + apart(lines[0][0].split(","), rows[0].T, rows[1].T)


def of_frames(a, b):
    columns = {}
    with h5py.File(a) as first, h5py.File(b) as second:
        for file, side in ((first, 0), (second, 1)):
            file.visititems(lambda name, item: columns.setdefault(name, {}).update({side: item[()]})
                            if isinstance(item, h5py.Dataset) else None)
    lone = [name for name, sides in columns.items() if len(sides) == 1]
    if lone:
        return f"only in one of them: {', '.join(lone)}"
    shapes = [name for name, s in columns.items() if s[0].shape != s[1].shape or s[0].dtype != s[1].dtype]
    if shapes:
        return f"of another size or type: {', '.join(shapes)}"
    found = apart(list(columns), [s[0] for s in columns.values()], [s[1] for s in columns.values()])
    return found or "same values, other bytes"


def apart(names, old, new):
    """The columns that differ, with how much."""
    texts = []
    for name, a, b in zip(names, old, new):
        a, b = np.asarray(a, float).ravel(), np.asarray(b, float).ravel()
        differ = ~((a == b) | (np.isnan(a) & np.isnan(b)))
        if differ.any():
            most = np.nanmax(np.abs(a - b))
            texts.append(f"{name.split('/')[-1]}: {differ.sum()} of {len(a)}, at most {most:.2g} of {np.nanmax(np.abs(a)):.2g}")
    return "; ".join(texts[:6])


def key_of(program):
    return hashlib.sha256(Path(program).read_bytes()).hexdigest()[:12]


def compare(scene, options):
    settings = [part for key, value in scene.changes.items() for part in ("--set", f"{key}={toml_value(value)}")]
    end = end_of(options.old, scene, settings)
    if end is None:
        refusals = [subprocess.run([p, "check", scene.file, *settings], capture_output=True, text=True).stderr
                    for p in (options.old, options.new)]
        return "refused alike" if refusals[0] == refusals[1] else f"DIFFERENT refused otherwise: {refusals}"
    key = hashlib.sha256(f"{scene.file.read_text()}{scene.changes}{end}{options.threads}".encode()).hexdigest()[:16]
    folders = [options.folder / key_of(program) / key for program in (options.old, options.new)]
    for program, folder in zip((options.old, options.new), folders):
        run(program, scene, end, folder, options.threads)
    found = difference(*folders)
    return f"DIFFERENT {found}" if found else "same"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old", help="a program `sluice`")
    parser.add_argument("new", help="the other one")
    parser.add_argument("--quick", action="store_true", help="of the hard cases only those that the tests run")
    parser.add_argument("--scenes", default="", help="only those with this in their names")
    parser.add_argument("--folder", type=Path, default=ROOT / "build" / "compare", help="where the runs are kept")
    parser.add_argument("--threads", type=int, default=1, help="of each run")
    parser.add_argument("-j", "--jobs", type=int, default=2, help="runs at a time")
    options = parser.parse_args()
    chosen = [scene for scene in scenes(options.quick) if options.scenes in scene.name]
    different = 0
    with ThreadPoolExecutor(options.jobs) as pool:
        for scene, verdict in zip(chosen, pool.map(lambda s: compare(s, options), chosen)):
            different += verdict.startswith("DIFFERENT")
            print(f"{verdict:<14} {scene.name}", flush=True)
    print(f"{len(chosen)} scenes, {different} different")
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
