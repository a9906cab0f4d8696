#!/bin/sh
# The Debian package of the program, made from a build that is there: what is in it, and what it says of itself. (The real
# thing, in a fresh Debian, is package.sh.) Usage: packages.sh BUILD_DIR; exit code 77 = skipped, no dpkg-dev here.
set -eu
build=$1
command -v dpkg-shlibdeps >/dev/null && command -v cpack >/dev/null || { echo "skipped: no dpkg-dev here"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "packages: $*" >&2; exit 1; }

(cd "$scratch" && cpack --config "$build/CPackConfig.cmake" -B "$scratch" >log 2>&1) || { cat "$scratch/log"; fail "cpack failed"; }
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:.*=//p' "$build/CMakeCache.txt")
library=libsluice${version%.*}

# has PACKAGE FIELD TEXT
has() { dpkg-deb -f "$scratch/$1"_*.deb "$2" | grep -qF -- "$3" || fail "$1: $2 is '$(dpkg-deb -f "$scratch/$1"_*.deb "$2")', expected '$3'"; }
# holds PACKAGE FILE
holds() { dpkg-deb --contents "$scratch/$1"_*.deb | grep -q "$2" || fail "$1 lacks $2"; }

has sluice Version "$version-1"
for needed in libc6 libgomp1 libhdf5 libfmt9 libmuparser libcairo2 libcpp-httplib zlib1g; do has sluice Depends $needed; done
holds sluice '/usr/bin/sluice$'
holds sluice '/usr/share/man/man1/sluice.1.gz$'
holds sluice '/usr/share/bash-completion/completions/sluice$'
holds sluice '/usr/share/sluice/sluice.schema.json$'
holds sluice '/usr/share/doc/sluice/copyright$'
has "$library" Depends libgomp1
holds "$library" "libsluice.so.${version%.*}"
has libsluice-dev Depends "$library (= $version-1)"
holds libsluice-dev '/usr/include/sluice/simulation.hpp$'
holds libsluice-dev 'cmake/sluice/sluiceConfigVersion.cmake$'
if [ -f "$build/python/sluice/__init__.py" ]; then
    has python3-sluice Depends python3-numpy
    holds python3-sluice '/dist-packages/sluice/_sluice.*\.so$'
fi
echo "packages: passed"
