#!/bin/sh
# Builds and runs the benchmarks, writes JSON, prints tables.
# Usage: bench/run.sh [-o FILE] [-a] [FILTER] [sluice_bench options …]
#   -o FILE  where the JSON goes (default: build/bench.json)
#   -a       all: those under large/ too, which take gigabytes and minutes
#   FILTER   regular expression; a leading - takes out what matches (default: -^large/)
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
out=$root/build/bench.json
filter=-^large/
while getopts o:a option; do
    case $option in
        o) out=$OPTARG ;;
        a) filter=. ;;
        *) exit 2 ;;
    esac
done
shift $((OPTIND - 1))
if [ $# -gt 0 ]; then
    filter=$1
    shift
fi

cmake -S "$root" -B "$root/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DSLUICE_BENCH=ON >/dev/null
cmake --build "$root/build" --target sluice_bench
mkdir -p "$(dirname -- "$out")"
rm -f "$out"
# One line per benchmark while they run: the median's name and times, without its counters.
"$root/build/bin/sluice_bench" --benchmark_filter="$filter" --benchmark_min_time=0.05 --benchmark_repetitions=3 \
    --benchmark_display_aggregates_only=true --benchmark_out="$out" --benchmark_out_format=json "$@" |
    sed -n -u -E 's/^([^ ]*)_median( +[^ ]+ [nmu]?s)( +[^ ]+ [nmu]?s).*/\1\2\3/p'
[ -s "$out" ] || { echo "bench/run.sh: nothing measured"; exit 1; }
"$root/bench/table.py" "$out"
echo
echo "written: $out"
