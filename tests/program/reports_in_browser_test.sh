#!/usr/bin/env bash
# The reports that the program writes, opened in a browser at the width of a desktop and of a phone: no message on the
# console, all figures present, no sideways scrolling. REPORTS_SCREENSHOTS names a folder for screenshots.
source "$(dirname "${BASH_SOURCE[0]}")/harness.sh"

write_good_case good.toml
printf '\n[critical]\nfind = "failure_plane"\nunder = "given_water"\n' >>good.toml

title "fit of the Delabole failure"
delabole fit "$source_folder/cases/delabole_1967/delabole_1967.toml" --out fit
expect_status 0
in_browser fit

title "run, with a critical search"
delabole run good.toml --out run
expect_status 0
in_browser run

title "grid and compare"
delabole grid good.toml --vary "water.water_depth=0 m:4 m:9" --out grid
expect_status 0
in_browser grid
sed 's/^cohesion = .*/cohesion = "30 kPa"/' good.toml >other.toml
delabole compare good.toml other.toml --out compare
expect_status 0
in_browser compare

title "the page of a case with long words and markup in its texts"
delabole run good.toml --out markup --set "title=<script>console.log('x')</script> & \"quotes\"" \
    --set "description=$(printf 'Unbroken%.0s' {1..60}) <img src=x onerror=alert(1)>"
expect_status 0
in_browser markup

finish
