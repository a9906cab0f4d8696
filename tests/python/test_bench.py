"""`sluice bench`: what it prints and writes, and what it refuses. Nothing here depends on how long anything takes.
Usage: test_bench.py PROGRAM SCENES
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path


def call(*words, expect=0, says=""):
    done = subprocess.run([str(w) for w in words], capture_output=True, text=True)
    text = done.stdout + done.stderr
    assert done.returncode == expect and says in text, f"{words}: {done.returncode}, expected {expect} and {says!r}\n{text}"
    return done.stdout


def check(bench, threads):
    machine = bench["machine"]
    limits = [machine["single_precision_operations_per_second"], machine["double_precision_operations_per_second"]]
    limits += machine["triad_bytes_per_second"]
    assert [level["level"] for level in limits[2:]] == ["L2", "L3", "memory"] and machine["threads"] == threads
    assert all(limit["one_thread"] > 0 and limit["all_threads"] > 0 for limit in limits)
    assert bench["memory_level"] in ("L2", "L3", "memory") and bench["memory_bytes"] > 0
    for part, count in (("one_thread", 1), ("all_threads", threads)):
        assert bench[part]["threads"] == count and bench[part]["steps"] > 0 and bench[part]["steps_per_second"] > 0
    names = [loop["name"] for loop in bench["loops"]]
    assert "fluid momentum" in names, names
    for loop in bench["loops"]:
        assert loop["of_arithmetic_peak"] > 0 and loop["of_bandwidth"] > 0 and "%" in loop["verdict"], loop
        assert loop["effects"], loop
    shares = sum(row["share"] for row in bench["phases"]) + sum(r["share"] for r in bench["rests"] if not r["phase"])
    assert abs(shares - 1) < 1e-6, shares


def main(program, scenes):
    gate = scenes / "small_gate.toml"
    with tempfile.TemporaryDirectory() as scratch:
        file = Path(scratch) / "bench.json"
        text = call(program, "bench", gate, "--seconds", 0.2, "--threads", 2, "--json", file)
        for words in ("steps/s", "particle updates/s", "triad, memory", "of the arithmetic peak", "fluid momentum"):
            assert words in text, (words, text)
        check(json.loads(file.read_text()), 2)
        call(program, "bench", scenes / "still_water_3d.toml", "--seconds", 0.2, "--threads", 1, "--isa", "baseline", "--json", file)
        bench = json.loads(file.read_text())
        check(bench, 1)
        assert bench["machine"]["instruction_set"] == "baseline"

        call(program, "bench", expect=2, says="SCENE is required")
        call(program, "bench", "missing.toml", expect=2, says="missing.toml")
        call(program, "bench", gate, "--set", "method.spacign=0.01", expect=2, says='did you mean "spacing"?')
        call(program, "bench", gate, "--seconds", 0, expect=2, says="--seconds")
        call(program, "bench", gate, "--seconds", 0.2, "--json", Path(scratch) / "none" / "b.json", expect=3)
        call(program, "bench", scenes / "breakdown.toml", "--seconds", 600, expect=1, says="broke down")
    print("test_bench: passed")


main(sys.argv[1], Path(sys.argv[2]))
