#!/usr/bin/env bash
# delabole live: which requests are answered and which are refused, and what the page does when it is used.
source "$DELABOLE_SOURCE/tests/program/harness.sh"
source "$DELABOLE_SOURCE/tests/program/browser.sh"

end_server() {
    local from
    from=$(date +%s%3N)
    kill -INT "$server"
    status=0
    wait "$server" || status=$?
    waited=$(($(date +%s%3N) - from))
    expect "Ctrl-C ends it with exit code ${1:-0}" test "$status" == "${1:-0}"
}

# raw TEXT: sends the text unchanged; the answer is then in $scratch/answer and its status in $code.
raw() {
    exec 9<>"/dev/tcp/127.0.0.1/$port"
    # If a request is refused before it was read completely, nobody reads the rest of it.
    (trap '' PIPE && printf '%b' "$1" >&9) 2>/dev/null || true
    timeout 300 cat <&9 >"$scratch/answer" || true
    exec 9>&- 9<&-
    code=$(head -n 1 "$scratch/answer" | cut -d ' ' -f 2)
}

# post PATH BODY [HEADER...]: sends what the page would send; a given header replaces that of the page.
post() {
    local path=$1 body=$2 headers=""
    shift 2
    local host="Host: 127.0.0.1:$port" key="X-Delabole-Token: $token" header
    for header in "$@"; do
        case $header in
        Host:*) host=$header ;;
        X-Delabole-Token:*) key=$header ;;
        *) headers+="$header\r\n" ;;
        esac
    done
    raw "POST $path HTTP/1.1\r\n$host\r\n$key\r\n${headers}Content-Length: ${#body}\r\nConnection: close\r\n\r\n$body"
}

expect_code() {
    checks=$((checks + 1))
    [[ $code == "$1" ]] || fail "$2: status $code instead of $1"
}

write_good_case case.toml
sed -i 's/^height = "12 m"/height = "12 m"  # measured in 2024/' case.toml

title "who is answered"
serve case.toml
post /open '{}'
expect_code 200 "the page itself"
expect "the case is described" contains "$scratch/answer" '"name":"strength.friction_angle"'
raw "GET / HTTP/1.1\r\nHost: 127.0.0.1:$port\r\nConnection: close\r\n\r\n"
expect_code 200 "the page"
expect "the page holds no token" refuse contains "$scratch/answer" "$token"
expect "nothing is loaded from elsewhere" refuse grep -qE '(src|href)="https?:' "$scratch/answer"
expect "scripts need a nonce" grep -qiE "content-security-policy: default-src 'none'; script-src 'nonce-[0-9a-f]{32}'" "$scratch/answer"
post /open '{}' "X-Delabole-Token: 00000000000000000000000000000000"
expect_code 401 "another token"
post /open '{}' "X-Delabole-Token: "
expect_code 401 "no token"
post /open '{}' "Host: delabole.example:$port"
expect_code 403 "another name that leads here (DNS rebinding)"
post /open '{}' "Host: localhost:$port"
expect_code 403 "another name of this machine"
post /open '{}' "Origin: http://example.org"
expect_code 403 "a page from elsewhere"
post /open '{}' "Origin: null"
expect_code 403 "a page of a file"
post /open '{}' "Origin: http://127.0.0.1:$port"
expect_code 200 "its own page"
raw "OPTIONS /open HTTP/1.1\r\nHost: 127.0.0.1:$port\r\nOrigin: http://example.org\r\nAccess-Control-Request-Method: POST\r\nConnection: close\r\n\r\n"
expect_code 403 "a question of a browser on behalf of another page"
post /../../etc/passwd '{}'
expect_code 404 "a path out of it"
raw "GET /etc/passwd HTTP/1.1\r\nHost: 127.0.0.1:$port\r\nConnection: close\r\n\r\n"
expect_code 404 "another path"

expect "the terminal says that requests were refused" contains "$scratch/served_err" "a request was refused with status 401: it had not the token"
expect "but not each" test "$(wc -l <"$scratch/served_err")" -lt 9

