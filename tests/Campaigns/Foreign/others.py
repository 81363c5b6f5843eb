"""Draws pictures that no ray caster of the course draws:  python3 others.py FOLDER

Clouds of noise as in a photo, gradients, a fractal, a chessboard, and three of another renderer, with light, shadow and fog."""

import sys

import numpy as np

WIDTH, HEIGHT = 150, 100
Y, X = np.mgrid[0:HEIGHT, 0:WIDTH]
X, Y = X / WIDTH, Y / HEIGHT


def save(name, image):
    data = (np.clip(image, 0, 1) * 255 + 0.5).astype(np.uint8)
    with open(f"{sys.argv[1]}/foreign-{name}.ppm", "wb") as file:
        file.write(b"P6\n%d %d\n255\n" % (WIDTH, HEIGHT) + data.tobytes())


def clouds(seed, slope):
    """Noise whose spectrum falls as that of photographs does."""
    random = np.random.default_rng(seed)
    frequency = np.hypot(np.fft.fftfreq(HEIGHT)[:, None] * HEIGHT, np.fft.fftfreq(WIDTH)[None, :] * WIDTH)
    frequency[0, 0] = 1
    layers = [np.fft.ifft2(np.fft.fft2(random.normal(size=(HEIGHT, WIDTH))) / frequency ** slope).real for _ in range(4)]
    image = np.stack([layers[3] + 0.4 * layer for layer in layers[:3]], axis=-1)
    return 0.5 + image / (5 * image.std())


def mandelbrot():
    c = (X * 3 - 2.2) + 1j * (Y * 2.2 - 1.1)
    z, count = np.zeros_like(c), np.zeros(c.shape)
    for _ in range(60):
        inside = abs(z) < 2
        z[inside] = z[inside] ** 2 + c[inside]
        count += inside
    share = count / 60
    return np.stack([share ** 0.3, share ** 0.8, 1 - share], axis=-1)


def lit(mode):
    """Balls on a checked floor, seen without perspective, with one lamp."""
    x, y = (X - 0.5) * 6, (0.5 - Y) * 4
    depth = np.full(x.shape, np.inf)
    normal, color = np.zeros(x.shape + (3,)), np.zeros(x.shape + (3,))
    floor = y < -0.4
    depth[floor] = 4 - 2 * (y[floor] + 0.4)
    normal[floor] = [0, 1, 0]
    checks = (np.floor(x * 1.5) + np.floor(y * 4)) % 2
    color[floor] = np.where(checks[floor][:, None] > 0, 0.85, 0.25)
    for cx, cy, cz, r, tint in [(-1.4, 0, 3, 0.9, [0.8, 0.2, 0.2]), (0.4, -0.2, 2, 0.7, [0.2, 0.6, 0.3]), (1.8, 0.4, 4, 1.1, [0.3, 0.3, 0.9])]:
        inside = (x - cx) ** 2 + (y - cy) ** 2 < r * r
        dz = np.sqrt(np.where(inside, r * r - (x - cx) ** 2 - (y - cy) ** 2, 0))
        nearer = inside & (cz - dz < depth)
        depth[nearer] = (cz - dz)[nearer]
        normal[nearer] = (np.stack([x - cx, y - cy, -dz], axis=-1) / r)[nearer]
        color[nearer] = tint
    hit = np.isfinite(depth)
    lamp = np.array([-0.5, 0.7, -0.5]) / np.sqrt(0.99)
    diffuse = np.clip(normal @ lamp, 0, 1)
    image = color * (0.15 + 0.85 * diffuse)[..., None] + (np.clip(normal @ lamp, 0, 1) ** 40)[..., None] * 0.6
    sky = np.stack([0.5 + 0.3 * Y, 0.7 + 0.2 * Y, np.ones_like(Y)], axis=-1)
    if mode == "normals":
        return np.where(hit[..., None], normal * 0.5 + 0.5, 0)
    if mode == "fog":
        fog = np.exp(-0.4 * np.where(hit, depth, np.inf))[..., None]
        return image * fog + np.array([0.7, 0.7, 0.75]) * (1 - fog)
    return np.where(hit[..., None], image, sky)


def main():
    save("clouds-1", clouds(1, 1.0))
    save("clouds-2", clouds(2, 1.4))
    save("static", np.random.default_rng(3).random((HEIGHT, WIDTH, 3)))
    save("gradient", np.stack([X, 1 - X, Y], axis=-1))
    save("rings", np.stack([np.hypot(X - 0.5, Y - 0.5), np.cos(20 * np.hypot(X - 0.3, Y - 0.6)) / 2 + 0.5, 0.3 + 0 * X], axis=-1))
    save("mandelbrot", mandelbrot())
    save("chessboard", np.where((np.floor(X * 12) + np.floor(Y * 8)) % 2 > 0, 0.9, 0.1)[..., None] * np.ones(3))
    for mode in ("lit", "normals", "fog"):
        save(mode, lit(mode))


main()
