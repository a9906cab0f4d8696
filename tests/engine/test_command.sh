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

# A study: two that run, one that is refused, one that breaks down; each stands in the table.
vortex=$scenes/small_vortex.toml
expect 0 "reference energy" "$program" check "$vortex"
expect 0 "3/4 mixed, spacing 50 mm" "$program" study "$vortex" --vary method.spacing=x2,x1 --vary method.precision=mixed,half -o vortices
grep -q 'half .* failed: .* found "half", expected one of "double", "mixed"' out || fail "a refused setting is not in the table"
for file in study.json study.csv study.svg study.html; do [ -s vortices/$file ] || fail "the study lacks $file"; done
expect 0 "failed: " "$program" study "$scenes/breakdown.toml" --vary method.time_step=0.05,0.0001 --set output.end=0.1 -o torn
holds "time step 0.0001" out
# The same command again runs nothing.
expect 0 "2 of 4 runs are done already" "$program" study "$vortex" --vary method.spacing=x2,x1 --vary method.precision=mixed,half -o vortices
grep -q "CPU-s$" out && fail "a finished run is made again"
expect 2 "expected key.path=V1,V2" "$program" study "$vortex" --vary method.spacing
expect 2 "unknown key" "$program" study "$vortex" --vary method.spacign=1,2 -o none
expect 2 "--vary is required" "$program" study "$vortex"
[ ! -e none ] || fail "a refused study leaves a folder"

# Killed in the middle, nothing that was done is lost and no run goes on.
"$program" study "$vortex" --vary method.courant=0.1,0.15,0.2,0.25,0.3,0.35 --set output.end=0.4 --repeat 3 -o killed >out 2>&1 &
pid=$!
while [ -z "$(ls killed/runs/*/result.json 2>/dev/null)" ]; do sleep 0.05; done
kill -KILL $pid
wait $pid 2>/dev/null
holds '"methods"' killed/study.json
done_before=$(ls killed/runs/*/result.json | wc -l)
[ "$done_before" -lt 18 ] || fail "the study was done before it could be killed"
expect 0 "of 18 runs are done already" "$program" study "$vortex" --vary method.courant=0.1,0.15,0.2,0.25,0.3,0.35 --set output.end=0.4 --repeat 3 -o killed
[ "$(ls killed/runs/*/result.json | wc -l)" -eq 18 ] || fail "the study was not completed"

# Asked to stop, it says how to go on.
"$program" study "$vortex" --vary method.spacing=0.004 -o stopping >out 2>&1 &
pid=$!
while [ ! -s stopping/runs/*/summary.json ]; do sleep 0.05; done
kill -TERM $pid
wait $pid
code=$?
[ $code -eq 130 ] || fail "an interrupted study returned $code"
holds "goes on where it stopped" out
[ -s stopping/study.html ] || fail "an interrupted study leaves no page"

# Stored beside the scene it answers what settings an error takes, and what to expect of a run.
mkdir vortex && cp "$vortex" vortex/scene.toml
expect 2 "study.json: cannot be read" "$program" check vortex/scene.toml --target-error 3%
expect 0 "stored as vortex/study.json" "$program" study vortex/scene.toml --vary method.spacing=x2,x1 -o kept --store
expect 0 "For 50 % in energy: spacing" "$program" check vortex/scene.toml --target-error 50%
holds "measured " out
expect 2 "a share > 0" "$program" check vortex/scene.toml --target-error none
expect 0 "expected error, by vortex/study.json" "$program" run vortex/scene.toml -o once
expect 0 "particle-steps/s" "$program" run vortex/scene.toml -o other --set materials.water.viscosity=0.02
grep -q "expected error" out && fail "a study of another scene is asked"

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
