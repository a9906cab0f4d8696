#!/bin/sh
# engine/EFFECTS.md and engine/SCENE.md are what the program prints. Usage: test_document.sh PROGRAM REPOSITORY TOPIC
program=$1
topic=$3
document=$2/engine/$(echo "$topic" | tr '[:lower:]' '[:upper:]').md
printed=$(mktemp) || exit 1
trap 'rm -f "$printed"' EXIT
"$program" help "$topic" --markdown >"$printed" || exit 1
diff "$document" "$printed" && exit 0
echo "$document is out of date; bring it up to date with"
echo "  $program help $topic --markdown > $document"
exit 1
