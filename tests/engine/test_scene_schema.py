"""The JSON schema against scenes that are right and wrong. Usage: test_scene_schema.py PROGRAM REPOSITORY

All scenes of validation/, tests/ and the templates must pass; of the slips in wrong_edits/, those must not that are
marked so. 77 = skipped: no python3-jsonschema here.
"""
import json
import subprocess
import sys
import tomllib
from pathlib import Path

try:
    from jsonschema import Draft7Validator
except ImportError:
    print("skipped: python3-jsonschema is not installed")
    sys.exit(77)

SCENES = ("validation/*/*.toml", "tests/hard/scenes/*.toml", "tests/engine/scenes/**/*.toml",
          "tests/engine/wrong_edits/scene.toml", "engine/scene/templates/*.toml")
# A scene for each type of value that none of the slips breaks, on top of a right one: where, and what is put there.
WRONG_VALUES = [
    ("title", 3),
    ("dimension", 4),
    ("gravity", [0.0]),
    ("gravity", [0.0, "down"]),
    ("acceleration", ["sin(t)"]),
    ("method.courant", 2.5),
    ("method.precision", "single"),
    ("method.solid.artificial_stress_exponent", 2.5),
    ("effects.contact", True),
    ("effects.friction", "on"),
    ("bodies.water.shape.circle", {"centre": [0, 0], "radius": 1}),
    ("bodies.water.shape", {}),
    ("bodies.water.shape", {"union": []}),
    ("bodies.water.shape", {"polygon": [[0, 0], [1, 0]]}),
    ("domain.periodic.x", [0.0]),
    ("walls.floor.shape", {"box": {"min": [0, 0], "max": [1, 1]}}),
    ("probes.tip.at", ["0.4"]),
    ("probes.tip.velocity", [0, 0]),
    ("output.end", 0),
    ("tables", {}),
]


def scenes(repository):
    for pattern in SCENES:
        paths = sorted(repository.glob(pattern))
        if not paths:
            sys.exit(f"no scenes: {pattern}")
        yield from paths


def with_value(scene, path, value):
    *tables, last = path.split(".")
    place = scene
    for table in tables:
        place = place.setdefault(table, {})
    place[last] = value
    return scene


def main():
    program, repository = sys.argv[1], Path(sys.argv[2])
    schema = json.loads(subprocess.run([program, "help", "schema"], check=True, capture_output=True).stdout)
    Draft7Validator.check_schema(schema)
    validator = Draft7Validator(schema)
    problems, right, wrong = [], 0, 0
    for path in scenes(repository):
        right += 1
        for error in validator.iter_errors(tomllib.loads(path.read_text())):
            problems.append(f"{path}: {'.'.join(map(str, error.path))}: {error.message[:200]}")
    folder = repository / "tests/engine/wrong_edits"
    text = (folder / "scene.toml").read_text()
    for edit in tomllib.loads((folder / "edits.toml").read_text())["edit"]:
        try:
            scene = tomllib.loads(text.replace(edit["from"], edit["to"], 1))
        except tomllib.TOMLDecodeError:
            continue
        wrong += edit["schema"]
        if validator.is_valid(scene) == edit["schema"]:
            problems.append(f"{edit['name']}: {'accepted' if edit['schema'] else 'refused'}")
    for path, value in WRONG_VALUES:
        wrong += 1
        if validator.is_valid(with_value(tomllib.loads(text), path, value)):
            problems.append(f"{path} = {value}: accepted")
    print("\n".join(problems) or f"{right} scenes accepted, {wrong} refused")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
