#!/usr/bin/env bash
# Follows README.md in a fresh clone, command by command in its order, with the two edits that it asks for. Each line that README shows below a
# command must be printed by that command.
set -u
cd "$(dirname "$0")/../.." || exit 1
clone=$(mktemp -d)
trap 'rm -rf "$clone"' EXIT
git clone -q . "$clone" && cd "$clone" || exit 1
export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1
unset Strict
failed=0 commands=0 expected=0
printed=$(mktemp)

edit() { # replaces a text in a file, which must have it
    grep -q -- "$2" "$1" || { echo "$1 does not have $2"; failed=1; }
    sed -i.bak "s/$2/$3/" "$1" && rm "$1.bak"
}

follow() { # runs a command of README
    expected=0
    case $1 in
        *" -- scenes/first.json") edit scenes/first.json '"radius"' '"raduis"'; expected=2 ;;
        *"RayCaster.Lab -- scenes/room.json") edit src/RayCaster.Lab/Sphere.cs 'Math.Sqrt(R \* R' 'Math.Sqrt(R' ;;
        *"-o small-ball.png") edit src/RayCaster/Shapes/Sphere.cs 'Radius \* Radius' 'Radius' ;;
        *"--filter step=8" | *"--filter SphereTests") expected=2 ;; # so says Microsoft.Testing.Platform that a test failed
        *" --pixel "* | *" diagnose "* | *" compare "* | *" explain "*) expected=1 ;; # something is wrong
    esac
    echo "== $1"
    commands=$((commands + 1))
    $1 > "$printed" 2>&1
    local code=$?
    [ $code = $expected ] || { echo "its exit code is $code, not $expected:"; cat "$printed"; failed=1; }
    git checkout -q scenes
}

fenced=
while IFS= read -r line; do
    case $line in
        '```') [ -z "$fenced" ] && fenced=yes || fenced= ;;
        '```'*) fenced=other ;;
        '    dotnet test -c Release') ;; # all tests: .ci/run does that
        '    dotnet '*) [ -z "$fenced" ] && follow "${line#    }" ;;
        '$ '*) [ "$fenced" = yes ] && follow "${line#$ }" ;;
        ... | '') ;;
        *) [ "$fenced" != yes ] || grep -qxF -- "$line" "$printed" || { echo "it does not print: $line"; failed=1; } ;;
    esac
done < README.md

[ $commands -ge 10 ] || { echo "README has only $commands commands"; failed=1; }
cmp -s room.png small-ball.png && { echo "the edit of Sphere.cs does not change the picture"; failed=1; }
[ $failed = 0 ] && echo "README's $commands commands print what it shows"
exit $failed
