"""Runs the Python blocks of a document, one after the other, in an empty folder with the small gate as gate.toml.
A block with a module that is not here is skipped, with a word about it. Usage: test_document.py PROGRAM SCENES DOCUMENT
"""
import os
import re
import shutil
import sys
import tempfile
from importlib.util import find_spec
from pathlib import Path


def missing_modules(block):
    """Those of a block's imports, and of the blocks that go on with it, that are not here."""
    used = set(re.findall(r"^(?:import|from) (\w+)", block, re.M)) | set(re.findall(r"\b(simulation|sluice)\b", block))
    return sorted(name for name in {"sluice" if name == "simulation" else name for name in used} if find_spec(name) is None)


def main(program, scenes, document):
    text = document.read_text()
    blocks = [(text.count("\n", 0, found.start(1)) + 1, found.group(1))
              for found in re.finditer(r"^```python\n(.*?)^```", text, re.M | re.S)]
    if len(blocks) < 5:
        raise SystemExit(f"{document}: {len(blocks)} blocks of Python, expected more")
    os.environ["PATH"] = f"{Path(program).parent}:{os.environ['PATH']}"
    names = {"__name__": "document"}
    with tempfile.TemporaryDirectory() as scratch:
        shutil.copy(scenes / "small_gate.toml", Path(scratch) / "gate.toml")
        os.chdir(scratch)
        for line, block in blocks:
            if missing := missing_modules(block):
                print(f"{document}:{line}: skipped: no {', '.join(missing)} here")
                continue
            # An error then tells the document's own line.
            exec(compile("\n" * (line - 1) + block, str(document), "exec"), names)
        os.chdir("/")
    print(f"test_document: {len(blocks)} blocks seen")


main(sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3]).resolve())
