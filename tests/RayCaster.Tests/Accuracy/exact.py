"""Judges our ray parameters against exact arithmetic; see README.md.

The numbers of a ray and its shape are doubles, so they are whole numbers times a power of two. A row's points are brought to one such
power, its direction to another, its normal to a third; then every crossing is a fraction of whole numbers (the sphere's after a root of
more digits than matter), and so is its difference from ours.
"""
import array
import math
import multiprocessing
import os
import struct
import sys
from fractions import Fraction
from math import frexp, isnan, isinf, ldexp

REGIMES = ["ordinary", "scaled", "moved", "far", "extreme", "remote", "close", "on", "inside", "grazing", "outline", "distant", "parallel",
           "flat", "sliver"]
NUMBERS = {"plane": 12, "sphere": 10, "aabb": 12, "circle": 13, "triangle": 15}
ROOT_BITS = 160
PIXEL = 2 * math.tan(math.radians(45) / 2) / 1000  # of a picture of 1000 lines with fovY 45, at distance 1
INFINITY = float("inf")


def whole(*numbers):
    """The numbers as integers times one power of two, and the exponent: number = integer * 2 ** -exponent."""
    k = 53 - min(frexp(number)[1] for number in numbers if number) if any(numbers) else 0
    return [int(ldexp(number, k)) for number in numbers], k


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def minus(a, b):
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def length(v):
    """Of a vector of integers or fractions of any size."""
    largest = max(abs(x) for x in v)
    return largest, math.sqrt(sum(float(Fraction(x, largest)) ** 2 for x in v)) if largest else 0.0


def ratio_of_lengths(a, b):
    (la, fa), (lb, fb) = length(a), length(b)
    return float(Fraction(la, lb)) * fa / fb


class Crossing:
    """Where the exact ray meets the exact shape: t = numerator / denominator * 2 ** -shift."""

    __slots__ = ("numerator", "denominator", "shift", "slope")

    def __init__(self, numerator, denominator, shift, slope):
        self.numerator, self.denominator, self.shift = numerator, denominator, shift
        self.slope = slope  # how fast the ray leaves the surface: a function of t's error, in the unit of t

    def fraction(self):
        t = Fraction(self.numerator, self.denominator)
        return t / 2 ** self.shift if self.shift >= 0 else t * 2 ** -self.shift

    def error(self, t):
        """Of our t: in units of the last place of the exact t (None where that is 0), and as a length."""
        s = 53 - frexp(t)[1]
        ours, shift = int(ldexp(t, s)), self.shift - s
        numerator, denominator = self.numerator, self.denominator
        if shift >= 0:
            difference = (ours << shift) * denominator - numerator
        else:
            difference = ours * denominator - (numerator << -shift)
            denominator <<= -shift
            numerator <<= -shift
        error = ldexp(abs(difference / denominator), -self.shift)
        if not numerator:
            return None, error
        return abs(difference / numerator) * abs(frexp(numerator / denominator)[0]) * 2.0 ** 53, error


# Each shape: the row's doubles -> (near, far, largest distance, how far the ray passes from the outline), crossings None where there is
# none. The last is a function, for it is called only where a decision differs: -> (in sizes of the shape, in pixels).

def plane(row):
    (p0, p1, p2, q0, q1, q2), k = whole(*row[0:3], *row[6:9])
    d, kd = whole(*row[3:6])
    n, _ = whole(*row[9:12])
    L = (q0 - p0, q1 - p1, q2 - p2)
    numerator, denominator = dot(L, n), dot(d, n)
    reach = ldexp(math.sqrt(dot(L, L)), -k)
    if denominator == 0:
        return None, None, reach, None
    slope = abs(denominator) / (math.sqrt(float(dot(n, n))) * math.sqrt(float(dot(d, d))))
    return Crossing(numerator, denominator, k - kd, lambda e: e * slope), None, reach, None


