#!/usr/bin/env python3
"""Shows that no room of the house can include what stands above it: neighbor/layer.cmake gives each room folders of links
to the headers that it may see. Here the compiler is asked, room by room, which headers of the house it finds.

Usage: layers.py SOURCE_DIR BUILD_DIR COMPILER
"""
import os
import subprocess
import sys
import tempfile
from collections import defaultdict
from pathlib import Path

SOURCE, BUILD, COMPILER = Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3]


def rooms():
    """The rooms from the ground up: name -> folders of links, its own first."""
    lines = (BUILD / "layers" / "rooms.txt").read_text().splitlines()
    return {name: folders for name, *folders in (line.split(";") for line in lines)}


def headers():
    """room -> its headers, named as they are included."""
    found = defaultdict(list)
    for top in ("neighbor", "kernels", "engine"):
        for pattern in ("*.hpp", "*.def"):
            for file in sorted((SOURCE / top).rglob(pattern)):
                name = file.relative_to(SOURCE).as_posix()
                found[os.path.dirname(name)].append(name)
    return found


def compiles(text, folders):
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "asks.cpp"
        file.write_text(text)
        done = subprocess.run([COMPILER, "-std=c++20", "-fsyntax-only", *(f"-I{f}" for f in folders), file],
                              cwd=folder, capture_output=True, text=True)
    return done.returncode == 0, done.stderr


def main():
    failures = []
    folders_of, headers_of = rooms(), headers()
    # What is included by name only in a single room, and never above it.
    unlaid = sorted(set(headers_of) - set(folders_of) - {"engine/api/python"})
    if unlaid:
        failures.append(f"no rooms of the house: {', '.join(unlaid)}")
    room_of = {folders[0]: name for name, folders in folders_of.items()}
    asked = 0
    laid = []
    for room, folders in folders_of.items():
        seen = {room_of[f] for f in folders}
        if climbing := seen - set(laid) - {room}:
            failures.append(f"{room} sees what is laid above it: {', '.join(sorted(climbing))}")
        laid.append(room)
        text = []
        for other, names in headers_of.items():
            for name in names:
                wrong = "!" if other in seen else ""
                text.append(f'#if {wrong}__has_include("{name}")\n#error "{name}"\n#endif')
                asked += 1
        good, said = compiles("\n".join(text), folders)
        if not good:
            failures.append(f"{room} finds what it should not, or does not find what it should:\n{said[:1000]}")

    # The same with plain includes: one that goes down compiles, one that climbs does not.
    good, said = compiles('#include "neighbor/vec.hpp"\n', folders_of["kernels/terms"])
    if not good:
        failures.append(f"an include that goes down does not compile:\n{said}")
    good, said = compiles('#include "kernels/passes/pass_name.hpp"\n', folders_of["neighbor"])
    if good or "No such file" not in said:
        failures.append("an include that climbs compiles")

    for failure in failures:
        print(failure)
    print(f"{len(folders_of)} rooms, {asked} includes asked for: {'FAILED' if failures else 'ok'}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
