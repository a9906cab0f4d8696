"""Starting `sluice run` for a list of settings, some at a time; what is done already is not run again."""
import argparse
import hashlib
import json
import re
import shlex
import subprocess
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

from lib.run_output import RunError

ROOT = Path(__file__).resolve().parents[2]
SLUICE = ROOT / "build" / "bin" / "sluice"
PROGRAM = "program.txt"  # beside a run's summary: program_hash of what made it
FAILED_NUMERICALLY = 1  # exit code: that is a result, which the run's summary tells


@dataclass(frozen=True)
class Job:
    scene: Path
    folder: Path
    settings: dict = field(default_factory=dict)

    @property
    def label(self):
        return " ".join(f"{key}={value}" for key, value in self.settings.items()) or "as it stands"

    @property
    def changes(self):
        return [word for key, value in self.settings.items() for word in ("--set", f"{key}={value}")]

    def is_done(self, sluice):
        """Whether the folder holds the finished run of the very same scene."""
        try:
            summary = json.loads((Path(self.folder) / "summary.json").read_text())
        except (OSError, ValueError):
            return False
        return summary.get("status") == "done" and summary.get("scene_hash") == scene_hash(self, sluice)


class Watch:
    """Is told what happens to jobs; here, a line for each."""

    def done_before(self, job):
        print(f"{job.folder.name}: done before ({job.label})", flush=True)

    def started(self, job):
        print(f"{job.folder.name}: running ({job.label})", flush=True)

    def progress(self, job, share):
        pass

    def ended(self, job):
        pass


def program_hash(sluice):
    """To tell runs of one build from those of another; they count as done all the same."""
    return hashlib.sha256(Path(sluice).read_bytes()).hexdigest()[:16]


def made_by(folder):
    """The program_hash that a run's folder was made by; empty if it does not say."""
    path = folder / PROGRAM
    return path.read_text().strip() if path.exists() else ""


def scene_hash(job, sluice=SLUICE):
    """Hash of the scene with its changes, as `sluice check` prints it."""
    text = _output([sluice, "check", job.scene, *job.changes])
    return next(line.split()[-1] for line in text.splitlines() if line.startswith("scene hash"))


def _output(command):
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode:
        raise RunError(f"{shlex.join(map(str, command))}\n{result.stderr}")
    return result.stdout


def run(scene, folder, settings, sluice=SLUICE, options=()):
    """Runs the scene into the folder, unless the folder holds the finished run of the very same scene."""
    job = Job(Path(scene), Path(folder), settings)
    try:
        _run_unless_done(job, sluice, options, False, Watch())
    except RunError as error:
        raise SystemExit(str(error)) from None


@contextmanager
def workers(count):
    """Threads for runs. Ctrl-C drops the waiting ones; those that go on are told by the same signal, and stop with a
    checkpoint."""
    pool = ThreadPoolExecutor(max(1, count))
    try:
        yield pool
    finally:
        pool.shutdown(cancel_futures=True)


def submit(pool, jobs, options, watch):
    """Lets the pool run what is not done, each with options.threads threads."""
    words = ["--threads", str(options.threads)]
    return [pool.submit(_run_unless_done, job, options.sluice, words, options.again, watch) for job in jobs]


def wait_for(submitted):
    """Until all have ended; then RunError if one could not be run."""
    failed = [str(error) for error in (one.exception() for one in submitted) if error]
    if failed:
        raise RunError("\n".join(failed))


def run_all(jobs, options):
    """Runs what is not done, options.jobs at a time."""
    with workers(options.jobs) as pool:
        wait_for(submit(pool, jobs, options, Watch()))


def _run_unless_done(job, sluice, words, again, watch):
    if not again and job.is_done(sluice):
        watch.done_before(job)
        return
    watch.started(job)
    (job.folder / "summary.json").unlink(missing_ok=True)  # of another scene: if this run fails, it must not be read
    program = program_hash(sluice)  # now: who builds while it runs replaces the file
    command = [str(sluice), "run", str(job.scene), "-o", str(job.folder), *job.changes, *words]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
        said = []
        for line in process.stderr:
            share = re.match(r" *([\d.]+) % \|", line)
            if share:
                watch.progress(job, float(share[1]) / 100)
            else:
                said.append(line)
    watch.ended(job)
    if process.returncode not in (0, FAILED_NUMERICALLY):
        raise RunError(f"{shlex.join(command)}\n{''.join(said)}")
    (job.folder / PROGRAM).write_text(f"{program}\n")


def sweep_parser(description, name):
    """Of a script that runs a list of settings by itself: --sluice, --threads, and the folder of its runs."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", default=ROOT / "results" / name, type=Path, help="folder of the runs [%(default)s]")
    parser.add_argument("--sluice", default=SLUICE, type=Path, help="the program to run [%(default)s]")
    parser.add_argument("--threads", default="1")
    return parser
