"""What a case of the validation book is: the runs that it wants, and what is made of them.

A script of a case's folder defines `CASE = Case(...)` and ends with `sys.exit(case.main(CASE))`; then it is a command of its own
and a chapter of the book (`validation/book.py`). Runs are data, so that the book can plan, start and watch those of all cases
together; a case only reads what they left.
"""
import argparse
import json
import os
import shutil
import sys
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Callable

import numpy as np

from lib import runs
from lib.markdown import table
from lib.run_output import RunError, RunOutput
from lib.verdict import Verdict

VALIDATION = Path(__file__).resolve().parents[1]
RESULTS = runs.ROOT / "results"
CHAPTER = "chapter.json"
FORMAT = 1  # of chapters; to be raised when the book needs what older ones lack


@dataclass(frozen=True)
class Run:
    """One run of a scene of the case's folder."""
    name: str                                     # its folder, below that of the case's runs
    settings: dict = field(default_factory=dict)  # of the scene, as --set takes them
    scene: str = "scene.toml"


@dataclass(frozen=True)
class Finished:
    """What the runs left, for a case to judge."""
    runs: dict    # name -> RunOutput, in the order of the plan
    folder: Path  # where figures are drawn
    quick: bool


@dataclass(frozen=True)
class Table:
    title: str
    header: list
    rows: list  # of cells, text or numbers as they are to be shown
    note: str = ""


@dataclass(frozen=True)
class Figure:
    path: Path        # SVG (the book shows it in light and dark), or PNG (on white)
    caption: str      # what is seen; the reference and its uncertainty
    stored: str = ""  # name under which it is kept beside the scene, for a README to show


@dataclass(frozen=True)
class Errors:
    """One line of the book's diagram of errors against spacing."""
    name: str
    across: list  # particles across, coarse to fine
    errors: list  # relative, without sign


@dataclass
class Result:
    verdict: Verdict
    errors: list                                    # (name, value with its unit), the main one first
    tables: list = field(default_factory=list)
    figures: list = field(default_factory=list)     # the picture of the case first
    convergence: list = field(default_factory=list)  # of Errors
    measures: dict = field(default_factory=dict)    # measure of the case's peers.csv -> our value with its unit


class Named:
    """Of a case: what follows from its folder, and from its part if the folder has several cases."""
    part = ""

    @property
    def name(self):
        return f"{self.folder.name}_{self.part}" if self.part else self.folder.name

    @property
    def results_file(self):
        """The generated tables, kept beside the scene."""
        return self.folder / (f"results_{self.part}.md" if self.part else "results.md")


@dataclass(frozen=True)
class Case(Named):
    title: str
    folder: Path     # of the case, with its scenes
    proves: str      # a few words for the table of all cases
    against: str
    plan: Callable   # quick -> list of Run; quick: seconds of CPU time, for the tests
    study: Callable  # Finished -> Result; quick runs have criteria of their own
    part: str = ""      # of a folder that has several cases: the name of the script, compare.py having none


def default_folder(quick):
    return RESULTS / ("validation_quick" if quick else "validation")


def add_options(parser):
    """What every case's command and the book's have in common."""
    parser.add_argument("--sluice", default=runs.SLUICE, type=Path, help="the program to run [%(default)s]")
    parser.add_argument("--jobs", default=os.cpu_count(), type=int, help="runs at a time [%(default)s]")
    parser.add_argument("--threads", default=1, type=int, help="of each run [%(default)s]")
    parser.add_argument("--quick", action="store_true", help="the short form that the tests run, with criteria of its own")
    parser.add_argument("--again", action="store_true", help="run also what is done")


def need_program(parser, options):
    if not options.sluice.is_file():
        parser.error(f"there is no program {options.sluice}; validation/book.sh builds it")


def jobs(case, folder, quick, changes=None):
    """What is to be run for a case; changes: of every scene, beyond those of the plan."""
    return [runs.Job(case.folder / run.scene, folder / run.name, {**run.settings, **(changes or {})})
            for run in case.plan(quick)]


