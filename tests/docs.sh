#!/bin/sh
# The documentation of the code is made without a warning, and shows formulas as such. Usage: docs.sh DOXYFILE HTML
# Exit code 77 = skipped: no doxygen here.
set -eu
command -v doxygen >/dev/null || { echo "skipped: no doxygen here"; exit 77; }
fail() { echo "docs: $*" >&2; exit 1; }
rm -rf "$2"
mkdir -p "$(dirname -- "$2")"
doxygen "$1" 2>&1 | tee "$2.log"
[ ! -s "$2.log" ] || fail "doxygen complains"
grep -q 'class="fragment".*a_i = ' "$2"/structsluice_1_1SymmetricPressure.html || fail "formulas are not shown as such"
grep -q 'Two commands' "$2/index.html" || fail "the README is not the main page"
[ -s "$2/classsluice_1_1api_1_1Simulation.html" ] || fail "the public headers are missing"
echo "docs: passed"
