"""The book's page: one HTML file that needs no other."""
import csv
import time
from pathlib import Path

from lib.book import pictures
from lib.book.markup import cell, esc, headings, marked, row, table
from lib.book.progress import clock

HERE = Path(__file__).resolve().parent
WORDS = {"pass": "pass", "fail": "FAIL", "broken": "run failed", "none": "not run"}


def state(chapter):
    if chapter is None:
        return "none"
    if "failed" in chapter:
        return "broken"
    return "pass" if chapter["verdict"]["passed"] else "fail"


def cpu_seconds(chapter):
    return sum(run["cpu_seconds"] for run in chapter.get("runs", ())) if chapter else 0.0


def write(path, cases, chapters, folder, program, quick):
    """cases: Case by name; chapters: what is known of each, by name; program: hash of today's, to tell runs of another."""
    parts = [header(cases, chapters, quick), overview(cases, chapters)]
    parts += [section(case, chapters.get(name), folder / name, program) for name, case in cases.items()]
    css = (HERE / "page.css").read_text()
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>sluice: validation</title><style>
{css}</style></head>
<body><main>
{"".join(parts)}
</main></body></html>
""")


def header(cases, chapters, quick):
    words = {"pass": "pass", "fail": "fail", "broken": "with a failed run", "none": "not run"}
    count = {key: sum(state(chapters.get(name)) == key for name in cases) for key in words}
    told = ", ".join(f"{count[key]} {word}" for key, word in words.items() if count[key])
    programs = sorted({(run["version"], run["instruction_set"]) for c in chapters.values() for run in c.get("runs", ())})
    form = "The quick form, as the tests run it: coarse and short, with criteria of its own. " if quick else ""
    written = time.strftime("%-d %B %Y, %H:%M")
    return (f'<h1 id="top">sluice: validation</h1><p>{len(cases)} cases: {told}. {form}All runs took '
            f'{clock(sum(cpu_seconds(c) for c in chapters.values()))} of CPU time together.</p><p class="soft">'
            f'{esc("; ".join(f"sluice {version}, {isa}" for version, isa in programs))}. '
            f'Written {written} by <code>validation/book.py</code>.</p>')


def overview(cases, chapters):
    rows = []
    for name, case in cases.items():
        chapter = chapters.get(name)
        known = chapter.get("errors", ())[:1] if chapter else ()
        error = "".join(f'<b>{esc(value)}</b> <span class="soft">{esc(what)}</span>' for what, value in known)
        cpu = f"{cpu_seconds(chapter):.1f} s" if chapter and "runs" in chapter else "–"
        rows.append(row([cell(f'<a href="#{name}">{esc(case.title)}</a>'), cell(chip(chapter)), cell(error or "–"),
                         cell(esc(case.against)), cell(cpu, kind="number", name="CPU")]))
    return table(headings("case", "verdict", "main error", "against", "CPU time", number=(4,)), rows, "words cases")


def chip(chapter):
    key = state(chapter)
    return f'<span class="verdict {key}">{WORDS[key]}</span>'


def section(case, chapter, folder, program):
    title = (f'<section id="{case.name}"><div class="head"><h2>{esc(case.title)}</h2>{chip(chapter)}'
             f'<a class="up soft" href="#top">all cases</a></div>'
             f'<p>Proves {esc(case.proves)}. Against: {esc(case.against)}.</p>')
    if chapter is None:
        return f'{title}<p class="soft">Not run yet.</p></section>'
    if "failed" in chapter:
        return f'{title}<pre>{esc(chapter["failed"])}</pre></section>'
    drawn = [figure(f, folder, f"{case.name}-{i}") for i, f in enumerate(chapter["figures"])]
    judged = f'<div class="pair"><div>{errors_table(chapter)}</div><div>{criteria(chapter)}</div></div>'
    parts = [title, cost_line(case, chapter, program), *drawn[:1], judged, *drawn[1:]]
    parts += [results_table(t) for t in chapter["tables"]]
    parts += [convergence(chapter, case, folder), peers(case, chapter), precision_diagram(case), effects(chapter),
              run_table(chapter)]
    return "".join(parts) + "</section>"


def cost_line(case, chapter, program):
    runs = chapter["runs"]
    others = sum(run["program"] != program for run in runs)
    finished = time.strftime("%-d %B %Y, %H:%M", time.localtime(max(run["finished"] for run in runs)))
    return (f'<p class="soft">{cpu_seconds(chapter):.1f} s of CPU time in {len(runs)} run{"s" * (len(runs) > 1)}, finished '
            f'{finished}{f", {others} of them by another build of the program" if others else ""}. '
            f'<code>validation/{case.folder.name}</code></p>')


def figure(f, folder, key):
    return (f'<figure><div class="frame">{pictures.picture(folder / f["path"], key, f["caption"])}</div>'
            f'<figcaption>{esc(f["caption"])}</figcaption></figure>')


def errors_table(chapter):
    rows = [row([cell(esc(what)), cell(esc(value), kind="number")]) for what, value in chapter["errors"]]
    return "<h3>Errors</h3>" + table(None, rows)


def criteria(chapter):
    rows = [row([cell(esc(what)), cell(esc(f"{value} {unit}"), kind="number"), cell(esc(wanted), kind="wanted"),
                 cell("pass" if ok else "FAIL")], "" if ok else "failed")
            for what, value, unit, wanted, ok in chapter["verdict"]["rows"]]
    return "<h3>Criteria</h3>" + table(headings("", "value", "wanted", "", number=(1,)), rows)


def results_table(t):
    head = [cell(marked(name), "th") for name in t["header"]]
    rows = [row([cell(marked(value)) for value in values]) for values in t["rows"]]
    note = f'<p class="note">{marked(t["note"])}</p>' if t["note"] else ""
    return f'<h3>{marked(t["title"])}</h3>{table(head, rows, "")}{note}'


def convergence(chapter, case, folder):
    lines = [line for line in chapter["convergence"] if len(line["across"]) > 1 and all(e > 0 for e in line["errors"])]
    if not lines:
        return ""
    path = folder / "convergence.svg"
    pictures.draw_convergence(lines, path)
    return "<h3>Convergence</h3>" + figure({"path": path, "caption": "Errors against spacing."}, folder, f"{case.name}-order")


def peers(case, chapter):
    """What others are known to reach, below what we do; of the measures that the case has."""
    path = case.folder / "peers.csv"
    if not path.exists():
        return ""
    with open(path, newline="") as file:
        known = list(csv.DictReader(line for line in file if not line.startswith("#")))
    rows = []
    for measure, ours in chapter["measures"].items():
        theirs = [peer for peer in known if peer["measure"] == measure]
        if theirs:
            rows.append(row([cell("sluice"), cell(esc(measure)), cell(esc(ours), kind="number"), cell("here")], "ours"))
        rows += [row([cell(esc(peer["code"])), cell(esc(measure)), cell(esc(peer["value"]), kind="number"),
                      cell(esc(peer["source"]))]) for peer in theirs]
    if not rows:
        return ""
    return "<h3>What others reach</h3>" + table(headings("code", "measure", "value", "source", number=(2,)), rows)


def precision_diagram(case):
    path = case.folder / "study.svg"
    if case.part or not path.exists():
        return ""
    caption = ("Error against CPU time over spacings, presets and precisions, by sluice study (kept beside the scene, not run "
               "anew here).")
    return "<h3>What accuracy costs</h3>" + figure({"path": path, "caption": caption}, case.folder, f"{case.name}-study")


def effects(chapter):
    """Of each group of runs that have the same effects on."""
    groups = {}
    for run in chapter["runs"]:
        on = {key: effect for key, effect in run["effects"].items() if effect["on"]}
        groups.setdefault(tuple(on), []).append((run["name"], on))
    parts = []
    for runs in groups.values():
        if len(groups) > 1:
            parts.append(f'<p class="note">{esc(", ".join(name for name, _ in runs))}</p>')
        rows = [row([cell(esc(effect["name"])), cell(esc(why(key, runs))), cell(esc(effect["equation"]), kind="soft")])
                for key, effect in runs[0][1].items()]
        parts.append(table(headings("effect", "why", "source"), rows))
    return "<h3>Effects that ran</h3>" + "".join(parts)


def why(key, runs):
    """Runs may differ in it: by a coefficient, say."""
    return "; or ".join(dict.fromkeys(on[key]["why"] for _, on in runs))


def run_table(chapter):
    rows = [row([cell(esc(value)) for value in (
        r["name"], f'{r["particles"]:,}', f'{r["steps"]:,}', f'{r["cpu_seconds"]:.1f}', f'{r["wall_seconds"]:.1f}', r["threads"],
        r["precision"], r["instruction_set"])]) for r in chapter["runs"]]
    head = headings("run", "particles", "steps", "CPU [s]", "by the clock [s]", "threads", "precision", "instructions")
    return f'<details><summary>Runs and times</summary>{table(head, rows, "")}</details>'
