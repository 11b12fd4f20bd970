#!/usr/bin/env bash
# Usage: report_in_browser_test.sh
# report_in_browser has to refuse what it is there to refuse.
set -euo pipefail
here=$(dirname "$(realpath "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0

page() {
    printf '<!DOCTYPE html>\n<html><head><title>t</title></head><body><main><h1>t</h1>%s</main></body></html>\n' "$1"
}
drawing='<figure><svg viewBox="0 0 64 45" style="width:100%"><path d="M0,0 L9,9"/></svg></figure>'

expect_refused() {
    local why=$1 message=$2
    page "$3" >"$work/page.html"
    if "$here/report_in_browser" "$work/page.html" >"$work/said" 2>&1; then
        echo "accepted: $why" >&2
        failed=1
    elif ! grep -q "$message" "$work/said"; then
        echo "refused, but not because of: $why" >&2
        cat "$work/said" >&2
        failed=1
    fi
}

page "$drawing" >"$work/page.html"
"$here/report_in_browser" "$work/page.html" || { echo "refused a good page" >&2; failed=1; }
expect_refused "console error" "console is not empty" "$drawing<script>console.error('broken')</script>"
expect_refused "script error" "console is not empty" "$drawing<script>nothing()</script>"
expect_refused "missing drawing" "figure 2 has no drawing" "$drawing
<figure>Figure missing</figure>"
expect_refused "drawing without size" "figure 1 measures" \
    '<figure><svg width="0" height="0"><path d="M0,0 L9,9"/></svg></figure>'
expect_refused "sideways scrolling on a phone" "px wide in a window of 390 px" "$drawing<div style='width:800px'>wide</div>"
expect_refused "a desk half empty" "the page uses" "$drawing<style>main { max-width: 800px; }</style>"
expect_refused "a long answer" "the answer has 4 sentences" "$drawing<div class='answer'><p>1<p>2<p>3<p>4</div>"
expect_refused "a table cut off on a phone" "table 1 is cut off at" \
    "$drawing<div style='overflow: hidden'><table><tr><td style='min-width: 500px'>wide</td></tr></table></div>"
expect_refused "a table cut off on paper" "problems found (a4)" \
    "$drawing<div style='overflow: auto'><table><tr><td style='min-width: 900px'>wide</td></tr></table></div>"
expect_refused "a table that scrolls on a desk" "table 1 scrolls at" \
    "$drawing<div style='overflow: auto'><table><tr><td style='min-width: 1500px'>wide</td></tr></table></div>"
expect_refused "a broken name on a phone" "a name of table 1 is broken" "$drawing<style>
    @media (max-width: 400px) { td { width: 3rem; } }</style><table class='described'><tr><td>two words</td></tr></table>"
expect_refused "a broken number on paper" "a number of table 1 is broken" "$drawing<style>
    @media print { td { width: 1rem; } }</style><table><tr><td class='number'>1 km</td></tr></table>"
expect_refused "a caption on two pages" "not on one page (a4): Twopages" \
    "$drawing<table><caption>Two<p style='break-before: page'>pages</p></caption><tr><td>1</td></tr></table>"
expect_refused "a heading alone at the foot of a page" "alone at the foot of a page (a4): page 1: Alone" \
    "$drawing<h2>Alone</h2><p style='break-before: page'>text</p>"
expect_refused "ids used twice" "ids are not unique" "$drawing<p id='a'></p><p id='a'></p>"
expect_refused "something fetched" "outside itself" "$drawing<img src='https://example.org/a.png' alt=''>"
exit "$failed"
