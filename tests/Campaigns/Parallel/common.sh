# shellcheck shell=bash
# What the scripts beside this one share: a folder of their own, the program, a picture drawn in one go, and a part that is killed.
# Environment: RAYCASTER names a program that is built already; SIZE and PARTS set how much is drawn.

set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../../.." && pwd)
size=${SIZE:-6000x4000}
parts=${PARTS:-8}
scene=$root/scenes/mesh.json
checks=0

work=$(mktemp -d "${TMPDIR:-/tmp}/raycaster-parallel.XXXXXX")
mkdir "$work/bin"
cd "$work"
cleanups=()
clean_up() {
    local step
    set +e
    for step in "${cleanups[@]}"; do eval "$step"; done
    cd /
    rm -rf "$work"
}
trap clean_up EXIT
trap 'exit 1' INT TERM

need() { # the programs that a script cannot do without
    local program
    for program in "$@"; do
        PATH=$PATH:/usr/sbin command -v "$program" >/dev/null || { echo "$program is missing"; exit 77; }
    done
}

free_port() { python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'; }

passed() { checks=$((checks + 1)); echo "  ok: $*"; }
failed() { echo "  FAILED: $*" >&2; tail -n 5 ./*.log >&2; exit 1; }
check() { # check "what should hold" command...
    local what=$1
    shift
    "$@" || failed "$what"
    passed "$what"
}

wait_until() { # wait_until seconds command...: false if the time is over
    local end=$((SECONDS + $1))
    shift
    until "$@"; do
        [ $SECONDS -lt $end ] || return 1
        sleep 0.05
    done
}

make_program() {
    if [ -n "${RAYCASTER:-}" ]; then ln -s "$(realpath "$RAYCASTER")" bin/raycaster
    else dotnet publish "$root/src/RayCaster.Cli" -o "$work/bin" --nologo -v q >/dev/null
    fi
    export PATH=$work/bin:$PATH
    echo "raycaster $(raycaster --version), $size in $parts parts"
    [ -n "${skip_whole:-}" ] || raycaster -q "$scene" -s "$size" -o whole.ppm
}

kill_part() { # kill_part K SIGNAL: sends the Kth part a signal as soon as it writes
    wait_until 60 compgen -G "parts/$1.png.*.tmp" >/dev/null || failed "part $1 was not begun in a minute"
    pkill "-$2" -f "raycaster .*-o $work/parts/$1.png" || # and the shell that waits for it, where there is one; nobody else has this folder
        failed "part $1 was done before it got SIG$2; draw more: SIZE=9000x6000"
}

there() { # how many parts are there
    find parts -name '*.png' | wc -l
}

compare() { # the parts, joined, against the picture drawn in one go
    raycaster stitch parts -q -o stitched.ppm
    check "the parts are, joined, the picture that is drawn in one go, to the byte" cmp stitched.ppm whole.ppm
}

finish() {
    echo "$checks checks passed: $(basename "$0"), $(date -u +%Y-%m-%d), $(nproc) processors"
}
