#!/usr/bin/env bash
# Usage: animation_in_browser_test.sh
# The animation of the sample report, used as its reader does: buttons, slider and keys in headless Chromium, with and
# without the wish for less motion, and with scripts off.
set -euo pipefail
report=$DELABOLE_BUILD/tests/plots/sample/report.html
[[ -s $report ]] || { echo "no sample report at $report" >&2; exit 1; }
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || {
    echo "chromium is not installed" >&2
    exit 1
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0

open_page() {
    timeout 300 "$browser" --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --no-first-run \
        --disable-background-networking --disable-component-update --disable-sync --disable-extensions \
        --user-data-dir="$work/profile" --dump-dom "$@" 2>/dev/null
}

# The test sets this clock itself; it replaces the browser's before the page's own script requests pictures.
cat >"$work/clock.js" <<'SCRIPT'
let now = 1000, pending = null;
window.requestAnimationFrame = picture => { pending = picture; return 1; };
window.cancelAnimationFrame = () => { pending = null; };
const tick = () => {
    const picture = pending;
    pending = null;
    now += 20;
    if (picture) picture(now);
};
SCRIPT

# This script does what a reader does, and writes what is wrong into the page.
cat >"$work/hands.js" <<'SCRIPT'
const wrong = [];
const box = document.querySelector('.animation'), moment = box.querySelector('.moment');
const [back, play, step] = box.querySelectorAll('button');
const scrub = box.querySelector('input'), speed = box.querySelector('select');
const expect = (what, found, wanted) => {
    if (found !== wanted) wrong.push(what + ': ' + found + ' instead of ' + wanted);
};
const frame = () => Number(/frame (\d+) of 60/.exec(moment.textContent)[1]);
// Numbers instead of their spelling: 2.50 is 2.5.
const numbers = element => (element.getAttribute('transform').match(/[-\d.]+/g) || []).map(Number).join(' ');
const picture = () => [...box.querySelectorAll('.scene, .scene > g')].map(
    part => numbers(part) + ' ' + part.getAttribute('fill')).join('\n');
const key = name => box.dispatchEvent(new KeyboardEvent('keydown', {key: name, bubbles: true, cancelable: true}));
expect('controls are hidden', box.querySelector('.controls').hidden, false);
expect('at first', frame(), 60);
const force = box.querySelector('.force'), bar = box.querySelector('.bar');
expect('the bar at the end', force.textContent + ' ' + bar.classList, '60 kN/m, yielded bar yielded');
const last = picture();
key('Home');
expect('after Home', frame(), 1);
expect('the bar at first', force.textContent + ' ' + bar.classList, '0 kN/m bar');
expect('text of frame 1', moment.textContent, 'time 0 s, tilt 21.8\u00b0, frame 1 of 60');
const first = picture();
if (first === last) wrong.push('the picture does not change');
key('ArrowLeft');
expect('before the first', frame(), 1);
step.click();
expect('after a step', frame(), 2);
expect('slider', scrub.value, '1');
key('ArrowRight');
back.click();
back.click();
expect('two forward, two back', frame(), 1);
expect('frame 1, come back', picture(), first);
scrub.value = 30;
scrub.dispatchEvent(new Event('input'));
expect('after scrubbing', frame(), 31);
key('End');
expect('after End', frame(), 60);
expect('the last frame, come back', picture(), last);

expect('speeds', speed.options.length, 8);
expect('the chosen speed', speed.value, '0.2');
speed.value = '2';
play.click();
expect('button while it plays', play.textContent, 'Pause');
expect('it starts anew at', frame(), 1);
tick();
key(' ');
expect('button after the space bar', play.textContent, 'Play');
tick();
expect('frame while it rests', frame(), 1);
play.click();
// 1.01 s of the model: frames are 0.05 s apart. Whoever wants less motion sees a picture every half second.
const calm = matchMedia('(prefers-reduced-motion: reduce)').matches;
let pictures = 0, before = frame(), ticks = 0;
const watch = () => {
    tick();
    ++ticks;
    if (frame() !== before) ++pictures;
    before = frame();
};
while (ticks < 26) watch();
expect('frame after half a second', frame(), 21);
expect('pictures after half a second', pictures, calm ? 1 : 20);
while (play.textContent === 'Pause' && ticks < 1000) watch();
expect('frame at the end', frame(), 60);
// 2.95 s at twice their speed, or up to half a second later.
if (ticks < 73 || ticks > (calm ? 102 : 77)) wrong.push('it played for ' + ticks + ' ticks of 20 ms');
document.body.insertAdjacentHTML('beforeend', '<p id="findings"></p>');
document.getElementById('findings').textContent =
    'calm=' + calm + ' problems=' + wrong.length + '\n' + wrong.join('\n') + '\nend of findings';
SCRIPT
{
    printf '<script>\n'
    cat "$work/clock.js"
    printf '</script>\n'
    cat "$report"
    printf '<script>\n'
    cat "$work/hands.js"
    printf '</script>\n'
} >"$work/used.html"

expect_no_problems() { # calm, option ...
    local calm=$1 findings
    shift
    findings=$(open_page "$@" "file://$work/used.html" | sed -n '/<p id="findings">calm/,/end of findings/p')
    if [[ $findings != *"calm=$calm problems=0"* ]]; then
        echo "animation: ${findings:-no findings}" >&2
        failed=1
    fi
}
expect_no_problems false
expect_no_problems true --force-prefers-reduced-motion

# A browser without scripts shows the last frame and its moment, but no buttons without effect.
sed 's/<script>/<script type="text\/plain">/' "$report" >"$work/plain.html"
plain=$(open_page "file://$work/plain.html")
for expected in 'frame 60 of 60' 'class="controls" hidden' 'Outcome: collapse' 'class="scene"'; do
    if [[ $plain != *"$expected"* ]]; then
        echo "animation: without scripts there is no $expected" >&2
        failed=1
    fi
done
exit "$failed"
