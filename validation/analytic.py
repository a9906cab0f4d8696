#!/usr/bin/python3
"""Runs every case that has an analytic solution, each at three spacings; writes analytic.md beside this file.

Runs that are done are not run again. The exit code is 0 if all criteria are met, 1 if not, 2 if a run failed.
"""
import importlib.util
import sys
from pathlib import Path

VALIDATION = Path(__file__).resolve().parent
sys.path.insert(0, str(VALIDATION))

from lib import convergence, runs  # noqa: E402
from lib.run_output import RunError  # noqa: E402

CASES = ("taylor_green", "poiseuille", "couette", "standing_wave", "hydrostatic_column", "oscillating_drop")
HEAD = """# Cases with an analytic solution

Written by `validation/analytic.py`: preset "modern" as the scenes stand, one thread. Errors are relative; the folders'
READMEs define them. Orders are those between a row's spacing and the one above it.
"""


def load(name):
    spec = importlib.util.spec_from_file_location(f"{name}_compare", VALIDATION / name / "compare.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.CASE


def section(case, study, verdict):
    lines = [f"## {case.title}: {'PASS' if verdict.passed else 'FAIL'}", "", study.markdown()]
    for what, value, unit, wanted, ok in verdict.rows:
        lines.append(f"- {'pass' if ok else '**FAIL**'}: {what} {value} {unit} ({wanted})".replace("  ", " "))
    return "\n".join(lines) + "\n"


def main():
    parser = convergence.arguments(__doc__, runs.ROOT / "results" / "analytic")
    parser.add_argument("--only", nargs="*", choices=CASES, default=CASES, help="of the cases; analytic.md is kept then")
    options = parser.parse_args()
    top, parts, failed = options.folder, [HEAD], []
    for name in options.only:
        case, options.folder = load(name), top / name
        try:
            study, verdict = convergence.run_case(case, options)
        except RunError as error:
            print(f"{case.title}: cannot compare: {error}", file=sys.stderr)
            return 2
        verdict.close(case.title)
        parts.append(section(case, study, verdict))
        failed += [] if verdict.passed else [case.title]
    if options.only == CASES:
        (VALIDATION / "analytic.md").write_text("\n".join(parts))
    print(f"\nFailed: {', '.join(failed)}" if failed else "\nAll passed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
