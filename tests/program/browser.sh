# Controls a page in headless Chromium through its pipe (the DevTools protocol); to be sourced after harness.sh.
# open_browser WIDTH HEIGHT starts it, visit ADDRESS loads a page, evaluate SCRIPT stores the value of the script's last
# expression (or promise) in $value, as JSON, screenshot FILE saves the visible page, close_browser ends it. serve
# CASE... starts delabole live and sets $address, $port, $token and $server, the process, which ends with the test.

browser_message=0

trap '[[ -z ${server:-} ]] || kill "$server" 2>/dev/null || true; rm -rf "$scratch"' EXIT

serve() {
    rm -f "$scratch/served"  # of the previous server: a slow start would leave its address there
    "$program" live "$@" >"$scratch/served" 2>"$scratch/served_err" </dev/null &
    server=$!
    until grep -q '#' "$scratch/served" 2>/dev/null; do
        kill -0 "$server" || { fail "live has ended: $(cat "$scratch/served_err")" && return; }
        sleep 0.05
    done
    address=$(grep -oE 'http://[^ ]+' "$scratch/served")
    port=$(sed -E 's/.*:([0-9]+)\/.*/\1/' <<<"$address")
    token=${address#*#}
}

open_browser() {
    local browser
    browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome)
    rm -f "$scratch/to_browser" "$scratch/from_browser"
    mkfifo "$scratch/to_browser" "$scratch/from_browser"
    "$browser" --headless --no-sandbox --disable-gpu --disable-quic --disable-dev-shm-usage --no-first-run \
        --disable-background-networking --disable-component-update --disable-sync --disable-extensions \
        --hide-scrollbars --window-size="$1,$2" --user-data-dir="$scratch/profile" --remote-debugging-pipe about:blank \
        3<"$scratch/to_browser" 4>"$scratch/from_browser" >"$scratch/browser_log" 2>&1 &
    browser_process=$!
    exec 7>"$scratch/to_browser" 8<"$scratch/from_browser"
    browser_session=
    tell_browser Target.getTargets '{}'
    local target
    target=$(grep -oE '"targetId":"[^"]+","type":"page"' <<<"$reply" | head -n 1 | cut -d '"' -f 4)
    tell_browser Target.attachToTarget "{\"targetId\":\"$target\",\"flatten\":true}"
    browser_session=$(grep -oE '"sessionId":"[^"]+"' <<<"$reply" | head -n 1 | cut -d '"' -f 4)
    tell_browser Emulation.setDeviceMetricsOverride \
        "{\"width\":$1,\"height\":$2,\"deviceScaleFactor\":1,\"mobile\":false}"
    tell_browser Runtime.enable '{}'
}

# Stores the answer to the message in $reply; meanwhile console messages are kept in $scratch/console.
tell_browser() {
    browser_message=$((browser_message + 1))
    local session=${browser_session:+,\"sessionId\":\"$browser_session\"} line
    printf '{"id":%d,"method":"%s","params":%s%s}\0' "$browser_message" "$1" "$2" "$session" >&7
    while IFS= read -r -d '' -t 100 line <&8; do
        case $line in
        *"\"id\":$browser_message,"*) reply=$line && return ;;
        *Runtime.exceptionThrown* | *Runtime.consoleAPICalled*) printf '%s\n' "$line" >>"$scratch/console" ;;
        esac
    done
    reply=
    fail "the browser does not answer"
}

in_json() {
    local text=$1
    text=${text//\\/\\\\}
    text=${text//\"/\\\"}
    text=${text//$'\n'/\\n}
    printf '"%s"' "$text"
}

evaluate() {
    tell_browser Runtime.evaluate \
        "{\"expression\":$(in_json "$1"),\"awaitPromise\":true,\"returnByValue\":true,\"userGesture\":true}"
    value=$(sed -nE 's/.*"result":\{"type":"(string|number|boolean)","value":(.*)(,"description":"[^"]*")?\}\},"sessionId".*/\2/p' <<<"$reply" |
        sed -E 's/,"description":"[^"]*"$//' | head -n 1)
}

visit() {
    tell_browser Page.navigate "{\"url\":\"$1\"}"
}

# Waits until the expression becomes true.
wait_for() {
    local turn
    for turn in {1..600}; do
        evaluate "Boolean($1)"
        [[ $value == true ]] && return
        sleep 0.1
    done
    fail "never true: $1"
}

expect_value() {
    checks=$((checks + 1))
    evaluate "$2"
    [[ $value == "$3" ]] || fail "$1: $value instead of $3"
}

screenshot() {
    tell_browser Page.captureScreenshot '{"format":"png"}'
    sed -E 's/.*"data":"([^"]+)".*/\1/' <<<"$reply" | base64 -d >"$1"
}

close_browser() {
    tell_browser Browser.close '{}'
    wait "$browser_process" || true
    exec 7>&- 8<&-
}
