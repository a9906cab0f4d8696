#!/bin/sh
# Builds with assertions or sanitizers, and runs what is worth their time: the program as Debug builds it, with those of the
# standard library too; address and undefined behaviour; races.
# Usage: tests/sanitize.sh [debug|asan|asan-quick|tsan]...
# (asan and tsan, seventeen and six minutes of CPU time; debug and asan-quick: six)
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
"$root/tests/install_packages.sh" clang libclang-rt-dev libomp-dev python3-dev pybind11-dev python3-numpy
cd "$root"
export UBSAN_OPTIONS=print_stacktrace=1 ASAN_OPTIONS=detect_stack_use_after_return=1
# Archer, which libomp loads by itself, tells the sanitizer what OpenMP's runtime waits for; libraries that were built
# without it are left out. Nothing is suppressed.
export TSAN_OPTIONS="ignore_noninstrumented_modules=1 halt_on_error=1"
for preset in ${*:-asan tsan}; do
    cmake --preset "$preset" >"$root/build-$preset.log" 2>&1 || { cat "$root/build-$preset.log"; exit 1; }
    rm -f "$root/build-$preset.log"
    cmake --build --preset "$preset"
    if ctest --preset "$preset"; then
        echo "sluice: $preset found nothing"
    else
        echo "sluice: $preset FAILED"
        exit 1
    fi
done
