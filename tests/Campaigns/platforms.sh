#!/usr/bin/env bash
# Windows and ARM64 on a Linux machine, by wine and qemu: the tests' own programs, each scene's picture, paths as Windows writes them. A copy of
# the project whose lines end with CR LF must build, draw and hand out. Needs Debian for x64, and installs its packages if it may.
#
#     tests/Campaigns/platforms.sh [windows|arm]
#
# Environment: LIMIT, in seconds, for each program of tests.
set -euo pipefail
cd "$(dirname "$0")/../.."
export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1
unset UseSharedCompilation # one compiler for all builds here
limit=${LIMIT:-1800}
work=$(mktemp -d)
export work WINEPREFIX=$work/wine WINEDEBUG=-all
trap 'wineserver -k 2>/dev/null || true; rm -rf "$work"' EXIT

# What is left out: system, project, methods, the reason. Each line must name tests that are there.
# wine 8 stops at the second exception out of a method that reflection calls (a program of ten lines does so, too): a failed test and Assert.Skip
# both stop the whole program. So a test that needs another system says so in its attribute, and a program that stops names the test.
left_out='
windows Lab.Tests *RayAssertTests* it throws and catches by the dozen, where wine stops; nothing in it depends on the system
windows Cli.Tests *HandOutFolderTests* dotnet builds the tool of a hand-out, and is not in wine
windows Live.Tests *AttackTests.ItListensOnNoOtherAddressOfThisMachine wine names no address on which a program listens
arm Cli.Tests *FaultTests.ALimitOfFileSizes* qemu does not let a program ignore SIGXFSZ: the signal ends it (153) before the write fails
arm Cli.Tests *AttackTests.ADeletedCurrentFolderIsReported the shell that starts qemu reports it first, on the same stream
arm Cli.Tests *HandOutFolderTests* it starts the tool by the dotnet of the machine, which is for x64
'

skip() { echo "$*"; exit 77; }
tools() { command -v wine wineserver qemu-aarch64-static && [ -e /usr/aarch64-linux-gnu/lib/libstdc++.so.6 ]; } >/dev/null
if [ "$(uname -m)" != x86_64 ] || ! grep -qx ID=debian /etc/os-release; then skip "this is no Debian for x64"; fi
if ! tools; then
    { apt-get update -qq && apt-get install -y -qq wine wine64 qemu-user-static libc6-arm64-cross libstdc++6-arm64-cross; } >/dev/null 2>&1 || true
    tools || skip "wine and qemu cannot be installed here"
fi
# The runtime computes SHA-256 by OpenSSL. Its package for ARM64 is only unpacked, by lists of its own, which leaves the system as it is.
mkdir -p "$work/lists/partial" "$work/ssl"
of_arm() { apt-get -qq -o APT::Architecture=arm64 -o APT::Architectures=arm64 -o Dir::State::lists="$work/lists" -o APT::Sandbox::User=root "$@"; }
(cd "$work/ssl" && of_arm update && of_arm download libssl3) >/dev/null 2>&1 || skip "libssl3 for ARM64 cannot be fetched here"
dpkg -x "$work"/ssl/libssl3_*.deb "$work/ssl"

for folder in windows arm crlf; do
    mkdir "$work/$folder"
    git ls-files -z | tar -c --null -T - | tar -x -C "$work/$folder"
done
git ls-files --eol | sed -n 's/^i\/lf[^\t]*eol=lf *\t//p' | (cd "$work/crlf" && tr '\n' '\0' | xargs -0 sed -i 's/$/\r/')

failed=0
fail() { echo "failed: $*"; failed=1; }

# What starts a program of each system. The runtime's double mapping of code is too much for both emulators.
export DOTNET_EnableWriteXorExecute=0
cat >"$work/on_windows" <<'EOF'
#!/bin/sh
program=$1.exe
shift
exec wine "$program" "$@"
EOF
cat >"$work/on_arm" <<'EOF'
#!/bin/sh
export DOTNET_SYSTEM_GLOBALIZATION_INVARIANT=1 QEMU_SET_ENV="LD_LIBRARY_PATH=$work/ssl/usr/lib/aarch64-linux-gnu"
exec qemu-aarch64-static -L /usr/aarch64-linux-gnu "$@"
EOF
chmod +x "$work/on_windows" "$work/on_arm"