def sphere(row):
    (p0, p1, p2, c0, c1, c2, R), k = whole(*row[0:3], *row[6:10])
    d, kd = whole(*row[3:6])
    L = (c0 - p0, c1 - p1, c2 - p2)
    a, b, LL = dot(d, d), dot(L, d), dot(L, L)
    c = LL - R * R
    disc = b * b - a * c
    reach = ldexp(math.sqrt(LL), -k) + row[9]

    def miss():
        beyond = float(Fraction(-disc, 2 * a * R * R))  # (D^2 - R^2) / 2 R^2, of which D/R - 1 is the first term
        return abs(beyond), abs(beyond) * row[9] / max(reach - row[9], 1e-300) / PIXEL

    if disc < 0:
        return None, None, reach, miss
    # Both roots without cancellation, from b + sign(b) * root.
    root = math.isqrt(disc << 2 * ROOT_BITS)
    q = (b << ROOT_BITS) + (root if b >= 0 else -root)
    half = ldexp(float(root >> ROOT_BITS) / float(a), kd - k)  # half of the chord

    def slope(e):
        return e * (2 * half + e) / (2 * row[9])

    one = Crossing(c << ROOT_BITS, q, k - kd, slope) if q else Crossing(0, 1, 0, slope)
    two = Crossing(q, a << ROOT_BITS, k - kd, slope)
    return (one, two, reach, miss) if b >= 0 else (two, one, reach, miss)


def aabb(row):
    ints, k = whole(*row[0:3], *row[6:12])
    d, kd = whole(*row[3:6])
    reach = max(max(abs(row[6 + i] - row[i]), abs(row[9 + i] - row[i])) for i in range(3))
    near = far = None
    nearSlope = farSlope = 0
    outside = False
    for i in range(3):
        lo, hi, di = ints[3 + i] - ints[i], ints[6 + i] - ints[i], d[i]
        if di == 0:
            outside |= not lo <= 0 <= hi
            continue
        if di < 0:
            lo, hi, di = -hi, -lo, -di
        if near is None or lo * near[1] > near[0] * di:
            near, nearSlope, nearAxis = (lo, di), abs(row[3 + i]), i
        if far is None or hi * far[1] < far[0] * di:
            far, farSlope, farAxis = (hi, di), abs(row[3 + i]), i
    gap = near[0] * far[1] - far[0] * near[1]

    def miss():
        size = max(row[9 + i] - row[6 + i] for i in range(3))
        sideways = min(abs(row[3 + nearAxis]), abs(row[3 + farAxis]))
        length = abs(ldexp(gap / (near[1] * far[1]), kd - k)) * sideways
        return length / size, length / max(abs(ldexp(near[0] / near[1], kd - k)), 1e-300) / PIXEL

    if outside or gap > 0:
        return None, None, reach, miss
    return (Crossing(*near, k - kd, lambda e: e * nearSlope), Crossing(*far, k - kd, lambda e: e * farSlope), reach, miss)


def circle(row):
    ints, k = whole(*row[0:3], *row[6:9], row[12])
    d, kd = whole(*row[3:6])
    n, _ = whole(*row[9:12])
    P, C, R = ints[0:3], ints[3:6], ints[6]
    L = minus(C, P)
    numerator, denominator = dot(L, n), dot(d, n)
    reach = ldexp(math.sqrt(dot(L, L)), -k) + row[12]
    if denominator == 0:
        return None, None, reach, lambda: (0, 0)
    # X - C, times the denominator
    X = tuple(numerator * d[i] - denominator * L[i] for i in range(3))
    inside = dot(X, X) <= (denominator * R) ** 2

    def miss():
        (largest, factor) = length(X)
        radius = Fraction(largest, abs(denominator))
        away = float(radius / R * Fraction(factor) - 1)
        r = [float(Fraction(x, largest)) / factor for x in X]
        nl = math.sqrt(float(dot(n, n)))
        nn, dd = [x / nl for x in n], row[3:6]
        tilt = dot(r, dd) / dot(dd, nn)
        across = math.sqrt(sum((r[i] - nn[i] * tilt) ** 2 for i in range(3)))
        seen = abs(away) / max(across, 1e-300)
        t = abs(ldexp(numerator / denominator, kd - k))
        return seen, seen * row[12] / max(t, 1e-300) / PIXEL

    if not inside:
        return None, None, reach, miss
    slope = abs(denominator) / (math.sqrt(float(dot(n, n))) * math.sqrt(float(dot(d, d))))
    return Crossing(numerator, denominator, k - kd, lambda e: e * slope), None, reach, miss


