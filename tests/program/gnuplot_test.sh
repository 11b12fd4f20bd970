#!/usr/bin/env bash
# A missing figure does not end an analysis: without gnuplot, or if it fails, results and report are written, the report
# says which figures are missing and why, a warning on standard error says so, too, and the exit code is 0.
source "$(dirname "${BASH_SOURCE[0]}")/harness.sh"

write_good_case good.toml
write_good_fit good_fit.toml
mkdir none failing silent crashing
printf '#!/bin/sh\necho "line 0: cannot open the terminal" >&2\nexit 1\n' >failing/gnuplot
printf '#!/bin/sh\nexit 0\n' >silent/gnuplot
printf '#!/bin/sh\nkill -KILL $$\n' >crashing/gnuplot
chmod +x ./*/gnuplot
echo "not a program" >none/gnuplot

# without WHAT PATH REASON
without() {
    local arguments scripts warnings
    title "$1"
    for arguments in "run good.toml" "fit good_fit.toml" "reproduce fig2.8"; do
        rm -rf results
        # shellcheck disable=SC2086
        run env PATH="$2" "$program" $arguments --out results
        expect_status 0
        expect "results on standard output" test -s "$scratch/out"
        scripts=$(find results/figures -name '*.gp' | wc -l)
        expect "scripts are there" test "$scripts" -ge 1
        warnings=$(grep -c '^warning: figure .* was not drawn: ' "$scratch/err" || true)
        expect "a warning for each of $scripts figures, not $warnings" test "$warnings" == "$scripts"
        expect_error "$3"
        expect "no picture" test -z "$(find results/figures -name '*.svg' -o -name '*.png')"
        expect "the report is whole" contains results/report.html '</html>'
        expect "the report says why" contains results/report.html "${3%%:*}"
        expect "result.json is JSON" is_json results/result.json
        expect_no_leftovers results
        local script
        for script in results/figures/*.gp; do
            expect "the report names $(basename "$script")" contains results/report.html "$(basename "$script")"
        done
    done
    run env PATH="$2" "$program" run good.toml --out results --quiet
    expect_status 0
    expect_silence out
    expect_error "$3"
}

without "gnuplot is not installed" "$work/none" 'gnuplot is not installed'
without "gnuplot fails" "$work/failing" 'exit code 1'
expect "its last words are passed on" contains results/report.html 'cannot open the terminal'
without "gnuplot says nothing and draws nothing" "$work/silent:/usr/bin:/bin" 'gnuplot left an empty or incomplete picture'
without "gnuplot is killed" "$work/crashing:/usr/bin:/bin" 'stopped by signal 9'

title "pictures of an earlier run do not stay beside a script they do not belong to"
delabole run good.toml --out results --quiet
expect_status 0
expect "drawn" test -s results/figures/section.svg
run env PATH="$work/none" "$program" run good.toml --out results
expect_status 0
expect "no picture" test -z "$(find results/figures -name '*.svg' -o -name '*.png')"

title "PATH is not set at all"
run env -u PATH "$program" run good.toml --out results
expect_status 0
expect_complete_results results

finish
