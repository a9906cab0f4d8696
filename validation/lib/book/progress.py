"""How far all runs of all cases are, and when they will be done."""
import csv
import shutil
import sys
import threading
import time

from lib.case import VALIDATION

COSTS = VALIDATION / "costs.csv"  # CPU seconds of each run, from the last whole book
UNKNOWN = 10.0                    # s, of a run that is not in it
QUIET = 30.0                      # s between two lines where there is no terminal


def known_costs():
    if not COSTS.exists():
        return {}
    with open(COSTS, newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return {f"{row['case']}/{row['run']}": float(row["cpu_seconds"]) for row in rows}


def write_costs(chapters):
    """Of the cases that are in chapters; the others keep theirs."""
    costs = {key: cost for key, cost in known_costs().items() if key.split("/")[0] not in chapters}
    costs |= {f"{name}/{run['name']}": run["cpu_seconds"] for name, chapter in chapters.items() for run in chapter["runs"]}
    with open(COSTS, "w", newline="") as file:
        file.write("# CPU time of each run of the validation book [s]; written by book.py, which tells the time left by it.\n")
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["case", "run", "cpu_seconds"])
        writer.writerows([*key.split("/", 1), f"{cost:.1f}"] for key, cost in sorted(costs.items()))


class Progress:
    """Is told what happens to the jobs of all cases, by the threads that run them."""

    def __init__(self, jobs, quick, file=sys.stderr):
        costs = {} if quick else known_costs()
        self._cost = {job.folder: costs.get(label(job), UNKNOWN) for job in jobs}
        self._share = {job.folder: 0.0 for job in jobs}
        self._before, self._running, self._ended = set(), {}, 0
        self._file, self._terminal = file, file.isatty()
        self._start, self._last = time.monotonic(), 0.0
        self._lock = threading.Lock()

    def done_before(self, job):
        with self._lock:
            self._before.add(job.folder)
            self._share[job.folder] = 1.0
            self._show()

    def started(self, job):
        with self._lock:
            self._running[job.folder] = label(job)
            self._show()

    def progress(self, job, share):
        with self._lock:
            self._share[job.folder] = share
            self._show()

    def ended(self, job):
        with self._lock:
            self._share[job.folder] = 1.0
            self._running.pop(job.folder, None)
            self._ended += 1
            self._show(even_if_quiet=True)

    def say(self, text):
        """A line that stays."""
        with self._lock:
            self._clear()
            print(text, file=self._file, flush=True)

    def seconds_left(self):
        """By the expected costs of what is open, and how fast such costs went down so far; None before anything did."""
        mine = [folder for folder in self._cost if folder not in self._before]
        done = sum(self._cost[folder] * self._share[folder] for folder in mine)
        if done <= 0:
            return None
        return (sum(self._cost[folder] for folder in mine) / done - 1) * (time.monotonic() - self._start)

    def _show(self, even_if_quiet=False):
        now = time.monotonic()
        if now - self._last < (0.2 if self._terminal else QUIET) and not even_if_quiet:
            return
        self._last = now
        total = sum(self._cost.values())
        share = sum(self._cost[folder] * self._share[folder] for folder in self._cost) / total if total else 1.0
        left = self.seconds_left()
        running = ", ".join(f"{name} {100 * self._share[folder]:.0f} %" for folder, name in list(self._running.items()))
        line = (f"{100 * share:4.0f} % | {'-:--' if left is None else clock(left)} left | "
                f"{self._ended + len(self._before)} of {len(self._cost)} runs" + (f" | {running}" if running else ""))
        if self._terminal:
            print("\r" + line[:shutil.get_terminal_size().columns - 1] + "\033[K", end="", file=self._file, flush=True)
        else:
            print(line, file=self._file, flush=True)

    def _clear(self):
        if self._terminal:
            print("\r\033[K", end="", file=self._file)


def label(job):
    """case/run"""
    return f"{job.folder.parent.name}/{job.folder.name}"


def clock(seconds):
    minutes, seconds = divmod(int(seconds + 0.5), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02d}:{seconds:02d}" if hours else f"{minutes}:{seconds:02d}"