def triangle(row):
    ints, k = whole(*row[0:3], *row[6:15])
    d, kd = whole(*row[3:6])
    P = ints[0:3]
    a, b, c = minus(ints[3:6], P), minus(ints[6:9], P), minus(ints[9:12], P)
    n = cross(minus(b, a), minus(c, a))
    reach = ldexp(math.sqrt(max(dot(a, a), dot(b, b), dot(c, c))), -k)
    numerator, denominator = dot(a, n), dot(d, n)
    u, v, w = dot(d, cross(b, c)), dot(d, cross(c, a)), dot(d, cross(a, b))

    def miss():
        # The corners moved along d into the plane across it through P; there the ray is the origin.
        dd = dot(d, d)
        flat = [tuple(x[i] * dd - dot(x, d) * d[i] for i in range(3)) for x in (a, b, c)]
        side = max(ratio_of_lengths(minus(x, y), (1, 0, 0)) for x, y in ((a, b), (b, c), (c, a)))
        least = min(to_segment(flat[i], flat[(i + 1) % 3]) for i in range(3)) / dd
        depth = abs(ldexp(numerator / denominator, kd - k)) if denominator else reach
        return least / side, ldexp(least, -k) / max(depth, 1e-300) / PIXEL

    if denominator == 0 or not (u >= 0 and v >= 0 and w >= 0 or u <= 0 and v <= 0 and w <= 0):
        return None, None, reach, miss
    slope = abs(denominator / math.isqrt(dot(n, n) * dot(d, d))) if dot(n, n) else 0
    return Crossing(numerator, denominator, k - kd, lambda e: e * slope), None, reach, miss


def to_segment(p, q):
    """The distance of the origin from a segment."""
    e = minus(q, p)
    ee = dot(e, e)
    s = min(max(Fraction(-dot(p, e), ee), 0), 1) if ee else 0
    nearest = [p[i] + s * e[i] for i in range(3)]
    largest = max(abs(x) for x in nearest)
    return float(largest) * math.sqrt(sum(float(x / largest) ** 2 for x in nearest)) if largest else 0.0


SHAPES = {"plane": plane, "sphere": sphere, "aabb": aabb, "circle": circle, "triangle": triangle}


def judge(job):
    """A file of rays and one of our crossings with them: the line of the table, and its worst cases."""
    path, keep = job
    shape, regime = os.path.basename(path)[:-5].split("-")
    exact, count = SHAPES[shape], NUMBERS[shape]
    row_bytes = struct.Struct(f"<{count}d")
    errors, worst, wrong = array.array("d"), [], []
    rays = hits = false_hits = false_misses = zeros = 0
    most_off = most_size = most_pixels = 0.0
    with open(path, "rb") as file, open(path[:-5] + ".crossings", "rb") as crossings:
        data, answers = file.read(), crossings.read()
    for row, ours in zip(row_bytes.iter_unpack(data), struct.iter_unpack("<2d", answers), strict=True):
        rays += 1
        near, far, reach, miss = exact(row)
        is_hit = not isnan(ours[0]) and not isinf(ours[0])
        if is_hit != (near is not None):
            if is_hit:
                false_hits += 1
            else:
                false_misses += 1
            size, pixels = miss() if miss else (0.0, 0.0)
            most_size, most_pixels = max(most_size, size), max(most_pixels, pixels)
            wrong.append((size, rays, row))
            continue
        if near is None:
            continue
        hits += 1
        most = 0.0
        for crossing, t in ((near, ours[0]), (far, ours[1])):
            if crossing is None:
                continue
            ulps, error = crossing.error(t)
            off = crossing.slope(error) / (max(abs(t), reach) * 2.0 ** -53)
            most_off = max(most_off, off)
            if ulps is None:
                zeros += 1
                if t:
                    most = INFINITY
            else:
                errors.append(ulps)
                most = max(most, ulps)
        if len(worst) < keep or most > worst[-1][0]:
            worst.append((most, rays, row))
            worst.sort(key=lambda case: (-case[0], case[1]))
            del worst[keep:]
    errors = sorted(errors)
    wrong.sort(key=lambda case: (-case[0], case[1]))
    cases = [case_line(shape, regime, row) for _, _, row in worst] + [case_line(shape, regime, row) for _, _, row in wrong[:4]]
    part = lambda share: errors[min(len(errors) - 1, int(share * len(errors)))] if errors else 0.0
    line = (shape, regime, rays, hits, part(0.5), part(0.99), errors[-1] if errors else 0.0, most_off, false_hits, false_misses, most_size,
            most_pixels, zeros)
    return line, cases


