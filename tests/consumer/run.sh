#!/bin/sh
# Installs sluice into a folder of its own, and builds and runs a program against it as others would; nothing of the build
# may be needed for that. Usage: run.sh BUILD_DIR CXX
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
build=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "consumer: $*" >&2; exit 1; }

cmake --install "$build" --prefix "$scratch/prefix" >"$scratch/log" || { cat "$scratch/log"; fail "cannot be installed"; }
"$scratch/prefix/bin/sluice" check "$here/dam.toml" >/dev/null || fail "the installed program does not run"

# Headers are all there is to see: no file of the engine, no other library's.
grep -rhE '#include' "$scratch/prefix/include" | grep -vE '<[a-z_]+>|"(sluice/)?(errors|export|field|run|scene|simulation)\.hpp"' &&
    fail "an installed header includes something that is not installed"
library=$(ls "$scratch"/prefix/lib*/libsluice.so "$scratch"/prefix/lib/*/libsluice.so 2>/dev/null | head -n 1)
nm -DC --defined-only "$library" | grep -F ' T ' | grep -vE ' T (sluice::api::|_init|_fini)' &&
    fail "the library shows what is not public"

cp "$here/CMakeLists.txt" "$here/main.cpp" "$scratch"
generator=$(sed -n 's/^CMAKE_GENERATOR:.*=//p' "$build/CMakeCache.txt")
cmake -S "$scratch" -B "$scratch/build" -G "$generator" -DCMAKE_PREFIX_PATH="$scratch/prefix" -DCMAKE_CXX_COMPILER="$2" \
    -DCMAKE_CXX_FLAGS="-Wall -Wextra -Wconversion -Werror" >"$scratch/log" 2>&1 || { cat "$scratch/log"; fail "is not configured"; }
cmake --build "$scratch/build" >"$scratch/log" 2>&1 || { cat "$scratch/log"; fail "is not built"; }
"$scratch/build/consumer" "$here/dam.toml" | tee "$scratch/said"
[ "$(grep -c 'front at x' "$scratch/said")" -eq 5 ] || fail "expected five places of the front"
grep -q 'did you mean "pressure"' "$scratch/said" || fail "expected a suggestion for the wrong field"

# Another minor version may have another interface.
sed 's/sluice 0.1/sluice 0.2/' "$here/CMakeLists.txt" >"$scratch/CMakeLists.txt"
cmake -S "$scratch" -B "$scratch/other" -G "$generator" -DCMAKE_PREFIX_PATH="$scratch/prefix" >/dev/null 2>&1 &&
    fail "version 0.2 was asked for and found"
echo "consumer: passed"
