#!/usr/bin/env bash
# Draws scenes with the programs of a class, each run in a sandbox (bubblewrap) with limits of time, memory, processes and file size. Linux only.
#
#     docs/draw-class.sh SUBMISSIONS SCENES OUT          the class: each folder in SUBMISSIONS is a student's
#     docs/draw-class.sh SUBMISSIONS SCENES OUT NAME     one student
#
# It writes OUT/NAME/SCENE.png of each SCENES/SCENE.json, OUT/NAME/results.xml, and OUT/NAME/log.txt, which holds what the programs printed. The
# same command run again draws those students only that OUT/.jobs.log does not list. More machines: PARALLEL="--sshlogin node1,node2 --workdir ."
#
# Needs bubblewrap and GNU parallel (apt-get install bubblewrap parallel), and an ordinary user: Linux does not limit the processes of root.
set -euo pipefail

# How a program is built, and how it draws. Both run in /work; they see the student's folder as /submission and yours, HANDOUT, as /handout, which
# nobody can change. Here the tests, scenes and project files are yours, and only the code in src/Lab is the student's.
build=${BUILD:-'cp -r /submission/. /handout/. . && rm -f src/Lab/*.cs && cp /submission/src/Lab/*.cs src/Lab && dotnet build -c Release'}
run=${RUN:-'dotnet src/Lab/bin/Release/net10.0/Lab.dll "$scene" "$picture"'}
tests=${TESTS-'dotnet test -c Release --no-build --logger "steps;junit=$results"'} # writes a JUnit file; TESTS= for none
limit=${LIMIT:-60} # seconds for a picture; a build and the tests may take three times as long
# In Python: BUILD='cp -r /submission/. .' RUN='python3 main.py "$scene" "$picture"' TESTS= docs/draw-class.sh …

submissions=$(realpath "$1") scenes=$(realpath "$2") out=$(realpath -m "$3")
if [ $# -eq 3 ]; then
    [ "$(id -u)" != 0 ] || { echo "run this as an ordinary user: Linux does not limit the processes of root" >&2; exit 2; }
    [ -n "${BUILD:-}" ] || [ -d "${HANDOUT:-}" ] || { echo "set HANDOUT to the folder of your hand-out, as in HANDOUT=../lab1 $0 …" >&2; exit 2; }
    mkdir -p "$out"
    exec parallel --will-cite --jobs 50% --joblog "$out/.jobs.log" --resume -0 "$(realpath "$0")" "$submissions" "$scenes" "$out" \
        < <(find "$submissions" -mindepth 1 -maxdepth 1 -type d -printf '%f\0' | sort -z)
fi

name=$4 work=$(mktemp -d) dotnet=$(dirname "$(readlink -f "$(command -v dotnet || echo /usr/bin/dotnet)")")
trap 'chmod -R u+rwX "$work"; rm -rf "$work"' EXIT
rm -rf "${out:?}/$name"
mkdir -p "$out/$name" "$work/home"

sandbox() { # seconds, "--bind" or "--ro-bind" of /work, a command. Nothing else is writable but /tmp, which is empty and in memory.
    prlimit --data=$((3 << 30)) --nproc=256 --fsize=$((64 << 20)) --core=0 timeout --kill-after=1 "$1" \
        bwrap --unshare-all --die-with-parent --new-session --clearenv --ro-bind /usr /usr --ro-bind /etc /etc \
        --symlink usr/bin /bin --symlink usr/lib /lib --symlink usr/lib64 /lib64 --proc /proc --dev /dev --size $((256 << 20)) --tmpfs /tmp \
        --ro-bind "$dotnet" "$dotnet" --ro-bind-try ~/.nuget/packages /packages --ro-bind "$scenes" /scenes \
        --ro-bind "$submissions/$name" /submission --ro-bind-try "${HANDOUT:-/nothing}" /handout "$2" "$work" /work --chdir /work \
        --setenv PATH "$dotnet:/usr/bin" --setenv HOME /tmp --setenv LANG C.UTF-8 --setenv NUGET_PACKAGES /packages --setenv DOTNET_NOLOGO 1 \
        sh -c "$3" </dev/null 2>>"$out/$name/log.txt" | head -c 64M
}

sandbox $((3 * limit)) --bind "($build) >&2" || echo "$name: the build failed" | tee -a "$out/$name/log.txt"
for scene in "$scenes"/*.json; do
    picture=$(basename "${scene%.json}").png
    sandbox "$limit" --ro-bind "scene='/scenes/${scene##*/}' picture='/tmp/$picture'; ($run) >&2; cat \"\$picture\"" >"$out/$name/$picture" ||
        echo "$name: $picture was not drawn" | tee -a "$out/$name/log.txt"
    [ -s "$out/$name/$picture" ] || rm "$out/$name/$picture"
done
[ -z "$tests" ] || sandbox $((3 * limit)) --bind "results=/tmp/results.xml; ($tests) >&2; cat \"\$results\"" >"$out/$name/results.xml" || true
