#!/usr/bin/env python3
"""Prints what sluice_bench measured, as Markdown tables. Usage: bench/table.py FILE.json"""

import argparse

import results

LEVELS = ["baseline", "avx2", "avx512"]


def print_table(title, header, rows):
    if not rows:
        return
    rows = [[str(cell) for cell in row] for row in [header, *rows]]
    widths = [max(len(row[k]) for row in rows) for k in range(len(header))]

    def line(row):
        cells = [row[0].ljust(widths[0])] + [cell.rjust(width) for cell, width in zip(row[1:], widths[1:])]
        return "| " + " | ".join(cells) + " |"

    rule = "| " + " | ".join(["-" * widths[0]] + ["-" * (width - 1) + ":" for width in widths[1:]]) + " |"
    print(f"\n{title}\n\n{line(rows[0])}\n{rule}")
    print("\n".join(line(row) for row in rows[1:]))


def millions(value):
    return "" if value is None else f"{value / 1e6:.3g}" if value < 1e8 else f"{value / 1e6:.0f}"


def billions(value):
    return f"{value / 1e9:.1f}"


def percent(value):
    return "" if value is None else f"{100 * value:.0f} %"


def roofline_rows(found):
    for name in found.runs:
        if name.startswith("roofline/"):
            rate = found.median(name, "operations/s") or found.median(name, "bytes/s")
            yield [name.removeprefix("roofline/"), billions(rate)]


def smoothing_rows(found):
    for name in found.runs:
        if name.startswith("smoothing/"):
            yield [name.removeprefix("smoothing/"), millions(found.median(name, "evaluations/s")),
                   percent(found.median(name, "of_fma_peak"))]


def pressure_rows(found):
    for name in found.runs:
        if name.startswith("equation_of_state/"):
            yield [name.removeprefix("equation_of_state/"), millions(found.median(name, "evaluations/s"))]


def search_rows(found):
    for name in found.runs:
        words, arguments = results.parts(name)
        if words[0] == "search":
            yield ["/".join(words[1:]), *(arguments.get(key, "") for key in ("dim", "h", "n", "threads")),
                   millions(found.median(name, "particles/s")), millions(found.median(name, "pairs/s")),
                   number(found.median(name, "bytes/particle"))]


def number(value):
    return "" if value is None else f"{value:.3g}"


def pass_rows(found):
    """One row per pass and arguments, with the instruction sets side by side: M pairs/s (fraction of the FMA peak)."""
    groups = {}
    for name in found.runs:
        if found.median(name, "of_copy") is not None:
            words, arguments = results.parts(name)
            level = words.pop()
            groups.setdefault(("/".join(words[:-1]), words[-1], *arguments.items()), {})[level] = name
    for (name, precision, *arguments), levels in groups.items():
        values = dict(arguments)
        cells = []
        for level in LEVELS:
            run = levels.get(level)
            cells.append(f"{millions(found.median(run, 'pairs/s'))} ({percent(found.median(run, 'of_fma_peak'))})"
                         if run else "")
        best = [levels[level] for level in LEVELS if level in levels][-1]
        bytes_per_particle = found.median(best, "list_bytes/particle") + found.median(best, "column_bytes/particle")
        yield [name, *(values[key] for key in ("dim", "h", "n")), precision, values["threads"], *cells,
               percent(found.median(best, "of_copy")), f"{found.median(best, 'lanes/pair'):.2f}",
               f"{found.median(best, 'operations/lane'):.0f}", f"{bytes_per_particle:.0f}"]


def step_rows(found):
    for name in found.runs:
        words, arguments = results.parts(name)
        rate = found.median(name, "particle-steps/s")
        if rate is not None:
            yield ["/".join(words), *(arguments.get(key, "") for key in ("dim", "n", "threads")), millions(rate),
                   millions(found.median(name, "by_the_clock")), millions(found.median(name, "pairs/s")),
                   number(found.median(name, "builds/step")), percent(found.median(name, "search_share")),
                   percent(found.median(name, "update_share")), f"{found.median(name, 'bytes/particle'):.0f}"]


def start_rows(found):
    for name in found.runs:
        words, arguments = results.parts(name)
        if "start" in words:
            yield ["/".join(words), *(arguments.get(key, "") for key in ("dim", "n", "threads")),
                   millions(found.median(name, "particles/s"))]


def print_all(found):
    print(f"{found.context['date']}, {found.context['num_cpus']} processors, load average "
          f"{results.load(found.context)}")
    print_table("Limits of one core, 10⁹ operations/s or bytes/s", ["limit", "10⁹/s"], list(roofline_rows(found)))
    print_table("Smoothing functions, 10⁶ evaluations/s", ["function", "10⁶/s", "of FMA peak"],
                list(smoothing_rows(found)))
    print_table("Pressure from density, 10⁶ evaluations/s", ["equation of state", "10⁶/s"], list(pressure_rows(found)))
    print_table("Search", ["stage", "dim", "100 h/d", "particles", "threads", "10⁶ particles/s", "10⁶ pairs/s",
                           "bytes/particle"], list(search_rows(found)))
    print_table("Passes, 10⁶ pairs/s of CPU time (of the FMA peak)",
                ["pass", "dim", "100 h/d", "particles", "precision", "threads", *LEVELS, "of copy", "lanes/pair",
                 "operations/lane", "bytes/particle"], list(pass_rows(found)))
    print_table("Whole steps, 10⁶ particle-steps/s",
                ["scene", "dim", "particles", "threads", "per core", "by the clock", "10⁶ pairs/s", "builds/step",
                 "search", "update", "bytes/particle"], list(step_rows(found)))
    print_table("From a scene's text to the first step, 10⁶ particles/s",
                ["scene", "dim", "particles", "threads", "10⁶ particles/s"], list(start_rows(found)))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("file")
    print_all(results.read(parser.parse_args().file))
