#!/bin/sh
# Makes the float map that PfmFileTests compares with, with netpbm's pamtopfm: a small picture whose levels are known.
set -e
cd "$(dirname "$0")"
printf 'P2\n3 2\n4\n0 1 2\n3 4 2\n' | pamtopfm -endian little > grey-little.netpbm.pfm
