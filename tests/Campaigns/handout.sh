#!/usr/bin/env bash
# Makes a hand-out outside of the project, and for k = 0 … 10 puts in the first k solutions: it builds, it draws, the steps 1 … k are green, the
# later ones red. Needs nothing but the .NET SDK and the test packages.
#
#     tests/Campaigns/handout.sh [k…]
set -euo pipefail
cd "$(dirname "$0")/../.."
export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1
[ $# -gt 0 ] || set -- 0 1 2 3 4 5 6 7 8 9 10
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

dotnet build src/RayCaster.Cli -v q
raycaster() { dotnet src/RayCaster.Cli/bin/Release/net10.0/raycaster.dll "$@"; }
raycaster handout -q "$folder/lab"

for k in "$@"; do
    echo "== the first $k steps are done"
    if [ "$k" -lt 10 ]; then open=(--open "$((k + 1))..10"); else open=(--solution); fi
    raycaster handout -q "$folder/$k" "${open[@]}"
    cp "$folder/$k"/src/Lab/*.cs "$folder/lab/src/Lab/"
    rm -r "${folder:?}/$k"
    (
        cd "$folder/lab"
        dotnet build -v q
        rm -f room.png
        dotnet run --no-build --project src/Lab -- scenes/room.json room.png 2> said
        [ -s room.png ]
        if [ "$k" -lt 10 ]; then grep -q "^Not written yet: .* Next: step $((k + 1)), " said; else [ ! -s said ]; fi
        dotnet test --no-build > log && passed=yes || passed=no
        for step in 1 2 3 4 5 6 7 8 9 10; do
            line=$(grep -E "^ *$step +([0-9]+ of +[0-9]+|not written) " log) || { tail -20 log; echo "step $step is not in the table"; exit 1; }
            case "$line" in *done*) green=1 ;; *) green=0 ;; esac
            if [ "$green" != "$((step <= k))" ]; then
                grep -A 8 "Failed Lab" log | head -60
                echo "step $step, with $k done: $line"
                exit 1
            fi
        done
        [ "$passed" = "$([ "$k" = 10 ] && echo yes || echo no)" ]
        grep -E "^ +[0-9]+ +([0-9]+ of|not written) " log
    )
done
echo "hand-out: all as it should be"
