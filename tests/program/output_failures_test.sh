#!/usr/bin/env bash
# Exit code 5: if a result cannot be written or does not reach its reader, there is one clear message, no incomplete
# file, and no result.json for results that are missing.
source "$(dirname "${BASH_SOURCE[0]}")/harness.sh"

write_good_case good.toml
write_good_fit good_fit.toml

# cannot_write WHERE MESSAGE: run, fit and reproduce all end with the message.
cannot_write() {
    local folder=$1 message=$2
    for arguments in "run good.toml" "fit good_fit.toml" "reproduce dry_friction"; do
        # shellcheck disable=SC2086
        delabole $arguments --out "$folder"
        expect_status 5
        expect_silence out
        expect_error "delabole: cannot write $message"
        expect_one_line_of_error
    done
}

title "the folder for the results is a file"
echo precious >file
cannot_write file "file: "
expect "the file is as it was" test "$(cat file)" == precious

title "below a file"
cannot_write file/results "file/results: Not a directory"

title "where nobody can make a folder"
cannot_write /proc/results "/proc/results: "

title "a link to nowhere"
ln -s nowhere/deeper dangling
cannot_write dangling "dangling: "
expect "the link is as it was" test -L dangling

title "a folder stands where result.json belongs"
mkdir -p occupied/result.json
cannot_write occupied "occupied/result.json: it is a folder"
expect "nothing else was written" test "$(ls occupied)" == result.json

title "a folder stands where report.html belongs"
mkdir -p occupied_report/report.html
cannot_write occupied_report "occupied_report/report.html: it is a folder"
expect "no result.json: the result is not whole" refuse test -e occupied_report/result.json
expect_no_leftovers occupied_report

title "a file stands where the folder of figures belongs"
mkdir occupied_figures
echo precious >occupied_figures/figures
delabole run good.toml --out occupied_figures
expect_status 5
expect_error 'delabole: cannot write occupied_figures/figures'
expect "no result.json" refuse test -e occupied_figures/result.json
expect "the file is as it was" test "$(cat occupied_figures/figures)" == precious

if [[ $(id -u) != 0 ]]; then
    title "a folder that may not be written to"
    mkdir locked
    chmod 555 locked
    cannot_write locked/results "locked/results: Permission denied"
fi

title "a failed second run does not leave the first one's result.json beside new files"
delabole run good.toml --out twice --quiet
expect_status 0
rm twice/report.html
mkdir twice/report.html
delabole run good.toml --set 'slope.height=13 m' --out twice --quiet
expect_status 5
expect "no result.json" refuse test -e twice/result.json

title "a file of somebody else is not replaced by a result's of the same name"
mkdir mine
for name in report.html resolved.toml; do
    echo precious >"mine/$name"
    delabole run good.toml --out mine --quiet
    expect_status 5
    expect_error "delabole: cannot write mine/$name: it was not written by delabole, which would replace it"
    expect "the file is as it was" test "$(cat "mine/$name")" == precious
    expect "nothing else was written" test "$(ls mine)" == "$name"
    rm "mine/$name"
done

title "init does not overwrite, and says why it cannot write"
delabole init plane_failure --out file
expect_status 5
expect_error 'delabole: cannot write file: it exists already and is not overwritten'
expect "the file is as it was" test "$(cat file)" == precious
delabole init plane_failure --out dangling
expect_status 5
expect "the link is as it was" test -L dangling
ln -s loop loop
delabole init plane_failure --out loop
expect_status 5
expect_error 'delabole: cannot write loop: '
expect_one_line_of_error
mkdir linked
ln -s linked/slope.toml link
delabole init plane_failure --out link
expect_status 0
expect "the link is followed" test -s linked/slope.toml -a -L link
delabole init plane_failure --out missing_folder/slope.toml
expect_status 5
expect_error 'delabole: cannot write missing_folder/slope.toml: No such file or directory'
expect_one_line_of_error

