#!/usr/bin/env bash
# Windows and ARM64 on a Linux machine, by wine and qemu: the tests' own programs, each scene's picture, and paths as Windows writes them. Windows'
# side is built in a copy of the project whose lines end with CR LF; that copy must also build, draw and hand out on Linux.
# Needs Debian for x64, and installs its packages if it may. Environment: LIMIT, in seconds, for each program of tests.
set -euo pipefail
cd "$(dirname "$0")/../.."
export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1
limit=${LIMIT:-240}
root=$PWD
work=$(mktemp -d)
export WINEPREFIX=$work/wine WINEDEBUG=-all
trap 'wineserver -k 2>/dev/null || true; rm -rf "$work"' EXIT

# What is left out: system, project, methods, the reason. Each line must name a test that is there.
# wine 8 cannot pass a second exception out of a method that reflection calls (a program of ten lines stops there, too), so a failed test and
# Assert.Skip both stop the whole program there. A test that needs another system therefore says so in its attribute.
left_out='
'

skip() { echo "skipped: $*"; exit 0; }
tools() { command -v wine wineserver qemu-aarch64-static && [ -e /usr/aarch64-linux-gnu/lib/libstdc++.so.6 ]; } >/dev/null
[ "$(uname -m)" = x86_64 ] && command -v apt-get >/dev/null || skip "this is no Debian for x64"
if ! tools; then
    { apt-get update -qq && apt-get install -y -qq wine wine64 qemu-user-static libc6-arm64-cross libstdc++6-arm64-cross; } >/dev/null 2>&1 || true
    tools || skip "wine and qemu cannot be installed here"
fi
# The runtime computes SHA-256 by OpenSSL. Its package for ARM64 is only unpacked, by lists of its own, which leaves the system as it is.
mkdir -p "$work/apt/lists/partial" "$work/ssl"
of_arm() { apt-get -qq -o APT::Architecture=arm64 -o APT::Architectures=arm64 -o Dir::State::lists="$work/apt/lists" -o APT::Sandbox::User=root "$@"; }
(cd "$work/ssl" && of_arm update && of_arm download libssl3) >/dev/null 2>&1 || skip "libssl3 for ARM64 cannot be fetched"
dpkg -x "$work"/ssl/libssl3_*.deb "$work/ssl"

copy() { git ls-files -z | tar -c --null -T - | tar -x -C "$1"; }
mkdir "$work/windows" "$work/arm"
copy "$work/windows"
copy "$work/arm"
git ls-files --eol | sed -n 's/^i\/lf[^\t]*eol=lf *\t//p' | (cd "$work/windows" && tr '\n' '\0' | xargs -0 sed -i 's/$/\r/')

failed=0
fail() { echo "failed: $*"; failed=1; }

# What starts a program of each system. The runtime's double mapping of code is too much for both emulators.
export DOTNET_EnableWriteXorExecute=0
on_windows() { wine "$1.exe" "${@:2}"; }
on_arm() { DOTNET_SYSTEM_GLOBALIZATION_INVARIANT=1 LD_LIBRARY_PATH= QEMU_LD_PREFIX=/usr/aarch64-linux-gnu \
    QEMU_SET_ENV=LD_LIBRARY_PATH=$work/ssl/usr/lib/aarch64-linux-gnu qemu-aarch64-static "$@"; }
export -f on_windows on_arm
export work

publish() { # system, runtime identifier, projects
    local project
    for project in "${@:3}"; do
        dotnet publish "$work/$1/tests/RayCaster.$project" -r "$2" --self-contained -v quiet -o "$work/$1/publish/$project" >"$work/$1.txt" 2>&1 \
            || { cat "$work/$1.txt"; fail "publish $project for $1"; }
    done
}

tests() { # system, project: runs its program; each test that the program for x64 lists must have ended, or be left out by the list above
    local program=RayCaster.$2 log=$work/$1.$2.log here=tests/RayCaster.$2/bin/Release/net10.0/RayCaster.$2 without=() system project methods reason
    [ -x "$here" ] || dotnet build "tests/$program" -v quiet
    "$here" -noLogo -noColor -list tests | sort -u >"$log.listed"
    while read -r system project methods reason; do
        [ "$system $project" = "$1 $2" ] || continue
        "$here" -noLogo -noColor -list tests -method "$methods" | grep "^$program" >>"$log.left" || fail "$1 $2: no test is named $methods"
        without+=(-method- "$methods")
        echo "$1: $2 without $methods: $reason"
    done <<<"$left_out"
    local start=$SECONDS
    timeout "$limit" bash -c '"$@"' _ "on_$1" "$work/$1/publish/$2/$program" -noColor -reporter verbose "${without[@]}" >"$log" 2>&1 </dev/null || true
    sed -i 's/\r$//' "$log"
    sed -nE 's/^    ([A-Za-z0-9_.+]+)(<[^(]*)?(\(.*)? \[(FINISHED|SKIP)\].*/\1/p' "$log" | sort -u >"$log.ended"
    touch "$log.left"
    local missing
    missing=$(sort -u "$log.ended" "$log.left" | comm -23 "$log.listed" -)
    local total errors failures skipped
    read -r total errors failures skipped < <(sed -nE 's/^.*Total: ([0-9]+), Errors: ([0-9]+), Failed: ([0-9]+), Skipped: ([0-9]+),.*/\1 \2 \3 \4/p' "$log" | tail -1) \
        || read -r total errors failures skipped <<<"0 0 0 0"
    if [ -n "$missing" ]; then fail "$1 $2: these have not ended: $missing"; fi
    if ((total == 0)); then
        fail "$1 $2 stopped, at: $(comm -23 <(sed -n 's/ \[STARTING\].*//p' "$log" | sort -u) <(sed -nE 's/ \[(FINISHED|SKIP|FAIL)\].*//p' "$log" | sort -u))"
    elif ((errors + failures)); then
        grep -A 12 -F '[FAIL]' "$log" | head -80
        fail "$1 $2: $((errors + failures)) tests"
    fi
    echo "$1: $2: $((total - errors - failures - skipped)) passed, $skipped skipped, $(wc -l <"$log.left") left out ($((SECONDS - start)) s)"
}

