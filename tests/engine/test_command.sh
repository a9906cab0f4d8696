#!/bin/sh
# What the command `sluice` prints and returns. Usage: test_command.sh PROGRAM SCENES
program=$1
scenes=$2
topics=$(CDPATH='' cd -- "$(dirname -- "$0")/../../engine/command/topics" && pwd)
. "$(dirname -- "$0")/scratch.sh"
trap 'umount "$work/disk" 2>/dev/null; rm -rf "$work"' EXIT

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
expect 2 'found "chek", expected one of "new", "run", "check"' "$program" chek
holds 'did you mean "check"?' out
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
for topic in units probes output exit-codes environment profiling; do
    expect 0 "$topic" "$program" help --help
    expect 0 "$(head -n 1 "$topics/$topic.txt")" "$program" help $topic
    [ "$(wc -L <out)" -le 100 ] || fail "help $topic is wider than a terminal"
done
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

# What a run has left is shown: as a page, as pictures.
expect 0 "3 frames, " "$program" view results/small_gate
holds 'id="frame-2"' results/small_gate/view.html
grep -qE '<(script|link|img)[^>]*(src|href)="?(http|/)' results/small_gate/view.html && fail "the page asks for other files"
expect 0 "2 frames, " "$program" view results/small_gate -o half.html --every 2 --fields velocity,pressure
expect 2 'did you mean "pressure"?' "$program" view results/small_gate -o none.html --fields presure
expect 2 "no such folder" "$program" view missing
expect 2 "not the folder of a run" "$program" view "$scenes"
expect 2 "excludes" "$program" view plain --serve --every 2
[ ! -e none.html ] || fail "a refused page is written"
expect 0 "3 pictures in pictures" "$program" render results/small_gate -o pictures --video none --size 320x180
[ -s pictures/frame_0002.png ] || fail "a picture is missing"
expect 2 "--size: found" "$program" render results/small_gate --size 320
expect 2 "LOW,HIGH with LOW < HIGH" "$program" render results/small_gate --range 2,1
expect 2 'did you mean "viridis"?' "$program" render results/small_gate --map virids -o pictures
expect 3 "apt install ffmpeg" env PATH=/nowhere "$program" render results/small_gate -o pictures --size 320x180
truncate -s 700 results/small_gate/frames/frame_0001.hdf
expect 0 "frame_0001.hdf: cannot be read as a frame: it is cut short or damaged; left out" "$program" view results/small_gate
holds "2 frames, " out

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

# Killed in the middle, nothing that was done is lost and no run goes on. Where it was done before, once more.
for attempt in 1 2 3 4 5; do
    rm -rf killed
    "$program" study "$vortex" --vary method.courant=0.1,0.15,0.2,0.25,0.3,0.35 --set output.end=0.4 --repeat 3 -o killed >out 2>&1 &
    pid=$!
    while [ -z "$(ls killed/runs/*/result.json 2>/dev/null)" ]; do sleep 0.05; done
    kill -KILL $pid
    wait $pid 2>/dev/null
    [ "$(ls killed/runs/*/result.json | wc -l)" -eq 18 ] || break
done
holds '"methods"' killed/study.json
[ "$(ls killed/runs/*/result.json | wc -l)" -lt 18 ] || fail "$attempt times the study was done before it could be killed"
expect 0 "of 18 runs are done already" "$program" study "$vortex" --vary method.courant=0.1,0.15,0.2,0.25,0.3,0.35 --set output.end=0.4 --repeat 3 -o killed
[ "$(ls killed/runs/*/result.json | wc -l)" -eq 18 ] || fail "the study was not completed"

# Asked to stop, it says how to go on. Its run would take hours.
"$program" study "$vortex" --vary method.spacing=0.004 --set output.end=1000 -o stopping >out 2>&1 &
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

# What a stopped run wrote is gone on with, to the same bits: same FOLDER FOLDER.
same() {
    cmp "$1/probes.csv" "$2/probes.csv" || fail "$2/probes.csv is not that of $1"
    diff -r "$1/frames" "$2/frames" || fail "$2/frames are not those of $1"
}

expect 2 "--force requires --resume" "$program" run "$gate" --force
expect 2 "--output excludes --resume" "$program" run --resume stopped -o other
expect 2 "missing: found no such folder" "$program" run --resume missing
mkdir empty
expect 2 "empty: found no checkpoint" "$program" run --resume empty

# A few hundred steps, with a frame, a row and a checkpoint every few of them.
intervals="--set output.frame_interval=0.004 --set output.probe_interval=0.001"
settings="--until 0.03 $intervals"
often="--set output.checkpoint_interval=0.0012"
# shellcheck disable=SC2086 # settings are words
expect 0 "done" "$program" run "$gate" -o whole $settings --threads 1

