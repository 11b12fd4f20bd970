#!/usr/bin/env bash
# delabole sensitivity: the results that it writes, the same bytes for any number of threads, messages with the place
# for wrong studies, and studies without an answer or interrupted, which are reported as such.
source "$(dirname "${BASH_SOURCE[0]}")/harness.sh"

write_good_case good.toml
{
    cat good.toml
    cat <<'CASE'

[sensitivity]
quantity = "factor_of_safety"
[sensitivity.failure]
limit = 1
[[sensitivity.parameter]]
name = "strength.cohesion"
distribution = "lognormal"
mean = "25 kPa"
standard_deviation = "8 kPa"
[[sensitivity.parameter]]
name = "strength.friction_angle"
distribution = "normal"
mean = "37 deg"
standard_deviation = "4 deg"
[[sensitivity.parameter]]
name = "water.water_depth"
distribution = "uniform"
lower = "0 m"
upper = "5 m"
[sensitivity.tornado]
[sensitivity.sweep]
[[sensitivity.sweep.quantity]]
name = "resisting_force"
[sensitivity.morris]
[sensitivity.sobol_indices]
samples = 256
[sensitivity.propagation]
samples = 2048
[sensitivity.reliability]
CASE
} >study.toml

title "results of all methods"
delabole sensitivity study.toml --out one
expect_status 0
expect_silence err
expect_output 'Probability of failure'
expect_output 'First order: reliability index'
expect_output 'The factor of safety changes most with '
expect_complete_results one
for table in tornado sweep morris sobol_indices histogram cumulative convergence design_points; do
    expect "$table.csv is there" test -s "one/$table.csv"
done
for figure in tornado morris sobol_indices histogram cumulative convergence; do
    expect "$figure.png is there" test -s "one/figures/$figure.png"
done
# A crack of 4.348 m cannot hold 5 m of water: an eighth of the samples has no answer.
expect "samples without an answer are counted by cause" contains one/result.json '"water_above_crack"'
expect "and named in the report" contains one/report.html 'without a finite value'
finding='of the 256 rows of samples have an evaluation without a value and were left out'
expect "a finding from the rest of the rows says so" contains one/result.json "$finding"
expect_output "$finding"

title "two threads, another seed"
delabole sensitivity study.toml --out two --threads 2 --quiet
expect_status 0
expect_silence out
for table in one/*.csv; do
    expect "${table##*/} is the same on two threads" cmp "$table" "two/${table##*/}"
done
delabole sensitivity study.toml --out three --seed 5 --quiet
expect "other samples by another seed" refuse cmp -s one/cumulative.csv three/cumulative.csv
delabole sensitivity one/resolved.toml --out four --quiet
expect "the same from the resolved case" cmp one/cumulative.csv four/cumulative.csv

# refused WHAT SED MESSAGE
refused() {
    title "$1"
    sed -E "$2" study.toml >case.toml
    expect "the case was changed" refuse cmp -s study.toml case.toml
    local command
    for command in check sensitivity; do
        delabole "$command" case.toml $([[ $command == check ]] || echo --out results)
        expect_status 3
        expect_error "$3"
        expect_one_line_of_error
        expect "no result folder" refuse test -e results
    done
}
refused "no spread" 's/"8 kPa"/"-1 kPa"/' \
    'sensitivity.parameter[1].standard_deviation = "-1 kPa": must be more than 0 kPa'
refused "limits reversed" 's/lower = "0 m"/lower = "9 m"/' \
    'sensitivity.parameter[3].lower = "9 m": must be less than upper'
refused "rows that are no power of 2" 's/samples = 256/samples = 300/' \
    'sensitivity.sobol_indices.samples = 300: must be a power of 2'
refused "indices of parameters that depend on each other" \
    's/^\[sensitivity.tornado\]/[[sensitivity.correlation]]\nbetween = ["strength.cohesion", "strength.friction_angle"]\ncoefficient = -0.5\n&/' \
    'sensitivity.sobol_indices: needs independent parameters'
refused "a linear correlation that these distributions cannot have" \
    '/sobol_indices/,/samples/d; s/^\[sensitivity.tornado\]/[[sensitivity.correlation]]\nbetween = ["strength.cohesion", "water.water_depth"]\ncoefficient = 0.99\n&/' \
    'can only have linear correlations between'
refused "first-order reliability without a limit" '/^\[sensitivity.failure\]/,/limit/d' \
    'sensitivity.reliability: needs [sensitivity.failure]'

title "no [sensitivity] section"
delabole sensitivity good.toml --out results
expect_status 3
expect_error 'sensitivity: the case has no [sensitivity] section; delabole init sensitivity shows one'

title "samples that all fail"
sed 's/lower = "0 m"/lower = "6 m"/; s/upper = "5 m"/upper = "9 m"/' study.toml >hopeless.toml
delabole sensitivity hopeless.toml --out hopeless
expect_status 4
expect_error 'found no value of the quantity anywhere'
expect_complete_results hopeless
expect "the status says so" test "$(json_value hopeless/result.json status)" == '"no_answer"'

title "a search that ends at a bound decides a sample where the bound is the limit"
probability=$source_folder/cases/relaxation/single_block_probability.toml
# few UPPER STATUS: runs a few samples with UPPER as the upper bound of the search for the critical tilt
few() {
    delabole sensitivity "$probability" --out "few_$1" --set critical.upper="$1 deg" --set settings.quality=draft \
        --set sensitivity.propagation.samples=64 --quiet
    expect_status "$2"
}
few 30 0
few 16 4 # the slope stands at the medians, where first-order reliability has no value to start from
for answer in failed decided; do
    expect "the same number $answer" \
        test "$(json_value few_16/result.json "$answer")" == "$(json_value few_30/result.json "$answer")"
done
expect "and said in the report" contains few_16/report.html 'stands: at least 16 deg'
few 15.9 4
expect "few samples decided give no probability" contains few_15.9/result.json '"probability": null'
expect "but bounds" contains few_15.9/result.json 'Probability of failure not known: only'

title "a parameter that nothing depends on"
sed 's/name = "water.water_depth"/name = "slope.toe_elevation"/' study.toml >idle.toml
delabole sensitivity idle.toml --out idle
expect_status 0
expect_output 'slope.toe_elevation'
expect "named" test "$(grep -A1 '"without_effect"' idle/result.json | tail -n 1 | tr -d ' ')" == '"slope.toe_elevation"'

title "Ctrl-C"
sed 's/samples = 2048/samples = 10000000/' study.toml >long.toml
setsid "$program" sensitivity long.toml --out long >"$scratch/out" 2>"$scratch/err" </dev/null &
child=$!
for ((wait = 0; wait < 600; ++wait)); do
    ! grep -q '[1-9] %: ' "$scratch/err" || break
    sleep 0.1
done
kill -s INT -- "-$child" || true
status=0
wait "$child" || status=$?
expect_status 4
expect_error 'delabole: interrupted: '
expect_complete_results long
expect "marked in result.json" test "$(json_value long/result.json status)" == '"interrupted"'

title "the factor of safety of a search by strength reduction, which the weight of one block does not change"
delabole sensitivity "$source_folder/cases/relaxation/strength_reduction.toml" --out reduced --no-report
expect_status 0
expect_output 'No change of scene.rock[1].density alone was seen to change the factor of safety.'

finish
