"""The book's page: one HTML file that needs no other."""
import csv
import html
import re
import time
from pathlib import Path

from lib.book import pictures
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
    count = {key: sum(state(chapters.get(name)) == key for name in cases) for key in WORDS}
    told = ", ".join(f"{count[key]} {word}" for key, word in (("pass", "pass"), ("fail", "fail"), ("broken", "with a failed run"),
                                                               ("none", "not run")) if count[key])
    program = sorted({(run["version"], run["instruction_set"]) for c in chapters.values() for run in c.get("runs", ())})
    programs = "; ".join(f"sluice {version}, {isa}" for version, isa in program)
    form = ("The quick form, as the tests run it: coarse and short, with criteria of its own. " if quick else "")
    return (f'<h1 id="top">sluice: validation</h1><p>{len(cases)} cases: {told}. {form}All runs took '
            f'{clock(sum(cpu_seconds(c) for c in chapters.values()))} of CPU time together.</p>'
            f'<p class="soft">{esc(programs)}. Written {time.strftime("%-d %B %Y, %H:%M")} by <code>validation/book.py</code>.</p>')


def overview(cases, chapters):
    rows = []
    for name, case in cases.items():
        chapter = chapters.get(name)
        error = "".join(f'<b>{esc(value)}</b> <span class="soft">{esc(what)}</span>'
                        for what, value in chapter.get("errors", ())[:1]) if chapter else ""
        cpu = f"{cpu_seconds(chapter):.1f} s" if chapter and "runs" in chapter else "–"
        rows.append(f'<tr><td><a href="#{name}">{esc(case.title)}</a></td><td>{chip(chapter)}</td>'
                    f'<td>{error or "–"}</td><td>{esc(case.against)}</td><td class="number" data-name="CPU">{cpu}</td></tr>')
    return ('<div class="scroll"><table class="words cases"><thead><tr><th>case</th><th>verdict</th><th>main error</th>'
            f'<th>against</th><th class="number">CPU time</th></tr></thead><tbody>{"".join(rows)}</tbody></table></div>')


def chip(chapter):
    key = state(chapter)
    return f'<span class="verdict {key}">{WORDS[key]}</span>'


def section(case, chapter, folder, program):
    title = (f'<section id="{case.name}"><div class="head"><h2>{esc(case.title)}</h2>{chip(chapter)}'
             f'<a class="up soft" href="#top">all cases</a></div><p>Proves {esc(case.proves)}. Against: {esc(case.against)}.</p>')
    if chapter is None:
        return f'{title}<p class="soft">Not run yet.</p></section>'
    if "failed" in chapter:
        return f'{title}<pre>{esc(chapter["failed"])}</pre></section>'
    parts = [title, cost_line(case, chapter, program)]
    drawn = [figure(f, folder, f"{case.name}-{i}") for i, f in enumerate(chapter["figures"])]
    parts += drawn[:1] + [f'<div class="pair"><div>{errors_table(chapter)}</div><div>{criteria(chapter)}</div></div>'] + drawn[1:]
    parts += [table(t) for t in chapter["tables"]]
    parts += [convergence(chapter, case, folder), peers(case, chapter), precision_diagram(case), effects(chapter), run_table(chapter)]
    return "".join(parts) + "</section>"


def cost_line(case, chapter, program):
    others = sum(run["program"] != program for run in chapter["runs"])
    runs = len(chapter["runs"])
    return (f'<p class="soft">{cpu_seconds(chapter):.1f} s of CPU time in {runs} run{"s" * (runs > 1)}, finished '
            f'{time.strftime("%-d %B %Y, %H:%M", time.localtime(max(run["finished"] for run in chapter["runs"])))}'
            f'{f", {others} of them by another build of the program" if others else ""}. <code>validation/{case.folder.name}</code></p>')


def figure(f, folder, key):
    return (f'<figure><div class="frame">{pictures.picture(folder / f["path"], key, f["caption"])}</div>'
            f'<figcaption>{esc(f["caption"])}</figcaption></figure>')


def errors_table(chapter):
    rows = "".join(f'<tr><td>{esc(what)}</td><td class="number">{esc(value)}</td></tr>' for what, value in chapter["errors"])
    return f'<h3>Errors</h3><div class="scroll"><table class="words"><tbody>{rows}</tbody></table></div>'