# Stopped by a signal, once more when it goes on, which both would take hours, then left to an end.
# shellcheck disable=SC2086
"$program" run "$gate" -o termed --until 100 $intervals >out 2>&1 &
pid=$!
while [ ! -e termed/frames/frame_0001.hdf ]; do sleep 0.02; done
kill -TERM $pid
wait $pid
[ -e termed/checkpoints ] || fail "an interrupted run leaves no checkpoint"
"$program" run --resume termed --until 100 --threads 2 >out 2>&1 &
pid=$!
while [ ! -e termed/frames/frame_0003.hdf ]; do sleep 0.02; done
kill -TERM $pid
wait $pid
end=$(python3 -c 'import json; print(json.load(open("termed/summary.json"))["simulated_time"] + 0.005)')
expect 0 "going on from termed/checkpoints/step_" "$program" run --resume termed --until "$end" --threads 1
# shellcheck disable=SC2086
expect 0 "done" "$program" run "$gate" -o longer --until "$end" $intervals --threads 2
same longer termed
expect 0 "termed is finished: it ran to " "$program" run --resume termed

# Killed at moments of every kind, again and again; SLUICE_KILLS says how often.
kills=${SLUICE_KILLS:-10}
k=0
while [ $k -lt "$kills" ]; do
    threads=$((k % 2 + 1))
    if ls killed/checkpoints/step_*.h5 >out 2>&1; then
        "$program" run --resume killed --threads $threads >out 2>&1 &
    else
        # shellcheck disable=SC2086
        "$program" run "$gate" -o killed $settings $often --threads $threads >out 2>&1 &
    fi
    pid=$!
    sleep 0.$((k * 37 % 23 + 10))
    kill -KILL $pid 2>/dev/null
    wait $pid 2>/dev/null
    k=$((k + 1))
    if grep -qs '"status": "done"' killed/summary.json; then # it was faster: once more from the start
        same whole killed
        rm -r killed
    fi
done
if ls killed/checkpoints/step_*.h5 >out 2>&1; then
    expect 0 "results in killed" "$program" run --resume killed
    same whole killed
fi

# The newest checkpoint is damaged, then both.
cp -r termed damaged
# shellcheck disable=SC2086
expect 0 "done" "$program" run "$gate" -o damaged $settings $often
last=$(ls damaged/checkpoints | tail -n 1)
printf x | dd of="damaged/checkpoints/$last" bs=1 seek=2000 conv=notrunc 2>out
rm damaged/summary.json
expect 0 "$last: is damaged: size or checksum do not match; the one before is used" "$program" run --resume damaged
same whole damaged
for file in damaged/checkpoints/*; do printf x | dd of="$file" bs=1 seek=2000 conv=notrunc 2>out; done
rm damaged/summary.json
expect 2 "no checkpoint can be used" "$program" run --resume damaged

# Another scene is refused, and what differs is shown.
expect 0 "done" "$program" run "$gate" -o early --until 0.01 --set output.checkpoint_interval=0.004
expect 2 "+ courant = 0.5" "$program" run --resume early --until 0.012 --set method.courant=0.5
holds "the scene is not that of early/checkpoints/" out
holds "--force goes on with it all the same" out
expect 2 "the scene is not that of" "$program" run "$scenes/still_water_3d.toml" --resume early --until 0.012
expect 2 "the checkpoint does not fit" \
    "$program" run "$scenes/still_water_3d.toml" --resume early --until 0.012 --force
expect 0 "going on with it all the same" \
    "$program" run --resume early --until 0.012 --set output.probe_interval=0.001 --force
holds "probe_interval = 0.001" early/scene.toml

# Only root can make a small disk.
mkdir disk
if mount -t tmpfs -o size=900k tmpfs disk 2>out; then
    # shellcheck disable=SC2086
    expect 3 "No space left on device" "$program" run "$gate" -o disk $settings $often
    holds "checkpoints/step_" out
    holds '"status": "failed"' disk/summary.json
    ls disk/checkpoints/*.part >out 2>&1 && fail "a part of a checkpoint is left"
    mount -o remount,ro disk
    expect 3 "Read-only file system" "$program" run --resume disk
    mount -o remount,rw,size=20m disk
    expect 0 "going on from" "$program" run --resume disk
    same whole disk
    umount disk
else
    echo "no small disk could be made: what happens on a full one was not tried"
fi

[ $failures -eq 0 ] && echo "all as expected"
exit $failures
