"""From a finished process to its outcome and figures: ok, dissipated, out of limits, failed at t, refused."""
import fnmatch
import json
import math
import re
from dataclasses import dataclass, field

from figures import FIGURES, Run

DISSIPATED = "dissipated"  # limits of this name grade a run without failing it


@dataclass
class Result:
    job: object
    outcome: str = ""        # first word as cases expect it
    detail: str = ""
    figures: dict = field(default_factory=dict)
    broken: list = field(default_factory=list)
    cause: str = ""          # why an outcome that was not expected comes about: a name in causes.toml
    cpu: float = 0.0

    @property
    def expected(self):
        """What must break has to, by the figures that the case names; failing altogether is breaking too."""
        breaks = set(self.job.breaks) <= set(self.broken) if self.outcome == "out" else True
        return self.outcome in self.job.expect and breaks

    @property
    def verdict(self):
        if self.expected:
            return "as expected"
        return "known" if self.cause else "UNEXPLAINED"


def judge(job, process, root):
    result = Result(job, cpu=process.cpu)
    if process.code == 2:
        result.outcome, result.detail = "refused", _message(process.said)
    elif process.code is None:
        result.outcome, result.detail = "hung", "stopped by the clock"
    elif process.code not in (0, 1):
        result.outcome, result.detail = "crashed", f"exit code {process.code}"
    else:
        _measure(result, process, root)
    if not result.expected:
        result.cause = _known(job, result)
    return result


def _measure(result, process, root):
    job = result.job
    summary = json.loads((process.folder / "summary.json").read_text())
    if process.code == 1:
        result.outcome, result.detail = "failed", f"at t = {summary['simulated_time']:.4g} s: {summary.get('message', '')}"
        return
    twin = Run(job.twin.folder(root), job.twin.scale) if job.twin else None
    run = Run(process.folder, job.scale, twin)
    result.figures["finite"] = FIGURES["finite"](run)
    if result.figures["finite"]:
        result.broken.append("finite")
    for name, limit in job.limits.items():
        if name == "warned":
            value = int("warning" in process.said)
        else:
            value = FIGURES[limit.get("figure", name)](run)
        result.figures[name] = value
        if not within(value, limit):
            result.broken.append(name)
    hard = [name for name in result.broken if name != DISSIPATED]
    if hard:
        result.outcome, result.detail = "out", "of limits: " + ", ".join(hard)
    else:
        result.outcome = DISSIPATED if result.broken else "ok"


def within(value, limit):
    return math.isfinite(value) and limit.get("least", -math.inf) <= value <= limit.get("most", math.inf)


def _message(said):
    """Its place shortened to the file's name."""
    line = next((line for line in said.splitlines() if "error:" in line), said.strip())
    return re.sub(r"\S*/", "", line.replace("sluice: error: ", ""), count=1)


def _known(job, result):
    """The cause that the first entry of `known` that fits gives: this run, this outcome, no figure beyond its bound."""
    broken = set(result.broken) - {DISSIPATED}
    for entry in job.known:
        bounds = entry.get("limits", {})
        fits = any(fnmatch.fnmatch(f"{job.variant} / {job.setting}", pattern) for pattern in entry["runs"])
        if fits and result.outcome == entry["outcome"] and broken <= set(bounds):
            if all(_bounded(result.figures[name], job.limits[name], bounds[name]) for name in broken):
                return entry["cause"]
    return ""


def _bounded(value, limit, bound):
    """The bound replaces the limit on the side that is broken."""
    side = "most" if value > limit.get("most", math.inf) else "least"
    return within(value, {**limit, side: bound})
