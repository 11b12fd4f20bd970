#!/usr/bin/env bash
# delabole fit with [fit.posterior]: the results that it writes, the same bytes for any number of threads, and the
# warnings about priors, parameters and draws from which no answer can follow.
source "$(dirname "${BASH_SOURCE[0]}")/harness.sh"

write_good_fit good_fit.toml
sed '/^seed/a \
\
[fit.posterior]\
draws = 800\
evidence_points = 64' good_fit.toml >study.toml

line_of() {
    grep -n -m 1 -e "$1" "$scratch/out" | cut -d: -f1
}

title "results"
delabole fit study.toml --out one
expect_status 0
expect_output 'What the data determine'
expect_output 'posterior'
expect_output 'Evidence'
expect "the verdict stands before the intervals" test "$(line_of 'What the data determine')" -lt "$(line_of 'R-hat')"
expect_output 'More parameters than data: 2 free parameters, 1 datum'
expect_complete_results one
for table in plane_failure_draws evidence; do
    expect "$table.csv is there" test -s "one/$table.csv"
done
for figure in evidence chain_agreement plane_failure_posterior plane_failure_sampling; do
    expect "$figure.png is there" test -s "one/figures/$figure.png"
done
expect "effective sizes are recorded" contains one/result.json '"effective_size_tails"'

title "two threads, another seed, the resolved case"
delabole fit study.toml --out two --threads 2 --quiet
for table in plane_failure_draws evidence; do
    expect "$table.csv is the same on two threads" cmp "one/$table.csv" "two/$table.csv"
done
delabole fit study.toml --out three --seed 8 --quiet
expect "other draws by another seed" refuse cmp -s one/plane_failure_draws.csv three/plane_failure_draws.csv
delabole fit one/resolved.toml --out four --quiet
expect "the same draws from the resolved case" cmp one/plane_failure_draws.csv four/plane_failure_draws.csv

title "without the section"
delabole fit good_fit.toml --out plain --quiet
expect "no draws" refuse test -e plain/plane_failure_draws.csv

title "priors that exclude what was observed"
sed 's/^value = 1$/value = 30/' study.toml >excluded.toml
delabole fit excluded.toml --out excluded
expect_output 'The priors exclude what was observed'
expect_output '"it failed"'

title "a parameter that nothing depends on"
sed 's/name = "water.water_depth"/name = "slope.toe_elevation"/' study.toml >idle.toml
delabole fit idle.toml --out idle
expect_output 'Nothing observed depends on slope.toe_elevation'

title "draws that all fail"
sed 's/^lower = "0 m"/lower = "6 m"/; s/^upper = "4 m"/upper = "9 m"/' study.toml >hopeless.toml
delabole fit hopeless.toml --out hopeless
expect_status 4
expect_output 'No draw of the priors has an answer: water_above_crack'
expect_complete_results hopeless
expect "the status says so" test "$(json_value hopeless/result.json status)" == '"no_valid_point"'

title "chains that are too short to agree"
sed 's/^draws = 800/draws = 64\nevaluations_per_chain = 8/' study.toml >short.toml
delabole fit short.toml --out short
expect_status 4
expect_error 'fit.posterior.evaluations_per_chain sets the limit'
expect_output 'The chains did not converge'
expect_complete_results short
expect "the status says so" test "$(json_value short/result.json status)" == '"posterior_not_converged"'

title "a prior with nothing between the bounds"
sed '/^upper = "4 m"/a prior = { mean = "3.9 km", standard_deviation = "1 m" }' study.toml >far.toml
delabole fit far.toml --out far
expect_status 3
expect_error 'water.water_depth: prior: '
expect "no result folder" refuse test -e far

finish
