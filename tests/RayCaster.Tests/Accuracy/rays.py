"""Makes the rays that exact.py judges: a file of rows for each shape and kind of ray; see README.md.

A row is a ray and its shape as little-endian doubles: P, d, then what the scene file says of the shape (plane Q n, sphere C R,
aabb B0 B1, circle C n R, triangle a b c).
"""
import math
import os
import random
import struct
import sys
from types import SimpleNamespace as Target


def plus(a, b, k=1.0):
    return [x + k * y for x, y in zip(a, b)]


def times(k, v):
    return [k * x for x in v]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def normalized(v):
    return [x / math.hypot(*v) for x in v]


def number(reach):
    return random.uniform(-reach, reach)


def point(reach):
    return [number(reach) for _ in range(3)]


def grid_point():
    return [random.randint(-256, 256) / 16 for _ in range(3)]


def direction():
    while True:
        v = point(1)
        if 0.01 < math.hypot(*v) < 1:
            return normalized(v)


def across(n):
    """A direction at a right angle to n."""
    return normalized(cross(direction(), n))


def power(least, most):
    return 10 ** random.uniform(least, most)


# A shape about 1 large near the origin, and places to aim at. points, normal, radius: the shape itself; aim: a point in or near it;
# outline: a point on an edge or corner (a sphere has none); surface: a point of it, with its normal; inside: a point in the body.

def plane():
    Q, n = point(1), direction()
    X = plus(Q, across(n), 3)
    return Target(points=[Q], normal=times(random.uniform(0.5, 1.5), n), radius=None, aim=X, surface=X, up=n)


def sphere():
    C, R, up = point(1), random.uniform(0.2, 1.2), direction()
    return Target(points=[C], normal=None, radius=R, aim=plus(C, point(1), 1.2 * R), surface=plus(C, up, R), up=up,
                  inside=plus(C, point(1), 0.5 * R))


def aabb(flat=False):
    a, b = point(1), point(1)
    if flat:
        thin = random.randrange(3)
        b[thin] = a[thin]
    low, high = list(map(min, a, b)), list(map(max, a, b))

    def between(beyond):
        return [lo + (hi - lo) * (0.5 + (0.5 + beyond) * number(1)) for lo, hi in zip(low, high)]

    inside = between(0)
    face, edge, up, axis, end = list(inside), list(inside), [0.0] * 3, random.randrange(3), random.choice((low, high))
    face[axis], up[axis] = end[axis], 1.0 if end is high else -1.0
    free = random.randrange(4)  # the axis that the edge follows; none for a corner
    for i in range(3):
        if i != free:
            edge[i] = random.choice((low, high))[i]
    return Target(points=[low, high], normal=None, radius=None, aim=between(0.2), outline=edge, surface=face, up=up, inside=inside)


def circle():
    C, n, R = point(1), direction(), random.uniform(0.2, 1.2)

    def at(part):
        return plus(C, across(n), part * R)

    return Target(points=[C], normal=times(random.uniform(0.5, 1.5), n), radius=R, aim=at(random.uniform(0, 1.2)), outline=at(1),
                  surface=at(random.random()), up=n)


def triangle(a=None, b=None, c=None):
    a, b, c = a or point(1), b or point(1), c or point(1)

    def weighted(u, v):
        return [x + u * (y - x) + v * (z - x) for x, y, z in zip(a, b, c)]

    (u, v), part = (random.random(), random.random()), random.random()
    outline = random.choice((weighted(0, 0), weighted(part, 0), weighted(1 - part, part), weighted(0, part)))
    return Target(points=[a, b, c], normal=None, radius=None, aim=weighted(1.2 * u - 0.1, 1.2 * v - 0.1), outline=outline,
                  surface=weighted(u, v) if u + v < 1 else weighted(1 - u, 1 - v), up=normalized(cross(plus(b, a, -1), plus(c, a, -1))))


