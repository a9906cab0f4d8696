"""Starts `sluice run` for the jobs, some at a time, and keeps what each said; what is done already is not run again."""
import json
import os
import shutil
import subprocess
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

RECORD = "hard.json"  # beside summary.json
TIME_LIMIT = 900      # s by the clock: ten times the longest run on a busy machine; what takes longer hangs


@dataclass
class Program:
    path: Path
    isa: str = ""  # instruction set; empty = the best that there is

    def label(self):
        at = self.path.resolve().stat()
        return [at.st_size, at.st_mtime_ns]

    def version(self):
        said = subprocess.run([str(self.path), "--version"], capture_output=True, text=True).stdout.strip()
        return f"{said}, {self.isa}" if self.isa else said


@dataclass
class Outcome:
    code: int      # of the process; None: it was stopped after TIME_LIMIT
    said: str      # standard output and error
    folder: Path
    cpu: float     # s, of the whole process


def run_all(jobs, root, program, parallel, done):
    """Outcome of each job, in its order; `done(job, outcome, fresh)` is called as they end."""
    def work(job):
        outcome, fresh = run(job, job.folder(root), program)
        done(job, outcome, fresh)
        return outcome

    with ThreadPoolExecutor(parallel) as pool:
        return list(pool.map(work, jobs))


def run(job, folder, program):
    command = [str(program.path), "run", str(job.scene), "-o", str(folder), "--threads", str(job.threads)]
    command += ["--isa", program.isa] if program.isa else []
    for key, value in job.set.items():
        command += ["--set", f"{key}={toml_value(value)}"]
    label = {"command": command, "scene": job.scene.read_text(), "program": program.label()}
    kept = _kept(folder, label)
    if kept:
        return kept, False
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    outcome = _execute(command, folder)
    record = {"label": label, "code": outcome.code, "said": outcome.said, "cpu": outcome.cpu}
    (folder / RECORD).write_text(json.dumps(record, indent=1))
    return outcome, True


def _execute(command, folder):
    """Files in place of pipes, and a wait of our own, for the process's CPU time."""
    with open(folder / "said.txt", "w+") as said:
        process = subprocess.Popen(command, stdout=said, stderr=subprocess.STDOUT)
        end, status, usage = time.monotonic() + TIME_LIMIT, 0, None
        while True:
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            if pid:
                break
            if time.monotonic() > end:
                process.kill()
                _, status, usage = os.wait4(process.pid, 0)
                status = None
                break
            time.sleep(0.02)
        process.returncode = 0  # waited for above
        said.seek(0)
        text = said.read()
    code = None if status is None else os.waitstatus_to_exitcode(status)
    return Outcome(code, text, folder, usage.ru_utime + usage.ru_stime)


def _kept(folder, label):
    try:
        record = json.loads((folder / RECORD).read_text())
    except (OSError, ValueError):
        return None
    if record["label"] != json.loads(json.dumps(label)):
        return None
    return Outcome(record["code"], record["said"], folder, record["cpu"])


def toml_value(value):
    """As --set takes it: words without quotes, tables inline."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key} = {_inner(item)}" for key, item in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(_inner(item) for item in value) + "]"
    if isinstance(value, str) and not value[:1].isalpha():
        return json.dumps(value)  # a formula
    return str(value)


def _inner(value):
    return json.dumps(value) if isinstance(value, str) else toml_value(value)
