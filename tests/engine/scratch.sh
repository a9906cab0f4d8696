# To be sourced by tests that are shell scripts: goes into a folder of its own, and counts what fails.
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

# A failure is told and counted.
fail() {
    echo "FAILED: $*"
    failures=$((failures + 1))
}
