#!/usr/bin/env bash
# Ctrl-C during a long back-analysis ends it soon, with exit code 4 and a complete report that says that it was
# interrupted; a second Ctrl-C ends the program at once. Progress is shown as occasional lines, or as a bar on a
# terminal.
source "$(dirname "${BASH_SOURCE[0]}")/harness.sh"

# This fit would take hours.
long_fit=(fit "$source_folder/cases/delabole_1967/delabole_1967.toml" --set fit.starts=100000
    --set fit.evaluations_per_start=100000)
# Seconds: far more than an interrupt takes on a busy machine, far less than the work.
patience=60

milliseconds() {
    date +%s%3N
}

wait_until() {
    local count=0
    until "$@"; do
        sleep 0.1
        count=$((count + 1))
        if ((count > patience * 10)); then
            fail "waited in vain for: $*"
            return 1
        fi
    done
}

start_long_fit() {
    setsid "$program" "${long_fit[@]}" --out "$1" >"$scratch/out" 2>"$scratch/err" </dev/null &
    child=$!
    wait_until test -d "$1"
    sleep 1
}

# Waits for $child; its exit code is then in $status, the time it took in $waited.
wait_for_child() {
    local from
    from=$(milliseconds)
    local count=0
    while kill -0 "$child" 2>/dev/null && ((count < patience * 20)); do
        sleep 0.05
        count=$((count + 1))
    done
    ! kill -KILL "$child" 2>/dev/null || fail "it had to be killed"
    status=0
    wait "$child" || status=$?
    waited=$(($(milliseconds) - from))
}