title "what is refused"
post /answer 'not JSON'
expect_code 400 "what is not JSON"
post /answer '[]'
expect_code 200 "a request without values asks for the case as it is"
post /answer '{"values":{"slope.heigth":12}}'
expect_code 400 "an unknown input"
expect "it is named" contains "$scratch/answer" "slope.heigth"
post /answer '{"values":{"slope.face_dip":190}}'
expect_code 400 "a value out of its range"
expect "the range is said" contains "$scratch/answer" "90 deg"
post /answer '{"values":{"slope.face_dip":"60"}}'
expect_code 400 "a text for a number"
post /map '{"x":{"name":"strength.friction_angle","lower":1,"upper":60},"y":{"name":"water.water_depth","lower":0,"upper":4},"output":"factor_of_safety","columns":100000,"rows":100000}'
expect_code 400 "a map without end"
post /motion/step '{"steps":1}'
expect_code 400 "motion of a slope that has no blocks"
big=$(head -c 300000 /dev/zero | tr '\0' ' ')
post /answer "$big"
expect_code 413 "a body of 300 kB"
raw "POST /answer HTTP/1.1\r\nHost: 127.0.0.1:$port\r\nContent-Length: 99\r\n\r\n{"
expect "who says nothing more is not waited for" test -n "$port"
# Requests that must not be read: a body of any length, which a client without the token could send, and a page a
# thousand times in one answer.
raw "POST /answer HTTP/1.1\r\nHost: 127.0.0.1:$port\r\nX-Delabole-Token: $token\r\nTransfer-Encoding: chunked\r\nConnection: close\r\n\r\n2\r\n{}\r\n0\r\n\r\n"
expect_code 400 "a body in parts, whose length nobody knows"
post /answer '{}' "Content-Encoding: gzip"
expect_code 400 "a compressed body"
raw "GET / HTTP/1.1\r\nHost: 127.0.0.1:$port\r\nRange: bytes=0-,1-,2-\r\nConnection: close\r\n\r\n"
expect_code 400 "parts of an answer"
post /map '{"x":{"name":"strength.friction_angle","lower":1,"upper":60},"y":{"name":"water.water_depth","lower":0,"upper":4},"output":"factor_of_safety","columns":1e300,"rows":2}'
expect_code 400 "a number of columns that is none"
post /answer '{}'
expect_code 200 "it still answers"

title "the same numbers as delabole run"
post /answer '{"values":{"strength.friction_angle":30}}'
"$program" run case.toml --set 'strength.friction_angle=30 deg' --no-report --out plain >plain.txt
factor=$(sed -nE 's/^factor_of_safety +//p' plain.txt)
expect "a factor of safety of $factor" contains "$scratch/answer" "\"text\":\"$factor\""

title "a case is saved with its comments"
post /save '{"values":{"slope.height":13.5,"strength.friction_angle":31}}'
expect "the new height stands before its comment" contains "$scratch/answer" 'height = \"13.5 m\"  # measured in 2024'
expect "the friction angle too" contains "$scratch/answer" 'friction_angle = \"31 deg\"'
expect "the rest is as it was" contains "$scratch/answer" 'title = \"A slope that is in order\"'