scenes() { # system: each scene at its size, byte for byte as on x64
    local scene drawn=0
    for scene in scenes/*.json scenes/mistakes/*.json scenes/weeks/*.json; do
        case $scene in *.schema.json) continue ;; esac
        "on_$1" "$work/$1/publish/Cli.Tests/raycaster" "$work/$1/$scene" -q -o "$work/$1/picture.ppm" 2>&1 </dev/null || fail "$1 does not draw $scene"
        "$here" "$scene" -q -o "$work/$1/here.ppm"
        cmp "$work/$1/picture.ppm" "$work/$1/here.ppm" || fail "$1 draws $scene otherwise"
        drawn=$((drawn + 1))
    done
    echo "$1: $drawn scenes drawn as on x64"
}

windows_paths() {
    local folder="$work/My Pictures für Übung" place out
    place="Z:${folder//\//\\}"
    mkdir -p "$folder/Meshes"
    cp scenes/meshes/icosphere.obj "$folder/Meshes/Ball.obj"
    cp scenes/meshes/icosphere.obj "$folder/Meshes/ball.obj.kept"
    printf '{ "camera": { "position": [20, 0, 0], "target": [0, 0, 0] },\r\n  "models": [{ "type": "mesh", "file": "Meshes\\\\Ball.obj" }] }\r\n' \
        >"$folder/scene.json"
    "$here" "$folder/scene.json" -q -s 90x90 -o "$folder/here.ppm"
    draw() { on_windows "$work/windows/publish/Cli.Tests/raycaster" "$@" 2>&1 </dev/null; }
    draw "$place\\scene.json" -q -s 90x90 -o "$place\\blänk name.ppm" || fail "blanks and umlauts"
    cmp "$folder/blänk name.ppm" "$folder/here.ppm" || fail "the picture of a scene with backslashes differs"
    sed -i 's/Meshes.*Ball.obj/MESHES\\\\BALL.OBJ/' "$folder/scene.json"
    draw "$place\\SCENE.JSON" -q -s 90x90 -o "$place\\case.ppm" || fail "another case"
    cmp "$folder/case.ppm" "$folder/here.ppm" || fail "the picture of a scene with another case differs"
    chmod a-w "$folder/case.ppm"
    out=$(draw "$place\\scene.json" -s 9x9 -o "$place\\case.ppm") && fail "a read-only picture was replaced"
    [[ $out == *"the old file is read-only"* ]] || fail "read-only: $out"
    cmp "$folder/case.ppm" "$folder/here.ppm" || fail "a read-only picture was changed"
    echo "windows: paths with blanks, umlauts, backslashes, another case, a read-only target"
}

crlf() { # the copy with CR LF on Linux
    local program=$work/windows/src/RayCaster.Cli/bin/Release/net10.0/raycaster
    dotnet build "$work/windows/src/RayCaster.Cli" -v quiet >"$work/crlf.txt" 2>&1 || { cat "$work/crlf.txt"; fail "the copy with CR LF does not build"; }
    "$program" "$work/windows/scenes/room.json" -q -o "$work/room.ppm"
    "$here" scenes/room.json -q -o "$work/here.ppm"
    cmp "$work/room.ppm" "$work/here.ppm" || fail "with CR LF the room is another"
    "$program" handout -q "$work/lab-crlf"
    "$here" handout -q "$work/lab"
    diff -rq -x lib "$work/lab-crlf" "$work/lab" || fail "with CR LF another hand-out is made"
    echo "CR LF on Linux: builds, draws, hands out the same"
}

here=$root/src/RayCaster.Cli/bin/Release/net10.0/raycaster
[ -x "$here" ] || dotnet build src/RayCaster.Cli -v quiet

windows() {
    wineboot -i >/dev/null 2>&1 || true
    publish windows win-x64 Tests Files.Tests Lab.Tests Cli.Tests Engine.Tests Live.Tests
    for project in Tests Files.Tests Lab.Tests Cli.Tests Live.Tests; do tests windows "$project"; done
    RAYCASTER_SCENES=4 RAYCASTER_ROUNDS=2 tests windows Engine.Tests
    scenes windows
    windows_paths
    crlf
    exit "$failed"
}
arm() {
    publish arm linux-arm64 Tests Files.Tests Lab.Tests Cli.Tests Engine.Tests
    cat >"$work/raycaster" <<<'#!/bin/bash
on_arm "$work/arm/publish/Cli.Tests/raycaster" "$@"'
    chmod +x "$work/raycaster"
    for project in Tests Files.Tests Lab.Tests; do tests arm "$project"; done
    RAYCASTER_APP=$work/raycaster tests arm Cli.Tests
    RAYCASTER_SCENES=2 RAYCASTER_ROUNDS=1 tests arm Engine.Tests
    scenes arm
    exit "$failed"
}
[ "${1:-arm}" = arm ] && { (arm) >"$work/arm.out" 2>&1 & beside=$!; }
[ "${1:-windows}" = windows ] && { (windows) || failed=1; }
[ "${1:-arm}" = arm ] && { wait "$beside" || failed=1; cat "$work/arm.out"; }
exit "$failed"
