"""Slips in a scene, and the answers to them. Usage: test_wrong_edits.py PROGRAM FOLDER

FOLDER holds a scene and edits.toml: what is replaced by what, and the exact answer.
"""
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path


def edited(text, edit):
    """The scene after the first occurrence has been replaced."""
    if edit["from"] not in text:
        sys.exit(f"{edit['name']}: no {edit['from']!r} in the scene")
    return text.replace(edit["from"], edit["to"], 1)


def problem_of(program, text, edit):
    """What is wrong with the program's answer; empty if nothing is."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "scene.toml").write_text(edited(text, edit))
        ran = subprocess.run([program, "check", "scene.toml"], cwd=folder, capture_output=True, text=True)
    accepted = edit.get("accepted", False)
    expected = f"sluice: {'warning' if accepted else 'error'}: scene.toml:{edit['message']}\n"
    code = 0 if accepted else 2
    if ran.stderr == expected and ran.returncode == code:
        return ""
    return f"{edit['name']}: returned {ran.returncode}, expected {code}\n  {ran.stderr}  {expected}"


def main():
    program, folder = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2])
    text = (folder / "scene.toml").read_text()
    edits = tomllib.loads((folder / "edits.toml").read_text())["edit"]
    whole = {"name": "no edit", "from": "", "to": "", "accepted": True}
    clean = subprocess.run([program, "check", str(folder / "scene.toml")], capture_output=True, text=True)
    problems = [problem_of(program, text, edit) for edit in edits]
    if clean.returncode != 0 or clean.stderr:
        problems.append(f"{whole['name']}: {clean.stderr}")
    problems = [problem for problem in problems if problem]
    print("\n".join(problems) or f"{len(edits)} slips, each answered as it should be")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