title "as a person uses it"
open_browser 1400 900
visit "$address"
wait_for "document.body && document.body.dataset.ready === 'yes'"
expect_value "the verdict" "document.getElementById('verdict').textContent.startsWith('FS 1.2')" true
expect_value "the rest of the answer below it" "find('sentences').children.length > 0" true
expect_value "what colours and dashes mean" "[...document.querySelectorAll('#sections .legend li')].some(one => one.textContent === 'failure plane')" true
expect_value "handles of toe, crest, plane, crack and water" "document.querySelectorAll('.handle').length" 5
evaluate "(async () => {
    const box = document.querySelector('[data-name=\"water level\"]').getBoundingClientRect(), before = find('verdict').textContent;
    const at = (type, dy) => new PointerEvent(type, {clientX: box.x + box.width / 2, clientY: box.y + box.height / 2 + dy, bubbles: true});
    document.querySelector('[data-name=\"water level\"]').dispatchEvent(at('pointerdown', 0));
    for (let turn = 1; turn <= 20; ++turn) {
        const old = state.answer;
        window.dispatchEvent(at('pointermove', 2 * turn));
        while (state.answer === old) await new Promise(requestAnimationFrame);
    }
    window.dispatchEvent(at('pointerup', 40));
    return find('verdict').textContent !== before && state.values['water.water_depth'] < 3;
})()"
expect "the water level follows a drag, and the verdict with it" test "$value" == true
expect_value "let go at once, the picture is that of the slope where it was let go" "(async () => {
    let wrong = 0;
    for (let turn = 0; turn < 10; ++turn) {
        const box = document.querySelector('[data-name=\"water level\"]').getBoundingClientRect();
        const at = (type, dy) => new PointerEvent(type, {clientX: box.x + box.width / 2, clientY: box.y + box.height / 2 + dy, bubbles: true});
        const before = JSON.stringify(state.values);
        document.querySelector('[data-name=\"water level\"]').dispatchEvent(at('pointerdown', 0));
        window.dispatchEvent(at('pointermove', turn % 2 ? -20 : 20));
        window.dispatchEvent(at('pointerup', 0));
        let right = false;
        for (let waited = 0; !right && waited < 100; ++waited) {
            await new Promise(done => setTimeout(done, 100));
            right = JSON.stringify(state.values) !== before && state.answer.verdict === (await ask('/answer', {values: state.values})).verdict;
        }
        wrong += !right;
        find('undo').click();
        await refresh();
    }
    return wrong;
})()" 0
expect_value "undo" "(find('undo').click(), 'water.water_depth' in state.values)" false
expect_value "redo" "(find('redo').click(), state.values['water.water_depth'] < 3)" true
expect_value "an arrow key moves a handle" "(async () => {
    const old = state.values['slope.height'];
    document.querySelector('[data-name=crest]').dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowUp', bubbles: true}));
    while (state.values['slope.height'] === old) await new Promise(requestAnimationFrame);
    return state.values['slope.height'] > 12;
})()" true
expect_value "a click on a handle leaves nothing to undo" "(() => {
    const before = state.past.length;
    document.querySelector('[data-name=crest]').dispatchEvent(new PointerEvent('pointerdown', {bubbles: true}));
    window.dispatchEvent(new PointerEvent('pointerup', {bubbles: true}));
    return state.past.length - before;
})()" 0
expect_value "a key of a slider is undone like a drag" "(async () => {
    const slider = state.inputs.get('strength.cohesion').slider, before = state.past.length;
    for (const key of ['Home', 'PageUp', 'ArrowLeft', 'Tab']) slider.dispatchEvent(new KeyboardEvent('keydown', {key, bubbles: true}));
    return state.past.splice(before).length;
})()" 3
expect_value "a handle says its value" "document.querySelector('[data-name=toe]').getAttribute('aria-valuenow')" '"100"'
expect_value "within its range" "[...document.querySelectorAll('.handle')].every(one => Number(one.getAttribute('aria-valuemin')) <= Number(one.getAttribute('aria-valuenow')) && Number(one.getAttribute('aria-valuenow')) <= Number(one.getAttribute('aria-valuemax')))" true
expect_value "a variant beside it" "(find('name').value = 'steeper', find('keep').click(), document.querySelectorAll('#sections figure').length)" 2
expect_value "columns of numbers have heads" "[...find('results').tHead.rows[0].cells].map(one => one.textContent).join()" '"result,now,steeper"'
expect_value "by its name" "document.querySelectorAll('#sections figcaption')[1].textContent.startsWith('steeper: FS ')" true
expect_value "two variants, the second without a name" "(async () => {
    find('restore').click();
    await refresh();
    find('keep').click();
    find('beside').value = 'steeper';
    find('beside').dispatchEvent(new Event('change'));
    find('return').click();
    await refresh();
    find('beside').value = 'variant 2';
    find('beside').dispatchEvent(new Event('change'));
    const [now, other] = [...find('results').tBodies[0].rows].find(row => row.cells[0].textContent === 'factor of safety').querySelectorAll('.number');
    return state.values['slope.height'] > 12 && now.textContent !== other.textContent;
})()" true
wait_for "document.querySelector('#chart svg .here')"
expect_value "the line of a factor of 1" "document.querySelector('#chart svg title').textContent" '"factor of safety 1"'
typed="async (name, text) => {
    const box = state.inputs.get(name).number;
    box.value = text;
    box.dispatchEvent(new Event('change'));
    await refresh();
    return box.value;
}"
expect_value "an emptied field has its value again" "($typed)('strength.cohesion', '')" '"25"'
expect_value "what is refused has no verdict" "($typed)('slope.face_dip', '190').then(() => find('verdict').textContent)" \
    '"slope.face_dip = 190 deg: must be more than 0 and at most 90 deg"'