declare -A runtime=([windows]=win-x64 [arm]=linux-arm64)
built() { echo "$work/$1/tests/RayCaster.$2/bin/Release/net10.0/${runtime[$1]}/$3"; } # system, project, name of a program
build() { # system, projects: all in one go, so that what they share is built once
    local projects project for_system="RuntimeIdentifier=${runtime[$1]};SelfContained=true"
    projects=$(for project in "${@:2}"; do printf '%s;' "tests/RayCaster.$project/RayCaster.$project.csproj"; done)
    cat >"$work/$1/all.proj" <<EOF
<Project>
  <Target Name="Build">
    <MSBuild Projects="$projects" Targets="Restore" Properties="$for_system;Step=Restore" />
    <MSBuild Projects="$projects" Targets="Build" Properties="$for_system" BuildInParallel="true" />
  </Target>
</Project>
EOF
    local start=$SECONDS
    dotnet build "$work/$1/all.proj" -v quiet >"$work/$1.txt" 2>&1 || { cat "$work/$1.txt"; fail "the build for $1"; exit 1; }
    echo "$1: built ($((SECONDS - start)) s)"
}

unended() { comm -23 <(sed -n 's/ \[STARTING\].*//p' "$1" | sort -u) <(sed -nE 's/ \[(FINISHED|SKIP|FAIL)\].*//p' "$1" | sort -u); }
tests() { # system, project: each test that the program for x64 lists must have ended, or be left out by the list above
    local program=RayCaster.$2 log=$work/$1.$2 here=tests/RayCaster.$2/bin/Release/net10.0/RayCaster.$2 without=() system project methods reason
    [ -x "$here" ] || dotnet build "tests/$program" -v quiet >/dev/null
    "$here" -noLogo -noColor -list tests | sed -nE 's/^([A-Za-z0-9_.+]*Tests\.[A-Za-z0-9_.+]+).*/\1/p' | sort -u >"$log.listed"
    touch "$log.left"
    while read -r system project methods reason; do
        [ "$system $project" = "$1 $2" ] || continue
        grep -E "^${methods//\*/.*}$" "$log.listed" >>"$log.left" || fail "$1: $2: no test is named $methods"
        without+=(-method- "$methods")
        echo "$1: $2 without $methods: $reason"
    done <<<"$left_out"
    local start=$SECONDS missing total errors failures skipped
    timeout "$limit" "$work/on_$1" "$(built "$1" "$2" "$program")" -noColor -reporter verbose "${without[@]}" >"$log" 2>&1 </dev/null || true
    sed -i 's/\r$//' "$log"
    read -r total errors failures skipped < <(
        sed -nE 's/^.*Total: ([0-9]+), Errors: ([0-9]+), Failed: ([0-9]+), Skipped: ([0-9]+),.*/\1 \2 \3 \4/p' "$log"
        echo 0 0 0 0)
    missing=$(sed -nE 's/^ +([A-Za-z0-9_.+]+).* \[(FINISHED|SKIP)\].*/\1/p' "$log" | sort -u - "$log.left" | comm -23 "$log.listed" -)
    if ((total == 0)); then fail "$1: $2 stopped in $(unended "$log")"
    elif ((errors + failures)); then
        grep -A 12 -F '[FAIL]' "$log" | head -90
        fail "$1: $2"
    elif [ -n "$missing" ]; then fail "$1: $2 did not run ${missing//$'\n'/ }"; fi
    echo "$1: $2: $((total - errors - failures - skipped)) passed, $skipped skipped, $(wc -l <"$log.left") left out ($((SECONDS - start)) s)"
}

