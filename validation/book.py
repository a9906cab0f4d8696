#!/usr/bin/python3
"""Runs all validation cases, judges them, and writes the book: one page with every case's picture, curves, errors, criteria,
effects and times. Runs that are done are not run again, so that it may be stopped at any time and started again.

The whole book also keeps each case's tables beside its scene (results.md) and writes the table of all cases in README.md. Exit
code: 0 if all criteria are met, 1 if not, 2 if a run failed.
"""
import argparse
import sys
import traceback
from pathlib import Path

VALIDATION = Path(__file__).resolve().parent
sys.path.insert(0, str(VALIDATION))

from lib import case as cases_  # noqa: E402
from lib import runs  # noqa: E402
from lib.book import cases as found  # noqa: E402
from lib.book import page, progress, readme  # noqa: E402
from lib.run_output import RunError  # noqa: E402

EXIT = {"pass": 0, "fail": 1, "broken": 2}


def arguments(names):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, help="of runs and page [results/validation]")
    parser.add_argument("--only", nargs="+", metavar="CASE", default=names, choices=names, help=f"of: {', '.join(names)}")
    cases_.add_options(parser)
    parser.add_argument("--check", action="store_true", help="only whether README.md's table has every case")
    options = parser.parse_args()
    if not options.check:
        cases_.need_program(parser, options)
    return options


def main():
    cases = found.load_all()
    options = arguments(list(cases))
    if options.check:
        return check(cases)
    folder = options.folder or cases_.default_folder(options.quick)
    wanted = {name: cases[name] for name in cases if name in options.only}
    jobs = {name: cases_.jobs(case, folder / name, options.quick) for name, case in wanted.items()}
    watch = progress.Progress([job for several in jobs.values() for job in several], options.quick)
    chapters = stored(cases, folder)
    try:
        with runs.workers(options.jobs) as pool:
            submitted = {name: runs.submit(pool, several, options, watch) for name, several in jobs.items()}
            for name, case in wanted.items():
                chapters[name] = judge(case, submitted[name], folder / name, options.quick)
                watch.say(told(case, chapters[name]))
                page.write(folder / "book.html", cases, chapters, folder, runs.program_hash(options.sluice), options.quick)
    except KeyboardInterrupt:
        watch.say("Stopped; what is done is kept, the same command goes on from here.")
        return 130
    others = sum(run["program"] != runs.program_hash(options.sluice) for name in wanted for run in chapters[name].get("runs", ()))
    if others:
        print(f"{others} runs are of another build of the program; --again runs all anew")
    fresh = {name: chapters[name] for name in wanted if "failed" not in chapters[name]}
    if not options.quick:
        readme.update(cases, found.folders(), fresh)
        progress.write_costs(fresh)
    print(f"Book: {folder / 'book.html'}")
    return max(EXIT[page.state(chapters[name])] for name in wanted)


def judge(case, submitted, folder, quick):
    """Waits for the runs of one case. What goes wrong is its chapter."""
    try:
        runs.wait_for(submitted)
        result = cases_.finish(case, folder, quick)
        if not quick:
            cases_.store(case, result)
    except RunError as error:
        cases_.write_chapter(case, folder, quick, {"failed": str(error)})
    except Exception:  # a fault of the case's own script must not take the other cases along
        cases_.write_chapter(case, folder, quick, {"failed": traceback.format_exc()})
    return cases_.read_chapter(folder)


def told(case, chapter):
    """The criteria that failed, and the verdict."""
    if "failed" in chapter:
        return f"{case.name}: BROKEN\n{chapter['failed']}"
    rows = chapter["verdict"]["rows"]
    lines = [f"  FAIL  {what}: {value} {unit} ({wanted})" for what, value, unit, wanted, ok in rows if not ok]
    return "\n".join([*lines, f"{case.name}: {'FAIL' if lines else 'pass'}, {len(rows) - len(lines)} of {len(rows)} criteria met, "
                              f"{page.cpu_seconds(chapter):.1f} s"])


def stored(cases, folder):
    """Chapters of earlier calls."""
    there = {name: cases_.read_chapter(folder / name) for name in cases}
    return {name: chapter for name, chapter in there.items() if chapter}


def check(cases):
    lacking, surplus = readme.missing(cases, found.folders())
    for name in lacking:
        print(f"{readme.README}: the table lacks {name}; validation/book.py writes it", file=sys.stderr)
    for name in surplus:
        print(f"{readme.README}: the table has {name}, which is no case", file=sys.stderr)
    return 1 if lacking or surplus else 0


if __name__ == "__main__":
    sys.exit(main())
