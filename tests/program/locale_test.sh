#!/usr/bin/env bash
# In a locale with decimal commas, cases are read and results written as in any other: numbers in input, output,
# gnuplot's scripts and pictures have decimal points.
source "$(dirname "${BASH_SOURCE[0]}")/harness.sh"

mkdir "$scratch/locales"
localedef --inputfile=de_DE --charmap=UTF-8 "$scratch/locales/de_DE.UTF-8"
german=(env LOCPATH="$scratch/locales" LC_ALL=de_DE.UTF-8)

title "the language is there: printf writes a decimal comma"
expect "1,5" test "$("${german[@]}" /usr/bin/printf '%.1f' 1,5)" == 1,5

write_good_case good.toml
for arguments in "run good.toml" "sensitivity $source_folder/cases/plane_failure/sau_mau_ping_probability.toml"; do
    title "$arguments"
    # shellcheck disable=SC2086
    delabole $arguments --out english
    expect_status 0
    # shellcheck disable=SC2086
    run "${german[@]}" "$program" $arguments --out german
    expect_status 0
    for file in english/*.csv english/resolved.toml english/figures/*; do
        expect "${file#english/} is the same" cmp -s "$file" "german/${file#english/}"
    done
    expect "the same numbers in result.json" \
        cmp -s <(grep -v _seconds english/result.json) <(grep -v _seconds german/result.json)
    rm -r english german
done

title "a comma in a case is refused as everywhere"
sed 's/"12 m"/"12,5 m"/' good.toml >comma.toml
expect "there is a comma" contains comma.toml '12,5 m'
run "${german[@]}" "$program" check comma.toml
expect_status 3

finish