def criteria(chapter):
    rows = "".join(f'<tr{"" if ok else " class=failed"}><td>{esc(what)}</td><td class="number">{esc(f"{value} {unit}")}</td><td class="wanted">{esc(wanted)}</td>'
                   f'<td>{"pass" if ok else "FAIL"}</td></tr>' for what, value, unit, wanted, ok in chapter["verdict"]["rows"])
    return ('<h3>Criteria</h3><div class="scroll"><table class="words"><thead><tr><th></th><th class="number">value</th><th>wanted</th><th></th></tr>'
            f'</thead><tbody>{rows}</tbody></table></div>')


def table(t):
    head = "".join(f"<th>{marked(cell)}</th>" for cell in t["header"])
    rows = "".join("<tr>" + "".join(f"<td>{marked(cell)}</td>" for cell in row) + "</tr>" for row in t["rows"])
    note = f'<p class="note">{marked(t["note"])}</p>' if t["note"] else ""
    return (f'<h3>{marked(t["title"])}</h3><div class="scroll"><table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table></div>{note}')


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
    for measure in dict.fromkeys(row["measure"] for row in known):
        if measure not in chapter["measures"]:
            continue
        rows.append(f'<tr class="ours"><td>sluice</td><td>{esc(measure)}</td><td class="number">{esc(chapter["measures"][measure])}</td><td>here</td></tr>')
        rows += [f'<tr><td>{esc(row["code"])}</td><td>{esc(measure)}</td><td class="number">{esc(row["value"])}</td><td>{esc(row["source"])}</td></tr>'
                 for row in known if row["measure"] == measure]
    if not rows:
        return ""
    return ('<h3>What others reach</h3><div class="scroll"><table class="words"><thead><tr><th>code</th><th>measure</th>'
            f'<th class="number">value</th><th>source</th></tr></thead><tbody>{"".join(rows)}</tbody></table></div>')


def precision_diagram(case):
    path = case.folder / "study.svg"
    if case.part or not path.exists():
        return ""
    caption = "Error against CPU time over spacings, presets and precisions, by sluice study (kept beside the scene, not run anew here)."
    return "<h3>What accuracy costs</h3>" + figure({"path": path, "caption": caption}, case.folder, f"{case.name}-study")


def effects(chapter):
    """Of each group of runs that have the same effects on."""
    groups = {}
    for run in chapter["runs"]:
        on = {key: effect for key, effect in run["effects"].items() if effect["on"]}
        groups.setdefault(tuple(on), []).append((run["name"], on))
    parts = []
    for runs in groups.values():
        names = "" if len(groups) == 1 else f'<p class="note">{esc(", ".join(name for name, _ in runs))}</p>'
        rows = "".join(f'<tr><td>{esc(effect["name"])}</td><td>{esc(why(key, runs))}</td><td class="soft">{esc(effect["equation"])}</td></tr>'
                       for key, effect in runs[0][1].items())
        parts.append(f'{names}<div class="scroll"><table class="words"><thead><tr><th>effect</th><th>why</th><th>source</th></tr></thead>'
                     f'<tbody>{rows}</tbody></table></div>')
    return "<h3>Effects that ran</h3>" + "".join(parts)


def why(key, runs):
    """Runs may differ in it: by a coefficient, say."""
    return "; or ".join(dict.fromkeys(on[key]["why"] for _, on in runs))


def run_table(chapter):
    rows = "".join(
        f'<tr><td>{esc(r["name"])}</td><td>{r["particles"]:,}</td><td>{r["steps"]:,}</td><td>{r["cpu_seconds"]:.1f}</td>'
        f'<td>{r["wall_seconds"]:.1f}</td><td>{r["threads"]}</td><td>{r["precision"]}</td><td>{r["instruction_set"]}</td></tr>' for r in chapter["runs"])
    return ('<details><summary>Runs and times</summary><div class="scroll"><table><thead><tr><th>run</th><th>particles</th><th>steps</th>'
            '<th>CPU [s]</th><th>by the clock [s]</th><th>threads</th><th>precision</th><th>instructions</th></tr></thead>'
            f'<tbody>{rows}</tbody></table></div></details>')


def esc(text):
    return html.escape(str(text))


def marked(text):
    """Escaped, with the little of Markdown that tables' notes have."""
    return re.sub(r"\*([^*]+)\*", r"<em>\1</em>", re.sub(r"`([^`]+)`", r"<code>\1</code>", esc(text)))
