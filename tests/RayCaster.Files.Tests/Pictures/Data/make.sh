#!/bin/sh
# Makes the pictures of this folder with ImageMagick and netpbm (Debian: apt-get install imagemagick netpbm pngcheck).
#
# NAME.expected.ppm holds the pixels of all NAME.VARIANT.*: 8 bits a sample, alpha dropped, as netpbm rounds them.
# ImageMagick, which does not round, must read the same 16 bits a sample, or the script stops. Dates are left out, so a second run makes the
# same files.
set -eu
cd "$(dirname "$0")"
rm -f ./*.png ./*.ppm ./*.pgm
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# pattern P2|P3 WIDTH HEIGHT MAXVAL: all kinds of neighbours, every value of a small maxval.
pattern() {
    awk -v kind="$1" -v w="$2" -v h="$3" -v max="$4" 'BEGIN {
        print kind; print w, h; print max
        for (y = 0; y < h; y++) for (x = 0; x < w; x++) for (c = 0; c < (kind == "P3" ? 3 : 1); c++) {
            v = int((x + c) * max / (w + 2)) + (y % 5 == 0 ? 0 : y * y * (c + 3) + x * y * 7)
            print v % (max + 1)
        }
    }'
}

# colours COUNT: a picture of exactly so many colours.
colours() {
    awk -v n="$1" 'BEGIN {
        print "P3"; print 23, 17; print 255
        for (i = 0; i < 23 * 17; i++) { k = (i * 7 + int(i / 50)) % n; print k * 37 % 256, 255 - k, k * k % 256 }
    }'
}

# expect NAME: what all variants of a name show.
expect() {
    for file in "$1".*; do
        case $file in
            *.expected.ppm) continue ;;
            *.png) pngcheck -q "$file" >&2 && pngtopnm "$file" > "$work/pnm" ;;
            *) cat "$file" > "$work/pnm" ;;
        esac
        ppmtoppm < "$work/pnm" > "$work/netpbm.ppm"
        pamdepth -quiet 65535 "$work/netpbm.ppm" > "$work/netpbm16.ppm"
        convert "$file" -alpha off -depth 16 -endian MSB "$work/imagemagick.rgb"
        tail -c "$(wc -c < "$work/imagemagick.rgb")" "$work/netpbm16.ppm" | cmp - "$work/imagemagick.rgb" || { echo "in $file" >&2; exit 1; }
        pamdepth -quiet 255 "$work/netpbm.ppm" > "$work/expected.ppm"
        [ -e "$1.expected.ppm" ] || cp "$work/expected.ppm" "$1.expected.ppm"
        cmp "$work/expected.ppm" "$1.expected.ppm"
    done
}

# netpbm OUT [OPTION…] and magick OUT COLOUR-TYPE BIT-DEPTH [OPTION…] turn $work/in.pnm into PNG, line by line and interlaced.
netpbm() {
    out=$1; shift
    pnmtopng -quiet "$@" "$work/in.pnm" > "$out.netpbm.png"
    pnmtopng -quiet -interlace "$@" "$work/in.pnm" > "$out.netpbm-adam7.png"
}
magick() {
    out=$1; type=$2; depth=$3; shift 3
    for interlace in None PNG; do
        [ $interlace = None ] && suffix= || suffix=-adam7
        convert "$work/in.pnm" "$@" -interlace $interlace -define png:color-type="$type" -define png:bit-depth="$depth" \
            -define png:exclude-chunks=date,time,gama,chrm "$out.imagemagick$suffix.png"
    done
}

for bits in 1 2 4 8 16; do
    pattern P2 23 17 $(((1 << bits) - 1)) > "$work/in.pnm"
    netpbm grey-$bits
    magick grey-$bits 0 $bits
    expect grey-$bits
done
for bits in 8 16; do
    pattern P2 23 17 $(((1 << bits) - 1)) | pamflip -lr > "$work/alpha.pgm"

    pattern P2 23 17 $(((1 << bits) - 1)) > "$work/in.pnm"
    netpbm grey-alpha-$bits -force -alpha="$work/alpha.pgm"
    magick grey-alpha-$bits 4 $bits "$work/alpha.pgm" -alpha off -compose CopyOpacity -composite
    expect grey-alpha-$bits

    pattern P3 23 17 $(((1 << bits) - 1)) > "$work/in.pnm"
    netpbm rgb-alpha-$bits -alpha="$work/alpha.pgm"
    magick rgb-alpha-$bits 6 $bits "$work/alpha.pgm" -alpha off -compose CopyOpacity -composite
    expect rgb-alpha-$bits

    netpbm rgb-$bits
    magick rgb-$bits 2 $bits
    [ $bits = 16 ] || for filter in nofilter sub up avg paeth; do pnmtopng -quiet -$filter "$work/in.pnm" > rgb-8.netpbm-$filter.png; done
    echo 'Title  chunks that a reader may skip' > "$work/text"
    [ $bits = 16 ] || pnmtopng -quiet -gamma=0.3 -text="$work/text" "$work/in.pnm" > rgb-8.netpbm-gamma.png
    expect rgb-$bits
done
for bits in 1 2 4 8; do
    colours $(((1 << bits) * 3 / 4 + (bits == 1))) > "$work/in.pnm"
    netpbm palette-$bits
    pnmtopng -quiet -transparent="$(printf '#%02x%02x%02x' 37 254 1)" "$work/in.pnm" > palette-$bits.netpbm-transparent.png
    magick palette-$bits 3 $((bits == 1 ? 2 : bits)) # ImageMagick writes no palette in one bit
    expect palette-$bits
done
for size in 1x1 2x2 3x5 5x3 1x9 9x1; do
    pattern P3 ${size%x*} ${size#*x} 255 > "$work/in.pnm"
    netpbm size-$size -force
    magick size-$size 2 8
    expect size-$size
done

# ImageMagick and netpbm write text and bytes.
for max in 1 5 100 255 256 1000 65535; do
    if [ $max != 1 ]; then # with 1 they write a bitmap
        pattern P2 13 11 $max > "$work/in.pnm"
        pamtopnm "$work/in.pnm" > greymap-$max.netpbm-p5.pgm
        pnmtoplainpnm "$work/in.pnm" > greymap-$max.netpbm-p2.pgm
    fi
    pattern P3 13 11 $max > "$work/in3.pnm"
    pamtopnm "$work/in3.pnm" > pixmap-$max.netpbm-p6.ppm
    pnmtoplainpnm "$work/in3.pnm" > pixmap-$max.netpbm-p3.ppm
    case $max in
        255 | 65535)
            convert "$work/in.pnm" -set comment 'a comment' -compress none greymap-$max.imagemagick-p2.pgm
            convert "$work/in.pnm" -set comment 'a comment' greymap-$max.imagemagick-p5.pgm
            convert "$work/in3.pnm" -set comment 'a comment' -compress none pixmap-$max.imagemagick-p3.ppm
            convert "$work/in3.pnm" -set comment 'a comment' pixmap-$max.imagemagick-p6.ppm
            ;;
    esac
    [ $max = 1 ] || expect greymap-$max
    expect pixmap-$max
done
