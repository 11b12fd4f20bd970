#!/usr/bin/env bash
# Every link of a README leads to a file, and every source, script and case that it names in backquotes is the end of
# some file's path.
set -euo pipefail
cd "$DELABOLE_SOURCE"
failed=0
files=$(find . -path ./build -prune -o -path ./results -prune -o -type f -print)
readmes=$(grep '/README\.md$' <<<"$files")

complain() {
    echo "$1: there is no $2"
    failed=1
}

for readme in $readmes; do
    while read -r link; do
        [[ -e ${readme%/*}/$link ]] || complain "$readme" "$link"
    done < <(grep -oE '\]\([^)]+\)' "$readme" | sed 's/^](//; s/)$//' | grep -v '^https*:')
    while read -r name; do
        grep -q -- "/${name//./\\.}$" <<<"$files" || complain "$readme" "$name"
    done < <(grep -oE '`[A-Za-z0-9_./-]+\.(cpp|hpp|sh|py)`|`[A-Za-z0-9_.-]+/[A-Za-z0-9_./-]+\.toml`' "$readme" | tr -d '`' | sort -u)
done
[[ -n $readmes ]] || complain "$PWD" "README.md"
exit "$failed"
