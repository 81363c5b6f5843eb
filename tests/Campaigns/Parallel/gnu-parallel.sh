#!/usr/bin/env bash
# Parts of a picture drawn by GNU parallel, two at a time on this machine; one is killed, and running the same again finishes only what is missing.
. "$(dirname "$0")/common.sh"
need parallel pkill
make_program
mkdir parts

draw() {
    parallel --will-cite --jobs 2 raycaster part "$scene" "{}/$parts" -t 1 -s "$size" -o "$work/parts/{}.png" --resume ::: $(seq "$parts") 2>"$1"
}

kill_part 2 KILL &
killer=$!
code=0
draw first.log || code=$?
wait $killer
check "parallel tells that one part failed" [ "$code" -eq 1 ]
check "all other parts are there" [ "$(there)" -eq $((parts - 1)) ]
code=0
missing=$(raycaster stitch parts --missing) || code=$?
check "stitch says which lines are missing: $missing" [ "$code" -eq 1 ]
code=0
raycaster stitch parts -q -o no.png 2>no.log || code=$?
check "and joins nothing" [ "$code" -eq 1 -a ! -e no.png ]

draw second.log
check "run again, parallel draws that part only" \
    [ "$(grep -c 'exists already' second.log)" -eq $((parts - 1)) -a "$(grep -c 'lines ' second.log)" -eq 1 ]
compare

rm parts/3.png parts/5.png
raycaster stitch parts --missing >missing || true
parallel --will-cite --jobs 2 raycaster part "$scene" {} -q -t 1 -s "$size" -o "$work/parts/{}.png" :::: missing
check "the ranges that are missing are what part takes" raycaster stitch parts --missing
compare
finish
