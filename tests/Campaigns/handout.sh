#!/usr/bin/env bash
# Makes a hand-out outside of the project, and for k = 0, 5, 10 puts in the first k solutions: it builds, it draws, the steps 1 … k are green, the
# later ones red. WHOLE=yes takes all k, and more kinds of endless code. Needs nothing but the .NET SDK and the test packages.
set -euo pipefail
cd "$(dirname "$0")/../.."
export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1
if [ -n "${WHOLE:-}" ]; then solutions=(0 1 2 3 4 5 6 7 8 9 10); else solutions=(0 5 10); fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

dotnet publish src/RayCaster.Cli -v q -o "$folder/tool"
dotnet publish src/RayCaster.Live -v q -o "$folder/tool" -p:UseAppHost=false # a hand-out has the live page, too
raycaster() { "$folder/tool/raycaster" "$@"; }
raycaster handout -q "$folder/lab"

for k in "${solutions[@]}"; do
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
            line=$(grep -E "^ *$step +([0-9]+ of +[0-9]+|unfinished) " log) || { tail -20 log; echo "step $step is not in the table"; exit 1; }
            case "$line" in *done*) green=1 ;; *) green=0 ;; esac
            if [ "$green" != "$((step <= k))" ]; then
                grep -A 8 "Failed Lab" log | head -60
                echo "step $step, with $k done: $line"
                exit 1
            fi
        done
        [ "$passed" = "$([ "$k" = 10 ] && echo yes || echo no)" ]
        grep -E "^ +[0-9]+ +([0-9]+ of|unfinished) " log
    )
done

raycaster handout -q "$folder/solved" --solution
solved() { cp -r "$folder/solved" "$folder/$1"; }

echo "== the tool in lib"
solved stopped
(
    cd "$folder/stopped"
    cp scenes/step10/room.png room.png
    dotnet lib/raycaster.dll compare room.png scenes/step10/room.png --scene scenes/room.json
    dotnet lib/raycaster.dll diagnose scenes/room.json room.png
    dotnet lib/raycaster.dll explain scenes/room.json 325 359 --mine room.png > /dev/null
    dotnet lib/raycaster.dll live scenes/room.json --mine room.png --no-browser > page 2>&1 &
    live=$!
    for _ in $(seq 100); do
        address=$(grep -o 'http://[^ ]*' page | head -1) && break
        sleep 0.2
    done
    curl -sf "$address" | grep "<title>" # to the end: grep -q would end before curl has written all
    kill $live
    dotnet lib/raycaster.dll handout ../new 2> said && exit 1
    grep -q "the folder handout is not beside this program" said
)

echo "== endless code in tests"
(
    cd "$folder/stopped"
    sed -i 's/Seconds = 60/Seconds = 10/' tests/Lab.Tests/Tools/Teacher.cs
    test_step() { # its number, code to add, and a file with the line before which to add it; true if the tests fail
        rm -f tests/Lab.Tests/TestResults/step.xml
        cp "src/Lab/$3" kept
        sed -i "0,/$4/s//$2\n&/" "src/Lab/$3"
        cmp -s "src/Lab/$3" kept && return 1
        dotnet test --filter "step=$1" --logger "steps;junit=step.xml" > log 2>&1 && return 1
        cp kept "src/Lab/$3"
    }
    test_step 8 "while (true) { }" Sphere.cs "var L = "
    grep -Eq "^   8  stopped " log
    grep -E "Passed!|Attachments|Sequence_" log && exit 1
    [ -n "${WHOLE:-}" ] || exit 0
    test_step 8 "while (C.X == 0 \&\& C.Y == 3) { }" Sphere.cs "var L = " # for one sphere of the tests
    grep -Eq "^   8  stopped " log
    grep -q "^Lab.Tests.Step08Sphere.StraightOn(way: .*Geometric" log
    grep -q '<testsuite .* errors="1">' tests/Lab.Tests/TestResults/step.xml
    test_step 7 "Intersect(ray);" Aabb.cs "var (P, d) = " # which calls itself
    grep -Eq "^   7  stopped " log
    grep -q '<testsuite .* errors="1">' tests/Lab.Tests/TestResults/step.xml
    sed -i 's/var (P, d) = .*/Intersect(ray);\n&/' src/Lab/Aabb.cs
    dotnet test --filter step=6 > log # which has no boxes
)

echo "== the pictures for marks"
solved drawn
(
    cd "$folder/drawn"
    sh .ci/pictures.sh ada > log
    [ -s pictures/ada/room.png ] && [ -s pictures/ada/generic.png ]
    grep -q '<testsuite .* failures="0" errors="0">' pictures/ada/results.xml
)
raycaster mark -q docs/rubric.json "$folder/drawn/pictures" -o "$folder/marks"
grep -q "^ada,20,0,20," "$folder/marks/marks.csv"

echo "== files that students must not change"
solved changed
(
    cd "$folder/changed"
    git init -q
    git config user.name teacher
    git config user.email teacher@example.org
    git commit -q --allow-empty -m "what a hosting site begins a repository with"
    git add -A
    git commit -qm "hand-out"
    sed -i 's/"radius": 1,/"radius": 1.5,/' scenes/circle.json
    cmp -s scenes/circle.json <(git show HEAD:scenes/circle.json) && exit 1
    dotnet test --filter step=9 > log && exit 1
    grep -q "scenes/circle.json is not as it was handed out" log
    rm tests/Lab.Tests/Step10Triangle.cs
    mkdir src/Lab/Shapes
    mv src/Lab/Circle.cs src/Lab/Shapes
    echo "// mine" >> src/Lab/Sphere.cs
    git add -A
    git commit -qm "all done"
    env -u CI sh .ci/restore.sh 2> ../said && exit 1
    grep -q "runs only in CI" ../said
    git clone -q --depth 1 "file://$PWD" ../shallow
    (cd ../shallow && CI=1 sh .ci/restore.sh) 2> ../said && exit 1
    grep -q "lacks a part of its history" ../said
    [ -z "$(git -C ../shallow status --porcelain --ignored)" ]
    GIT_TRACE=1 CI=1 sh .ci/restore.sh 2> ../said # what git prints besides its answer is none
    [ "$(git status --porcelain -uall)" = "$(printf ' D src/Lab/Circle.cs\n M src/Lab/Sphere.cs\n?? src/Lab/Shapes/Circle.cs')" ]
)

echo "== a hand-out that was committed in parts"
solved parts
(
    cd "$folder/parts"
    git init -q
    git config user.name teacher
    git config user.email teacher@example.org
    git add .ci
    git commit -qm "only a part"
    git add -A
    git commit -qm "the rest"
    CI=1 sh .ci/restore.sh 2> ../said && exit 1
    grep -q "has no src/Lab: commit the hand-out as a whole. Nothing was restored or deleted." ../said
    [ -f src/Lab/Circle.cs ] && [ -z "$(git status --porcelain --ignored)" ]
)
echo "hand-out: all as it should be"
