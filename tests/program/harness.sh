# Functions that the tests of the program share; to be sourced. The test works in $work, an empty folder that is removed
# at the end, and the path of the program is in $program. Every expectation that fails is printed; `finish` turns them
# into the exit code.
set -euo pipefail

program=$DELABOLE_BUILD/bin/delabole
source_folder=$DELABOLE_SOURCE
scratch=$(mktemp -d)
work=$scratch/work
mkdir "$work"
trap 'rm -rf "$scratch"' EXIT
cd "$work"

# A quicker fit of the Delabole case, for tests that do not depend on its digits. It takes half the time.
quick_fit=(--set fit.starts=4 --set fit.profile_points=5 --set fit.map_points=5 --set fit.posterior.chains=4
    --set fit.posterior.draws=1000 --set fit.posterior.evidence_points=64)

failures=0
checks=0

title() {
    printf '%s\n' "- $*"
}

fail() {
    printf '  FAILED: %s\n' "$*"
    failures=$((failures + 1))
}

# expect "what must hold" command...
expect() {
    local what=$1
    shift
    checks=$((checks + 1))
    "$@" || fail "$what"
}

refuse() {
    ! "$@"
}

# Runs a command; its exit code is then in $status, its output in $scratch/out and $scratch/err.
run() {
    status=0
    "$@" >"$scratch/out" 2>"$scratch/err" </dev/null || status=$?
}

delabole() {
    run "$program" "$@"
}

show_run() {
    printf '    exit code %s\n' "$status"
    sed 's/^/    out: /' "$scratch/out" | head -n 12
    sed 's/^/    err: /' "$scratch/err" | head -n 12
}

expect_status() {
    checks=$((checks + 1))
    if [[ $status != "$1" ]]; then
        fail "exit code $status instead of $1"
        show_run
    fi
}

contains() {
    grep -qF -e "$2" "$1"
}

# Standard error (or output) of the last run contains the text.
expect_error() {
    checks=$((checks + 1))
    if ! contains "$scratch/err" "$1"; then
        fail "standard error lacks: $1"
        show_run
    fi
}

expect_output() {
    checks=$((checks + 1))
    if ! contains "$scratch/out" "$1"; then
        fail "standard output lacks: $1"
        show_run
    fi
}

# Standard error is a single line.
expect_one_line_of_error() {
    checks=$((checks + 1))
    if [[ $(wc -l <"$scratch/err") != 1 ]]; then
        fail "not one line of error"
        show_run
    fi
}

expect_silence() {
    checks=$((checks + 1))
    if [[ -s $scratch/$1 ]]; then
        fail "something was printed (${1/err/error}put)"
        show_run
    fi
}

# Standard error is empty or holds only progress, which a slow build or a busy machine prints.
expect_only_progress() {
    checks=$((checks + 1))
    if grep -qvE '^ *[0-9]+ %: ' "$scratch/err"; then
        fail "something other than progress was printed"
        show_run
    fi
}

# There is no temporary file of a write that was not completed.
expect_no_leftovers() {
    checks=$((checks + 1))
    local left
    left=$(find "$1" -name '.*' ! -path "$1" 2>/dev/null || true)
    [[ -z $left ]] || fail "left behind: $left"
}

# The files of a result folder that every analysis writes.
expect_complete_results() {
    local folder=$1 file
    for file in result.json resolved.toml report.html; do
        expect "$folder/$file is there" test -s "$folder/$file"
    done
    expect "the report is whole" contains "$folder/report.html" "</html>"
    expect "result.json is JSON" is_json "$folder/result.json"
    expect_no_leftovers "$folder"
}

# Checks with Python if it is there; otherwise checks only both ends of the text and words that JSON does not have.
is_json() {
    if command -v python3 >/dev/null; then
        python3 -c 'import json, sys
def refuse(word): raise ValueError(word)
json.load(open(sys.argv[1]), parse_constant=refuse)' "$1"
    else
        [[ $(head -c 1 "$1") == [{[] && $(tail -n 1 "$1") == [}\]] ]] && ! grep -qwE '(NaN|Infinity|nan|inf)' "$1"
    fi
}

# json_value FILE KEY: the first value of that name, as written.
json_value() {
    sed -nE "s/^ *\"$2\": (.*[^,]),?\$/\\1/p" "$1" | head -n 1
}

# A valid case: a slope of 12 m with a tension crack 4.348 m deep.
write_good_case() {
    cat >"$1" <<'CASE'
schema = 1
model = "plane_failure"
title = "A slope that is in order"

[slope]
height = "12 m"
face_dip = "60 deg"
upper_surface_dip = "0 deg"
toe_elevation = "100 m"

[failure_plane]
dip = "35 deg"

[tension_crack]
dip = "90 deg"
distance_behind_crest = "4 m"

[rock]
unit_weight = "26 kN/m3"

[strength]
kind = "coulomb"
cohesion = "25 kPa"
friction_angle = "37 deg"

[water]
kind = "crack_and_base"
unit_weight = "9.81 kN/m3"
water_depth = "3 m"
CASE
}

