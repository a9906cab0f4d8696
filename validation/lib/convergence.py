"""Cases with a solution to be wrong by: runs at several spacings, errors, and how fast they fall."""
import math
from dataclasses import dataclass, field
from pathlib import Path
from typing import Callable

from lib import case, runs
from lib.markdown import number
from lib.run_output import RunOutput
from lib.verdict import Verdict

SPACING = "method.spacing"
FLOOR = 0.005  # what the sums over neighbours leave at a fixed h/d, however small d is; README.md has the figures


@dataclass(frozen=True)
class Case(case.Named):
    title: str
    folder: Path            # with scene.toml
    proves: str
    against: str
    across: tuple           # what counts the spacings, and the length that it divides: ("L/d", 1.0) [m]
    counts: tuple           # particles across, coarse to fine
    errors: tuple           # names of relative errors, the main one first; each gets an order
    others: tuple           # (name, digits) of what is shown beside them
    measure: Callable       # RunOutput -> {name: value}
    judge: Callable         # Study -> Verdict
    draw: Callable          # Study, path of an SVG
    caption: str            # of what is drawn
    quick_counts: tuple
    quick_limits: dict = field(default_factory=dict)  # name of an error or of what is beside it -> the most that it may be
    judge_quick: Callable = None                      # Study -> Verdict, where most-that-it-may-be does not do
    part: str = ""
    scene: str = "scene.toml"
    settings: dict = field(default_factory=dict)        # changes of the scene beside its spacing,
    quick_settings: dict = field(default_factory=dict)  # and of the quick form: an earlier end
    stored: str = ""        # name of the figure beside the scene, for the README to show

    def plan(self, quick):
        changes = self.quick_settings if quick else self.settings
        return runs_at("across", self.across[1], self.counts_for(quick), changes, self.scene)

    def counts_for(self, quick):
        return self.quick_counts if quick else self.counts

    def study(self, done):
        study = Study(self, self.counts_for(done.quick), list(done.runs.values()))
        verdict = (self.judge_quick or self._within_limits)(study) if done.quick else self.judge(study)
        picture = done.folder / "figure.svg"
        self.draw(study, picture)
        return case.Result(
            verdict, errors=[(name, f"{percent(study.finest[name])} %") for name in self.errors],
            tables=[study.table()], figures=[case.Figure(picture, self.caption, self.stored)],
            convergence=[case.Errors(name, list(study.counts), [abs(value[name]) for value in study.values])
                         for name in self.errors])

    def _within_limits(self, study):
        verdict = Verdict()
        for name, limit in self.quick_limits.items():
            if name in self.errors:
                verdict.limit(f"{name}, {self.across[0]} = {study.counts[-1]}", 100 * study.finest[name], "%", high=100 * limit)
            else:
                verdict.limit(f"{name}, {self.across[0]} = {study.counts[-1]}", study.finest[name], "", high=limit)
        return verdict


def runs_at(name, length, counts, settings=None, scene="scene.toml"):
    """Runs name_N with N spacings to the length, for each of the counts."""
    return [case.Run(f"{name}_{n}", {SPACING: f"{length / n:.10g}", **(settings or {})}, scene) for n in counts]


@dataclass(frozen=True)
class Measured:
    """One of several scenes of a case: what a Study needs to know of it."""
    title: str
    across: tuple
    errors: tuple
    others: tuple
    measure: Callable


def study_at(measured, name, counts, done):
    """Of a scene whose runs runs_at planned under this name."""
    return Study(measured, counts, [done.runs[f"{name}_{n}"] for n in counts])


class Study:
    """Runs at several spacings, each measured to a dictionary of numbers. case_: a Case, or Measured."""

    def __init__(self, case_, counts, outputs):
        self.case, self.counts, self.runs = case_, counts, outputs
        self.values = [{**case_.measure(run), "CPU [s]": run.summary["cpu_seconds"]} for run in outputs]

    @property
    def finest(self):
        return self.values[-1]

    def order(self, error, i=-1):
        """Of convergence, from spacing i − 1 to spacing i; NaN for the first."""
        i %= len(self.values)
        if i == 0:
            return math.nan
        coarse, fine = abs(self.values[i - 1][error]), abs(self.values[i][error])
        if not coarse > 0 or not fine > 0:
            return math.nan
        return math.log(coarse / fine) / math.log(self.counts[i] / self.counts[i - 1])

    def require_order(self, verdict, error):
        """First order between the two finest spacings, unless the error has reached the floor."""
        if abs(self.finest[error]) <= FLOOR:
            verdict.limit(f"{error}: finest, at the floor", 100 * abs(self.finest[error]), "%", high=100 * FLOOR)
        else:
            verdict.limit(f"{error}: order, last", self.order(error), "", low=1)

    def table(self, title="Spacings"):
        header = [self.case.across[0]]
        for error in self.case.errors:
            header += [f"{error} [%]", "order"]
        header += [name for name, _ in self.case.others] + ["CPU [s]"]
        rows = []
        for i, (count, value) in enumerate(zip(self.counts, self.values)):
            row = [count]
            for error in self.case.errors:
                row += [percent(value[error]), number(self.order(error, i), 2)]
            rows.append(row + [number(value[name], digits) for name, digits in (*self.case.others, ("CPU [s]", 1))])
        note = "Order: between a row's spacing and the one above it." if self.case.errors else ""
        return case.Table(title, header, rows, note)


def study_of(case_, folder, settings, options, counts):
    """The case's scene with changed settings, at these counts; for the scripts that vary more than the spacing."""
    outputs, words = [], ["--threads", options.threads]
    for count in counts:
        changes = {SPACING: f"{case_.across[1] / count:.10g}", **settings}
        runs.run(case_.folder / "scene.toml", Path(folder) / f"across_{count}", changes, options.sluice, words)
        outputs.append(RunOutput(Path(folder) / f"across_{count}"))
    return Study(case_, counts, outputs)


def percent(value):
    """A share in percent, with three digits."""
    return "–" if value is None or value != value else f"{100 * value:.3g}"
