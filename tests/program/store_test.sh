#!/usr/bin/env bash
# Evaluations of dynamic relaxation are kept: a study that is killed at any moment continues with the same command, does
# not repeat a finished evaluation and gives the same bytes; other studies of the same model use the evaluations; a file
# that is not a store, or is damaged, is refused and left unchanged.
source "$(dirname "${BASH_SOURCE[0]}")/harness.sh"

blocks=$source_folder/cases/relaxation/single_block_probability.toml
# The study is slow enough to be killed while it runs.
study=(sensitivity "$blocks" --set settings.quality=standard --set sensitivity.propagation.samples=128 --quiet)

rows() {
    sqlite3 -readonly "$1" 'SELECT count(*) FROM evaluation' 2>/dev/null || echo 0
}

# Tables and all results, except for their origin and the time they took.
same_answers() {
    local table
    for table in "$1"/*.csv "$1"/resolved.toml; do
        expect "$(basename "$table") is the same" cmp "$table" "$2/$(basename "$table")"
    done
    checks=$((checks + 1))
    diff <(sed '/"provenance"/,$d' "$1/result.json") <(sed '/"provenance"/,$d' "$2/result.json") >"$scratch/difference" ||
        fail "$1 and $2 differ: $(head -n 6 "$scratch/difference")"
}

title "a study keeps what it computes, beside its results"
delabole "${study[@]}" --out whole
expect_status 0
expect_complete_results whole
all=$(rows whole/evaluations.sqlite)
expect "evaluations are kept" test "$all" -gt 100
expect "as many as were made" test "$(json_value whole/result.json evaluations_made)" == "$all"

title "killed three times, it repeats nothing and ends with the same bytes"
for kill in 1 2 3; do
    "$program" "${study[@]}" --out killed >/dev/null 2>&1 </dev/null &
    child=$!
    for ((wait = 0; wait < 600; ++wait)); do
        (($(rows killed/evaluations.sqlite) < kill * all / 5)) || break
        sleep 0.02
    done
    kill -KILL "$child" || true
    wait "$child" 2>/dev/null || true
done
expect "it was killed in the middle" refuse test -e killed/result.json
before=$(rows killed/evaluations.sqlite)
expect "with some evaluations finished" test "$before" -gt $((all / 2))
expect "but not all" test "$before" -lt "$all"
delabole "${study[@]}" --out killed
expect_status 0
expect "what was finished is not repeated" test "$(json_value killed/result.json evaluations_made)" == $((all - before))
expect "the store is whole" test "$(rows killed/evaluations.sqlite)" == "$all"
same_answers whole killed

title "a table of runs saves them, whatever store there is"
mkdir tables
delabole "${study[@]}" --runs tables --out tabled
expect_status 0
expect "a line for each run, below two" \
    test "$(wc -l <tabled/single_block_probability_predictions.csv)" == "$(($(rows tabled/evaluations.sqlite) + 2))"
delabole sensitivity "$blocks" --set settings.quality=standard --set sensitivity.propagation.samples=128 --runs tabled \
    --out from_table
expect_status 0
expect_output '0 evaluations made, 0 found in '
expect_output 'found in tables of runs in tabled'
for table in tabled/*.csv; do
    expect "$(basename "$table") is the same" cmp "$table" "from_table/$(basename "$table")"
done
delabole sensitivity "$blocks" --runs tabled --out other_model
expect_status 5
expect_error 'single_block_probability_predictions.csv, line 1: the table was made for another model'

title "another study of the same model, on two threads, from the store of the first"
delabole sensitivity "$blocks" --set settings.quality=standard --set sensitivity.propagation.samples=128 --threads 2 \
    --store whole/evaluations.sqlite --out again
expect_status 0
expect_output "0 evaluations made, "
expect_output "whole/evaluations.sqlite, which saved "
expect "nothing is left beside its results" refuse test -e again/evaluations.sqlite
same_answers whole again
delabole "${study[@]}" --set settings.quality=draft --store whole/evaluations.sqlite --out draft
expect_status 0
expect "another model shares nothing" test "$(rows whole/evaluations.sqlite)" -gt $((all + 100))

title "Ctrl-C says how to go on"
setsid "$program" "${study[@]}" --set settings.quality=reference --out stopped >"$scratch/out" 2>"$scratch/err" </dev/null &
child=$!
for ((wait = 0; wait < 600; ++wait)); do
    (($(rows stopped/evaluations.sqlite) < 3)) || break
    sleep 0.05
done
kill -s INT -- "-$child"
status=0
wait "$child" || status=$?
expect_status 4
expect_error 'delabole: the same command goes on from what stopped/evaluations.sqlite keeps'

title "a fit: the same from its store, and after a kill"
{
    sed '/^\[sensitivity\]/,$d' "$blocks"
    cat <<'CASE'
[fit]
starts = 3
evaluations_per_start = 60
profile_points = 5
map_points = 7
[[fit.observation]]
label = "tilt at failure"
quantity = "critical_tilt"
value = "17 deg"
standard_deviation = "0.5 deg"
[[fit.parameter]]
name = "scene.block[1].width"
lower = "0.7 m"
upper = "1.3 m"
prior = { mean = "1 m", standard_deviation = "0.1 m" }
[[fit.parameter]]
name = "scene.block[1].height"
lower = "2.5 m"
upper = "3.5 m"
prior = { mean = "3 m", standard_deviation = "0.2 m" }
CASE
} >fit.toml
delabole fit fit.toml --quiet --out fitted
expect_status 0
all=$(rows fitted/evaluations.sqlite)
"$program" fit fit.toml --quiet --out fit_killed >/dev/null 2>&1 </dev/null &
child=$!
for ((wait = 0; wait < 600; ++wait)); do
    (($(rows fit_killed/evaluations.sqlite) < all / 3)) || break
    sleep 0.02
done
kill -KILL "$child" || true
wait "$child" 2>/dev/null || true
before=$(rows fit_killed/evaluations.sqlite)
delabole fit fit.toml --quiet --out fit_killed
expect_status 0
expect "what was finished is not repeated" \
    test "$(json_value fit_killed/result.json evaluations_made)" == $((all - before))
same_answers fitted fit_killed

title "models that take no time leave no store"
write_good_fit good_fit.toml
delabole fit good_fit.toml --quiet --out cheap
expect_status 0
expect "no file" refuse test -e cheap/evaluations.sqlite

title "what is no store stays as it is"
echo "notes" >notes.txt
delabole "${study[@]}" --store notes.txt --out refused
expect_status 5
expect_error 'notes.txt is no evaluation store: name another file, or move this one away; nothing in it was changed'
expect_one_line_of_error
expect "the text" test "$(cat notes.txt)" == notes
cp whole/evaluations.sqlite damaged.sqlite
printf 'x%.0s' {1..4096} | dd of=damaged.sqlite bs=4096 seek=2 conv=notrunc status=none
cp damaged.sqlite damaged_before.sqlite
delabole "${study[@]}" --store damaged.sqlite --out refused
expect_status 5
expect_error 'damaged.sqlite is damaged ('
expect_error 'move it away and the work begins anew'
expect "the damaged file" cmp damaged.sqlite damaged_before.sqlite
cp whole/evaluations.sqlite later.sqlite
sqlite3 later.sqlite 'PRAGMA user_version = 2'
delabole "${study[@]}" --store later.sqlite --out refused
expect_status 5
expect_error 'is an evaluation store of layout 2, of another version of delabole'
delabole "${study[@]}" --store missing/folder/file.sqlite --out refused
expect_status 5
expect_error 'missing/folder/file.sqlite cannot be used as an evaluation store'

finish
