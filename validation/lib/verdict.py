"""Criteria with a pass or a fail each, and the line that sums them up."""
import math


class Verdict:
    def __init__(self):
        self.rows = []

    def limit(self, what, value, unit, low=None, high=None):
        """A number that must lie within limits. What could not be measured fails."""
        measured = value is not None and math.isfinite(value)
        ok = measured and (low is None or value >= low) and (high is None or value <= high)
        self.rows.append((what, f"{value:.4g}" if measured else "-", unit, _range(low, high), ok))

    def none_of(self, what, count):
        """A count that must be zero; None means that it could not be counted, and fails."""
        self.rows.append((what, "-" if count is None else str(count), "", "none", count == 0))

    @property
    def passed(self):
        return all(ok for *_, ok in self.rows)

    def print_table(self):
        width = max(len(row[0]) for row in self.rows)
        for what, value, unit, wanted, ok in self.rows:
            print(f"  {'PASS' if ok else 'FAIL'}  {what:<{width}}  {value:>9} {unit:<4} ({wanted})")

    def close(self, case):
        """Prints the last line and returns the process's exit code."""
        failed = sum(not row[-1] for row in self.rows)
        if failed:
            print(f"{case}: FAIL, {failed} of {len(self.rows)} criteria not met")
        else:
            print(f"{case}: PASS, all {len(self.rows)} criteria met")
        return 1 if failed else 0


def _range(low, high):
    if low is None:
        return f"at most {high:g}"
    if high is None:
        return f"at least {low:g}"
    return f"{low:g} to {high:g}"
