#!/usr/bin/env bash
# Under mpirun any number of ranks gives the same bytes as one; one rank prints and writes; mistakes are reported once;
# after the loss of a rank the same command continues from the store.
source "$(dirname "${BASH_SOURCE[0]}")/harness.sh"

if [[ $DELABOLE_WITH_MPI != ON && $DELABOLE_WITH_MPI != TRUE ]]; then
    echo "built without MPI"
    OMPI_COMM_WORLD_SIZE=2 run "$program" check "$source_folder/cases/delabole_1967/delabole_1967.toml"
    expect_status 70
    expect_error 'this program was built without MPI'
    finish
    exit
fi

# The test needs more ranks than there are processors, and may run as root in a container.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none
# Waiting ranks leave the processor to the others.
export OMPI_MCA_mpi_yield_when_idle=1

ranks() {
    local count=$1
    shift
    run mpirun -np "$count" "$program" "$@"
}

# All files of two folders are equal, except for pictures, the report and the origin of the results.
same_answers() {
    local file
    expect "the same files in $1 and $2" \
        test "$(cd "$1" && find . ! -name 'evaluations.*' | sort)" == "$(cd "$2" && find . ! -name 'evaluations.*' | sort)"
    for file in "$1"/*.csv "$1"/resolved.toml; do
        expect "$(basename "$file") is the same" cmp "$file" "$2/$(basename "$file")"
    done
    checks=$((checks + 1))
    diff <(sed '/"provenance"/,$d' "$1/result.json") <(sed '/"provenance"/,$d' "$2/result.json") >"$scratch/difference" ||
        fail "$1 and $2 differ: $(head -n 6 "$scratch/difference")"
}

probability=$source_folder/cases/plane_failure/sau_mau_ping_probability.toml
write_good_fit good_fit.toml
cp "$source_folder/cases/delabole_1967/delabole_1967.toml" delabole.toml
fit=(fit delabole.toml --no-report --set fit.starts=3 --set fit.evaluations_per_start=40 --set fit.profile_points=5
    --set fit.map_points=5 --set fit.posterior.chains=2 --set fit.posterior.draws=40
    --set fit.posterior.evaluations_per_chain=400 --set fit.posterior.evidence_points=32)

title "one rank"
delabole sensitivity "$probability" --out sensitivity_1 --quiet
expect_status 0
delabole "${fit[@]}" --out fit_1 --quiet
one=$status

for count in 2 4; do
    title "$count ranks: sensitivity"
    ranks "$count" sensitivity "$probability" --out "sensitivity_$count"
    expect_status 0
    expect_complete_results "sensitivity_$count"
    expect "printed once" test "$(grep -c 'report in' "$scratch/out")" == 1
    expect "their number is on record" test "$(json_value "sensitivity_$count/result.json" ranks)" == "$count"
    same_answers sensitivity_1 "sensitivity_$count"
done

title "three ranks: fit of three mechanisms"
ranks 3 "${fit[@]}" --out fit_3 --threads 2 --quiet
expect_status "$one"
same_answers fit_1 fit_3

title "two ranks write one report"
ranks 2 fit good_fit.toml --quiet --out good_fit_2
expect_status 0
expect_complete_results good_fit_2

title "a mistake is told once"
sed 's/standard_deviation = 0.05/standard_deviation = 0/' good_fit.toml >bad.toml
ranks 2 fit bad.toml
expect "exit code of the mistake" test "$status" == 3
expect "one message" test "$(grep -c 'standard_deviation' "$scratch/err")" == 1
ranks 2 fit good_fit.toml --no-such-option
expect "exit code of the command line" test "$status" == 2
ranks 2 run good_fit.toml
expect "exit code" test "$status" == 2
expect_error 'only fit, recover and sensitivity share their work among ranks'

title "a rank is killed in the middle: the others end, and the same command goes on"
blocks=(sensitivity "$source_folder/cases/relaxation/single_block_probability.toml" --set settings.quality=standard
    --set sensitivity.propagation.samples=1536)
delabole "${blocks[@]}" --quiet --out blocks_1
expect_status 0
all=$(sqlite3 -readonly blocks_1/evaluations.sqlite 'SELECT count(*) FROM evaluation')
mpirun -np 2 "$program" "${blocks[@]}" --out blocks_2 >"$scratch/out" 2>"$scratch/err" </dev/null &
child=$!
for ((wait = 0; wait < 600; ++wait)); do
    kept=$(sqlite3 -readonly blocks_2/evaluations.sqlite 'SELECT count(*) FROM evaluation' 2>/dev/null || echo 0)
    ((kept < all / 3)) || break
    sleep 0.02
done
pkill -KILL -P "$child" -n
status=0
wait "$child" || status=$?
expect "mpirun tells of it" test "$status" != 0
expect_error 'should one be lost, the same command goes on from blocks_2/evaluations.sqlite'
expect "no results" refuse test -e blocks_2/result.json
kept=$(sqlite3 -readonly blocks_2/evaluations.sqlite 'SELECT count(*) FROM evaluation')
expect "something is kept" test "$kept" -ge $((all / 3))
ranks 2 "${blocks[@]}" --quiet --out blocks_2
expect_status 0
expect "what was finished is not repeated" test "$(json_value blocks_2/result.json evaluations_made)" -le $((all - kept + 8))
same_answers blocks_1 blocks_2

finish
