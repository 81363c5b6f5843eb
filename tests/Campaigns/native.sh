#!/usr/bin/env bash
# The native program (docs/native.md): publishes it, runs the console app's tests with it, and draws each scene with it, which must give the same
# picture and the same distances, to the bit, as the program that "dotnet run" starts.
#
#     tests/Campaigns/native.sh [OPTION OF dotnet test…]
#
# Environment: RAYCASTER names a program that is published already.
set -euo pipefail
cd "$(dirname "$0")/../.."
export DOTNET_NOLOGO=1
if ! command -v clang >/dev/null && ! command -v gcc >/dev/null; then
    echo "gcc is missing"
    exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
publish() { dotnet publish "$OLDPWD/src/RayCaster.Cli" -v quiet -o "$@" >publish.txt || { cat publish.txt; exit 1; }; }
[ -n "${RAYCASTER:-}" ] || publish built
declare -A program=([built]=${RAYCASTER:-$work/built/raycaster} [native]=$work/native/raycaster)
publish native # the assemblies, of which a hand-out is made
publish native -p:PublishAot=true
dotnet publish "$OLDPWD/src/RayCaster.Live" -v quiet -o native -p:UseAppHost=false >publish.txt # a hand-out has the live page, too

drawn=0
for scene in "$OLDPWD"/scenes/*.json "$OLDPWD"/scenes/*/*.json; do
    case $scene in *.schema.json) continue ;; esac
    for name in built native; do
        "${program[$name]}" "$scene" -q -o "$name.png"
        "${program[$name]}" map "$scene" t -q -o "$name.t.png"
    done
    for what in png t.png; do
        cmp "built.$what" "native.$what" || { echo "the native program draws $scene otherwise"; exit 1; }
    done
    drawn=$((drawn + 1))
done
echo "$drawn scenes, the same to the bit"
[ "$drawn" -gt 0 ]

cd "$OLDPWD"
RAYCASTER_APP=${program[native]} dotnet test --project tests/RayCaster.Cli.Tests --filter-trait program=yes "$@"