title "standard output is full: /dev/full"
for arguments in "run good.toml" "fit good_fit.toml --json" "check good.toml" "show good.toml" "init plane_failure" \
    "verify $source_folder/cases/plane_failure" "reproduce dry_friction" --help --version "run --help"; do
    status=0
    # shellcheck disable=SC2086
    "$program" $arguments >/dev/full 2>"$scratch/err" </dev/null || status=$?
    : >"$scratch/out"
    expect_status 5
    expect_error 'delabole: cannot write to standard output'
done
expect_complete_results results/good
expect_complete_results results/good_fit_fit

title "standard output is closed, and so are the others: nothing ends up in the results"
rm -rf results
delabole run good.toml --out reference
expect_status 0
status=0
"$program" run good.toml --out closed >&- 2>"$scratch/err" </dev/null || status=$?
: >"$scratch/out"
expect_status 5
expect_error 'delabole: cannot write to standard output'
expect_complete_results closed
status=0
"$program" run good.toml --out closed_all >&- 2>&- <&- || status=$?
: >"$scratch/err"
expect_status 5
expect_complete_results closed_all
status=0
"$program" run good.toml --out closed_quiet --quiet >&- 2>&- <&- || status=$?
expect_status 0
expect_complete_results closed_quiet
expect "the same files" test "$(cd reference && find . | sort)" == "$(cd closed_all && find . | sort)"
expect "the same tables" cmp reference/results.csv closed_all/results.csv
expect "the same figures" cmp reference/figures/section.svg closed_all/figures/section.svg

# A full disk: all three commands on a disk with room for the first files only.
fits_on() {
    local disk=$1 arguments=$2
    # shellcheck disable=SC2086
    delabole $arguments --out "$disk/results"
    expect_status 5
    expect_silence out
    expect_error "delabole: cannot write $disk/results/"
    expect_error "$3"
    expect "no result.json" refuse test -e "$disk/results/result.json"
    expect_no_leftovers "$disk/results"
    local page
    for page in "$disk"/results/*.html; do
        [[ ! -e $page ]] || expect "the report is whole" contains "$page" "</html>"
    done
}

title "the disk is full"
mkdir disk
if mount -t tmpfs -o size=64k tmpfs disk 2>"$scratch/mount"; then
    trap 'umount "$work/disk"; rm -rf "$scratch"' EXIT
    for arguments in "run good.toml" "fit good_fit.toml" reproduce; do
        rm -rf disk/*
        fits_on disk "$arguments" "No space left on device"
    done
    title "the disk is full, and an earlier result is there"
    rm -rf disk/*
    head -c 40960 /dev/zero >disk/ballast
    delabole init plane_failure --out disk/slope.toml
    expect_status 0
    cp disk/slope.toml before.toml
    head -c 65536 /dev/zero >disk/more 2>/dev/null || true
    delabole init plane_failure --out disk/other.toml
    expect_status 5
    expect_error "delabole: cannot write disk/other.toml: No space left on device"
    expect "no half a file" refuse test -e disk/other.toml
    expect "the other file is as it was" cmp disk/slope.toml before.toml
    expect_no_leftovers disk
else
    echo "  cannot mount a small disk here ($(cat "$scratch/mount")); a limit on the size of files instead"
fi
# File sizes are limited to 16 kB, which is less than the report needs.
title "files must not grow"
for arguments in "run good.toml" "fit good_fit.toml" reproduce; do
    status=0
    # shellcheck disable=SC2086
    (
        trap '' XFSZ
        ulimit -f 16
        exec "$program" $arguments --out limited --quiet
    ) >"$scratch/out" 2>"$scratch/err" </dev/null || status=$?
    expect_status 5
    expect_error "delabole: cannot write limited/"
    expect_error ": File too large"
    expect_one_line_of_error
    expect "no result.json" refuse test -e limited/result.json
    expect "no report" refuse test -e limited/report.html
    expect_no_leftovers limited
done

finish
