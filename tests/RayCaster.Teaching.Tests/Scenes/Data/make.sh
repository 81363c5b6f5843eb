#!/bin/sh
# Makes the float maps that PfmFileTests compares with, with netpbm's pamtopfm: small pictures whose levels are known.
set -e
cd "$(dirname "$0")"
printf 'P2\n3 2\n4\n0 1 2\n3 4 2\n' | pamtopfm -endian little > grey-little.netpbm.pfm
printf 'P3\n2 2\n4\n0 1 2  3 4 0\n 4 3 2  1 0 4\n' | pamtopfm -endian little > colours.netpbm.pfm