here=src/RayCaster.Cli/bin/Release/net10.0/raycaster
[ -x "$here" ] || dotnet build src/RayCaster.Cli -v quiet
scenes() { # system: each scene at its size, byte for byte as on x64
    local scene drawn=0 start=$SECONDS program
    program=$(built "$1" Cli.Tests raycaster)
    for scene in scenes/*.json scenes/mistakes/*.json scenes/weeks/*.json; do
        case $scene in *.schema.json) continue ;; esac
        "$here" "$scene" -q -o "$work/$1.here.ppm"
        "$work/on_$1" "$program" "$work/$1/$scene" -q -o "$work/$1.ppm" 2>&1 </dev/null || fail "$1 does not draw $scene"
        cmp "$work/$1.ppm" "$work/$1.here.ppm" || fail "$1 draws $scene otherwise"
        drawn=$((drawn + 1))
    done
    echo "$1: $drawn scenes are the same as on x64 ($((SECONDS - start)) s)"
}

paths_of_windows() {
    local folder="$work/My Pictures für Übung" place said
    place="Z:${folder//\//\\}"
    draw() { "$work/on_windows" "$(built windows Cli.Tests raycaster)" "$@" 2>&1 </dev/null; }
    scene() { printf '{ "camera": { "position": [9, 0, 0], "target": [0, 0, 0] },\r\n  "models": [{ "type": "mesh", "file": "%s" }] }\r\n' "$1"; }
    mkdir -p "$folder/Meshes"
    cp scenes/meshes/icosphere.obj "$folder/Meshes/Ball.obj"
    scene 'Meshes\\Ball.obj' >"$folder/scene.json"
    scene 'MESHES\\BALL.OBJ' >"$folder/case.json"
    "$here" "$folder/scene.json" -q -s 90x90 -o "$folder/here.ppm"
    draw "$place\\scene.json" -q -s 90x90 -o "$place\\blänk name.ppm" || fail "a path with blanks and umlauts"
    cmp "$folder/blänk name.ppm" "$folder/here.ppm" || fail "a mesh behind a backslash"
    draw "$place\\CASE.JSON" -q -s 90x90 -o "$place\\case.ppm" || fail "names in another case"
    cmp "$folder/case.ppm" "$folder/here.ppm" || fail "a mesh in another case"
    chmod a-w "$folder/case.ppm"
    said=$(draw "$place\\scene.json" -q -s 9x9 -o "$place\\case.ppm") && fail "a read-only picture was replaced"
    [[ $said == *"the old file is read-only"* ]] || fail "of a read-only picture is said: $said"
    cmp "$folder/case.ppm" "$folder/here.ppm" || fail "a read-only picture was changed"
    echo "windows: blanks, umlauts, backslashes, names in another case, a read-only picture"
}

programs_of_the_current_folder() { # they lie where Windows looks first, and there is no other dotnet
    local said program
    program=$(built windows Cli.Tests raycaster)
    mkdir "$work/traps"
    cp scenes/first.json "$work/traps"
    for command in dotnet cmd; do cp "$program.exe" "$work/traps/$command.exe"; done
    touch "$(dirname "$program")/raycaster-live.dll"
    said=$(cd "$work/traps" && "$work/on_windows" "$program" live first.json 2>&1 </dev/null) && fail "windows: live, with dotnet.exe beside"
    [[ $said == *"dotnet is not in PATH"* ]] || fail "windows: live, with dotnet.exe beside: $said"
    rm "$(dirname "$program")/raycaster-live.dll"
    echo "windows: no dotnet.exe of the current folder"
}

line_ends() { # the copy with CR LF, on Linux
    local program=$work/crlf/src/RayCaster.Cli/bin/Release/net10.0/raycaster
    for project in Cli Live; do
        dotnet build "$work/crlf/src/RayCaster.$project" -v quiet >"$work/crlf.txt" 2>&1 ||
            { cat "$work/crlf.txt"; fail "the build with CR LF"; return; }
    done
    "$program" "$work/crlf/scenes/room.json" -q -o "$work/crlf.ppm"
    "$here" scenes/room.json -q -o "$work/lf.ppm"
    cmp "$work/crlf.ppm" "$work/lf.ppm" || fail "the room with CR LF"
    "$program" handout -q "$work/lab-crlf"
    "$here" handout -q "$work/lab"
    diff -rq -x lib "$work/lab-crlf" "$work/lab" || fail "the hand-out with CR LF"
    echo "CR LF on Linux: builds, draws, hands out the same"
}

windows() {
    build windows Tests Files.Tests Lab.Tests Cli.Tests Live.Tests Engine.Tests
    wineboot -i >/dev/null 2>&1 || true
    for project in Tests Files.Tests Lab.Tests Cli.Tests Live.Tests; do tests windows "$project"; done
    RAYCASTER_SCENES=20 RAYCASTER_ROUNDS=5 tests windows Engine.Tests
    scenes windows
    paths_of_windows
    line_ends
    programs_of_the_current_folder
    exit "$failed"
}
arm() {
    build arm Tests Files.Tests Lab.Tests Cli.Tests Engine.Tests
    printf '#!/bin/sh\nexec "$work/on_arm" "%s" "$@"\n' "$(built arm Cli.Tests raycaster)" >"$work/raycaster"
    chmod +x "$work/raycaster"
    for project in Tests Files.Tests Lab.Tests; do tests arm "$project"; done
    RAYCASTER_APP=$work/raycaster tests arm Cli.Tests
    RAYCASTER_SCENES=20 RAYCASTER_ROUNDS=1 tests arm Engine.Tests
    scenes arm
    exit "$failed"
}
for system in ${1:-windows arm}; do ("$system") &> "$work/$system.out" & done
for job in $(jobs -p); do wait "$job" || failed=1; done
cat "$work"/*.out
exit "$failed"
