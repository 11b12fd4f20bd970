#!/usr/bin/env bash
# Exit codes 0, 1 and 2: success, a mismatch, and command lines that cannot be understood. Codes 3 to 5 have tests of
# their own.
source "$(dirname "${BASH_SOURCE[0]}")/harness.sh"

write_good_case good.toml
write_good_fit good_fit.toml

misused() {
    title "delabole $*"
    delabole "$@"
    expect_status 2
    expect_silence out
    expect "a message" test -s "$scratch/err"
    expect "a short message" test "$(wc -l <"$scratch/err")" -le 3
    expect "nothing is written" test "$(ls)" == $'good.toml\ngood_fit.toml'
}

title "nothing wrong"
for arguments in --version --help --bash-completion --manual-page "check good.toml" "show good.toml" "init plane_failure" "init plane_failure --full" "init jointed_slope --full" "init support --full" "inputs plane_failure" "outputs good.toml" "run --help"; do
    # shellcheck disable=SC2086
    delabole $arguments
    expect_status 0
    expect_silence err
    expect "something on standard output" test -s "$scratch/out"
done

misused
expect_error 'To begin: delabole init plane_failure'
misused rnu good.toml
expect_error "no command is named 'rnu' (did you mean run?)"
misused inputs
misused inputs plane_falure
expect_error 'did you mean plane_failure?'
misused outputs nothing
misused --colour
misused run
misused fit
misused trade
misused check
misused show
misused init
misused run good.toml --colour
misused run good.toml --out
misused fit good_fit.toml --threads 0
misused fit good_fit.toml --threads many
misused fit good_fit.toml --seed -1
misused fit good_fit.toml --seed 1.5
misused fit good_fit.toml --seed 99999999999999999999999
misused fit good_fit.toml good_fit.toml
misused trade good.toml --seed 1
misused trade good.toml --threads 0
misused run good.toml --threads 0
misused run good.toml --checkpoint-every -1
expect_error 'Value -1 not in range 0.000000 to 86400.000000'
misused run good.toml --seed 1
misused init plane_falure
expect_error 'did you mean plane_failure?'
misused init slope --out slope.toml
expect_error 'the names are plane_failure, '
misused reproduce fig2.9
expect_error 'did you mean fig2.8?'
misused reproduce everything
expect_error 'chapter2'

title "verify: 0 where all agree, 1 where one does not, with every row shown"
delabole verify "$source_folder/cases/plane_failure"
expect_status 0
expect_output ' 0 missed'
{ cat good.toml; printf '\n[[expect]]\nquantity = "crack_depth"\nvalue = "4.348 m"\ntolerance = "1 mm"\n'; } >met.toml
{ cat met.toml; printf '\n[[expect]]\nquantity = "factor_of_safety"\nvalue = 9\ntolerance = 0.1\n'; } >missed.toml
delabole verify met.toml
expect_status 0
expect_output '1 met, 0 missed'
delabole verify met.toml missed.toml
expect_status 1
expect_output '2 met, 1 missed'
expect "the row says so" grep -q '0.1 *missed$' "$scratch/out"
delabole verify --quiet missed.toml
expect_status 1
expect_silence out
delabole verify --json missed.toml
expect_status 1
expect_output '"verdict": "missed"'
cp "$scratch/out" verify.json
expect "JSON only" is_json verify.json
delabole verify met.toml --set slope.height='13 m'
expect_status 1

title "an expectation of an impossibility"
{
    sed '/^water_depth/s/3/5/' good.toml
    printf '\n[[expect]]\nquantity = "check"\nvalue = "water_above_crack"\n'
} >impossible.toml
delabole verify impossible.toml
expect_status 0

title "verify: nothing to compare is not a success; a missing file is one message"
delabole verify good.toml
expect_status 3
expect_error 'there is nothing to compare'
delabole verify nonexistent
expect_status 3
expect_error 'nonexistent: there is no such file'
expect_one_line_of_error

finish
