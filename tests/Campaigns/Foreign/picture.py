"""Turns a PPM into a PNG:  python3 picture.py MINE.ppm MINE.png [OTHER.ppm ...]

Fails if the picture does not differ visibly from each of the others: at least 40 pixels by more than 2 levels."""

import struct
import sys
import zlib


def read_ppm(path):
    with open(path, "rb") as file:
        data = file.read()
    _, width, height, maximum = data.split(None, 4)[:4]
    pixels = data[data.index(maximum, data.index(height)) + len(maximum) + 1:]
    return int(width), int(height), pixels[:3 * int(width) * int(height)]


def write_png(path, width, height, pixels):
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    stride = 3 * width
    lines = b""
    for y in range(height):
        line = pixels[y * stride:(y + 1) * stride]
        above = pixels[(y - 1) * stride:y * stride] if y else bytes(stride)
        lines += b"\2" + bytes((a - b) & 255 for a, b in zip(line, above))
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
                   + chunk(b"IDAT", zlib.compress(lines, 9)) + chunk(b"IEND", b""))


def differ(one, other):
    """How many pixels differ by more than 2 levels; all, if the sizes do."""
    if one[:2] != other[:2]:
        return one[0] * one[1]
    a, b = one[2], other[2]
    return sum(max(abs(a[i + k] - b[i + k]) for k in range(3)) > 2 for i in range(0, len(a), 3))


def main(mine, png, *others):
    picture = read_ppm(mine)
    for other in others:
        if differ(picture, read_ppm(other)) < 40:
            sys.exit(f"{png} would not differ visibly from {other}")
    write_png(png, *picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
