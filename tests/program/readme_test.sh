#!/usr/bin/env bash
# Usage: readme_test.sh README, from the root of the sources
# Commands in a README work and print what the README shows. Every fenced block of language sh is run by bash -eu, one
# after the other, in a copy of the sources with an own home folder and the built program on PATH; a block of language
# text directly after it is the expected output. Pictures drawn by the commands must equal those in the sources. The
# block with cases/run and tests/run is left out, since .ci/run runs both; so are mpirun if the program was built without
# MPI, and Python if its module was not built.
set -euo pipefail
readme=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

mkdir "$work/home" "$work/delabole"
tar -C "$DELABOLE_SOURCE" --exclude=./build --exclude=./results --exclude=./.git -cf - . | tar -C "$work/delabole" -xf -
# The READMEs refer to build/release, whatever the preset of this test.
mkdir "$work/delabole/build"
ln -s "$DELABOLE_BUILD" "$work/delabole/build/release"

awk -v folder="$work" '
    !inside && /^```sh$/ { inside = 1; file = sprintf("%s/block_%02d.sh", folder, ++count); blank = 0; next }
    !inside && /^```text$/ && file != "" { inside = 1; file = sprintf("%s/block_%02d.out", folder, count); next }
    inside && /^```$/ { inside = 0; close(file); next }
    inside { print > file }
    !inside && NF { file = "" }
' "$work/delabole/$readme"

# Commands under mpirun may have more ranks than there are processors, and may run as root.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none

# Cases written out in a README must be valid.
awk -v folder="$work" '
    !inside && /^```toml$/ { inside = 1; file = sprintf("%s/case_%02d.toml", folder, ++count); next }
    inside && /^```$/ { inside = 0; close(file); next }
    inside { print > file }
' "$work/delabole/$readme"
failed=0
for written in "$work"/case_*.toml; do
    if [[ -f $written ]] && grep -q '^schema = 1' "$written" && ! "$DELABOLE_BUILD/bin/delabole" verify "$written"; then
        echo "$readme shows a case that is not right"
        failed=1
    fi
done

# Estimates from random draws depend on the last bits of the processor's own functions. Therefore numbers on lines with
# an error (+-) may differ by 5 %, which is several of those errors, and columns may be wider.
alike() {
    awk 'function differ(one, other) {
            return one != other && !(one ~ /^[-0-9.]+$/ && other ~ /^[-0-9.]+$/ &&
                                     (one - other) ^ 2 <= (0.05 * one) ^ 2)
         }
         FNR == NR { shown[FNR] = $0; lines = FNR; next }
         {
             fields = split(shown[FNR], word)
             if (fields != NF) { exit bad = 1 }
             for (field = 1; field <= NF; ++field) {
                 if (/\+-/ ? differ(word[field], $field) : word[field] != $field) { exit bad = 1 }
             }
         }
         END { exit bad || FNR != lines }' "$1" "$2"
}

run=0
for block in "$work"/block_*.sh; do
    if grep -qE '(^|/| )(cases|tests)/run( |$)' "$block"; then
        continue
    fi
    if grep -q '^mpirun ' "$block" && [[ $DELABOLE_WITH_MPI != ON && $DELABOLE_WITH_MPI != TRUE ]]; then
        continue
    fi
    if grep -q 'python3' "$block" && [[ ! -d $DELABOLE_BUILD/python/delabole ]]; then
        continue
    fi
    echo "--- $readme:"
    cat "$block"
    echo "---"
    (cd "$work/delabole" && HOME=$work/home PATH=$DELABOLE_BUILD/bin:$PATH bash -eu "$block" </dev/null | tee "$work/printed")
    if [[ -f ${block%.sh}.out ]] && ! diff "${block%.sh}.out" "$work/printed" &&
        ! { grep -qF -- '+-' "$work/printed" && alike "${block%.sh}.out" "$work/printed"; }; then
        echo "$readme does not show what this prints: <, what it shows, >, what it should"
        failed=1
    fi
    run=$((run + 1))
done
if [[ $run == 0 ]]; then
    echo "$readme has no command to run: has the mark of its blocks changed?"
    failed=1
fi

for picture in "$DELABOLE_SOURCE"/plots/pictures/*; do
    if ! cmp "$picture" "$work/delabole/plots/pictures/${picture##*/}"; then
        echo "plots/pictures/${picture##*/} is not what plots/README.md draws"
        failed=1
    fi
done

# What is in the prose of a README with a section "Measured once" but neither there, nor in the case files beside it, nor
# in what its commands print, where a number may have more digits.
strange_numbers() {
    awk 'function scan(text, list, rounded,   word, count, place, unit) {
            gsub(/`[^`]*`/, "", text)
            count = split(text, word, /[.]?[^A-Za-z0-9.%\/]+|[.]$/)
            for (place = 1; place <= count; ++place) {
                unit = word[place + 1] ~ /^(m2?|deg|%|ft|s|minutes|kPa|[kM]N\/m[23])$/ ? word[place + 1] : ""
                if (word[place] ~ /^[0-9.]+(e[0-9]+)?$/) { list[word[place] " " unit] += rounded }
            }
        }
        function found(number, unit,   one, part, digits) {
            digits = index(number, ".") ? length(number) - index(number, ".") : 0
            for (one in known) {
                split(one, part, " ")
                if ((part[1] == number || (known[one] && sprintf("%." digits "f", part[1]) == number)) &&
                    (part[2] == unit || unit == "" || (known[one] && part[2] == ""))) { return 1 }
            }
        }
        FNR == 1 { pass += FILENAME ~ /md$/; once = 0 }
        /^```/ { block = block ? "" : substr($0, 4); next }
        /^## / { once = /Measured once/ }
        pass == 1 && (FILENAME ~ /toml$/ || once || block == "text") { scan($0, known, block == "text") }
        pass == 2 && !block && !once {
            split("", prose)
            scan($0, prose, 0)
            for (one in prose) { split(one, part, " "); if (!found(part[1], part[2])) { print FNR ": " one } }
        }' "$1" "${1%/*}"/*.toml "$1"
}
if grep -q '^## Measured once$' "$DELABOLE_SOURCE/$readme"; then
    strange=$(strange_numbers "$DELABOLE_SOURCE/$readme")
    if [[ -n $strange ]]; then
        printf '%s has these numbers in its prose (line: number), which nothing says:\n%s\n' "$readme" "$strange"
        failed=1
    fi
fi
exit "$failed"
