"""The command of a case that is more than one scene at several spacings.

Such a case offers `study(options)`, which runs, draws and judges, and returns the lines of a Markdown text and a Verdict.
Of `options` it uses folder, sluice, threads, and, if they are there, quick (seconds instead of minutes, with criteria of its
own) and store (keep the figure beside the case's README).
"""
import sys

from lib import convergence, runs
from lib.run_output import RunError, RunOutput


def quick(options):
    return getattr(options, "quick", False)


def run(options, name, scene, settings):
    """A run of `scene` in the study's folder, which must have come to its end."""
    at = options.folder / name
    runs.run(scene, at, settings, options.sluice, ["--threads", options.threads])
    output = RunOutput(at)
    if output.summary["status"] != "done":
        raise RunError(f"{at}: {output.summary['status']} at t = {output.summary['simulated_time']:.3g} s")
    return output


def pictures(options, folder):
    """Where the figure goes: into the folder of the runs and, if it is to be kept, beside the case's README."""
    keep = getattr(options, "store", False) and not quick(options)
    return [options.folder / "figure.png"] + ([folder / "figure.svg"] if keep else [])


def main(title, folder, study):
    """Exit code 0 if the criteria are met, 1 if not, 2 if a run failed."""
    parser = convergence.arguments(sys.modules["__main__"].__doc__, runs.ROOT / "results" / folder.name)
    parser.add_argument("--quick", action="store_true", help="the quick form, with its own criteria")
    parser.add_argument("--store", action="store_true", help="keep the figure as figure.svg beside the README")
    options = parser.parse_args()
    if options.quick:
        options.folder = options.folder / "quick"
    try:
        lines, verdict = study(options)
    except RunError as error:
        print(f"{title}: cannot compare: {error}", file=sys.stderr)
        return 2
    print("\n" + "\n".join(lines))
    verdict.print_table()
    print(f"Picture: {options.folder / 'figure.png'}")
    return verdict.close(title)
