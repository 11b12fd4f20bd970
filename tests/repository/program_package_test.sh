#!/usr/bin/env bash
# Tests the program as its user gets it: installed below a prefix and as a Debian package unpacked in an empty root,
# with its completion for bash and its manual page, and with all its libraries among the packages it depends on.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

failures=0
expect() { # what command...
    local what=$1
    shift
    if ! "$@"; then
        echo "FAILED: $what"
        failures=$((failures + 1))
    fi
}

cmake --install "$DELABOLE_BUILD" --component program --prefix "$work/prefix" >install.log
cpack --config "$DELABOLE_BUILD/CPackConfig.cmake" -B package >cpack.log
package=$(echo package/delabole_*.deb)
mkdir root
dpkg-deb -x "$package" root

for place in prefix root/usr; do
    echo "- $place"
    program=$work/$place/bin/delabole
    # The environment is empty, so that nothing of the build folder helps.
    expect "it says its version" env -i "$program" --version
    expect "it writes a case" env -i "$program" init wedge --out "$place.toml"
    expect "it analyses it" env -i "$program" run "$place.toml" --no-report --out "$work/result" >/dev/null
    expect "a licence" test -s "$place/share/doc/delabole/copyright"

    expect "the manual page is clean" test -z "$(groff -man -Tutf8 -ww -z "$place/share/man/man1/delabole.1" 2>&1)"
    groff -man -Tascii -P-cbou "$place/share/man/man1/delabole.1" >page.txt
    for phrase in 'delabole run CASE' 'delabole init NAME' 'Exit codes: 0 ok' '\-\-threads'; do
        expect "the manual page has '$phrase'" grep -qe "$phrase" page.txt
    done

    completion=$place/share/bash-completion/completions/delabole
    # shellcheck disable=SC2016
    completed() { # words of the command line, the last to be completed
        env -i bash --norc -c 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _delabole; echo "${COMPREPLY[*]}"' \
            bash "$completion" "$@"
    }
    touch here.toml there.csv
    expect "commands" test "$(completed delabole sens)" == sensitivity
    expect "options" test "$(completed delabole run --no-)" == --no-report
    expect "words" test "$(completed delabole init wed)" == wedge
    expect "words beside files" test "$(completed delabole inputs kinem)" == kinematics
    expect "case files" test "$(completed delabole run he)" == here.toml
    expect "no other files" test -z "$(completed delabole run there)"
    expect "no case files where none is read" test -z "$(completed delabole reproduce he)"
    expect "folders" test "$(completed delabole run here.toml --out packa)" == package
done

for file in root/usr/include root/usr/lib; do
    expect "the package holds the program alone, not $file" test ! -e "$file"
done
depends=$(dpkg-deb -f "$package" Depends)
while read -r library; do
    owner=$(dpkg -S "$(readlink -f "$library")" 2>/dev/null || dpkg -S "$library")
    owner=${owner%%:*}
    expect "$library comes with what the package depends on: $depends" grep -qw -- "$owner" <<<"$depends"
done < <(objdump -p root/usr/bin/delabole | awk '/NEEDED/ { print $2 }' | sort -u |
    while read -r name; do ldd root/usr/bin/delabole | awk -v name="$name" '$1 == name && $3 { print $3 }'; done)

exit "$((failures > 0))"
