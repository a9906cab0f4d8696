"""The table of all cases in validation/README.md, between two marks."""
import re

from lib.book.page import WORDS, cpu_seconds, state
from lib.case import VALIDATION

README = VALIDATION / "README.md"
BEGIN, END = "<!-- book.py writes from here -->", "<!-- to here -->"
HEADER = "| case | what it proves | against | errors | CPU | verdict |\n| --- | --- | --- | --- | ---: | --- |\n"


def update(cases, folders, chapters):
    """Cases that are not in chapters keep their line, if they had one."""
    before, old, after = _split()
    kept = {_name(line): line for line in old.splitlines()}
    lines = []
    for name, case in cases.items():
        known = kept.get(name) if name not in chapters else None
        lines.append(known or _line(case, chapters.get(name)))
    judged = {case.folder for case in cases.values()}
    lines += [f"| [`{folder.name}`]({folder.name}) | no criteria yet | | | | |" for folder in folders if folder not in judged]
    README.write_text(before + HEADER + "\n".join(sorted(lines)) + "\n" + after)


def _line(case, chapter):
    errors = "; ".join(f"{what}: {value}" for what, value in chapter.get("errors", ())) if chapter else ""
    verdict = WORDS[state(chapter)]
    cpu = f"{cpu_seconds(chapter):.0f} s" if chapter and "runs" in chapter else ""
    return (f"| [`{case.name}`]({case.folder.name}) | {case.proves} | {case.against} | {errors} | {cpu} | "
            f"{verdict if verdict == 'pass' else f'**{verdict}**'} |")


def missing(cases, folders):
    """What the table lacks and what it has too much: names of cases, and of folders without one."""
    judged = {case.folder for case in cases.values()}
    wanted = set(cases) | {folder.name for folder in folders if folder not in judged}
    there = {_name(line) for line in _split()[1].splitlines()} - {None}
    return sorted(wanted - there), sorted(there - wanted)


def _split():
    text = README.read_text()
    start, end = text.index(BEGIN) + len(BEGIN) + 1, text.index(END)
    return text[:start], text[start:end], text[end:]


def _name(line):
    found = re.match(r"\| \[`(\w+)`\]", line)
    return found[1] if found else None
