#!/bin/sh
# What the command `sluice` prints and returns. Usage: test_command.sh PROGRAM SCENES
program=$1
scenes=$2
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

# A failure is told and counted.
fail() {
    echo "FAILED: $*"
    failures=$((failures + 1))
}

# expect CODE TEXT COMMAND…: the command must return CODE and print TEXT on either stream.
expect() {
    code=$1
    text=$2
    shift 2
    "$@" >out 2>&1
    got=$?
    if [ "$got" -ne "$code" ]; then
        fail "$*: returned $got, expected $code" && cat out
    elif ! grep -qF -- "$text" out; then
        fail "$*: does not print: $text" && cat out
    fi
}

# holds TEXT FILE: the file must contain the text.
holds() {
    grep -qF -- "$1" "$2" || fail "$2 lacks: $1"
}

gate=$scenes/small_gate.toml

expect 0 "sluice 0." "$program" --version
expect 0 "Examples:" "$program" --help
expect 0 "--threads" "$program" run --help
expect 2 "sluice: error: " "$program"
expect 2 "sluice: error: " "$program" fly
expect 2 "SCENE is required" "$program" run
expect 2 "--threads" "$program" run "$gate" --threads 0
expect 2 "--threads" "$program" run "$gate" --threads many
expect 2 "--until" "$program" run "$gate" --until -1
expect 2 "avx9 not in {baseline" "$program" run "$gate" --isa avx9
expect 2 "sluice: error: missing.toml" "$program" run missing.toml
expect 2 "spacign" "$program" run "$gate" --set method.spacign=0.01
expect 2 "sluice: error: " "$program" check "$gate" --set method.spacing=-1
[ ! -e results ] || fail "refused scenes leave a folder"

expect 0 'on if method.fluid.velocity_filter is not 1' "$program" help effects
expect 0 "Antoci2007 eq. 16" "$program" help effects velocity_filter
expect 2 'did you mean "velocity_filter"?' "$program" help effects velocity_fliter
expect 2 "KEY excludes --markdown" "$program" help effects velocity_filter --markdown
expect 2 "sluice: error: " "$program" help
expect 2 "sluice: error: " "$program" help scenes

expect 0 "gate" "$program" check "$gate"
expect 0 "the smallest" "$program" check "$gate"
expect 0 "tip.x [m]" "$program" check "$gate"
expect 2 "--threads requires --cost" "$program" check "$gate" --threads 2
expect 0 "fluid: velocity filter" "$program" check "$gate" --cost --threads 1
holds "cannot be left out" out
holds "cannot be on" out
holds "the whole scene:    about " out
holds " on one thread, without output" out
expect 0 "fluid: velocity filter" "$program" check "$gate"
expect 0 "switched off; theta" "$program" check "$gate" --set effects.velocity_filter=off
expect 2 'effects.clamp: found "off", but the scene cannot do without' "$program" check "$gate" --set effects.clamp=off
[ ! -e results ] || fail "check leaves a folder"

expect 0 "particle-steps/s" "$program" run "$gate"
holds '"status": "done"' results/small_gate/summary.json
expect 0 "baseline, mixed precision" "$program" run "$gate" -o plain --isa baseline --set method.precision=mixed
holds '"instruction_set": "baseline"' plain/summary.json
expect 0 "of the solid in each" "$program" run "$gate" -o rates --set method.time_stepping=multi-rate
mkdir tank && cp "$scenes/still_water_3d.toml" tank/scene.toml
expect 0 "results in results/tank" "$program" run tank/scene.toml --until 0.001 --set 'title="Mine"'
holds 'Mine' results/tank/scene.toml
expect 2 "choose another folder" "$program" run tank/scene.toml -o tank

expect 1 "sluice: error: " "$program" run "$scenes/breakdown.toml" -o broken
holds '"status": "failed"' broken/summary.json

touch occupied
expect 3 "occupied" "$program" run "$gate" -o occupied
expect 3 "No space left on device" sh -c '"$1" check "$2" >/dev/full' check "$program" "$gate"
# No file may grow beyond 20 blocks (of 512 or 1024 bytes, as the shell has it): the first frame does not fit.
expect 3 "frame_0000.hdf: cannot write: File too large" \
    sh -c 'ulimit -f 20; exec "$1" run "$2" -o small' run "$program" "$gate"
holds '"status": "failed"' small/summary.json
[ ! -e small/frames/frame_0000.hdf.part ] || fail "a part of a frame is left"

# Stopped: the last state is written and the summary says so. The run would take hours. (TERM, as shells shield what
# they start in the background from INT.)
"$program" run "$gate" -o stopped --until 100 >out 2>&1 &
pid=$!
while ! grep -qs '"status"' stopped/summary.json; do sleep 0.1; done
sleep 1
kill -TERM $pid
wait $pid
code=$?
[ $code -eq 130 ] || fail "an interrupted run returned $code"
holds '"status": "interrupted"' stopped/summary.json

[ $failures -eq 0 ] && echo "all as expected"
exit $failures