expect_value "and no results; the section is said to be older" "document.querySelector('#sections figcaption').textContent + find('results').tBodies[0].rows.length" '"The slope before this change.0"'
expect_value "undone, it has" "(find('undo').click(), refresh().then(() => find('verdict').textContent.startsWith('FS ')))" true
expect_value "every control has a name" "[...document.querySelectorAll('button, select, input, [role=slider]')].filter(one => !(one.textContent.trim() || one.getAttribute('aria-label') || one.labels?.length)).length" 0
[[ -z ${DELABOLE_SCREENSHOTS:-} ]] || screenshot "$DELABOLE_SCREENSHOTS/live_desk.png"
tell_browser Emulation.setDeviceMetricsOverride '{"width":390,"height":844,"deviceScaleFactor":1,"mobile":true}'
expect_value "nothing is wider than a phone" "document.documentElement.scrollWidth <= 390" true
[[ -z ${DELABOLE_SCREENSHOTS:-} ]] || screenshot "$DELABOLE_SCREENSHOTS/live_phone.png"
expect_value "the verdict is seen while the last slider is moved" "(() => {
    [...document.querySelectorAll('#inputs details')].forEach(one => { one.open = true; });
    [...state.inputs.values()].at(-1).slider.scrollIntoView({block: 'center'});
    const {top, bottom} = find('verdict').getBoundingClientRect(), slider = [...state.inputs.values()].at(-1).slider.getBoundingClientRect();
    return top >= 0 && bottom < find('picture').getBoundingClientRect().bottom && find('picture').getBoundingClientRect().bottom < slider.top;
})()" true
expect "the console is empty" test ! -s "$scratch/console"
close_browser
end_server

title "a back-analysis on the page: the valley of its misfit, and what was observed"
serve "$source_folder/cases/starting/fit.toml"
open_browser 1400 900
visit "$address"
wait_for "document.querySelector('#chart svg .here')"
expect_value "the valley" "[...document.querySelectorAll('#chart title')].filter(one => one.textContent.startsWith('valley') && one.parentElement.getAttribute('d')).length" 2
evaluate "(async () => {
    find('ask-study').click();
    while (!find('findings').children.length) await new Promise(requestAnimationFrame);
    const said = find('findings').textContent;
    change({'slope.height': 13});
    while (find('findings').children.length) await new Promise(requestAnimationFrame);
    goTo({});
    while (state.answer.verdict !== 'FS 1.54: stands.') await new Promise(requestAnimationFrame);
    return said.includes('friction angle 35.9 deg (30.9 deg to 39.6 deg with 95 %)');
})()"
expect "fitted ranges on demand, gone when the slope is another" test "$value" == true
wait_for "find('observations').tBodies[0].rows[0].cells[2].textContent === '1.54'"  # observed and predicted
[[ -z ${DELABOLE_SCREENSHOTS:-} ]] || screenshot "$DELABOLE_SCREENSHOTS/live_fit.png"
expect "the console is empty" test ! -s "$scratch/console"
close_browser
end_server

