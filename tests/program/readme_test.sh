#!/usr/bin/env bash
# What the README tells a reader to type works: every fenced block of language sh is run by bash -eu, one after the
# other, in a copy of the sources with a home folder of its own and the built program on PATH. The block with cases/run
# and tests/run is left to .ci/run, which runs both; mpirun is left out where the program was built without MPI.
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

# Commands under mpirun, with more ranks than processors and perhaps as root.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none

run=0
for block in "$work"/block_*.sh; do
    if grep -qE '(^|/| )(cases|tests)/run( |$)' "$block"; then
        continue
    fi
    if grep -q '^mpirun ' "$block" && [[ $DELABOLE_WITH_MPI != ON && $DELABOLE_WITH_MPI != TRUE ]]; then
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
