#!/usr/bin/env bash
# A picture as wide as pictures may be, in parts and in one go: memory must not depend on its height, and both must be the same file.
SIZE=${SIZE:-1000000x400} PARTS=${PARTS:-4}
. "$(dirname "$0")/common.sh"
need time
scene=$root/scenes/room.json
most=${MOST_MEGABYTES:-400}
measured() { # measured what command...: runs it and checks its greatest memory
    local what=$1 seconds kilobytes
    shift
    command time -f '%e %M' -o time.txt "$@" || failed "$what"
    read -r seconds kilobytes <time.txt
    check "$what: $((kilobytes / 1024)) MB of memory, $seconds s; at most $most MB are allowed" [ $((kilobytes / 1024)) -le "$most" ]
}
skip_whole=1
make_program
mkdir parts
for k in $(seq "$parts"); do measured "part $k" raycaster part "$scene" "$k/$parts" -q -s "$size" -o "parts/$k.png"; done
measured "the stitch" raycaster stitch parts -q -o stitched.png
rm -r parts
measured "all in one go" raycaster -q "$scene" -s "$size" -o whole.png
check "both are the same file" cmp stitched.png whole.png
finish
