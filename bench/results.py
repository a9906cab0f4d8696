"""What sluice_bench wrote, name by name."""

import json
import re
import statistics

NANOSECONDS = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}


class Results:
    """The runs of one JSON file; a benchmark's repetitions are the entries of a list."""

    def __init__(self, text):
        content = json.loads(text)
        self.context = content["context"]
        self.runs = {}
        for run in content["benchmarks"]:
            if run["run_type"] == "iteration" and not run.get("error_occurred"):
                self.runs.setdefault(short_name(run["name"]), []).append(run)

    def cpu_times(self, name):
        """CPU time per iteration of each repetition. [ns]"""
        return [run["cpu_time"] * NANOSECONDS[run["time_unit"]] for run in self.runs[name]]

    def median(self, name, counter):
        """A counter's median over the repetitions; None if the benchmark has no such counter."""
        values = [run[counter] for run in self.runs[name] if counter in run]
        return statistics.median(values) if values else None


def read(path):
    with open(path, encoding="utf-8") as file:
        return Results(file.read())


def short_name(name):
    """Without what Google Benchmark adds to every name."""
    return re.sub(r"/(process_time|real_time|iterations:\d+|repeats:\d+)", "", name)


def parts(name):
    """`fluid_momentum/dim:2/mixed/avx2` → (["fluid_momentum", "mixed", "avx2"], {"dim": "2"})."""
    words, arguments = [], {}
    for part in name.split("/"):
        key, colon, value = part.partition(":")
        if colon:
            arguments[key] = value
        else:
            words.append(part)
    return words, arguments


def load(context):
    """The load average at the start, as text."""
    return " ".join(f"{value:.1f}" for value in context.get("load_avg", [])) or "unknown"
