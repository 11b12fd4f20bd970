#!/usr/bin/env bash
# Exit code 4: a back-analysis that did not find what it searched for reports this on standard error, in result.json and
# in the report, and still writes its results. (interrupt_test.sh tests that an interrupt has code 4, too.)
source "$(dirname "${BASH_SOURCE[0]}")/harness.sh"

write_good_fit good_fit.toml

not_converged() {
    local what=$1 word=$2 message=$3
    shift 3
    title "$what"
    delabole "$@" --out results
    expect_status 4
    expect_error "delabole: not converged: $message"
    expect_one_line_of_error
    expect_complete_results results
    expect "in result.json" test "$(json_value results/result.json status)" == "\"$word\""
    expect "in the report" contains results/report.html 'Not converged'
    rm -rf results
}

not_converged "too few evaluations" evaluation_limit "the best search of a mechanism ended at its limit" \
    fit good_fit.toml --set fit.starts=1 --set fit.evaluations_per_start=10

# The plane is steeper than the face for every value of the parameters.
sed 's/^name = "water.water_depth"/name = "failure_plane.dip"/;s/^lower = "0 m"/lower = "61 deg"/;s/^upper = "4 m"/upper = "80 deg"/' \
    good_fit.toml >impossible_fit.toml
not_converged "no valid point" no_valid_point "a mechanism has no valid geometry" fit impossible_fit.toml

# The block stands at every tilt that is tried.
not_converged "a search that finds nothing" nothing_to_compare "no setting has both an answer" \
    trade "$source_folder/cases/relaxation/single_block.toml" --set critical.upper='12 deg' \
    --set critical.tolerance='1 deg' --quiet

title "the same with enough"
delabole fit good_fit.toml --out results
expect_status 0
expect_silence err

title "a run of blocks that neither rest nor fail in the time they have"
delabole init relaxation --full --out blocks.toml
printf '\n[settings]\nduration = "0.01 s"\n' >>blocks.toml
delabole run blocks.toml --set scene.tilt="35 deg" --out undecided
expect_status 4
expect_error 'delabole: not converged: the blocks neither came to rest nor failed within 0.01 s: raise settings.duration'
expect_one_line_of_error
expect_complete_results undecided
expect "in result.json" test "$(json_value undecided/result.json status)" == '"undecided"'
expect "in the report" contains undecided/report.html 'Not converged'

finish
