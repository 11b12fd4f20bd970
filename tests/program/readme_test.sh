#!/usr/bin/env bash
# What the README tells a reader to type works: every fenced block of language sh is run by bash -eu, one after the
# other, in a copy of the sources with a home folder of its own and the built program on PATH. The block with cases/run
# and tests/run is left to .ci/run, which runs both.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

mkdir "$work/home" "$work/delabole"
tar -C "$DELABOLE_SOURCE" --exclude=./build --exclude=./results --exclude=./.git -cf - . | tar -C "$work/delabole" -xf -
# The README speaks of build/release, whatever preset this test belongs to.
mkdir "$work/delabole/build"
ln -s "$DELABOLE_BUILD" "$work/delabole/build/release"

awk -v folder="$work" '
    !inside && /^```sh$/ { inside = 1; file = sprintf("%s/block_%02d.sh", folder, ++count); next }
    inside && /^```$/ { inside = 0; close(file); next }
    inside { print > file }
' "$work/delabole/README.md"

run=0
for block in "$work"/block_*.sh; do
    if grep -qE '(^|/| )(cases|tests)/run( |$)' "$block"; then
        continue
    fi
    echo "--- README:"
    cat "$block"
    echo "---"
    (cd "$work/delabole" && HOME=$work/home PATH=$DELABOLE_BUILD/bin:$PATH bash -eu "$block" </dev/null)
    run=$((run + 1))
done
if [[ $run == 0 ]]; then
    echo "the README has no command to run: has the mark of its blocks changed?"
    exit 1
fi
