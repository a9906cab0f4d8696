#!/bin/sh
# Fails if an object file that was compiled for one instruction set offers other files anything outside that set's
# namespace. Usage: check_isa_symbols.sh NM LEVEL OBJECT...
#
# Inline functions and templates are emitted, as weak symbols, by every file that calls them without inlining. The linker
# keeps any one of the copies for the whole program. Were it the one compiled for AVX-512, code that has nothing to do
# with pair loops would run AVX-512 instructions, and stop a program with SIGILL on a processor that lacks them. Within
# the set's namespace there is no namesake elsewhere.
set -eu
nm=$1
level=$2
shift 2
[ $# -gt 0 ] || { echo "no object files given"; exit 1; }

status=0
for object in "$@"; do
    symbols=$("$nm" -C --defined-only "$object")
    # W, V: weak; u: unique in the program. A strong one (T, D, B, R) would clash or be taken as well.
    shared=$(printf '%s\n' "$symbols" | grep -E '^[0-9a-f]* [WVuTDBRi] ' || true)
    if ! printf '%s\n' "$shared" | grep -q "sluice::$level::"; then
        echo "$object: defines nothing in sluice::$level"
        status=1
    fi
    foreign=$(printf '%s\n' "$shared" | grep -v -e "sluice::$level::" -e '^$' || true)
    if [ -n "$foreign" ]; then
        echo "$object: outside sluice::$level:"
        printf '%s\n' "$foreign"
        status=1
    fi
done
exit $status
