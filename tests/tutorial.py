#!/usr/bin/python3
"""Does what engine/doc/tutorial.md says, in an empty folder: makes its files, runs its commands, looks for what they print.

Of the page's blocks, in their order:
  ```toml NAME, ```python NAME    make the file NAME; NAME + adds to it
  ```sh                           are run; they must succeed, unless the text below begins with "sluice: error:"
  ```text                         is printed by the commands above it: these lines, in this order, others between them.
                                  Numbers may differ, and "…" stands for anything

Usage: tests/tutorial.py SLUICE [FOLDER]; with a FOLDER what was made stays there.
"""
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

PAGE = Path(__file__).resolve().parents[1] / "engine/doc/tutorial.md"
BLOCK = re.compile(r"^```(\w+)(?: (\S+)( \+)?)?\n(.*?)^```$", re.MULTILINE | re.DOTALL)
NUMBER = re.compile(r"[-+]?\d[\d.]*(e[-+]?\d+)?( [kMG]\b)?")
NOT_HERE = ("paraview ",)  # a window


class Failure(Exception):
    pass


def masked(line):
    """A line without what differs between runs and machines."""
    return NUMBER.sub("#", " ".join(line.split()))


def require_lines(wanted, printed):
    """All lines of `wanted` stand in `printed`, in their order."""
    lines = iter(masked(line) for line in printed.splitlines())
    for line in filter(str.strip, wanted.splitlines()):
        pattern = re.compile(".*".join(re.escape(part) for part in re.split(r" ?… ?", masked(line))))
        if not any(pattern.fullmatch(found) for found in lines):
            raise Failure(f"is not printed, or not there: {line}\nprinted was:\n{printed}")


def run(commands, folder, environment, may_fail):
    commands = "\n".join(line for line in commands.splitlines() if not line.startswith(NOT_HERE))
    done = subprocess.run(["sh", "-ec", commands], cwd=folder, env=environment, text=True, timeout=900,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if (done.returncode != 0) != may_fail:
        raise Failure(f"returned {done.returncode}:\n{commands}\n{done.stdout}")
    return done.stdout


def follow(page, sluice, folder):
    programs = folder / "bin"
    programs.mkdir(parents=True)
    (programs / "sluice").symlink_to(sluice)
    # One thread: the same everywhere, and no waiting for the other where processors are shared.
    environment = os.environ | {"PATH": f"{programs}:/usr/bin:/bin", "OMP_NUM_THREADS": "1"}
    blocks = list(BLOCK.finditer(page))
    printed = ""
    for number, block in enumerate(blocks):
        kind, name, more, text = block.groups()
        try:
            if name:
                with open(folder / name, "a" if more else "w") as file:
                    file.write(text)
            elif kind == "sh":
                following = blocks[number + 1] if number + 1 < len(blocks) else None
                may_fail = following is not None and following[1] == "text" and following[4].startswith("sluice: error:")
                printed = run(text, folder, environment, may_fail)
            elif kind == "text":
                require_lines(text, printed)
        except Failure as failure:
            line = page.count("\n", 0, block.start()) + 1
            raise Failure(f"{PAGE}:{line}: {failure}") from None
    return len(blocks)


def main():
    if len(sys.argv) not in (2, 3):
        raise SystemExit(__doc__)
    sluice = Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(sys.argv[2]) if len(sys.argv) == 3 else Path(scratch)
        try:
            blocks = follow(PAGE.read_text(), sluice, folder.resolve() / "tutorial")
        except Failure as failure:
            print(f"FAILED: {failure}")
            return 1
    print(f"{blocks} blocks of the tutorial hold")
    return 0


if __name__ == "__main__":
    sys.exit(main())
