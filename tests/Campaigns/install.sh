#!/usr/bin/env bash
# Packs the tool and the template of docs/teaching.md, installs both from a folder into an empty home, without a network, and uses them: a hand-out
# that builds, the same from "dotnet new", a picture, the live page.
set -euo pipefail
cd "$(dirname "$0")/../.."
export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1
NUGET_PACKAGES=$(dotnet nuget locals global-packages --list | sed 's/^[^:]*: //') # what the tests of a hand-out need is here already
export NUGET_PACKAGES
root=$PWD
work=$(mktemp -d)
trap 'kill $(jobs -p) 2>/dev/null; rm -rf "$work"' EXIT
for project in Cli Template; do dotnet pack "src/RayCaster.$project" -v quiet -o "$work/packages"; done

mkdir "$work/home" "$work/course"
cd "$work/course"
echo '<configuration><packageSources><clear /></packageSources></configuration>' >nuget.config
export HOME=$work/home DOTNET_CLI_HOME=$work/home PATH=$work/home/.dotnet/tools:$PATH
NUGET_PACKAGES=$work/tools dotnet tool install --global RayCaster.Tool --add-source "$work/packages"
dotnet new install "$work"/packages/RayCaster.Lab.Template.*.nupkg

echo "== a hand-out"
raycaster handout lab1
dotnet new raycaster-lab -o lab2
diff -r lab1 lab2
(cd lab2 && dotnet build -v quiet && dotnet run --no-build --project src/Lab -- scenes/room.json room.png && [ -s room.png ])

echo "== a picture and the live page"
cp lab1/scenes/room.json .
raycaster room.json -s 320x320
raycaster compare room.png "$root/tests/References/room.png"
raycaster live room.json --no-browser >page.txt 2>&1 &
for _ in $(seq 100); do
    address=$(grep -o 'http://[^ ]*' page.txt | head -1) && break
    sleep 0.1
done
curl -sf "$address" | grep "<title>" # to the end: grep -q would end before curl has written all
echo "installed: all as it should be"
