#!/usr/bin/env bash
# The same case gives the same result when it is run again, into the same folder or another, from its own resolved.toml,
# and with any number of threads.
source "$(dirname "${BASH_SOURCE[0]}")/harness.sh"

write_good_case good.toml
write_good_fit good_fit.toml

# The file without times, and without the commas at the ends of lines, because a list may lose its last line.
timeless() {
    sed -E '/"(wall|fit)_seconds": /d; s/,$//' "$1"
}

same_result() {
    checks=$((checks + 1))
    if ! diff <(timeless "$1") <(timeless "$2") >"$scratch/difference"; then
        fail "$1 and $2 differ: $(head -n 6 "$scratch/difference")"
    fi
}

same_but_for() {
    local pattern=$1
    checks=$((checks + 1))
    if ! diff <(timeless "$2" | grep -vE "$pattern") <(timeless "$3" | grep -vE "$pattern") >"$scratch/difference"; then
        fail "$2 and $3 differ: $(head -n 6 "$scratch/difference")"
    fi
}

# All files of two folders are equal, except for the wall time.
same_folders() {
    local file
    expect "the same files in $1 and $2" test "$(cd "$1" && find . | sort)" == "$(cd "$2" && find . | sort)"
    while IFS= read -r file; do
        case $file in
        *.json) same_result "$1/$file" "$2/$file" ;;
        *.html | *.png | *.svg) ;;
        *) expect "$file is the same" cmp "$1/$file" "$2/$file" ;;
        esac
    done < <(cd "$1" && find . -type f)
}

for command in run fit; do
    case_file=good.toml
    [[ $command == run ]] || case_file=good_fit.toml

    title "$command twice"
    delabole $command $case_file --out "$command.first" --quiet
    expect_status 0
    delabole $command $case_file --out "$command.second" --quiet
    expect_status 0
    same_folders "$command.first" "$command.second"

    title "$command again into the same folder"
    delabole $command $case_file --set 'slope.height=13 m' --set 'water.water_depth=1 m' --out "$command.again" --quiet
    expect_status 0
    expect "another result" refuse cmp -s <(timeless "$command.first/result.json") <(timeless "$command.again/result.json")
    delabole $command $case_file --out "$command.again" --quiet
    expect_status 0
    same_folders "$command.first" "$command.again"

    title "$command of its own resolved.toml"
    delabole $command "$command.first/resolved.toml" --out "$command.resolved" --quiet
    expect_status 0
    same_but_for '"case": ' "$command.first/result.json" "$command.resolved/result.json"
    expect "resolving again changes nothing" cmp "$command.first/resolved.toml" "$command.resolved/resolved.toml"
    hash=$(json_value "$command.first/result.json" case_hash)
    expect "a hash" test "${#hash}" == 18
    expect "the same hash" test "$hash" == "$(json_value "$command.resolved/result.json" case_hash)"
done

title "fit with one thread and with two"
for threads in 1 2; do
    delabole fit "$source_folder/cases/delabole_1967/delabole_1967.toml" --set fit.posterior.chains=2 --set fit.posterior.draws=400 \
        --mechanism critical_sliding --mechanism stepped_sliding --threads "$threads" --out "threads$threads" --quiet --no-report
    expect_status 0
done
same_but_for '"threads": ' threads1/result.json threads2/result.json
expect "threads are recorded" contains threads2/result.json '"threads": 2'
for table in threads1/*.csv; do
    expect "$table is the same" cmp "$table" "threads2/$(basename "$table")"
done

title "trade with one thread and with two"
for threads in 1 2; do
    delabole trade "$source_folder/cases/relaxation/single_block.toml" --set 'critical.tolerance=0.1 deg' \
        --threads "$threads" --out "trade$threads" --quiet --no-report
    expect_status 0
done
same_but_for '"threads": ' trade1/result.json trade2/result.json
# The last column is the wall time.
expect "the table is the same" cmp <(sed 's/,[^,]*$//' trade1/trade.csv) <(sed 's/,[^,]*$//' trade2/trade.csv)

title "the same seed twice, then the case's own given as an option"
for round in 1 2; do
    delabole fit good_fit.toml --seed 11 --out "seed$round" --quiet --no-report
    expect_status 0
done
same_result seed1/result.json seed2/result.json
delabole fit good_fit.toml --seed 7 --out seed7 --quiet --no-report
same_but_for '"seed": ' fit.first/result.json seed7/result.json

title "the hash tells cases apart and does not mind how they are written"
delabole run good.toml --set 'slope.height=12000 mm' --out units --quiet --no-report
expect "other units, same hash" test "$(json_value units/result.json case_hash)" == \
    "$(json_value run.first/result.json case_hash)"
delabole run good.toml --set 'slope.height=12.001 m' --out other --quiet --no-report
expect "other height, other hash" test "$(json_value other/result.json case_hash)" != \
    "$(json_value run.first/result.json case_hash)"

finish
