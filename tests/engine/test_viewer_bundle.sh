#!/bin/sh
# Builds the viewer's page anew from its sources and compares it with the one that is kept.
# Usage: test_viewer_bundle.sh PAGE_FOLDER WORK_FOLDER. Returns 77 (skipped) without npm or its packages.
page=$1
work=$2
if ! command -v npm >/dev/null || ! command -v node >/dev/null; then
    echo "skipped: no npm here (Debian: apt install npm)"
    exit 77
fi
mkdir -p "$work" && cd "$work" || exit 1
rm -rf src
cp -R "$page/src" "$page/package.json" "$page/package-lock.json" "$page/.npmrc" "$page/build.mjs" "$page/tsconfig.json" .
# What an earlier test has installed serves as long as the versions are the same.
if ! cmp -s package-lock.json node_modules/.lock; then
    if ! npm ci >npm.log 2>&1; then
        echo "skipped: npm cannot install the page's packages: $(grep -m 1 -i 'err' npm.log)"
        exit 77
    fi
    cp package-lock.json node_modules/.lock
fi
npm run --silent check || { echo "FAILED: the page's types do not fit"; exit 1; }
node build.mjs rebuilt.html || { echo "FAILED: the page cannot be built"; exit 1; }
if ! cmp rebuilt.html "$page/viewer.html"; then
    echo "FAILED: engine/view/page/viewer.html is not what its sources give; (cd engine/view/page && npm ci && npm run build)"
    exit 1
fi
echo "the page is what its sources give"
