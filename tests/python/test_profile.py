"""A profile tells of its run and does not change it; its files are what they are said to be. Nothing here depends on how
long anything takes. Usage: test_profile.py PROGRAM SCENES SCHEMA
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import jsonschema
except ImportError:  # then the schema is not looked at
    jsonschema = None

ROUNDING = 1e-6  # of nanoseconds added up as seconds


def call(*words, expect=0, says=""):
    done = subprocess.run([str(w) for w in words], capture_output=True, text=True)
    text = done.stdout + done.stderr
    assert done.returncode == expect and says in text, f"{words}: {done.returncode}, expected {expect} and {says!r}\n{text}"
    return done.stdout


def results(folder):
    return {file.name: file.read_bytes() for file in [folder / "probes.csv", *sorted((folder / "frames").iterdir())]}


def check_sums(profile, summary):
    """Loops and rests make up phases, phases and what is between them the steps."""
    phases = {p["name"]: p for p in profile["phases"]}
    between = [r for r in profile["rests"] if not r["phase"]]
    assert len(between) == 1 and set(phases) <= set(summary["seconds_per_phase"])
    total = sum(p["seconds"] for p in phases.values()) + between[0]["seconds"]
    assert abs(total - profile["seconds"]) < ROUNDING, (total, profile["seconds"])
    for name, phase in phases.items():
        parts = [r["seconds"] for r in profile["loops"] + profile["rests"] if r["phase"] == name]
        assert not parts or abs(sum(parts) - phase["seconds"]) < ROUNDING, name
    for row in profile["phases"] + profile["loops"] + profile["rests"]:
        assert len(row["busy_seconds"]) == profile["threads"], row
        assert all(-ROUNDING < t < row["seconds"] + ROUNDING for t in row["busy_seconds"]), row
        assert 1 - ROUNDING <= row["imbalance"] <= profile["threads"] + ROUNDING, row


def check_effects(profile, summary):
    """Each loop runs for effects that are on; each effect with a loop says so."""
    on = {key for key, effect in summary["effects"].items() if effect["on"]}
    assert {e["key"] for e in profile["effects"]} == on
    for loop in profile["loops"]:
        assert loop["effects"] and set(loop["effects"]) <= on, loop
        assert loop["pairs"] <= loop["lanes"] and (loop["operations"] > 0) == (loop["lanes"] > 0), loop
        for key in loop["effects"]:
            effect = next(e for e in profile["effects"] if e["key"] == key)
            assert loop["name"] in effect["where"], (loop["name"], effect)
            assert set(effect["with"]) >= set(loop["effects"]) - {key}, effect


def check_trace(trace, profile, summary):
    """Complete events, in order and nested on each thread; steps one behind the other on the first."""
    known = {p["name"] for p in profile["phases"] + profile["loops"]} | {"step", "share of the loop", "wait for other threads"}
    rows, marks = {t: [] for t in range(profile["threads"])}, []
    names = [e for e in trace["traceEvents"] if e["ph"] == "M"]
    assert len(names) == 1 + profile["threads"]
    for event in trace["traceEvents"]:
        if event["ph"] == "M":
            continue
        if event["ph"] == "i":
            marks.append(event)
            continue
        assert event["ph"] == "X" and event["pid"] == 1 and event["dur"] >= 0 and event["ts"] >= 0, event
        assert event["name"] in known, event
        assert set(event.get("args", {}).get("effects", "").split(" + ")) - {""} <= set(summary["effects"]), event
        rows[event["tid"]].append(event)
    for events in rows.values():
        open_until = []
        last = 0
        for event in events:
            begin, end = round(1000 * event["ts"]), round(1000 * (event["ts"] + event["dur"]))  # [ns]
            assert begin >= last, event
            last = begin
            while open_until and open_until[-1] < begin:
                open_until.pop()
            # Strictly: viewers add up in floating point. What takes no time at all may end where it began.
            assert not open_until or end < open_until[-1] or begin == end, event
            open_until.append(end)
    steps = [e for e in rows[0] if e["name"] == "step"]
    assert len(steps) == profile["trace"]["steps"], len(steps)
    assert [m["ts"] for m in marks] == [s["ts"] for s in steps]
    numbers = [m["args"]["step"] for m in marks]
    assert numbers == sorted(set(numbers)), numbers
    for before, after in zip(steps, steps[1:]):
        assert before["ts"] + before["dur"] <= after["ts"]
    return len(steps)


def check_profile(folder, schema, most_steps=20):
    profile, trace, summary = (json.loads((folder / f"{n}.json").read_text()) for n in ("profile", "trace", "summary"))
    if jsonschema:
        jsonschema.Draft202012Validator(schema).validate(profile)
    check_sums(profile, summary)
    check_effects(profile, summary)
    assert check_trace(trace, profile, summary) <= most_steps
    return profile, summary


def main(program, scenes, schema_file):
    schema = json.loads(Path(schema_file).read_text())
    gate, modern = scenes / "small_gate.toml", ["--set", 'method.preset="modern"']
    with tempfile.TemporaryDirectory() as scratch:
        scratch = Path(scratch)
        for name, words in [("paper", [gate]), ("modern", [gate, *modern]), ("vortex", [scenes / "small_vortex.toml"]),
                            ("water", [scenes / "still_water_3d.toml", "--until", "0.002"])]:
            plain, watched = scratch / name, scratch / f"{name}_profiled"
            call(program, "run", *words, "-o", plain, "--threads", 2)
            text = call(program, "run", *words, "-o", watched, "--threads", 2, "--profile")
            assert results(plain) == results(watched), f"{name}: other results with --profile"
            assert not (plain / "profile.json").exists() and not (plain / "trace.json").exists()
            profile, summary = check_profile(watched, schema)
            assert profile["steps"] == summary["steps"]
            momentum = [loop for loop in profile["loops"] if loop["name"] == "fluid momentum"]
            assert [loop["calls"] for loop in momentum] == [summary["steps"]], momentum
            assert "profile of " in text and "trace.json: " in text and "fluid momentum" in text

        few = scratch / "few"
        call(program, "run", gate, "-o", few, "--profile", "--trace-steps", 3)
        assert check_profile(few, schema, 3)[0]["trace"]["steps"] == 3
        call(program, "run", gate, "-o", few)
        assert not (few / "profile.json").exists(), "a profile of another run is left"
        call(program, "run", gate, "-o", few, "--profile", "--trace-steps", 0)
        assert check_profile(few, schema, 0)[0]["trace"]["steps"] == 0

        # Gone on with: the profile is of what is new.
        often = ["--set", "output.checkpoint_interval=0.0003"]
        parted, whole = scratch / "parted", scratch / "whole"
        call(program, "run", gate, *often, "-o", whole)
        end = json.loads((whole / "summary.json").read_text())["simulated_time"]
        call(program, "run", gate, *often, "-o", parted, "--until", end / 2)
        call(program, "run", "--resume", parted, "--until", end, "--profile")
        assert results(parted) == results(whole), "other results after a resume with --profile"
        profile, summary = check_profile(parted, schema)
        assert 0 < profile["steps"] < summary["steps"]

        call(program, "run", gate, "--trace-steps", 3, expect=2, says="--trace-steps requires --profile")
        call(program, "run", gate, "--profile", "--trace-steps", 1001, expect=2, says="not in range 0 to 1000")
        call(program, "run", gate, "--profile", "--trace-steps", "many", expect=2, says="--trace-steps")
    print("test_profile: passed")


main(sys.argv[1], Path(sys.argv[2]), sys.argv[3])
