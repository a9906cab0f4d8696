#!/usr/bin/env python3
"""Compares two runs of sluice_bench by CPU time.

bench/compare.py OLD.json NEW.json
    Medians over the repetitions. A change is marked if it exceeds the threshold and the ranges of the repetitions do
    not overlap.

bench/compare.py --run OLD_BINARY NEW_BINARY --filter 'fluid_momentum/dim:3'
    Runs the two alternately, so that a machine whose speed drifts slows both alike, and compares round by round. A
    change is marked if the median ratio exceeds the threshold and all rounds but the best and the worst agree in sign.

Ratios are old time / new time: above 1 is faster.
"""

import argparse
import re
import statistics
import subprocess
import sys

import results


class Change:
    """One benchmark's two times and whether they differ."""

    def __init__(self, name, old, new, ratio, low, high, threshold):
        self.name, self.old, self.new, self.ratio, self.low, self.high = name, old, new, ratio, low, high
        self.mark = ""
        if low is not None and abs(ratio - 1) > threshold:
            self.mark = "faster" if low > 1 else "slower" if high < 1 else ""

    def cells(self):
        spread = "one run each" if self.low is None else f"{self.low:.3f} … {self.high:.3f}"
        return [self.name, microseconds(self.old), microseconds(self.new), f"{self.ratio:.3f}", spread, self.mark]


def microseconds(nanoseconds):
    return f"{nanoseconds / 1e3:.4g}"


def compare_files(old, new, pattern, threshold):
    """Medians; the spread is that of the ratio between any two repetitions."""
    for name in old.runs:
        if name not in new.runs or not re.search(pattern, name):
            continue
        before, after = old.cpu_times(name), new.cpu_times(name)
        low = high = None
        if len(before) > 1 and len(after) > 1:
            low, high = min(before) / max(after), max(before) / min(after)
        old_time, new_time = statistics.median(before), statistics.median(after)
        yield Change(name, old_time, new_time, old_time / new_time, low, high, threshold)


def run_once(binary, options):
    command = [binary, f"--benchmark_filter={options.filter}", "--benchmark_format=json",
               f"--benchmark_min_time={options.min_time}"]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False)
    if done.returncode != 0 or not done.stdout:
        sys.exit(f"{' '.join(command)}: exit code {done.returncode}, nothing measured")
    return results.Results(done.stdout)


def run_rounds(binaries, options):
    """[(old, new), …]. Who goes first changes from round to round: a steady drift then cancels."""
    rounds = []
    for number in range(options.rounds):
        order = (0, 1) if number % 2 == 0 else (1, 0)
        pair = {which: run_once(binaries[which], options) for which in order}
        rounds.append((pair[0], pair[1]))
        print(f"round {number + 1} of {options.rounds}", file=sys.stderr)
    return rounds


def compare_rounds(rounds, threshold):
    first_old, first_new = rounds[0]
    for name in first_old.runs:
        if name not in first_new.runs:
            continue
        times = [(statistics.median(old.cpu_times(name)), statistics.median(new.cpu_times(name)))
                 for old, new in rounds]
        ratios = sorted(old / new for old, new in times)
        if len(ratios) > 4:
            low, high = ratios[1], ratios[-2]
        else:  # too few to leave any out
            low, high = (ratios[0], ratios[-1]) if len(ratios) > 1 else (None, None)
        yield Change(name, statistics.median(old for old, _ in times), statistics.median(new for _, new in times),
                     statistics.median(ratios), low, high, threshold)


def print_changes(changes):
    rows = [["benchmark", "old µs", "new µs", "old/new", "spread", ""], *(change.cells() for change in changes)]
    widths = [max(len(row[k]) for row in rows) for k in range(len(rows[0]))]
    for row in rows:
        cells = [row[0].ljust(widths[0])] + [cell.rjust(width) for cell, width in zip(row[1:-1], widths[1:-1])]
        print("  ".join([*cells, row[-1]]).rstrip())
    if changes:
        mean = statistics.geometric_mean(change.ratio for change in changes)
        marked = [change.mark for change in changes]
        print(f"\n{len(changes)} benchmarks: {marked.count('faster')} faster, {marked.count('slower')} slower, "
              f"geometric mean {mean:.3f}")


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old", help="JSON file, or with --run a sluice_bench")
    parser.add_argument("new", help="JSON file, or with --run a sluice_bench")
    parser.add_argument("--run", action="store_true", help="run the two binaries alternately")
    parser.add_argument("--filter", default=None, help="regular expression on the names; with --run required")
    parser.add_argument("--threshold", type=float, default=0.02, help="smallest change that is marked (default: 0.02)")
    parser.add_argument("--rounds", type=int, default=9, help="with --run: of each binary (default: 9)")
    parser.add_argument("--min-time", type=float, default=0.1, help="with --run: seconds per benchmark (default: 0.1)")
    options = parser.parse_args()
    if options.run and options.filter is None:
        parser.error("--run needs --filter: a round of the whole suite takes minutes, longer than a machine keeps its speed")
    return options


def main():
    options = parse()
    if options.run:
        changes = compare_rounds(run_rounds((options.old, options.new), options), options.threshold)
    else:
        old, new = results.read(options.old), results.read(options.new)
        print(f"load average: old {results.load(old.context)}, new {results.load(new.context)}\n")
        changes = compare_files(old, new, options.filter or "", options.threshold)
    print_changes(list(changes))


if __name__ == "__main__":
    main()