title "labels and the map of the thesis's slope"
serve "$source_folder/cases/plane_failure/fig_2_8.toml"
open_browser 1400 900
visit "$address"
apart="(() => {
    const boxes = [...document.querySelectorAll('#sections text.box')].map(one => one.getBBox());
    return boxes.length > 1 && boxes.every((one, place) => boxes.slice(place + 1).every(other =>
        one.x >= other.x + other.width || other.x >= one.x + one.width || one.y >= other.y + other.height || other.y >= one.y + one.height));
})()"
wait_for "document.querySelector('#chart svg .here')"
expect_value "no label lies on another" "$apart" true
expect_value "the map shows where there are answers" "(async () => {
    const axis = name => { const [lower, upper] = sliderRange(state.inputs.get(name)); return {name, lower, upper}; };
    const map = await ask('/map', {values: {}, x: axis(find('across').value), y: axis(find('up').value), output: 'factor_of_safety', columns: 48, rows: 36});
    const share = one => one.values.flat().filter(value => value !== null).length / one.values.flat().length;
    const [x, y] = closerRange(map, [find('across').value, find('up').value].map(valueOf));
    const closer = await ask('/map', {values: {}, x: {name: find('across').value, ...x}, y: {name: find('up').value, ...y}, output: 'factor_of_safety', columns: 48, rows: 36});
    return share(map) < 0.5 && share(closer) > 1.5 * share(map);
})()" true
tell_browser Emulation.setDeviceMetricsOverride '{"width":390,"height":844,"deviceScaleFactor":1,"mobile":true}'
wait_for "find('sections').clientWidth < 390"
expect_value "nor on a phone" "new Promise(done => setTimeout(done, 500)).then(() => $apart)" true
expect "the console is empty" test ! -s "$scratch/console"
close_browser
end_server

title "a support is designed as delabole run designs it"
cp "$source_folder/cases/starting/support.toml" .
"$program" run support.toml --no-report >plain.txt
serve support.toml
open_browser 1400 900
visit "$address"
wait_for "document.body && document.body.dataset.ready === 'yes'"
said="[find('verdict').textContent, ...[...find('sentences').children].map(one => one.textContent)].join('|')"
evaluate "$said"
IFS='|' read -ra sentences <<<"${value//\"/}"
expect "three sentences" test "${#sentences[@]}" == 3
for sentence in "${sentences[@]}"; do
    expect "run says '$sentence' too" contains plain.txt "$sentence"
done
expect_value "a pattern set by hand has no such sentence" "(async () => {
    remember();
    change({'support[1].rows': 1});
    await refresh();
    return find('sentences').firstChild.textContent.startsWith('The support is as set here');
})()" true
evaluate "(async () => { const {folder} = await ask('/report', {values: state.values}); return state.answer.verdict + '|' + folder; })()"
IFS='|' read -r verdict folder <<<"${value//\"/}"
expect "its report has that pattern: $verdict" contains "$folder/report.html" "$verdict"
expect "and designs no other" refuse contains "$folder/report.html" "the cheapest for FS"
expect_value "the cheapest is found again" "(async () => {
    find('design').click();
    while (!state.answer.verdict.startsWith('${sentences[0]}')) await new Promise(requestAnimationFrame);
    return find('sentences').firstChild.textContent.startsWith('Of 180 patterns the cheapest');
})()" true
expect_value "and undone" "(async () => { find('undo').click(); await refresh(); return state.values['support[1].rows']; })()" 1
"$program" run support.toml --no-report --set 'support[1].rows=5' --set 'support[1].spacing=2 m' --set 'support[1].length=8 m' >plain.txt
expect "what --set gives is not chosen" refuse contains plain.txt patterns
expect "the console is empty" test ! -s "$scratch/console"
close_browser
end_server

