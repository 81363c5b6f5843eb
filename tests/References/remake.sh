#!/bin/sh
# Remakes the reference pictures of the named scenes (room, not room.json), or of all: tests/References/remake.sh [scene ...]
set -eu
command -v povray >/dev/null || { echo "remake.sh: needs POV-Ray 3.7 (Debian: apt install povray)" >&2; exit 2; }
exec python3 -B "$(dirname "$0")/remake.py" "$@"
