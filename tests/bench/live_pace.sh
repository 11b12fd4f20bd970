#!/usr/bin/env bash
# Measures the pace of the page of `delabole live` in headless Chromium: the median and the slowest of fifty times, ms,
# from a drag to its picture, for a case of each model with handles; frames a second of blocks in motion.
export DELABOLE_SOURCE=${DELABOLE_SOURCE:-$(realpath "$(dirname "${BASH_SOURCE[0]}")/../..")}
export DELABOLE_BUILD=${DELABOLE_BUILD:-$DELABOLE_SOURCE/build/release}
source "$DELABOLE_SOURCE/tests/program/harness.sh"
source "$DELABOLE_SOURCE/tests/program/browser.sh"

open_case() {
    serve "$1"
    open_browser 1400 900
    visit "$address"
    wait_for "document.body && document.body.dataset.ready === 'yes'"
}

close_case() {
    close_browser
    kill -INT "$server"
    wait "$server" || true
}

for case in plane_failure/fig_2_8.toml starting/stepped_base.toml starting/kinematics.toml \
    starting/fit.toml; do
    open_case "$source_folder/cases/$case"
    evaluate "(async () => {
        const drawn = document.querySelector('.handle'), box = drawn.getBoundingClientRect(), times = [];
        const at = (type, to) => new PointerEvent(type, {clientX: box.x + to, clientY: box.y + to, bubbles: true});
        drawn.dispatchEvent(at('pointerdown', 0));
        for (let turn = 1; turn <= 50; ++turn) {
            const since = performance.now(), old = state.answer;
            window.dispatchEvent(at('pointermove', turn % 20));
            while (state.answer === old) await new Promise(requestAnimationFrame);
            times.push(performance.now() - since);
        }
        window.dispatchEvent(at('pointerup', 0));
        times.sort((a, b) => a - b);
        return times[25].toFixed(0) + ' ms, at most ' + times[49].toFixed(0) + ' ms';
    })()"
    echo "$case: $value"
    close_case
done

# All of a thousand bricks slide on a plane.
brick() {
    printf '[[scene.block]]\ndensity = "2700 kg/m3"\n%s\nvertex = [' "${5:-}"
    printf '{ x = "%s m", y = "%s m" }, ' "$1" "$2" "$3" "$2" "$3" "$4" "$1" "$4"
    printf ']\n'
}
{
    printf 'schema = 1\nmodel = "relaxation"\ntitle = "Bricks"\n[scene]\nkind = "blocks"\ntilt = "35 deg"\n'
    printf 'joint = [{ friction_angle = "30 deg" }]\n'
    brick -200 -1 60 0 'hold = "fixed"'
    for row in {0..24}; do
        for column in {0..39}; do
            brick "$column" "$row" $((column + 1)) $((row + 1))
        done
    done
} >bricks.toml
open_case bricks.toml
evaluate "(async () => {
    find('play').click();
    let pictures = 0, since = performance.now();
    const first = motion.picture.steps;
    for (let old = motion.picture; performance.now() - since < 10000; await new Promise(requestAnimationFrame))
        if (motion.picture !== old) { ++pictures; old = motion.picture; }
    find('play').click();
    return motion.blocks.length + ' blocks: ' + (pictures / 10).toFixed(1) + ' pictures a second of ' +
        ((motion.picture.steps - first) / pictures).toFixed(0) + ' steps each';
})()"
echo "$value"
close_case
finish