def sliver():
    """A triangle whose height is 1e-3 to 1e-11 of its base; one of less than 1e-12 is a line."""
    a, b = point(1), point(1)
    base = plus(b, a, -1)
    c = plus(plus(a, base, random.random()), across(normalized(base)), math.hypot(*base) * power(-11, -3))
    return triangle(a, b, c)


def row(target, P, towards, scale=1.0, of_normal=1.0, by=(0.0, 0.0, 0.0)):
    numbers = plus(times(scale, P), by) + normalized(towards)
    for corner in target.points:
        numbers += plus(times(scale, corner), by)
    numbers += times(of_normal, target.normal) if target.normal else []
    return numbers + ([scale * target.radius] if target.radius else [])


def aimed(target, P, at=None, **change):
    return row(target, P, plus(at or target.aim, P, -1), **change)


def far():
    return times(power(2, 8), direction())


def outline(target, P):
    """Of a sphere the outline is a circle that lies a little before C."""
    at = getattr(target, "outline", None)
    if not at:
        (C,), R = target.points, target.radius
        L = plus(C, P, -1)
        sine = min(1.0, R / math.hypot(*L))
        at = plus(plus(C, normalized(L), -sine * R), across(normalized(L)), math.sqrt(1 - sine * sine) * R)
    return aimed(target, P, at)


def grazing(target):
    back = plus(times(random.uniform(1, 10), across(target.up)), target.up, power(-12, -1))
    return row(target, plus(target.surface, back), times(-1, back))


def remote(target):
    target.points[0] = plus(target.points[0], across(target.up), power(2, 8))
    return aimed(target, point(10))


def parallel(_):
    """Along one or two of the slabs of a box, and often exactly in a face."""
    a, b, P, d = grid_point(), grid_point(), grid_point(), direction()
    for axis in random.choice(((0,), (1,), (2,), (0, 1))):
        d[axis] = 0.0
    axis = random.randrange(3)
    P[axis] = random.choice((a, b))[axis]
    return row(Target(points=[list(map(min, a, b)), list(map(max, a, b))], normal=None, radius=None), P, d)


KINDS = {
    "ordinary": lambda target: aimed(target, point(10)),
    "scaled": lambda target: aimed(target, point(10), scale=power(-30, 40), of_normal=power(-200, 200)),
    "moved": lambda target: aimed(target, point(10), by=far()),
    "far": lambda target: aimed(target, far()),
    "extreme": lambda target: aimed(target, far(), scale=power(-30, 32), of_normal=power(-200, 200)),
    "close": lambda target: row(target, plus(target.surface, target.up, power(-8, -1)), direction()),
    "on": lambda target: row(target, target.surface, direction()),
    "grazing": grazing,
    "outline": lambda target: outline(target, point(10)),
    "distant": lambda target: outline(target, far()),
}
SHAPES = {"plane": plane, "sphere": sphere, "aabb": aabb, "circle": circle, "triangle": triangle}


def kinds():
    """Every shape and every way to look at it."""
    for shape, make in SHAPES.items():
        for kind, aim in KINDS.items():
            if shape != "plane" or kind not in ("outline", "distant"):
                yield shape, kind, make, aim
        if shape in ("sphere", "aabb"):
            yield shape, "inside", make, lambda target: row(target, target.inside, direction())
    yield "plane", "remote", plane, remote
    yield "aabb", "parallel", aabb, parallel
    yield "aabb", "flat", lambda: aabb(flat=True), KINDS["ordinary"]
    yield "triangle", "sliver", sliver, KINDS["ordinary"]


def main():
    if len(sys.argv) != 3:
        raise SystemExit("usage: python3 rays.py <folder> <number of rays of each kind>")
    folder, count = sys.argv[1], int(sys.argv[2])
    os.makedirs(folder, exist_ok=True)
    for shape, kind, make, aim in kinds():
        random.seed(f"{shape} {kind}")
        with open(os.path.join(folder, f"{shape}-{kind}.rays"), "wb") as file:
            for _ in range(count):
                numbers = aim(make())
                file.write(struct.pack(f"<{len(numbers)}d", *numbers))


if __name__ == "__main__":
    main()
