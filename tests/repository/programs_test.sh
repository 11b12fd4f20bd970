#!/usr/bin/env bash
# No program looks for shared libraries in the folder from which it is called: every element of every run path, of what is
# built and of what is installed, is an absolute folder. The program itself and the Python module, built as Release, are
# hardened: see the options in CMakeLists.txt.
set -euo pipefail
export LC_ALL=C
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# What readelf -d says of a run path, e.g. "Library runpath: [/usr/lib/openmpi:]", on standard input; prints its elements
# that are empty or relative. $ORIGIN is the folder of the program itself.
unsafe_elements() {
    sed -nE 's/.*\((RPATH|RUNPATH)\).*\[(.*)\]$/\2/p' | while IFS= read -r path; do
        while IFS= read -r -d : element; do
            [[ $element == /* || $element == '$ORIGIN' || $element == '$ORIGIN/'* ]] || printf '"%s"\n' "$element"
        done <<<"$path:"
    done
}

failed=0
line=' 0x000000000000001d (RUNPATH)            Library runpath: '
for path in '[/usr/lib/openmpi:]' '[:/usr/lib]' '[/a::/b]' '[]' '[.]' '[lib:/a]' '[$ORIGINAL]'; do
    if [[ -z $(unsafe_elements <<<"$line$path") ]]; then
        echo "not noticed: $path"
        failed=1
    fi
done
for path in '[/usr/lib/openmpi]' '[/a:/b]' '[$ORIGIN/../lib:/a]'; do
    if [[ -n $(unsafe_elements <<<"$line$path") ]]; then
        echo "refused without a reason: $path"
        failed=1
    fi
done

for component in program python; do
    cmake --install "$DELABOLE_BUILD" --component "$component" --prefix "$work/prefix" >"$work/install.log"
done
programs=0
while IFS= read -r -d '' program; do
    readelf -d "$program" >"$work/dynamic" 2>/dev/null || continue  # not a program of the linker: a script, a list
    programs=$((programs + 1))
    unsafe=$(unsafe_elements <"$work/dynamic")
    if [[ -n $unsafe ]]; then
        echo "$program: its run path has the element" $unsafe
        failed=1
    fi
done < <(find "$DELABOLE_BUILD" "$work/prefix" -name CMakeFiles -prune -o -type f '(' -executable -o -name '*.so' ')' -print0)
if grep -q '^CMAKE_BUILD_TYPE:[A-Z]*=Release$' "$DELABOLE_BUILD/CMakeCache.txt"; then
    for program in "$DELABOLE_BUILD/bin/delabole" "$DELABOLE_BUILD"/python/delabole/_delabole*.so; do
        [[ -e $program ]] || continue  # there is no module without Python
        { readelf -hldW "$program" && readelf -W --dyn-syms "$program"; } >"$work/headers"
        for mark in 'Type: +DYN' 'GNU_RELRO' '\(FLAGS\).*BIND_NOW|\(FLAGS_1\).*NOW' \
            __stack_chk_fail '[a-z]_chk@GLIBC' __glibcxx_assert_fail; do
            if ! grep -qE "$mark" "$work/headers"; then
                echo "$(basename "$program"): its headers and symbols lack $mark"
                failed=1
            fi
        done
    done
fi
if [[ $programs -lt 2 ]]; then
    echo "found no programs, built and installed"
    failed=1
fi
echo "$programs programs"
exit "$failed"
