#!/usr/bin/env bash
# What reproduce writes, for the whole thesis and for one part: complete results with figures, and printed values beside
# computed ones.
source "$(dirname "${BASH_SOURCE[0]}")/harness.sh"

expect_complete_results_of_reproduce() {
    expect_status 0
    expect "report" contains "$1/report.html" '</html>'
    expect "result.json is JSON" is_json "$1/result.json"
    expect_only_numbers "$1"
    expect_no_leftovers "$1"
    expect_result_is_newest "$1"
}

title "all of the thesis"
delabole reproduce
expect_complete_results_of_reproduce results/thesis
expect_figures results/thesis 4
expect "rows have their place in the thesis" contains "$scratch/out" '2.3.5, Fig 2.15'
expect "they fit a terminal of 120 columns" test "$(LC_ALL=C.UTF-8 wc -L <"$scratch/out")" -le 120
expect "they are counted, and what is left out is named" contains "$scratch/out" 'left out, because they take minutes: plates, '
expect "what is not met has its reason" refuse contains results/thesis/result.json '"statement NOT met"'
in_browser results/thesis

title "one part"
for what in fig2.8 tilting dry_friction table3.2 limiting_friction program_cal; do
    delabole reproduce "$what" --out "part_$what"
    expect_complete_results_of_reproduce "part_$what"
done
expect "printed beside computed" contains part_tilting/report.html 'half saturated'
expect "printed beside computed" contains part_limiting_friction/report.html '41.1415 deg'

finish
