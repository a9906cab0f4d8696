#!/bin/sh
# Installs the packages, builds sluice, runs the elastic gate at the paper's resolution and compares it with the
# experiment, the paper and later codes. Usage: validation/elastic_gate/run.sh [RESULTS_DIR] [sluice run options …]
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
results=${1:-$root/results/elastic_gate}
[ $# -gt 0 ] && shift

"$root/tests/install_packages.sh"
cmake -S "$root" -B "$root/build" -G Ninja -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build "$root/build" --target sluice_command
"$root/build/bin/sluice" run "$root/validation/elastic_gate/scene.toml" -o "$results" "$@"
/usr/bin/python3 "$root/validation/elastic_gate/compare.py" --run "$results"
