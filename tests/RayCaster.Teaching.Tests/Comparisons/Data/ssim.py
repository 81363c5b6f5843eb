#!/usr/bin/env python3
"""SSIM of two binary PPMs as its definition has it, without any short cut: python3 ssim.py MINE.ppm REFERENCE.ppm

For each pixel and channel a window of 11 x 11 pixels under a Gaussian, sigma 1.5, pixels beyond the border being those on it;
the mean over all pixels and channels. ImageMagick 6 has no SSIM to compare with; 7 takes the same windows, but its figures differ between
versions."""
import math, sys


def read(path):
    data = open(path, "rb").read()
    magic, width, height, maximum = data.split(None, 4)[:4]
    assert magic == b"P6" and maximum == b"255"
    width, height = int(width), int(height)
    return width, height, data[-3 * width * height:]


(width, height, a), (other_width, other_height, b) = read(sys.argv[1]), read(sys.argv[2])
assert (width, height) == (other_width, other_height)
kernel = {(i, j): math.exp(-(i * i + j * j) / (2 * 1.5 ** 2)) for i in range(-5, 6) for j in range(-5, 6)}
weight = sum(kernel.values())
c1, c2 = 0.01 ** 2, 0.03 ** 2
total = 0
for y in range(height):
    for x in range(width):
        for channel in range(3):
            mx = my = xx = yy = xy = 0
            for (i, j), k in kernel.items():
                at = (min(max(y + j, 0), height - 1) * width + min(max(x + i, 0), width - 1)) * 3 + channel
                p, q, k = a[at] / 255, b[at] / 255, k / weight
                mx, my, xx, yy, xy = mx + k * p, my + k * q, xx + k * p * p, yy + k * q * q, xy + k * p * q
            total += ((2 * mx * my + c1) * (2 * (xy - mx * my) + c2)
                      / ((mx * mx + my * my + c1) * (xx - mx * mx + yy - my * my + c2)))
print(total / (width * height * 3))
