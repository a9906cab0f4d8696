"""results.md: what each case asks, its limits, every run's outcome and worst figures; causes of what was not expected."""
import subprocess
import tomllib
from datetime import date
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def text(cases, results, command):
    parts = ["# Hard cases: results\n",
             f"Written by `tests/hard/run.py` on {date.today().isoformat()}, sources at {_commit()}; "
             f"program: {command}. [README.md](README.md) explains the words.\n",
             _totals(results), _overview(cases, results)]
    parts += [_causes(results)]
    parts += [_case(case, [r for r in results if r.job.case == case.name]) for case in cases]
    return "\n".join(parts)


def _totals(results):
    count = {verdict: sum(r.verdict == verdict for r in results) for verdict in ("as expected", "known", "UNEXPLAINED")}
    cpu = sum(r.cpu for r in results)
    return (f"**{len(results)} runs: {count['as expected']} as expected, {count['known']} not, but explained below, "
            f"{count['UNEXPLAINED']} unexplained. {cpu:.0f} s of CPU time ({cpu / 60:.1f} min).**\n")


def _overview(cases, results):
    rows = ["| case | runs | as expected | known | unexplained | CPU |", "| --- | ---: | ---: | ---: | ---: | ---: |"]
    for case in cases:
        own = [r for r in results if r.job.case == case.name]
        counts = [sum(r.verdict == v for r in own) for v in ("as expected", "known", "UNEXPLAINED")]
        rows.append(f"| [{case.title}](#{_anchor(case.title)}) | {len(own)} | " + " | ".join(map(str, counts)) +
                    f" | {sum(r.cpu for r in own):.1f} s |")
    return "\n".join(rows) + "\n"


KINDS = {"fault": "fault of the engine", "limit": "limit of the method", "paper": "the paper's scheme"}


def load_causes():
    return tomllib.loads((Path(__file__).resolve().parent / "causes.toml").read_text())


def _causes(results):
    """Those that these runs met, faults first."""
    causes = load_causes()
    met = sorted({r.cause for r in results if r.cause}, key=lambda name: list(KINDS).index(causes[name]["kind"]))
    lines = ["## What was not expected, and why\n"]
    for name in met:
        cause = causes[name]
        count = sum(r.cause == name for r in results)
        lines.append(f"### {cause['title']}\n\n*{KINDS[cause['kind']]}; runs: {count}; `{name}`.* {cause['text'].strip()}\n")
        if "scene" in cause:
            lines.append(f"Smallest scene: `scenes/{cause['scene']}`\n")
    return "\n".join(lines)


def _case(case, results):
    columns = _columns(results)
    lines = [f"## {case.title}\n", case.asks.strip() + "\n", _limits(case, results)]
    lines.append("| variant | setting | outcome | " + " | ".join(columns) + " | CPU |")
    lines.append("| --- | --- | --- |" + " ---: |" * (len(columns) + 1))
    causes = load_causes()
    for r in results:
        flag = "" if r.expected else "**UNEXPLAINED** "
        if r.cause:
            flag = f"[**known**](#{_anchor(causes[r.cause]['title'])}) "
        cells = [_figure(r, name) for name in columns]
        lines.append(f"| {r.job.variant} | {r.job.setting} | {flag}{_outcome(r)} | " + " | ".join(cells) + f" | {r.cpu:.1f} s |")
    return "\n".join(lines) + "\n"


def _limits(case, results):
    """Those that the runs had; a variant's own are named by it."""
    lines = []
    for name, limit in case.limits.items():
        lines.append(f"- `{name}` {_range(limit)}: {limit['why']}")
    for variant in dict.fromkeys((r.job.variant) for r in results):
        own = next(r.job.limits for r in results if r.job.variant == variant)
        lines += [f"- `{name}` {_range(limit)} ({variant}): {limit['why']}" for name, limit in own.items()
                  if limit != case.limits.get(name) and name != "bits"]
    return "\n".join(lines) + "\n"


def _range(limit):
    words = [f"at least {limit['least']:g}"] if "least" in limit else []
    words += [f"at most {limit['most']:g}"] if "most" in limit else []
    return " and ".join(words) or "is told, not judged"


def _columns(results):
    names = dict.fromkeys(name for r in results for name in r.figures if name != "finite")
    return list(names)


def _figure(result, name):
    if name not in result.figures:
        return ""
    value = f"{result.figures[name]:.2g}"
    return f"**{value}**" if name in result.broken else value


def _outcome(result):
    detail = result.detail.replace("|", "/")
    wanted = "" if result.job.expect == ["ok"] else f" (expected: {' or '.join(result.job.expect)})"
    return f"{result.outcome} {detail}".strip() + wanted


def _anchor(title):
    return "".join(c for c in title.lower().replace(" ", "-") if c.isalnum() or c == "-")


def _commit():
    said = subprocess.run(["git", "-C", str(ROOT), "describe", "--always"], capture_output=True, text=True)
    return said.stdout.strip() or "an unknown commit"
