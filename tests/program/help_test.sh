#!/usr/bin/env bash
# --help of the program and of each command shows an example, and each example works as shown when it is typed into a
# shell in a copy of the sources.
source "$(dirname "${BASH_SOURCE[0]}")/harness.sh"

mkdir tree
cp -r "$source_folder/cases" tree/
PATH=$DELABOLE_BUILD/bin:$PATH

# All lines between "Example:" and the next empty line.
examples() {
    awk '/^Examples?:/ { inside = 1; next } inside && /^ *$/ { exit } inside' "$scratch/out"
}

# This command serves a page until Ctrl-C, so it is ended here.
serve_briefly() {
    bash -euc "cd tree && exec $1" >"$scratch/out" 2>"$scratch/err" </dev/null &
    local server=$!
    until grep -q 'http://' "$scratch/out" || ! kill -0 "$server" 2>/dev/null; do
        sleep 0.1
    done
    kill -INT "$server" 2>/dev/null || true
    status=0
    wait "$server" || status=$?
}

title "the program lists its commands"
delabole --help
expect_status 0
expect_output 'Exit codes: 0 ok, 1 verify mismatch, 2 usage, 3 invalid case'
mapfile -t commands < <(sed -n '/^Subcommands:/,$p' "$scratch/out" | sed -nE 's/^  ([a-z]+) +[A-Z].*/\1/p')
expect "run fit recover live sensitivity grid trade check compare show init inputs outputs verify reproduce, not ${commands[*]}" \
    test "${commands[*]}" == "run fit recover live sensitivity grid trade check compare show init inputs outputs verify reproduce"

for command in "" "${commands[@]}"; do
    # shellcheck disable=SC2086
    delabole $command --help
    expect_status 0
    expect_silence err
    mapfile -t lines < <(examples)
    expect "delabole $command --help shows an example" test "${#lines[@]}" -ge 1
    for line in "${lines[@]}"; do
        title "delabole ${command:+$command }--help: $line"
        expect "it is an example of the command" contains <(echo "$line") "delabole $command"
        if [[ $command == live ]]; then
            serve_briefly "$line"
        else
            run bash -euc "cd tree && $line"
        fi
        expect_status 0
        expect_only_progress
    done
done
expect "the examples left results" test -s tree/results/wyllie_mah_7_1/result.json

finish
