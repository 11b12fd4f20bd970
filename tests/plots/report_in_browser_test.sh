#!/usr/bin/env bash
# Usage: report_in_browser_test.sh
# Tests that report_in_browser refuses what it must refuse.
set -euo pipefail
here=$(dirname "$(realpath "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0

page() {
    printf '<!DOCTYPE html>\n<html><head><title>t</title></head><body><main><h1>t</h1>%s</main></body></html>\n' "$1"
}
drawing='<figure><svg viewBox="0 0 64 45" style="width:100%"><path d="M0,0 L9,9"/></svg></figure>'

# Refused for each of the reasons. Several faults stand on a page, because a browser takes seconds to start.
expect_refused() {
    page "$1" >"$work/page.html"
    shift
    if "$here/report_in_browser" "$work/page.html" >"$work/said" 2>&1; then
        echo "accepted, in spite of: $*" >&2
        failed=1
    fi
    local message
    for message in "$@"; do
        if ! grep -q "$message" "$work/said"; then
            echo "not said: $message" >&2
            cat "$work/said" >&2
            failed=1
        fi
    done
}

page "$drawing" >"$work/page.html"
"$here/report_in_browser" "$work/page.html" || { echo "refused a good page" >&2; failed=1; }
expect_refused "$drawing<img src='https://example.org/a.png' alt=''><script>console.error('broken')</script>
<script>nothing()</script><script>setTimeout(() => late(), 0)</script>" \
    'outside itself' 'console is not empty' '"broken"' 'nothing is not defined' 'late is not defined'
expect_refused "$drawing
<figure>Figure missing</figure>
<figure><svg width='0' height='0'><path d='M0,0 L9,9'/></svg></figure>
<div class='answer'><p>1<p>2<p>3<p>4</div><p id='a'></p><p id='a'></p>
<style>
    main { max-width: 800px; }
    @media (max-width: 400px) { .described td { width: 3rem; } }
    @media print { td.number { width: 1rem; } }
</style>
<div style='width:850px'>wide</div>
<div style='overflow: hidden'><table><tr><td style='min-width: 500px'>cut off on a phone</td></tr></table></div>
<div style='overflow: auto'><table><tr><td style='min-width: 750px'>cut off on paper</td></tr></table></div>
<div style='overflow: auto'><table><tr><td style='min-width: 1500px'>scrolls on a desk</td></tr></table></div>
<table class='described'><tr><td>two words</td></tr></table>
<table><tr><td class='number'>1 km</td></tr></table>" \
    'figure 2 has no drawing' 'figure 3 measures' 'the answer has 4 sentences' 'ids are not unique' \
    'the page uses 800 px of 1400' 'px wide in a window of 390 px' 'table 1 is cut off at 374 px' \
    'table 2 is cut off at 6' 'table 3 scrolls at 800 px' 'a name of table 4 is broken' 'a number of table 5 is broken'
expect_refused "$drawing<table><caption>Two<p style='break-before: page'>pages</p></caption><tr><td>1</td></tr></table>
<h2>Alone</h2><p style='break-before: page'>text</p>" \
    'not on one page (a4): Twopages' 'alone at the foot of a page (a4): page 2: Alone'
exit "$failed"
