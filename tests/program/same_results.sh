#!/usr/bin/env bash
# Tests whether two programs give every case the same results, to the bit: for changes that must keep them.
# Usage: same_results.sh OLD NEW [CASE...], from the root of the sources; the cases are all below cases/ but those of the
# thesis, which take an hour. Names the results that differ; the exit code is 1 if there are any.
set -uo pipefail
old=$1 new=$2
shift 2
if [ $# -eq 0 ]; then
    mapfile -t cases < <(find cases -name '*.toml' -not -path 'cases/thesis/*' | sort)
    set -- "${cases[@]}"
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

results() { # program case: what it says on paper and how it ends, without what tells the two programs apart
    rm -rf "$work/out"
    "$1" run "$2" --no-report --quiet --out "$work/out" >"$work/said" 2>&1
    echo "exit code $?" >>"$work/said"
    find "$work/out" -type f -not -name result.json -not -path '*/frames/*' | sort | xargs -r cat
    sed '/^  "provenance"/,$d' "$work/out/result.json" 2>/dev/null
    cat "$work/said"
}

differ=0
for case in "$@"; do
    results "$old" "$case" >"$work/old"
    results "$new" "$case" >"$work/new"
    if ! cmp -s "$work/old" "$work/new"; then
        echo "$case differs:"
        diff "$work/old" "$work/new" | head -n 10
        differ=$((differ + 1))
    fi
done
echo "$differ of $# differ"
[ "$differ" -eq 0 ]
