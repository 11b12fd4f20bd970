#!/usr/bin/env bash
# A dynamic relaxation that is killed at any moment continues with the same command and ends with the same bytes; Ctrl-C
# leaves a checkpoint and prints how to continue; a case to which the checkpoint does not belong is refused, so that the
# checkpoint is not lost.
source "$(dirname "${BASH_SOURCE[0]}")/harness.sh"

checkpoint=relaxation.checkpoint
"$program" init relaxation --full --out case.toml
# The run takes seconds: blocks slide for a long time, and a search follows.
cat >>case.toml <<'EOF'

[history]
interval = "0.05 s"

[[history.block]]
block = 1

[critical]
parameter = "friction"
lower = "5 deg"
upper = "60 deg"
EOF
settings=(--set scene.base.friction_angle="9.5 deg" --set settings.collapse_displacement=20 --set settings.step_fraction=0.04)

# Everything in a result folder that does not depend on the time when it was made.
answers() {
    (cd "$1" && cat results.csv history.csv movements.csv resolved.toml && cat figures/*.gp frames/*)
}

same_answers() {
    cmp <(answers "$1") <(answers "$2")
}

title "the whole run, for comparison, on one thread and on two"
seconds=$SECONDS
delabole run case.toml "${settings[@]}" --out whole
expect_status 0
echo "  took $((SECONDS - seconds)) s"
expect "no checkpoint is left" test ! -e "whole/$checkpoint"
delabole run case.toml "${settings[@]}" --out threads --threads 2
expect "two threads give the same bytes" same_answers whole threads

title "kill -9 again and again, then to the end"
killed=0
for delay in 0.3 0.7 0.2 1.1 0.5; do
    "$program" run case.toml "${settings[@]}" --out killed --checkpoint-every 0.02 >/dev/null 2>&1 </dev/null &
    child=$!
    sleep "$delay"
    if kill -KILL "$child" 2>/dev/null; then
        killed=$((killed + 1))
    fi
    wait "$child" 2>/dev/null || true
done
expect "it was killed more than once" test "$killed" -gt 1
expect "a checkpoint is left" test -s "killed/$checkpoint"
# As if the program had been killed while writing a checkpoint.
cp "killed/$checkpoint" "killed/.$checkpoint.123.4.part"
delabole run case.toml "${settings[@]}" --out killed
expect_status 0
expect_error "going on from killed/$checkpoint"
expect "the same bytes" same_answers whole killed
expect "the checkpoint is gone" test ! -e "killed/$checkpoint"
expect_no_leftovers killed

title "Ctrl-C leaves a checkpoint and says how to go on"
setsid "$program" run case.toml "${settings[@]}" --out stopped >"$scratch/out" 2>"$scratch/err" </dev/null &
child=$!
sleep 0.7
kill -s INT -- "-$child"
status=0
wait "$child" || status=$?
expect_status 4
expect_error "the same command goes on from stopped/$checkpoint"
expect "the checkpoint is there" test -s "stopped/$checkpoint"
expect "the report says so" contains stopped/report.html Interrupted
cp -r stopped other
delabole run case.toml "${settings[@]}" --out stopped
expect_status 0
expect "the same bytes" same_answers whole stopped

title "a checkpoint of another case is neither used nor lost"
cp "other/$checkpoint" kept
delabole run case.toml "${settings[@]}" --set scene.density="2500 kg/m3" --out other
expect_status 5
expect_error "other/$checkpoint: what an interrupted run has left there belongs to another case, or to this one with other values, and would be lost"
expect "it is as it was" cmp kept "other/$checkpoint"
expect "so is the report" contains other/report.html Interrupted
"$program" init plane_failure --out plane.toml
delabole run plane.toml --out other
expect_status 0
expect "a model without checkpoints leaves it" cmp kept "other/$checkpoint"
delabole run case.toml "${settings[@]}" --out other
expect_status 0
expect_error "going on from other/$checkpoint"
expect "the same bytes" same_answers whole other
expect "it is gone in the end" test ! -e "other/$checkpoint"

title "what is no checkpoint is said so, and the run starts anew"
printf 'no checkpoint\n' >"other/$checkpoint"
delabole run case.toml "${settings[@]}" --out other
expect_status 0
expect_error "$checkpoint is not a checkpoint of dynamic relaxation: the run starts anew"
expect "it is gone in the end" test ! -e "other/$checkpoint"

finish
