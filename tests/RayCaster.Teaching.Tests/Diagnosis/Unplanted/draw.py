#!/usr/bin/env python3
"""Draws the pictures of Unplanted.txt that have an edit. Needs node."""
import pathlib, re, struct, subprocess, tempfile, zlib

here = pathlib.Path(__file__).resolve().parent
program = (here.parents[2] / "Campaigns/Foreign/javascript/cast.js").read_text()


def png(ppm):
    width, height = map(int, ppm.split(None, 3)[1:3])
    rgb = ppm[-3 * width * height:]
    lines = b"".join(b"\0" + rgb[3 * width * y:3 * width * (y + 1)] for y in range(height))

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(lines, 9)) + chunk(b"IEND", b""))


for line in (here / "Unplanted.txt").read_text().splitlines():
    cells = [cell.strip() for cell in re.split(r"(?<!\|)\|(?!\|)", line.lstrip("* "))]
    if line.startswith("#") or len(cells) < 3 or not cells[2]:
        continue
    old, new = cells[2].split(" → ")
    assert old in program, old
    with tempfile.NamedTemporaryFile("w", suffix=".js") as edited:
        edited.write(program.replace(old, new))
        edited.flush()
        ppm = subprocess.check_output(["node", edited.name, here / (cells[1] + ".json")])
    (here / (cells[0] + ".png")).write_bytes(png(ppm))
