#!/usr/bin/env bash
# The reports that the program writes, opened in a browser at the width of a desktop and of a phone: no message on the
# console, all figures present, no sideways scrolling; and their parts in order. REPORTS_SCREENSHOTS names a folder for
# screenshots, of reports of engineers' other jobs as well.
source "$(dirname "${BASH_SOURCE[0]}")/harness.sh"

write_good_case good.toml
printf '\n[critical]\nfind = "failure_plane"\nunder = "given_water"\n' >>good.toml

title "fit of the Delabole failure"
if [[ -n ${REPORTS_SCREENSHOTS:-} ]]; then
    quick_fit=()
fi
delabole fit "$source_folder/cases/delabole_1967/delabole_1967.toml" --out fit "${quick_fit[@]}"
expect_status 0
in_browser fit
expect_order fit/report.html '<section class="head' '<p>Best explanation of the 3 compared' '<nav class="contents"' '<figure>' \
    'Section before the failure and the profile left standing' '>Friction angle against water elevation</h2>' '<svg' \
    '>Mechanisms</h2>' '<div class="figures small">' '<details>' '<summary>Evidence: how it was weighed' \
    '>What to measure next</h2>' '>Conclusions held against the fit</h2>' 'What was concluded' '<details>' \
    '<summary>How each was tested' '>Sliding on the critical plane</h2>' '<details>' '<summary>Its posterior: draws and chains' \
    '>Inputs</h2>' '<summary>Provenance'
expect "each conclusion that is not decided says what would decide it" awk '
    /^\([iv]+\).*  (undecided|not tested)  / { open += 1 }
    /^ +would decide it +[a-z]/ { said += 1 }
    END { exit !(open > 0 && said == open) }' "$scratch/out"

title "run, with a critical search, long words and markup in its texts"
delabole run good.toml --out run --set "title=<script>console.log('x')</script> & \"quotes\"" \
    --set "description=$(printf 'Unbroken%.0s' {1..60}) <img src=x onerror=alert(1)>"
expect_status 0
in_browser run
expect_order run/report.html '<section class="head' '<p>FS 1.12: stands.' '<nav class="contents"' '<figure>' '<svg' \
    'The slope and what slides.' '>Results</h2>' '>Inputs</h2>'

title "blocks in motion"
delabole run "$source_folder/cases/relaxation/free_slide.toml" --out motion
expect_status 0
expect_order motion/report.html '<section class="head' '<p>Fails: 2 m2 had begun to move' '<nav class="contents"' \
    '<div class="animation"' '>The blocks</h2>' '<details>' '<summary>Table of the blocks' '<table' '</details>' \
    '<summary>All results' '>Inputs</h2>'
expect "numbers of blocks are off" contains motion/report.html '<label><input type="checkbox">numbers</label>'

title "grid and compare"
delabole grid good.toml --vary "water.water_depth=0 m:4 m:9" --out grid
expect_status 0
in_browser grid
sed 's/^cohesion = .*/cohesion = "30 kPa"/' good.toml >other.toml
delabole compare good.toml other.toml --out compare
expect_status 0
in_browser compare

if [[ -n ${REPORTS_SCREENSHOTS:-} ]]; then
    for case in stepped_base/goodman_bray_1976_cable kinematics/road_cut_poles plane_failure/bolted_road_cut; do
        delabole run "$source_folder/cases/$case.toml" --out "${case##*/}"
        in_browser "${case##*/}"
    done
    in_browser motion
fi

finish
