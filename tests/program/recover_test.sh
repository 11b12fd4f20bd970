#!/usr/bin/env bash
# delabole recover: Delabole's mechanisms recover known parameters, with the same bytes for any number of threads; the
# report of the fit shows the expected information of further measurements.
source "$(dirname "${BASH_SOURCE[0]}")/harness.sh"

sliding() {
    # The case with only its first mechanism, and an observed profile.
    awk '/^\[\[fit.mechanism\]\]/ { if (++count == 2) exit } { print }' "$source_folder/cases/delabole_1967/given_surface.toml"
    cat <<'END'
[fit.profile]
points = [["0 ft", "0 ft"], ["81.8482 ft", "75 ft"], ["129.1446 ft", "225 ft"]]
standard_deviation = "3 m"
source = "as in delabole_1967.toml"
END
}
sliding >sliding.toml

title "the mechanism of sliding, truths drawn from the prior"
delabole recover sliding.toml --repetitions 60 --threads 2 --out prior
expect_status 0
expect_complete_results prior
expect_output 'structural_sliding, strength.friction_angle'
for file in coverage.csv repetitions_structural_sliding.csv figures/coverage_structural_sliding.svg \
    figures/ranks_structural_sliding_1.svg figures/ranks_structural_sliding_2.svg; do
    expect "$file is there" test -s "prior/$file"
done
# Shares of 60 repetitions within 3.3 binomial standard errors (0.060 and 0.028): a correct sampler misses this once in
# a thousand times.
while IFS=, read -r _ parameter _ share_68 _ _ share_95 _ _ _ _ _ uniformity; do
    expect "$parameter: 68 %" awk "BEGIN { exit !($share_68 > 0.683 - 0.198 && $share_68 < 0.683 + 0.198) }"
    expect "$parameter: 95 %" awk "BEGIN { exit !($share_95 > 0.95 - 0.093) }"
    expect "$parameter: ranks" awk "BEGIN { exit !($uniformity > 0.001) }"
done < <(tail -n +2 prior/coverage.csv)
expect "both parameters" test "$(wc -l <prior/coverage.csv)" == 3
expect "the profile is said to be left out" contains prior/report.html 'the observed profile is left out'

title "one thread, fewer repetitions: the same first ones"
delabole recover sliding.toml --repetitions 5 --out few --quiet
expect_status 0
expect "the same" cmp few/repetitions_structural_sliding.csv <(head -n 6 prior/repetitions_structural_sliding.csv)

title "costly mechanisms are never recovered, and named"
delabole recover "$source_folder/cases/delabole_1967/delabole_1967.toml" --repetitions 2 --no-report --threads 2 --out without_costly
expect_output 'Left out: jointed_slope and jointed_slope_above_fault. Every prediction is a run of dynamic relaxation'
expect "so does the result" contains without_costly/result.json '"left_out"'

title "data made from the best fit"
delabole recover sliding.toml --repetitions 5 --at-best --out best --json
expect_status 0
expect_output '"at": "best"'
expect "one truth" test "$(tail -n +2 best/repetitions_structural_sliding.csv | cut -d, -f2 | sort -u | wc -l)" == 1

title "nothing to recover"
write_good_case good.toml
delabole recover good.toml
expect_status 3
expect_error 'the case has no [fit] section; delabole init fit shows one'
delabole recover sliding.toml --repetitions 0
expect_status 2

title "Ctrl-C"
setsid "$program" recover sliding.toml --repetitions 100000 --out stopped >"$scratch/out" 2>"$scratch/err" </dev/null &
child=$!
sleep 3
kill -s INT -- "-$child" || true
status=0
wait "$child" || status=$?
expect_status 4
expect_error 'delabole: interrupted: '
expect_complete_results stopped

title "what to measure next, with a fit"
# With the face held, nearly, which mechanism is first follows the priors.
delabole fit "$source_folder/cases/delabole_1967/delabole_1967.toml" --out fitted "${quick_fit[@]}" \
    --set 'fit.mechanism[1].parameter[6].prior.standard_deviation=0.05 deg' \
    --set 'fit.mechanism[2].parameter[4].prior.standard_deviation=0.05 deg' \
    --set 'fit.mechanism[3].parameter[4].prior.standard_deviation=0.05 deg'
expect "the first sentence of the report says that the ranking follows the priors" \
    grep -qE '<p>Which of the 3 compared explains best depends on what was put in: stepped_toppling as given, with a probability of [0-9]+ %, critical_sliding with flat priors' fitted/report.html
expect_output 'what to measure next'
expect_output 'piezometers behind the face'
expect "table" test -s fitted/value_of_information.csv
expect "figure" test -s fitted/figures/value_of_information.svg
# A parameter that is measured directly has the greatest reduction: the water level by a piezometer, the spacing by a
# survey.
reduction() {
    awk -F, -v candidate="$1" -v parameter="$2" '$1 == candidate && $2 == "all" && $4 == parameter { print $5 }' \
        fitted/value_of_information.csv
}
expect "piezometers tell of the water" awk "BEGIN { exit !($(reduction 'piezometers behind the face' water.water_elevation) > 0.3) }"
expect "a survey tells of the spacing" awk "BEGIN { exit !($(reduction 'survey of joint set B at the crest' columns.spacing) > 0.1) }"

finish
