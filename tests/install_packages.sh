#!/bin/sh
# Installs what sluice is built and validated with, from Debian's own packages; skips apt if all are there. With the word
# `tests` also what only tests need (860 MB, most of it the browser and VTK). Further words are packages.
# Usage: install_packages.sh [tests] [PACKAGE...]
set -eu
packages="g++ cmake ninja-build libeigen3-dev libhdf5-dev libfmt-dev libtomlplusplus-dev libcli11-dev \
nlohmann-json3-dev libmuparser-dev zlib1g-dev libcpp-httplib-dev libcairo2-dev pkg-config catch2 \
libbenchmark-dev python3 python3-numpy python3-matplotlib python3-h5py"
if [ "${1:-}" = tests ]; then
    shift
    packages="$packages python3-dev pybind11-dev python3-pandas python3-jsonschema groff-base doxygen dpkg-dev file \
python3-fusepy fuse3 python3-vtk9"
    # These often come from elsewhere: the package is wanted only where the command is missing.
    for needed in chromium:chromium node:nodejs npm:npm; do
        command -v "${needed%:*}" >/dev/null || packages="$packages ${needed#*:}"
    done
fi
packages="$packages $*"

missing=""
for package in $packages; do
    dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed || missing="$missing $package"
done
if [ -z "$missing" ]; then
    echo "packages: all installed"
    exit 0
fi
echo "packages: installing$missing"
if [ "$(id -u)" -eq 0 ]; then as_root=""; else as_root="sudo"; fi
export DEBIAN_FRONTEND=noninteractive
$as_root apt-get update -qq
# shellcheck disable=SC2086 # a list of words on purpose
$as_root apt-get install -y -qq --no-install-recommends $missing >/dev/null
echo "packages: done"
