#!/bin/sh
# Scenes to start from: written, accepted, run for a moment. Usage: test_new.sh PROGRAM
program=$1
. "$(dirname -- "$0")/scratch.sh"

# refuses TEXT COMMAND…: bad input, and the text on stderr.
refuses() {
    text=$1
    shift
    "$@" >out 2>err
    [ $? -eq 2 ] || fail "$*: is not refused"
    grep -qF -- "$text" err || { fail "$*: does not print: $text" && cat err; }
}

"$program" new >list || fail "no list"
names=$(awk '/^[a-z]/ {print $1}' list)
[ "$(echo "$names" | wc -w)" -eq 6 ] || fail "not six templates: $names"
for name in $names; do
    "$program" new "$name" >out || fail "$name is not written"
    grep -q "^  sluice run $name.toml$" out || fail "$name: does not say how it is run"
    "$program" new "$name" -o - | cmp -s - "$name.toml" || fail "$name: -o - prints something else"
    grep -q '^# Cost: .*CPU' "$name.toml" || fail "$name does not say what it costs"
    "$program" check "$name.toml" --draw >out 2>err || fail "$name is refused"
    [ "$(cat err)" = "sluice: picture in $name.png" ] || { fail "$name: is not accepted without a word" && cat err; }
    [ "$(head -c 4 "$name.png" | tail -c 3)" = PNG ] || fail "$name.png is no picture"
    end=$(awk '/^end = / {print 0.01 * $3}' "$name.toml")
    "$program" run "$name.toml" --until "$end" --set output.frame_interval="$end" --set output.probe_interval="$end" \
        >out 2>err || fail "$name does not run"
    [ -s err ] && grep warning err && fail "$name runs with warnings"
    [ "$(find results/"$name"/frames -name '*.hdf' | wc -l)" -eq 2 ] || fail "$name: not two frames"
    [ "$(wc -l <results/"$name"/probes.csv)" -eq 3 ] || fail "$name: not a heading and two rows"
done

"$program" help schema | cmp -s - sluice.schema.json || fail "the schema is not written beside the scene"
refuses 'did you mean "dam-break"?' "$program" new dam-brake
refuses "dam-break.toml: is there already" "$program" new dam-break
echo "mine" >dam-break.toml
refuses "--force overwrites it" "$program" new dam-break
[ "$(cat dam-break.toml)" = mine ] || fail "a file was overwritten"
echo "mine" >sluice.schema.json
"$program" new rings -o other.toml >out || fail "-o"
[ "$(cat sluice.schema.json)" = mine ] || fail "a schema was overwritten"
"$program" new dam-break --force >out || fail "--force"
"$program" help schema | cmp -s - sluice.schema.json || fail "--force leaves the schema"
"$program" new rings -o - | cmp -s - dam-break.toml && fail "the wrong template"
refuses "expected the name of a picture" "$program" check other.toml --draw other.toml
"$program" new rings -o - | cmp -s - other.toml || fail "--draw has overwritten a scene"

# What the checks refuse is drawn all the same.
"$program" check dam-break.toml --draw wrong.png --set bodies.water.shape.box.min='[-0.1, 0.0]' >out 2>err
[ $? -eq 2 ] || fail "a scene with water behind a wall is not refused"
[ -s wrong.png ] || fail "a refused scene is not drawn"

[ $failures -eq 0 ] || exit 1
echo "six scenes to start from"
