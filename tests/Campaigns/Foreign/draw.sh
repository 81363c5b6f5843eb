#!/usr/bin/env bash
# Draws the pictures of expected.csv again. It needs gcc, node, and python3 with NumPy.
# It fails if a picture does not differ visibly from the right one, or a pair of mistakes from each of the two.
set -eu
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
gcc -O2 -std=c99 -o "$work/cast" c/cast.c -lm

cast() { # manner, scene, mistakes joined by + (or right)
    local to="$work/$1-$2-$3.ppm" options=()
    [ "$3" = right ] || options=(--mistake "${3//+/,}")
    if [ ! -e "$to" ]; then
        case $1 in
            c) "$work/cast" "scenes/$2" "${options[@]}" ;;
            numpy) python3 numpy/cast.py "scenes/$2" "${options[@]}" ;;
            javascript) node javascript/cast.js "scenes/$2" "${options[@]}" ;;
        esac >"$to"
    fi
    echo "$to"
}

python3 others.py "$work"
while IFS=, read -r picture scene ids; do
    manner=${picture%%-*} others=()
    if [ "$ids" = none ]; then
        case $picture in
            foreign-scene-*) mine=$(cast c "${picture#foreign-scene-}.json" right) ;;
            *) mine=$work/$picture.ppm ;;
        esac
    else
        mine=$(cast "$manner" "$scene" "$ids")
        [ "$ids" = right ] || others=("$(cast "$manner" "$scene" right)")
        case $ids in
            *+*) others+=("$(cast "$manner" "$scene" "${ids%+*}")" "$(cast "$manner" "$scene" "${ids#*+}")") ;;
        esac
    fi
    python3 picture.py "$mine" "pictures/$picture.png" "${others[@]}"
done < <(tail -n +2 expected.csv)
