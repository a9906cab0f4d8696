"""Cases with an analytic solution: runs at several spacings, errors, and how fast they fall."""
import argparse
import math
import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import Callable

from lib import runs
from lib.markdown import number, table
from lib.run_output import RunError, RunOutput

SPACING = "method.spacing"
FLOOR = 0.005  # what the sums over neighbours leave at a fixed h/d, however small d is; README.md has the figures


@dataclass
class Case:
    title: str
    folder: Path            # with scene.toml
    across: tuple           # what counts the spacings, and the length that it divides: ("L/d", 1.0) [m]
    counts: tuple           # particles across, coarse to fine
    errors: tuple           # names of relative errors; each gets an order
    others: tuple           # (name, digits) of what is shown beside them
    measure: Callable       # RunOutput -> {name: value}
    judge: Callable         # Study -> Verdict
    draw: Callable          # Study, path
    scene: str = "scene.toml"
    settings: dict = field(default_factory=dict)  # changes of the scene beside its spacing, e.g. a quick form's end


class Study:
    """Runs of a case's scene at its spacings, each measured to a dictionary of numbers."""

    def __init__(self, case, folder, sluice=runs.SLUICE, settings=None, threads="1", counts=None):
        self.case, self.counts, self.values, self.runs = case, counts or case.counts, [], []
        for count in self.counts:
            at = Path(folder) / f"across_{count}"
            changes = {SPACING: f"{case.across[1] / count:.10g}", **case.settings, **(settings or {})}
            runs.run(case.folder / case.scene, at, changes, sluice, ["--threads", threads])
            run = RunOutput(at)
            if run.summary["status"] != "done":
                raise RunError(f"{at}: {run.summary['status']} at t = {run.summary['simulated_time']:.3g} s")
            self.runs.append(run)
            self.values.append({**case.measure(run), "CPU [s]": run.summary["cpu_seconds"]})

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

    def markdown(self):
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
        return table(header, rows)


def percent(value):
    """A share in percent, with three digits."""
    return "–" if value is None or value != value else f"{100 * value:.3g}"


def arguments(description, folder):
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", default=folder, type=Path, help="folder of the runs [%(default)s]")
    parser.add_argument("--sluice", default=runs.SLUICE, type=Path, help="the program to run")
    parser.add_argument("--threads", default="1")
    return parser


def run_case(case, options, settings=None):
    """Runs, prints and draws a case. Returns its study and its verdict."""
    study = Study(case, options.folder, options.sluice, settings, options.threads)
    print(f"\n{study.markdown()}")
    verdict = case.judge(study)
    verdict.print_table()
    case.draw(study, options.folder / "figure.png")
    print(f"Picture: {options.folder / 'figure.png'}")
    return study, verdict


def main(case, quick=None):
    """The command of one case: exit code 0 if its criteria are met, 1 if not, 2 if a run failed. `quick` is the case in
    seconds, with criteria of its own; its runs go to a folder of their own."""
    parser = arguments(sys.modules["__main__"].__doc__, runs.ROOT / "results" / case.folder.name)
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="change a value of the scene")
    parser.add_argument("--store", action="store_true", help="keep the figure as figure.svg beside the README")
    if quick:
        parser.add_argument("--quick", action="store_true", help="the quick form, with its own criteria")
    options = parser.parse_args()
    if quick and options.quick:
        case, options.folder = quick, options.folder / "quick"
    try:
        study, verdict = run_case(case, options, dict(change.split("=", 1) for change in options.set))
    except RunError as error:
        print(f"{case.title}: cannot compare: {error}", file=sys.stderr)
        return 2
    if options.store and case is not quick:
        case.draw(study, case.folder / "figure.svg")
    return verdict.close(case.title)