def case_line(shape, regime, row):
    """A kept case: the row's doubles as 16 hexadecimal digits each, then the exact near and far t to 30 digits, "none" for none."""
    numbers = row[:NUMBERS[shape]]
    near, far = textbook(shape, numbers)
    words = [struct.pack(">d", number).hex() for number in numbers]
    return " ".join([shape, regime, *words, near, far])


def textbook(shape, row):
    """The crossings once more, by the formulas of the textbook in mpmath with 700 digits, to be checked against the integers."""
    from mpmath import mp, mpf, nstr, sqrt
    mp.dps = 700
    x = [mpf(number) for number in row]
    P, d = x[0:3], x[3:6]
    write = lambda t: "0" if t == 0 else nstr(t, 30, strip_zeros=False, min_fixed=1, max_fixed=0)
    none = ("none", "none")
    on_plane = lambda Q, n: dot(minus(Q, P), n) / dot(d, n) if dot(d, n) else None
    if shape == "plane":
        t = on_plane(x[6:9], x[9:12])
        result = none if t is None else (write(t), "none")
    elif shape == "sphere":
        L, a = minus(x[6:9], P), dot(d, d)
        b = dot(L, d)
        disc = b * b - a * (dot(L, L) - x[9] ** 2)
        result = none if disc < 0 else (write((b - sqrt(disc)) / a), write((b + sqrt(disc)) / a))
    elif shape == "aabb":
        ways = [sorted(((x[6 + i] - P[i]) / d[i], (x[9 + i] - P[i]) / d[i])) for i in range(3) if d[i]]
        beside = any(not d[i] and not x[6 + i] <= P[i] <= x[9 + i] for i in range(3))
        near, far = max(way[0] for way in ways), min(way[1] for way in ways)
        result = none if beside or near > far else (write(near), write(far))
    elif shape == "circle":
        t = on_plane(x[6:9], x[9:12])
        X = None if t is None else minus([P[i] + t * d[i] for i in range(3)], x[6:9])
        result = none if t is None or dot(X, X) > x[12] ** 2 else (write(t), "none")
    else:
        A, B, C = x[6:9], x[9:12], x[12:15]
        e1, e2, s = minus(B, A), minus(C, A), minus(P, A)
        h = cross(d, e2)
        determinant = dot(e1, h)
        if not determinant:
            result = none
        else:
            u, v = dot(s, h) / determinant, dot(d, cross(s, e1)) / determinant
            result = (write(dot(e2, cross(s, e1)) / determinant), "none") if u >= 0 and v >= 0 and u + v <= 1 else none
    check(shape, row, result)
    return result


def check(shape, row, result):
    """The integers and mpmath must agree to 28 digits."""
    near, far, _, _ = SHAPES[shape](row)
    for crossing, text in zip((near, far), result):
        if (crossing is None) != (text == "none"):
            raise SystemExit(f"{shape} {row}: mpmath says {text}, the integers {crossing and crossing.fraction()}")
        if crossing is not None and abs(crossing.fraction() - Fraction(text)) > abs(Fraction(text)) / 10 ** 28:
            raise SystemExit(f"{shape} {row}: mpmath says {text}, the integers {float(crossing.fraction())!r}")


def number(x):
    return "0" if x == 0 else f"{x:.2f}" if 0.01 <= x < 1000 else f"{x:.2e}".replace("e+0", "e").replace("e+", "e").replace("e-0", "e-")


def main():
    if len(sys.argv) != 3:
        raise SystemExit("usage: python3 exact.py <folder of .rays files> <file for the worst cases>")
    folder, kept = sys.argv[1:]
    paths = [os.path.join(folder, f"{shape}-{regime}.rays") for shape in SHAPES for regime in REGIMES]
    paths = [path for path in paths if os.path.exists(path)]
    with multiprocessing.Pool(2) as pool, open(kept, "w") as cases:
        for line, worst in pool.imap(judge, [(path, 12) for path in paths]):
            shape, regime, rays, hits, *numbers, false_hits, false_misses, size, pixels, zeros = line
            print("|", " | ".join([shape, regime, f"{rays:,}", f"{hits:,}", *map(number, numbers), f"{false_hits:,}", f"{false_misses:,}",
                                   number(size), number(pixels)]), "|", flush=True)
            if zeros:
                print(f"{shape} {regime}: t is exactly 0 in {zeros}", file=sys.stderr)
            cases.writelines(case + "\n" for case in worst)


if __name__ == "__main__":
    main()
