#!/bin/sh
# Builds the Debian packages, looks at them with lintian, and installs and uses them in a fresh Debian 12: the command, the
# Python module, and a program that is built against the library. Takes some minutes, 1.5 GB in /tmp, and root; needs
# debootstrap, dpkg-dev, file, and lintian if they are to be looked at. Usage: tests/package.sh [BUILD_DIR]
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
build=${1:-$root/build-package}
fail() { echo "package: $*" >&2; exit 1; }
[ "$(id -u)" -eq 0 ] || fail "a fresh Debian can only be made by root"
command -v debootstrap >/dev/null || fail "debootstrap is missing: apt-get install debootstrap"

cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr \
    -DSLUICE_TESTS=OFF -DSLUICE_BENCH=OFF >/dev/null
cmake --build "$build"
rm -f "$build"/*.deb
(cd "$build" && cpack >cpack.log 2>&1) || { cat "$build/cpack.log"; fail "cpack failed"; }
for deb in "$build"/*.deb; do
    echo "== $(basename "$deb"): $(dpkg-deb -f "$deb" Installed-Size) kB, depends on $(dpkg-deb -f "$deb" Depends)"
done
# Suppressed: what only uploads to Debian need, and the call of ldconfig that CPack writes beside the trigger.
if command -v lintian >/dev/null; then
    lintian --allow-root --fail-on error,warning --suppress-tags-from-file "$root/engine/install/lintian-tags" "$build"/*.deb ||
        fail "lintian found something"
fi

fresh=$(mktemp -d)
chmod 755 "$fresh"
leave() { umount "$fresh/proc" 2>/dev/null || true; rm -rf --one-file-system "$fresh"; }
trap leave EXIT
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Codename: bookworm' | head -n 1)
debootstrap --variant=minbase bookworm "$fresh" "${mirror:-http://deb.debian.org/debian}" >"$build/debootstrap.log" ||
    { tail "$build/debootstrap.log"; fail "no fresh Debian"; }
cp /etc/resolv.conf "$fresh/etc/" 2>/dev/null || true
mount -t proc proc "$fresh/proc" 2>/dev/null || echo "package: goes on without /proc"
mkdir "$fresh/try"
cp "$build"/*.deb "$root"/tests/consumer/* "$fresh/try/"
inside() { chroot "$fresh" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root DEBIAN_FRONTEND=noninteractive sh -euc "$1"; }

# First the program and the module with what they depend on, and nothing else.
inside 'apt-get update -qq; cd /try
    apt-get install -y -qq --no-install-recommends ./sluice_*.deb ./python3-sluice_*.deb >/dev/null 2>&1 || apt-get install -y ./sluice_*.deb ./python3-sluice_*.deb'
inside 'cd /try; sluice --version; sluice check dam.toml >/dev/null
    sluice run dam.toml -o results --until 0.05 2>/dev/null | tail -n 3
    test -s results/frames/frame_0002.hdf; sluice view results >/dev/null; sluice render results --video none >/dev/null
    test -s /usr/share/sluice/summary.schema.json; test -s /usr/share/sluice/profile.schema.json
    python3 -c "
import sluice
s = sluice.Simulation(\"dam.toml\"); s.step(10)
print(\"python: \", s.fluid.count, \"particles, t =\", s.time, \"front at\", s.fluid[\"position\"][0].max())"' ||
    fail "the installed packages do not work"

# Then a program against the library, built without any other of its libraries' headers.
inside 'cd /try
    apt-get install -y -qq --no-install-recommends ./libsluice*.deb g++ make cmake >/dev/null 2>&1
    cmake -B build >/dev/null && cmake --build build >/dev/null && build/consumer dam.toml' ||
    fail "a program cannot be built against the library"
inside 'apt-get remove -y -qq sluice python3-sluice "libsluice*" >/dev/null 2>&1; find / -xdev -name "*sluice*" -not -path "/try/*" -not -path "/var/*" -not -path "/proc/*"' >"$build/left.log"
[ ! -s "$build/left.log" ] || { cat "$build/left.log"; fail "files are left after removal"; }
echo "package: all tried in a fresh Debian"
