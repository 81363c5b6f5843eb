#!/usr/bin/env bash
# Whole programs from start to end, by hyperfine: ours as built and native, an app that only says hello, POV-Ray. Debian: hyperfine povray gcc.
#
#     tests/Tools/Benchmarks/programs.sh [SCENE…]    such as room bumpy-70k; RUNS=3 for fewer runs
set -euo pipefail
cd "$(dirname "$0")/../../.."
work=$(mktemp -d) runs=${RUNS:-10}
trap 'rm -r "$work"' EXIT
[ $# -gt 0 ] || set -- room bumpy-70k bumpy-1m spheres-100k
dotnet run --project tests/Tools/Benchmarks -- write "$work" "$@"
dotnet publish src/RayCaster.Cli -v q -o "$work/built"
dotnet publish src/RayCaster.Cli -v q -p:PublishAot=true -o "$work/native" >/dev/null || echo "The native program is left out: it needs a linker."
dotnet new console -o "$work/hello" >/dev/null && dotnet build "$work/hello" -v q -c Release -o "$work/hello/out" >/dev/null
programs=("$work/built/raycaster")
[ ! -x "$work/native/raycaster" ] || programs+=("$work/native/raycaster")

echo "== the course's room, 500 x 500, beside an app that only says hello: compare user and system time"
hyperfine -N -w 2 -r "$((2 * runs))" "$work/hello/out/hello" "${programs[@]/%/ scenes/room.json -q -o $work/room.png}"
for scene in "$@"; do
    for threads in 1 2; do
        echo "== $scene, 1920 x 1080, $threads threads"
        commands=("${programs[@]/%/ $work/$scene.json -q -t $threads -o $work/ours.png}")
        if command -v povray >/dev/null; then
            python3 tests/References/scene_to_pov.py "$work/$scene.json" 1920 1080 >"$work/$scene.pov"
            commands+=("povray +I$work/$scene.pov +O$work/pov.png +W1920 +H1080 +WT$threads File_Gamma=1 -D -A -GA")
        fi
        hyperfine -N -w 1 -r "$runs" "${commands[@]}"
    done
done
