"""summary.json is as its schema says, whatever becomes of the run; and the schema names each of its keys.
Usage: test_summary_schema.py PROGRAM SCENES SCHEMA

77 = skipped: no python3-jsonschema here.
"""
import copy
import json
import sys
import tempfile
from pathlib import Path

from program import SKIPPED, run

try:
    import jsonschema
except ImportError as missing:
    print(f"skipped: {missing}")
    raise SystemExit(SKIPPED)


def closed(schema):
    """The schema, which allows for what later versions add, without that allowance."""
    if isinstance(schema, dict):
        schema = {key: closed(value) for key, value in schema.items()}
        if schema.get("type") == "object" and "properties" in schema:
            schema["additionalProperties"] = False
    elif isinstance(schema, list):
        schema = [closed(value) for value in schema]
    return schema


def validate(validator, folder, status):
    summary = json.loads((folder / "summary.json").read_text())
    problems = [f"{folder.name}: {'/'.join(map(str, e.absolute_path))}: {e.message[:200]}" for e in validator.iter_errors(summary)]
    if summary["status"] != status:
        problems.append(f"{folder.name}: status {summary['status']}, expected {status}")
    if problems:
        raise SystemExit("\n".join(problems))
    return summary


def refuse(validator, summary, change):
    """A schema that accepts everything would pass too."""
    wrong = copy.deepcopy(summary)
    change(wrong)
    if validator.is_valid(wrong):
        raise SystemExit("the schema accepts a wrong summary")


def main(program, scenes, schema_file):
    schema = json.loads(Path(schema_file).read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    strict = jsonschema.Draft202012Validator(closed(schema))
    gate = scenes / "small_gate.toml"
    with tempfile.TemporaryDirectory() as scratch:
        scratch = Path(scratch)
        summary = validate(strict, run(program, gate, scratch / "paper"), "done")
        validate(strict, run(program, gate, scratch / "modern", 'method.preset="modern"'), "done")
        validate(strict, run(program, scenes / "small_vortex.toml", scratch / "vortex"), "done")
        validate(strict, run(program, scenes / "still_water_3d.toml", scratch / "water", until=0.002), "done")
        broken = scenes / "breakdown.toml"
        validate(strict, run(program, broken, scratch / "stop", expect=1), "failed")
        validate(strict, run(program, broken, scratch / "retry", 'watch.policy="retry"', expect=1), "failed")
    refuse(strict, summary, lambda s: s.pop("energy"))
    refuse(strict, summary, lambda s: s.update(status="failed"))   # without a message
    refuse(strict, summary, lambda s: s.update(steps=-1))
    refuse(strict, summary, lambda s: s["particles"].update(gas=0))
    print("test_summary_schema: passed")


main(sys.argv[1], Path(sys.argv[2]), sys.argv[3])
