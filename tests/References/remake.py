"""Remakes reference pictures with POV-Ray: see README.md."""

import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

import scene_file
from scene_to_pov import pov

HERE = pathlib.Path(__file__).resolve().parent
SCENES = HERE.parent.parent / "scenes"
LONGEST_SIDE = 320
SHIFT = 1e-3                                     # of a pixel
NEIGHBOURHOOD = [(x, y) for x in (-SHIFT, SHIFT) for y in (-SHIFT, SHIFT)]


def size(camera):
    """The scene's own size, or the same shape with 320 pixels on the longer side."""
    width, height = camera["width"], camera["height"]
    longest = max(width, height)
    if longest <= LONGEST_SIDE:
        return width, height
    return max(1, round(width * LONGEST_SIDE / longest)), max(1, round(height * LONGEST_SIDE / longest))


def render(scene, width, height, shift=(0, 0)):
    """POV-Ray's 16-bit picture, rounded to bytes: red, green, blue, left to right, top to bottom."""
    with tempfile.TemporaryDirectory() as folder:
        source, picture = pathlib.Path(folder, "scene.pov"), pathlib.Path(folder, "scene.ppm")
        source.write_text(pov(scene, width, height, shift), encoding="ascii")
        run = subprocess.run(
            ["povray", f"+I{source}", f"+O{picture}", f"+W{width}", f"+H{height}", "+FP", "Bits_Per_Color=16", "File_Gamma=1",
             "Antialias=off", "Dither=off", "Display=off", "Verbose=off"],
            capture_output=True, text=True, check=False)
        if run.returncode != 0:
            raise SystemExit(f"povray failed:\n{run.stderr}")
        data = picture.read_bytes()
    samples = data[-width * height * 6:]
    return bytes((v * 255 + 32767) // 65535 for v in struct.unpack(f">{width * height * 3}H", samples))


def outline(scene, picture, width, height):
    """One byte for each pixel, 255 where the colour hangs on a thousandth of a pixel: outlines, edges, exact ties."""
    pixels = bytearray(width * height)
    for shift in NEIGHBOURHOOD:
        for i, (one, other) in enumerate(zip(picture, render(scene, width, height, shift))):
            if abs(one - other) > 1:             # a difference of 1 is rounding
                pixels[i // 3] = 255
    return bytes(pixels)


def write_png(path, width, height, channels, pixels):
    line = width * channels
    rows = b"".join(b"\0" + pixels[y * line:(y + 1) * line] for y in range(height))

    def chunk(name, content):
        return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))

    header = struct.pack(">IIBBBBB", width, height, 8, 2 if channels == 3 else 0, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def remake(name):
    scene = scene_file.read(SCENES / f"{name}.json")
    width, height = size(scene["camera"])
    picture = render(scene, width, height)
    pixels = outline(scene, picture, width, height)
    (HERE / name).parent.mkdir(exist_ok=True)
    write_png(HERE / f"{name}.png", width, height, 3, picture)
    mask = HERE / f"{name}.outline.png"
    mask.unlink(missing_ok=True)
    if any(pixels):
        write_png(mask, width, height, 1, pixels)
    count = pixels.count(255)
    return f"{name} {width}x{height} {count}"


def main(names):
    """Remakes the named references, or all. Prints of each its name, size, and the number of pixels on outlines."""
    for name in names or sorted(path.relative_to(SCENES).with_suffix("").as_posix() for path in SCENES.rglob("*.json")
                                if not path.name.endswith(".schema.json") and path.parent.name != "my"):
        print(remake(name))


main(sys.argv[1:])
