#!/usr/bin/python3
"""Runs the hard cases and says which came out as expected; the full suite writes results.md beside this file.

The exit code is 0 if every outcome that was not expected is explained in the case's data, 1 otherwise.
"""
import argparse
import sys
import tempfile
import time
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER))

import case_data  # noqa: E402
import execute  # noqa: E402
import table  # noqa: E402
from judge import judge  # noqa: E402


def main():
    options = _options()
    cases = case_data.load_cases(options.cases, options.fast)
    jobs = [job for case in cases for job in case.jobs]
    print(f"{len(jobs)} runs of {len(cases)} cases, {options.jobs} at a time", flush=True)
    with tempfile.TemporaryDirectory() as scratch:
        root = Path(scratch) if options.fast and not options.keep else options.folder
        results = _run(jobs, root, options)
    _report(results)
    if not options.fast and not options.cases:
        (FOLDER / "results.md").write_text(table.text(cases, results, _program(options).version()))
        print(f"wrote {FOLDER / 'results.md'}")
    return 1 if any(r.verdict == "UNEXPLAINED" for r in results) else 0


def _options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cases", nargs="*", help="only those whose names start so")
    parser.add_argument("--fast", action="store_true", help="the subset that ctest runs, about a minute of CPU time")
    parser.add_argument("--sluice", default=FOLDER.parents[1] / "build" / "bin" / "sluice", type=Path)
    parser.add_argument("--folder", default=FOLDER / "results", type=Path, help="where the runs are kept")
    parser.add_argument("--keep", action="store_true", help="keep the runs of --fast too")
    parser.add_argument("--isa", default="", help="instruction set: baseline, avx2, avx512")
    parser.add_argument("-j", "--jobs", default=1, type=int, help="runs at a time")
    return parser.parse_args()


def _program(options):
    return execute.Program(options.sluice, options.isa)


def _run(jobs, root, options):
    """Jobs with a twin are judged when all have run."""
    started, count = time.monotonic(), [0]

    def done(job, process, fresh):
        count[0] += 1
        print(f"[{count[0]}/{len(jobs)}, {time.monotonic() - started:.0f} s] {job.name}: "
              f"{process.cpu:.1f} s of CPU time{'' if fresh else ' (done before)'}", flush=True)

    processes = execute.run_all(jobs, root, _program(options), options.jobs, done)
    return [judge(job, process, root) for job, process in zip(jobs, processes)]


def _report(results):
    width = max(len(r.job.name) for r in results)
    for r in results:
        figures = ", ".join(f"{name} {value:.3g}" for name, value in r.figures.items() if name != "finite")
        print(f"{r.verdict:<12} {r.job.name:<{width}} {r.outcome} {r.detail}  [{figures}]")
    bad = [r for r in results if r.verdict == "UNEXPLAINED"]
    known = sum(r.verdict == "known" for r in results)
    print(f"{len(results)} runs, {sum(r.cpu for r in results):.0f} s of CPU time: {len(results) - len(bad) - known} as "
          f"expected, {known} known shortfalls, {len(bad)} unexplained")
    for r in bad:
        print(f"  UNEXPLAINED: {r.job.name}: {r.outcome} {r.detail}")


if __name__ == "__main__":
    sys.exit(main())