def finish(case, folder, quick):
    """Reads what a case's runs left, judges it, and keeps the chapter as JSON. RunError if a run failed."""
    done = {run.name: _complete(folder / run.name) for run in case.plan(quick)}
    result = case.study(Finished(done, folder, quick))
    text = asdict(result)
    text["verdict"] = {"passed": bool(result.verdict.passed), "rows": result.verdict.rows}
    for figure in text["figures"]:
        figure["path"] = figure["path"].relative_to(folder)
    write_chapter(case, folder, quick, text | {"runs": [run_facts(name, run) for name, run in done.items()]})
    return result


def write_chapter(case, folder, quick, facts):
    """All that the book says of a case, as plain data."""
    folder.mkdir(parents=True, exist_ok=True)
    about = {"format": FORMAT, "name": case.name, "title": case.title, "proves": case.proves, "against": case.against}
    facts = about | {"quick": quick} | facts
    (folder / CHAPTER).write_text(json.dumps(facts, indent=1, default=_plain))


def read_chapter(folder):
    """None if there is none, or one that an older book has written."""
    path = folder / CHAPTER
    facts = json.loads(path.read_text()) if path.exists() else {}
    return facts if facts.get("format") == FORMAT else None


def _plain(value):
    return value.item() if isinstance(value, np.generic) else str(value)


def _complete(folder):
    run = RunOutput(folder)
    if run.summary["status"] != "done":
        raise RunError(f"{folder}: {run.summary['status']} at t = {run.summary['simulated_time']:.3g} s")
    return run


def run_facts(name, run):
    s = run.summary
    kept = ("version", "cpu_seconds", "wall_seconds", "threads", "steps", "precision", "instruction_set", "effects")
    return {key: s[key] for key in kept} | {
        "name": name, "particles": sum(s["particles"][phase] for phase in ("fluid", "solid", "wall")),
        "program": runs.made_by(run.folder), "finished": (run.folder / "summary.json").stat().st_mtime}


def markdown(case, result):
    """The case's tables and criteria, as they are kept beside the scene."""
    parts = [f"# {case.title}: results\n\nWritten by `validation/book.py`; {case.against}."]
    for t in result.tables:
        parts.append(f"## {t.title}\n\n{table(t.header, t.rows)}" + (f"\n{t.note}" if t.note else ""))
    parts.append("## Criteria\n\n" + table(["", "", "wanted", "verdict"], [
        [what, f"{value} {unit}".strip(), wanted, "pass" if ok else "**FAIL**"]
        for what, value, unit, wanted, ok in result.verdict.rows]))
    return "\n\n".join(part.rstrip("\n") for part in parts) + "\n"


def store(case, result):
    """Keeps the tables, and the figures that are to be, beside the scene."""
    case.results_file.write_text(markdown(case, result))
    for figure in result.figures:
        if figure.stored:
            shutil.copy(figure.path, case.folder / figure.stored)


def print_result(case, result):
    for t in result.tables:
        print(f"\n{t.title}\n{table(t.header, t.rows)}" + (f"{t.note}\n" if t.note else ""))
    result.verdict.print_table()
    for figure in result.figures:
        print(f"Picture: {figure.path}")


def main(case):
    """The command of one case: exit code 0 if its criteria are met, 1 if not, 2 if a run failed."""
    parser = argparse.ArgumentParser(description=sys.modules["__main__"].__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, help=f"folder of the runs [results/validation/{case.name}]")
    add_options(parser)
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="change a value of the scene")
    parser.add_argument("--store", action="store_true", help=f"keep the tables in {case.results_file.name} beside the scene")
    options = parser.parse_args()
    need_program(parser, options)
    folder = options.folder or default_folder(options.quick) / case.name
    changes = dict(change.split("=", 1) for change in options.set)
    try:
        runs.run_all(jobs(case, folder, options.quick, changes), options)
        result = finish(case, folder, options.quick)
    except RunError as error:
        print(f"{case.title}: cannot compare: {error}", file=sys.stderr)
        return 2
    print_result(case, result)
    if options.store:
        store(case, result)
        print(f"Tables: {case.results_file}")
    return result.verdict.close(case.title)