title "a case whose report is in feet"
{ cat "$source_folder/cases/starting/plane_failure.toml"; printf '\n[report]\nunits = "imperial"\n'; } >feet.toml
serve feet.toml
open_browser 1400 900
visit "$address"
wait_for "document.body && document.body.dataset.ready === 'yes'"
expect_value "inputs are in feet" "state.inputs.get('slope.height').unit + ' ' + digits(valueOf('slope.height'))" '"ft 39.37"'
expect_value "the crest's handle lies on the drawn crest, and follows the pointer" "(async () => {
    const middle = () => { const box = document.querySelector('[data-name=crest]').getBoundingClientRect(); return [box.x + box.width / 2, box.y + box.height / 2]; };
    const [x, y] = middle(), at = (type, by) => new PointerEvent(type, {clientX: x + by, clientY: y - by, bubbles: true});
    const crest = document.querySelector('#sections svg').toPicture([valueOf('slope.height') / Math.tan(Math.PI / 3), valueOf('slope.height')]);
    const shown = document.querySelector('[data-name=crest] circle');
    const off = Math.hypot(shown.getAttribute('cx') - crest[0], shown.getAttribute('cy') - crest[1]);
    const old = state.answer;
    document.querySelector('[data-name=crest]').dispatchEvent(at('pointerdown', 0));
    window.dispatchEvent(at('pointermove', 20));
    while (state.answer === old) await new Promise(requestAnimationFrame);
    const [there, up] = middle();
    window.dispatchEvent(at('pointerup', 20));
    return off < 0.1 && Math.hypot(there - x - 20, up - y + 20) < 0.5;
})()" true
expect_value "the verdict is that of metres" "(async () => { goTo({}); await refresh(); return find('verdict').textContent; })()" '"FS 1.54: stands."'
expect "the console is empty" test ! -s "$scratch/console"
close_browser
end_server

title "an engineer's jobs take as many clicks as plots/README.md says"
# job NAME CASE SCRIPT: the script, which may click and counts, answers "clicks|what is said".
job() {
    serve "$2"
    open_browser 1400 900
    visit "$address"
    wait_for "document.body && document.body.dataset.ready === 'yes'"
    evaluate "(async () => {
        let clicks = 0;
        const click = name => { ++clicks; find(name).click(); }, until = async holds => { while (!holds()) await new Promise(requestAnimationFrame); };
        const text = () => ['verdict', 'sentences', 'findings'].map(name => find(name).textContent).join(' ');
        $3
        return clicks + '|' + text();
    })()"
    expect "$1: the console is empty" test ! -s "$scratch/console"
    close_browser
    end_server
    clicks=$(sed -E 's/^"?([0-9]+)\|.*/\1/' <<<"$value")
}
study="click('ask-study'); await until(() => find('findings').children.length);"
job "a road cut" "$source_folder/cases/plane_failure/bolted_road_cut.toml" "const told = text(); $study
    if (!/FS 1.59.*cheapest for FS 1.5/.test(told)) return told;"
expect "factor of safety and bolts at once, probability after a click: $value" grep -q 'Probability of failure ' <<<"$value"
expect "one click" test "$clicks" == 1
job "a toppling slope" "$source_folder/cases/stepped_base/goodman_bray_1976_cable.toml" ""
expect "its cable: $value" grep -q 'kN/m' <<<"$value"
expect "no click" test "$clicks" == 0
job "a back-analysis" "$source_folder/cases/starting/fit.toml" "await until(() => document.querySelector('#chart svg .here')); $study"
expect "its ranges: $value" grep -q 'friction angle 35.9 deg' <<<"$value"
expect "one click" test "$clicks" == 1
job "measured poles" "$source_folder/cases/kinematics/road_cut_poles.toml" "click('more'); await until(() => find('figures').children.length);"
expect "all stereonets after one click" test "$clicks" == 1