# Blocks on a stepped base.
write_good_blocks() {
    cat >"$1" <<'CASE'
schema = 1
model = "stepped_base"
title = "Three blocks that are in order"

[columns]
kind = "blocks"
joint_dip = "68 deg"

[[columns.block]]
height = "1 m"
width = "1 m"
step_above = "0.5 m"

[[columns.block]]
height = "3 m"
width = "1 m"
step_above = "0.6 m"

[[columns.block]]
height = "2 m"
width = "1 m"
step_above = "0.5 m"

[rock]
unit_weight = "26 kN/m3"

[joints]
friction_angle = "35 deg"

[bases]
friction_angle = "35 deg"
cohesion = "0 kPa"

[water]
kind = "dry"

[[bolt]]
block = 2
force = "5 kN/m"
plunge = "0 deg"
height = "1.5 m"
CASE
}

# Columns cut from a slope.
write_good_columns() {
    cat >"$1" <<'CASE'
schema = 1
model = "stepped_base"
title = "A slope of columns that is in order"

[slope]
height = "60 m"
face_dip = "65 deg"
upper_surface_dip = "0 deg"

[columns]
kind = "continuous"
joint_dip = "70 deg"
spacing = "3 m"
base_inclination = "35 deg"
base_end_height = "25 m"

[rock]
unit_weight = "26 kN/m3"

[joints]
friction_angle = "35 deg"

[bases]
friction_angle = "38 deg"
cohesion = "0 kPa"

[water]
kind = "water_table"
unit_weight = "9.81 kN/m3"
water_depth = "15 m"

[[bolt]]
block = 2
force = "5 kN/m"
plunge = "0 deg"
height = "1 m"
CASE
}

# The valid case with a back-analysis that is quick.
write_good_fit() {
    write_good_case "$1"
    cat >>"$1" <<'CASE'

[fit]
algorithm = "sbplx"
starts = 4
evaluations_per_start = 400
profile_points = 9
map_points = 9
seed = 7

[[fit.observation]]
label = "it failed"
quantity = "factor_of_safety"
value = 1
standard_deviation = 0.05

[[fit.parameter]]
name = "strength.friction_angle"
lower = "15 deg"
upper = "60 deg"

[[fit.parameter]]
name = "water.water_depth"
lower = "0 m"
upper = "4 m"
CASE
}

# Texts for readers and for programs contain no "nan" or "inf" in any form.
expect_only_numbers() {
    local file
    while IFS= read -r file; do
        checks=$((checks + 1))
        if grep -nwiE '(nan|-nan|infinity|inf|-inf)' "$file" | grep -vF 'd="M' >"$scratch/bad_numbers"; then
            fail "$file: $(head -n 3 "$scratch/bad_numbers")"
        fi
    done < <(find "$1" -name '*.json' -o -name '*.csv' -o -name '*.toml' -o -name '*.html' -o -name '*.svg')
}

# No table holds rounding in place of a zero.
expect_zeros_are_zeros() {
    local file
    for file in "$1"/*.csv; do
        checks=$((checks + 1))
        awk -F, '{ for (i = 1; i <= NF; i++) if ($i + 0 != 0 && $i < 1e-11 && $i > -1e-11 && !($1 ~ /probability/)) exit 1 }' \
            "$file" || fail "$file: rounding in place of a zero"
    done
}

expect_figures() {
    local folder=$1 script figures=0
    for script in "$folder"/figures/*.gp; do
        expect "${script%.gp}.svg is whole" contains "${script%.gp}.svg" '</svg>'
        expect "${script%.gp}.png is there" test -s "${script%.gp}.png"
        figures=$((figures + 1))
    done
    # The blocks of a run are moved by the report itself.
    local animations
    animations=$(grep -c '<div class="animation"' "$folder/report.html" || true)
    expect "figures in the report" \
        test "$(grep -c '<figure[ >]' "$folder/report.html")" == "$((figures + animations))"
    expect "at least $2 figures" test "$figures" -ge "$2"
}

# result.json is the last file to be written, so that its presence shows that all others are there. Files written within
# one tick of the clock count as equally old.
expect_result_is_newest() {
    checks=$((checks + 1))
    local newer
    newer=$(find "$1" -type f -newer "$1/result.json")
    [[ -z $newer ]] || fail "newer than $1/result.json: $newer"
}

# Opens a report in a browser at the width of a desktop and of a phone, and as printed on paper.
# expect_order FILE TEXT...: each text stands on a later line than the one before it.
expect_order() {
    local file=$1 line=0 text
    shift
    checks=$((checks + 1))
    for text in "$@"; do
        line=$(awk -v from="$line" -v text="$text" 'NR > from && index($0, text) { print NR; exit }' "$file")
        [[ -n $line ]] || { fail "$file: $text is missing or stands too early" && return; }
    done
}

in_browser() {
    local name=$1
    checks=$((checks + 1))
    "$source_folder/tests/plots/report_in_browser" "$name/report.html" \
        ${REPORTS_SCREENSHOTS:+"$REPORTS_SCREENSHOTS/$name"} || fail "the report of $name"
}

finish() {
    printf '%d checks, %d failed\n' "$checks" "$failures"
    [[ $failures == 0 ]]
}
