#!/usr/bin/env bash
# The texts of a case may come from another person: a terminal, a spreadsheet, gnuplot and a report must only display
# them.
source "$(dirname "${BASH_SOURCE[0]}")/harness.sh"

write_good_fit good.toml
expect_no_escapes() {
    local file
    for file in out err; do
        expect "$1: no control characters in $file" refuse grep -qP '[\x00-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]' \
            "$scratch/$file"
    done
}

title "escape sequences do not reach the terminal"
# The first sequence would change the window's title, the second is the 8-bit form of such a sequence; a label and a
# source hold more of them.
sed -E 's/^title = .*/title = "\\u001B]0;owned\\u0007 \\u009B31m"/; s/it failed/it \\u001B[8mfailed/' good.toml >wild.toml
cat >>wild.toml <<'CASE'

[[expect]]
quantity = "crack_depth"
value = "4.348 m"
tolerance = "1 mm"
source = "\u001B[2J \r hidden"
CASE
expect "the case was changed" refuse cmp -s good.toml wild.toml
escape=$'\e'
for arguments in "run wild.toml" "run wild.toml --json" "fit wild.toml" "fit wild.toml --json" "verify wild.toml" \
    "verify wild.toml --json" "show wild.toml" "show wild.toml --json" "check wild.toml" "compare wild.toml good.toml" \
    "compare good.toml wild.toml --json" "inputs wild.toml" "inputs wild.toml --json" "outputs wild.toml" \
    "grid wild.toml --vary strength.cohesion=5kPa,9kPa" "grid wild.toml --vary strength.cohesion=5kPa,9kPa --json"; do
    # shellcheck disable=SC2086
    delabole $arguments
    expect_status 0
    expect_no_escapes "$arguments"
    if [[ $arguments == *--json ]]; then
        expect "$arguments is JSON" is_json "$scratch/out"
    fi
done
delabole run wild.toml
expect_output '\u001b]0;owned\u0007'
delabole show wild.toml
cp "$scratch/out" shown.toml
delabole check shown.toml
expect_status 0

title "nor do those of names and arguments"
cp good.toml "${escape}[31m.toml"
for arguments in "run ${escape}[31m.toml" "check ${escape}[31m.toml" "run ${escape}[0m" "${escape}[1m" \
    "reproduce ${escape}[1m" "run good.toml --out /proc/${escape}[1m" "run good.toml --${escape}[1m" \
    "run good.toml --set ${escape}[1m=1" "init ${escape}[1m"; do
    # shellcheck disable=SC2086
    delabole $arguments
    expect_no_escapes "$(printf '%q' "$arguments")"
done

title "a text that begins as a formula is none in the tables"
sed -E 's/it failed/=1+2/' good.toml >formula.toml
delabole fit formula.toml --out formula --quiet
expect_status 0
expect "the label is in a table" grep -qF '=1+2' formula/*.csv
expect "and behind an apostrophe" refuse grep -qE "(^|,)\"?[=@]" formula/*.csv

cat good.toml - >swept.toml <<'CASE'

[[sweep]]
name = "swept"
vary = [{ input = "water.water_depth", values = ["0 m", "3 m"] }]
curve = [{ label = "@safety", output = "factor_of_safety" }, { label = "-1+safety", output = "factor_of_safety" }]
CASE
delabole run swept.toml --out swept --quiet
expect_status 0
expect "labels of curves are in a table" grep -qF '@safety' swept/swept.csv
expect "and behind an apostrophe" refuse grep -qE '(^|,)"?[=@-][^0-9]' swept/swept.csv

title "a text that begins with a quote breaks no figure"
sed -E "s/^title = .*/title = \"'quoted' ''\"/; s/it failed/'failed'/" good.toml >quoted.toml
for command in run fit; do
    delabole "$command" quoted.toml --out "quoted_$command"
    expect_status 0
    expect_silence err
    expect "$command: every script is drawn" test "$(ls "quoted_$command"/figures/*.gp | wc -l)" == \
        "$(ls "quoted_$command"/figures/*.svg | wc -l)"
done

title "nothing of a file that a case names as a table is shown"
echo 'secret words,of somebody' >secret
sed -E 's/^shaking_file = .*/shaking_file = "secret"/' "$source_folder/cases/relaxation/newmark_block.toml" >shaken.toml
delabole check shaken.toml
expect_status 3
expect_error 'names none of the columns of this table'
expect "the file is not quoted" refuse grep -q secret.words "$scratch/err"

finish
