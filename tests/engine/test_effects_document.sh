#!/bin/sh
# engine/EFFECTS.md is what the program prints. Usage: test_effects_document.sh PROGRAM REPOSITORY
program=$1
document=$2/engine/EFFECTS.md
printed=$(mktemp) || exit 1
trap 'rm -f "$printed"' EXIT
"$program" help effects --markdown >"$printed" || exit 1
diff "$document" "$printed" && exit 0
echo "engine/EFFECTS.md is out of date; bring it up to date with"
echo "  $program help effects --markdown > $document"
exit 1