title "a slope cut by joints: its outline and joint sets are dragged, above the blocks"
serve "$source_folder/cases/starting/jointed_slope.toml"
open_browser 1400 900
visit "$address"
wait_for "document.body && document.body.dataset.ready === 'yes'"
expect_value "points of the outline and joint sets" "document.querySelectorAll('#handles .handle').length" 6
evaluate "(async () => {
    const drawn = document.querySelector('[data-name=\"joint set columns\"]'), box = drawn.getBoundingClientRect(), old = motion.blocks;
    const at = (type, by) => new PointerEvent(type, {clientX: box.x + box.width / 2 + by, clientY: box.y + box.height / 2, bubbles: true});
    drawn.dispatchEvent(at('pointerdown', 0));
    window.dispatchEvent(at('pointermove', 30));
    while (motion.blocks === old) await new Promise(requestAnimationFrame);
    window.dispatchEvent(at('pointerup', 30));
    return state.values['scene.cut[2].trace.dip'] > -75;
})()"
expect "a joint set turns, and the slope is cut anew" test "$value" == true
expect_value "before they move they are said to be at the start" "find('verdict').textContent.startsWith('At the start')" true
evaluate "(async () => {
    goTo({});
    await refresh();
    find('play').click();
    while (!motion.said) await new Promise(requestAnimationFrame);
    await new Promise(done => setTimeout(done, 100));
    find('play').click();
    return find('verdict').textContent.replace('Collapsed: ', 'collapsed, ');
})()"
"$program" run "$source_folder/cases/starting/jointed_slope.toml" --out jointed --no-report >plain.txt
expect "what happened is said as delabole run says it: $value" contains plain.txt "${value//\"/}"
expect "it has failed" test "${value:0:12}" == '"collapsed, '
expect "the console is empty" test ! -s "$scratch/console"
close_browser
end_server

title "blocks in motion"
cp "$source_folder/cases/relaxation/two_blocks_3.toml" blocks.toml
printf '%s\n' '[[bolt]]' 'head_x = "0 m"' 'head_y = "1 m"' 'plunge = "0 deg"' 'length = "1.5 m"' 'spacing = "1 m"' \
    'axial_stiffness = "1 MN"' 'capacity = "10 kN"' >>blocks.toml
serve blocks.toml
post /motion/start '{}'
expect_code 200 "blocks are set in motion"
expect "the blocks are described" contains "$scratch/answer" '"outline"'
post /motion/step '{"steps":10}'
expect_code 200 "ten steps"
open_browser 1400 900
visit "$address"
wait_for "document.body && document.body.dataset.ready === 'yes'"
evaluate "(async () => {
    find('play').click();
    while (!(motion.picture.steps > 2000)) await new Promise(requestAnimationFrame);
    find('play').click();
    return motion.picture.time > 0 && motion.picture.poses.some(number => number !== 0);
})()"
expect "time goes on and blocks move" test "$value" == true
expect_value "the bolt comes with its force" "motion.picture.bolts.length === 6 && motion.picture.bolts[4] >= 0" true
expect_value "the energy balance has its lines" "find('energy').rows.length" 6
expect_value "and stands beside them" "find('energy').getBoundingClientRect().left >= find('stage').getBoundingClientRect().right && find('energy').getBoundingClientRect().bottom <= 900" true
expect_value "a variant of them is kept, with its picture" "(async () => {
    find('name').value = 'first';
    find('keep').click();
    const shown = find('sections').querySelector('img');
    await shown.decode();
    return find('sections').textContent.startsWith('first, after ') && shown.naturalWidth;
})()" 900
evaluate "(async () => {
    const before = motion.picture.steps, name = [...state.inputs.keys()].find(one => one.endsWith('friction_angle'));
    change({[name]: 15});
    find('step').click();
    while (motion.picture.steps === before) await new Promise(requestAnimationFrame);
    return name in state.values;
})()"
expect "friction changes while they move" test "$value" == true
[[ -z ${DELABOLE_SCREENSHOTS:-} ]] || screenshot "$DELABOLE_SCREENSHOTS/live_motion.png"
expect "the console is empty" test ! -s "$scratch/console"
close_browser
end_server

