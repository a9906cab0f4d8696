#!/bin/sh
# Installs the packages, builds sluice, runs every validation case and writes the book: results/validation/book.html.
# Usage: validation/book.sh [book.py options …], among them --quick and --only CASE …
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)

"$root/tests/install_packages.sh"
cmake -S "$root" -B "$root/build" -G Ninja -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build "$root/build" --target sluice_command
/usr/bin/python3 "$root/validation/book.py" "$@"
