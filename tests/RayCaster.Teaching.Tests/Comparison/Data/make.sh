#!/bin/sh
# Makes measures.txt, the measures of pictures as ImageMagick's "compare" has them (6.9.11 was used). Needs
# convert and compare. The pictures are a scene's and what ImageMagick makes of it.
#   tests/RayCaster.Teaching.Tests/Comparison/Data/make.sh
set -e
cd "$(dirname "$0")"
convert ../../../References/mistakes/generic.png -crop 96x64+100+60 +repage -strip reference.ppm
convert reference.ppm -flip flipped.ppm
convert reference.ppm -gamma 2.2 gamma.ppm
convert reference.ppm -blur 0x1 blurred.ppm
convert reference.ppm -roll +1+0 moved.ppm
convert reference.ppm -fill '#204060' -draw 'rectangle 20,10 60,30' box.ppm
for name in flipped gamma blurred moved box; do
    # of 65535 and, in brackets, of 1
    measure() { compare -metric "$1" "$name.ppm" reference.ppm null: 2>&1 || true; }
    in_brackets() { measure "$1" | sed 's/.*(\(.*\))/\1/'; }
    echo "$name $(measure AE) $(in_brackets PAE) $(in_brackets MAE)"
done > measures.txt
cat measures.txt