for signal in INT TERM HUP; do
    title "SIG$signal, to the whole process group as from a terminal"
    start_long_fit "stopped_$signal"
    kill -s "$signal" -- "-$child"
    wait_for_child
    echo "  ended after $waited ms"
    expect_status 4
    expect_error 'delabole: interrupted: '
    expect_complete_results "stopped_$signal"
    expect "marked in result.json" test "$(json_value "stopped_$signal/result.json" status)" == '"interrupted"'
    expect "marked in the report" contains "stopped_$signal/report.html" 'Interrupted'
    expect_no_leftovers "stopped_$signal"
    expect "no scratch folder" test -z "$(find "stopped_$signal" -mindepth 1 -type d ! -name figures)"
    # Figures are drawn for another 0.7 s, which on a busy machine suffices for few of them.
    left_out=0
    for script in "stopped_$signal"/figures/*.gp; do
        if [[ -e ${script%.gp}.svg ]]; then
            expect "${script%.gp}.svg is whole" contains "${script%.gp}.svg" '</svg>'
        else
            left_out=1
        fi
    done
    if ((left_out)); then
        # The one that was being drawn has been ended, the others have not been begun.
        expect "said in the report" grep -qE 'because the work was interrupted|gnuplot failed on' "stopped_$signal/report.html"
    fi
    expect "no warning of figures" refuse contains "$scratch/err" 'was not drawn'
    expect_output "report in stopped_$signal/report.html"
done

title "under nohup it goes on when the terminal closes"
(
    trap '' HUP
    exec setsid "$program" "${long_fit[@]}" --out without_terminal
) >"$scratch/out" 2>"$scratch/err" </dev/null &
child=$!
wait_until test -d without_terminal
kill -s HUP "$child"
sleep 1
expect "it runs on" kill -0 "$child"
kill -s INT "$child"
wait_for_child
expect_status 4

title "Ctrl-C while gnuplot draws, as the terminal sends it to all: no half picture is left, and no result"
mkdir slow
cat >slow/gnuplot <<'SCRIPT'
#!/bin/sh
echo $$ >>"$PIDS"
sleep 1
exec /usr/bin/gnuplot "$@"
SCRIPT
chmod +x slow/gnuplot
write_good_case good.toml
if [[ -x /usr/bin/gnuplot ]]; then
    export PIDS=$scratch/pids
    PATH=$work/slow:$PATH setsid "$program" run good.toml --out drawn >"$scratch/out" 2>"$scratch/err" </dev/null &
    child=$!
    wait_until test -s "$PIDS"
    kill -s INT -- "-$child"
    wait_for_child
    expect_status 4
    expect_error 'delabole: interrupted, 0 of 1 cases were analysed'
    expect "nothing that would say that all is there" refuse test -e drawn/result.json
    expect "no scratch folder" test -z "$(find drawn -mindepth 1 -type d ! -name figures)"
    expect "no figure is half drawn" refuse contains "$scratch/err" 'was not drawn'
fi

title "a second Ctrl-C ends the program at once"
cat >slow/gnuplot <<'SCRIPT'
#!/bin/sh
echo $$ >"$PIDS"
exec sleep 300
SCRIPT
export PIDS=$scratch/sleeping
PATH=$work/slow:$PATH setsid "$program" run good.toml --out twice >"$scratch/out" 2>"$scratch/err" </dev/null &
child=$!
wait_until test -s "$PIDS"
kill -s INT "$child"
expect "the first one did not kill" kill -0 "$child"
sleep 0.3
kill -s INT "$child"
wait_for_child
expect_status 130
expect "no result.json" refuse test -e twice/result.json
ended() {
    ! kill -0 "$(cat "$PIDS")" 2>/dev/null
}
expect "gnuplot was ended, too" wait_until ended

title "one Ctrl-C ends a gnuplot that hangs"
rm "$PIDS"
PATH=$work/slow:$PATH setsid "$program" run good.toml --out hung >"$scratch/out" 2>"$scratch/err" </dev/null &
child=$!
wait_until test -s "$PIDS"
kill -s INT "$child"
wait_for_child
echo "  ended after $waited ms"
expect_status 4
expect_error 'delabole: interrupted, 0 of 1 cases were analysed'
expect "gnuplot was ended, too" wait_until ended
expect "no scratch folder" test -z "$(find hung -mindepth 1 -type d ! -name figures)"

title "one Ctrl-C ends what waits for input"
mkfifo never
exec 3<>never
setsid "$program" check - >"$scratch/out" 2>"$scratch/err" <&3 &
child=$!
sleep 1
expect "it waits" kill -0 "$child"
kill -s INT "$child"
wait_for_child
echo "  ended after $waited ms"
exec 3>&-
expect_status 4
expect_error 'delabole: interrupted: the work was ended where it was'

title "what passes a Ctrl-C on and sends it twice does not count as a second one"
status=0
timeout --signal=INT --preserve-status 3 "$program" "${long_fit[@]}" --out passed_on >"$scratch/out" 2>"$scratch/err" ||
    status=$?
expect_status 4
expect_error 'delabole: interrupted: '
expect_complete_results passed_on

title "Ctrl-C between the cases of run"
for number in 1 2 3; do
    write_good_case "case$number.toml"
done
rm -rf results
cat >slow/gnuplot <<'SCRIPT'
#!/bin/sh
echo $$ >"$PIDS"
sleep 0.5
exit 1
SCRIPT
export PIDS=$scratch/between
PATH=$work/slow:$PATH setsid "$program" run case1.toml case2.toml case3.toml >"$scratch/out" 2>"$scratch/err" </dev/null &
child=$!
wait_until test -s "$PIDS"
kill -s INT "$child"
wait_for_child
expect_status 4
expect_error 'delabole: interrupted, 0 of 3 cases were analysed'
expect "the others were not begun" refuse test -e results/case2

title "Ctrl-C in a long run of blocks: what it has, and its mark"
setsid "$program" run "$source_folder/cases/relaxation/single_block.toml" --set scene.tilt="5 deg" \
    --set settings.stop=collapse --set settings.duration="100000 s" --out blocks \
    >"$scratch/out" 2>"$scratch/err" </dev/null &
child=$!
sleep 2
kill -s INT "$child"
wait_for_child
expect_status 4
expect_error 'delabole: interrupted: the run ended at '
expect_complete_results blocks
expect "marked in result.json" test "$(json_value blocks/result.json status)" == '"interrupted"'
expect "marked in the report" contains blocks/report.html 'Interrupted'

title "Ctrl-C in the linear programmes of a single long run, which says beforehand that it is long"
{
    printf 'schema = 1\nmodel = "stepped_base"\ntitle = "Many columns"\n[columns]\nkind = "blocks"\njoint_dip = "70 deg"\n'
    for ((column = 1; column <= 450; ++column)); do
        printf '[[columns.block]]\nheight = "%d m"\nwidth = "5 m"\nstep_above = "0.5 m"\n' "$((column < 225 ? column + 1 : 451 - column))"
    done
    printf '[rock]\nunit_weight = "25 kN/m3"\n[joints]\nfriction_angle = "35 deg"\n'
    printf '[bases]\nfriction_angle = "35 deg"\ncohesion = "0 kPa"\n[water]\nkind = "dry"\n'
    printf '[linear_programming_bound]\nupper_part = 1\n'
} >long.toml
setsid "$program" run long.toml --out long >"$scratch/out" 2>"$scratch/err" </dev/null &
child=$!
wait_until grep -q 'Ctrl-C ends it' "$scratch/err"
sleep 0.5
expect "it is still at it" kill -0 "$child"
kill -s INT "$child"
wait_for_child
echo "  ended after $waited ms"
expect_status 4
expect_error 'delabole: interrupted, 0 of 1 cases were analysed'
expect "soon: far sooner than the whole run" test "$waited" -lt 3000
expect "no result folder" refuse test -e long

title "Ctrl-C in work that never asks for it: sections of many blocks that are cut and checked"
fine_section=$source_folder/cases/relaxation/base_friction_slope.toml
# The case is checked many times, so that even a fast machine is still at work when the signal comes.
mapfile -t many < <(yes "$fine_section" | head -n 50)
setsid "$program" check "${many[@]}" --set 'scene.cut[1].trace.spacing="1 mm"' \
    --set 'scene.cut[2].trace.spacing="1 mm"' >"$scratch/out" 2>"$scratch/err" </dev/null &
child=$!
sleep 1
expect "it is still at it" kill -0 "$child"
kill -s INT -- "-$child"
wait_for_child
echo "  ended after $waited ms"
expect_status 4
expect_error 'delabole: interrupted: the work was ended where it was'
expect_one_line_of_error

title "Ctrl-C in a trade of accuracy against cost: what is finished is written"
# With a tolerance of a billionth of a degree and fine settings the work is far longer than the test waits.
setsid "$program" trade "$source_folder/cases/relaxation/two_blocks_3.toml" --set 'critical.tolerance=1e-9 deg' \
    --out traded >"$scratch/out" 2>"$scratch/err" </dev/null &
child=$!
wait_until grep -qE '^[0-9]+ %: [1-9][0-9]* of [0-9]+ settings, ([0-9]+ (s|min|h) left|time left not known)' "$scratch/err"
kill -s INT -- "-$child"
wait_for_child
echo "  ended after $waited ms"
expect_status 4
expect_error 'delabole: interrupted: '
expect_complete_results traded
expect "marked in result.json" test "$(json_value traded/result.json status)" == '"interrupted"'
expect "the settings that were finished" test "$(wc -l <traded/trade.csv)" -ge 2

title "Ctrl-C in a chapter that is reproduced: where it was, and what the command does the next time"
setsid "$program" reproduce chapter5 --out chapter >"$scratch/out" 2>"$scratch/err" </dev/null &
child=$!
# A line appears every five seconds, in this case about forty lines in all.
wait_until grep -qE '^[0-9]+ %: [a-z_0-9.]+(, ([0-9]+ (s|min|h) left|time left not known))?$' "$scratch/err"
kill -s INT -- "-$child"
wait_for_child
echo "  ended after $waited ms"
expect_status 4
expect_error 'delabole: interrupted at '
expect_error '; nothing is kept of it: the same command begins anew'
# The complete work takes minutes.
expect "soon: after a run or two of blocks" test "$waited" -lt 30000
expect "nothing that would say that all is there" refuse test -e chapter/result.json

title "progress as plain lines where there is no terminal, none when quiet"
rm "$scratch/err"
setsid "$program" "${long_fit[@]}" --out lines >"$scratch/out" 2>"$scratch/err" </dev/null &
child=$!
wait_until test -s "$scratch/err"
kill -s INT "$child"
wait_for_child
expect_status 4
expect "percent, what is done" grep -qE '^[0-9]+ %: [a-z_]+: [a-z]' "$scratch/err"
expect "no carriage returns, no escapes" refuse grep -q $'[\r\033]' "$scratch/err"
setsid "$program" "${long_fit[@]}" --quiet --out quiet >"$scratch/out" 2>"$scratch/err" </dev/null &
child=$!
sleep 6
kill -s INT "$child"
wait_for_child
expect_status 4
expect_silence out
expect_error 'delabole: interrupted: '
expect_one_line_of_error

title "progress as a bar with the time left on a terminal"
if command -v script >/dev/null; then
    SHELL=/bin/bash TERM=xterm timeout 300 script -qec \
        "timeout --foreground -s INT 4 $(printf '%q ' "$program" "${long_fit[@]}" --set fit.starts=2000 --out terminal)" \
        /dev/null >"$scratch/typed" </dev/null || true
    tr '\r' '\n' <"$scratch/typed" >"$scratch/bars"
    expect "a bar" grep -qE '\[[# ]{30}\] +[0-9]+ %  ' "$scratch/bars"
    expect "with the time left" grep -qE '\[[# ]{30}\] +[0-9]+ %  [0-9]+ (s|min|h) left  [a-z_]+: [a-z]' "$scratch/bars"
    expect "the bar is wiped before the results" grep -q $'\033\\[K[^\[]*Old Delabole' "$scratch/bars"
else
    echo "  not checked: there is no 'script' to make a terminal"
fi

finish