title "the water table of blocks in motion is drawn, and dragged while they move"
cp "$source_folder/cases/starting/jointed_slope.toml" water.toml
printf '%s\n' '[scene.water]' 'unit_weight = "9.81 kN/m3"' \
    'vertex = [{ x = "0 m", y = "1 m" }, { x = "12 m", y = "4 m" }, { x = "20 m", y = "5 m" }]' >>water.toml
serve water.toml
open_browser 1400 900
visit "$address"
wait_for "document.body && document.body.dataset.ready === 'yes'"
blue="(() => {
    const canvas = find('blocks'), middle = axis => (valueOf('scene.water.vertex[1].' + axis) + valueOf('scene.water.vertex[2].' + axis)) / 2;
    find('forces').checked = false;
    drawBlocks();
    const [x, y] = motion.view([middle('x'), middle('y')]).map(Math.round);
    const [red, green, blue] = canvas.getContext('2d').getImageData(x, y, 1, 1).data;
    return red === 86 && green === 180 && blue === 233;
})()"
expect_value "a blue line" "$blue" true
expect_value "joint sets have their spokes" "document.querySelectorAll('#handles .spoke').length" 2
[[ -z ${DELABOLE_SCREENSHOTS:-} ]] || screenshot "$DELABOLE_SCREENSHOTS/live_water.png"
evaluate "(async () => {
    find('play').click();
    while (!(motion.picture.steps > 200)) await new Promise(requestAnimationFrame);
    const seen = [...document.querySelectorAll('#handles .handle')].filter(one => getComputedStyle(one).display !== 'none').map(one => one.dataset.name);
    const before = motion.picture.steps, drawn = document.querySelector('[data-name=\"scene.water.vertex[2]\"]'), box = drawn.getBoundingClientRect();
    const at = (type, by) => new PointerEvent(type, {clientX: box.x + box.width / 2, clientY: box.y + box.height / 2 + by, bubbles: true});
    drawn.dispatchEvent(at('pointerdown', 0));
    window.dispatchEvent(at('pointermove', -40));
    while (!(state.values['scene.water.vertex[2].y'] > 4)) await new Promise(requestAnimationFrame);
    window.dispatchEvent(at('pointerup', -40));
    while (!(motion.picture.steps > before + 100)) await new Promise(requestAnimationFrame);
    find('play').click();
    await new Promise(done => setTimeout(done, 300));
    return seen.join();
})()"
expect "of the handles those of the water stay: $value" test "$value" == '"scene.water.vertex[1],scene.water.vertex[2],scene.water.vertex[3]"'
expect_value "the line is where it was dragged" "$blue" true
expect "the console is empty" test ! -s "$scratch/console"
close_browser
end_server

title "Ctrl-C ends it within 2 s, whatever its clients do"
serve case.toml
exec 8<>"/dev/tcp/127.0.0.1/$port"
printf 'POST /open HTTP/1.1\r\nHost: 127.0.0.1:%s\r\nX-Delabole-Token: %s\r\nContent-Length: 2\r\n\r\n{}' "$port" "$token" >&8
head -c 15 <&8 >"$scratch/answer"
expect "a browser is answered and keeps its connection" contains "$scratch/answer" "HTTP/1.1 200"
end_server
exec 8>&-
echo "  ended after $waited ms"
expect "soon, with a connection that is kept" test "$waited" -lt 3000
serve case.toml
exec 8<>"/dev/tcp/127.0.0.1/$port"
printf 'POST /open HTTP/1.1\r\nHost: 127.0.0.1:%s\r\nX-Delabole-Token: %s\r\nContent-Length: 999\r\n\r\n{' "$port" "$token" >&8
(while sleep 0.3 && printf ' ' >&8; do :; done) 2>/dev/null &
dripping=$!
sleep 0.5
end_server 4
kill "$dripping" 2>/dev/null || true
exec 8>&-
echo "  ended after $waited ms"
expect "soon, with one that never ends its request" test "$waited" -lt 4000

title "what cannot be served"
delabole live missing.toml
expect_status 3
delabole live -
expect_status 2
finish
