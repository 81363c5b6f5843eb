"""A ray caster the way a student of NumPy writes it: all pixels at once, in arrays.

    python3 cast.py SCENE [--mistake ID[,ID]] > picture.ppm

The camera is a matrix, whose columns are right, up and back. The sphere is the reduced quadratic, the box the slabs
as arrays, the triangle the signed volumes of three tetrahedra. The picture's first line is cast first.
"id" in WRONG asks whether the mistake of that name was ordered on the command line.
"""

import json
import re
import sys

import numpy as np

WRONG = set(sys.argv[3].split(",")) if len(sys.argv) == 4 else set()


# ---------- vectors: the last axis is x, y, z ----------

def dot(a, b):
    return (a * b).sum(axis=-1)


def cross(a, b):
    ax, ay, az = a[..., 0], a[..., 1], a[..., 2]
    bx, by, bz = b[..., 0], b[..., 1], b[..., 2]
    y = az * bx - ax * bz
    if "cross-y" in WRONG:
        y = ax * bz - az * bx
    return np.stack([ay * bz - az * by, y, ax * by - ay * bx], axis=-1)


def length(a):
    squared = dot(a, a)
    return squared if "len-nosqrt" in WRONG else np.sqrt(squared)


def normalize(a):
    return a / length(a)[..., None]


# ---------- the scene ----------

def read_scene(path):
    with open(path, encoding="utf-8-sig") as file:
        text = file.read()
    token = re.compile(r'"(?:[^"\\]|\\.)*"|//[^\n]*|/\*.*?\*/', re.S)
    text = token.sub(lambda m: m.group() if m.group().startswith('"') else " ", text)
    return json.loads(re.sub(r",(\s*[}\]])", r"\1", text))


def color_of(value):
    if isinstance(value, str):
        return np.array([int(value[i:i + 2], 16) / 255 for i in (1, 3, 5)])
    return np.array(value, float)


def vector(value):
    return np.array(value, float)


# ---------- crossings: arrays of t, the nearest first, no number where there is none ----------

def cross_plane(origin, d, point, normal):
    slope = d @ normal
    t = np.where(slope != 0, ((point - origin) @ normal) / slope, np.nan)
    if "plane-cull" in WRONG:
        t[slope >= 0] = np.nan
    return t


def cross_circle(origin, d, center, normal, radius):
    # Not cross_plane: that one culls for "plane-cull", which here is a matter of planes alone.
    slope = d @ normal
    t = np.where(slope != 0, ((center - origin) @ normal) / slope, np.nan)
    if "circ-inf" in WRONG:
        return [t]
    offset = origin + t[..., None] * d - center
    limit = radius if "circ-nosq" in WRONG else radius ** 2
    return [np.where(dot(offset, offset) <= limit, t, np.nan)]


def cross_sphere(origin, d, center, radius):
    oc = center - origin if "oc-sign" in WRONG else origin - center
    a = dot(d, d)
    half_b = d @ oc
    c = oc @ oc - (radius if "r-nosq" in WRONG else radius ** 2)
    root = np.sqrt(half_b ** 2 - a * c)
    near, far = (-half_b - root) / a, (-half_b + root) / a
    if "far-root" in WRONG:
        return [far]
    if "near-root-only" in WRONG:
        return [near]
    return [near, far]


def cross_box(origin, d, low, high):
    axes = slice(0, 2) if "slab-2axes" in WRONG else slice(0, 3)
    o, d, low, high = origin[axes], d[..., axes], low[axes], high[axes]
    t0, t1 = (low - o) / d, (high - o) / d
    least, greatest = np.minimum(t0, t1), np.maximum(t0, t1)
    flat = d == 0  # such a ray is between the two faces, or beside them
    between = (low <= o) & (o <= high)
    least = np.where(flat, np.where(between, -np.inf, np.inf), least)
    greatest = np.where(flat, np.where(between, np.inf, -np.inf), greatest)
    t_in, t_out = least.max(axis=-1), greatest.min(axis=-1)
    miss = t_in > t_out
    t_in, t_out = np.where(miss, np.nan, t_in), np.where(miss, np.nan, t_out)
    if "slab-tmax" in WRONG:
        return [t_out]
    if "slab-inside" in WRONG:
        return [t_in]
    return [t_in, t_out]


def cross_triangle(origin, d, a, b, c):
    a, b, c = a - origin, b - origin, c - origin
    opposite_a, opposite_b, opposite_c = d @ cross(b, c), d @ cross(c, a), d @ cross(a, b)
    normal = cross(b - a, c - a)
    volume = d @ normal
    sign = np.sign(volume)
    inside = sign != 0
    if "tri-uv" not in WRONG:
        inside &= opposite_a * sign >= 0
    if "tri-neg" not in WRONG:
        inside &= (opposite_b * sign >= 0) & (opposite_c * sign >= 0)
    if "tri-cull" in WRONG:
        inside &= volume < 0
    return [np.where(inside, (a @ normal) / volume, np.nan)]


def crossings(model, origin, d):
    kind = model["type"]
    if kind == "plane":
        return [cross_plane(origin, d, vector(model["point"]), vector(model["normal"]))]
    if kind == "sphere":
        return cross_sphere(origin, d, vector(model["center"]), model["radius"])
    if kind == "aabb":
        return cross_box(origin, d, vector(model["min"]), vector(model["max"]))
    if kind == "circle":
        return cross_circle(origin, d, vector(model["center"]), vector(model["normal"]), model["radius"])
    return cross_triangle(origin, d, vector(model["a"]), vector(model["b"]), vector(model["c"]))


# ---------- the picture ----------

def camera_matrix(camera):
    back = vector(camera["position"]) - vector(camera["target"])
    up = vector(camera.get("up", [0, 0, 1]))
    if "w-sign" in WRONG:
        back = -back
    if "w-unnorm" not in WRONG:
        back = normalize(back)
    right = cross(back, up) if "u-cross" in WRONG else cross(up, back)
    if "u-unnorm" not in WRONG:
        right = normalize(right)
    above = cross(right, back) if "v-cross" in WRONG else cross(back, right)
    if "v-up" in WRONG:
        above = up
    if "u-only" in WRONG:
        right = -right
    return np.column_stack([right, above, back])


def directions(camera, width, height, matrix):
    fov = camera.get("fovY", 45)
    angle = fov if "rad" in WRONG else np.radians(fov)
    view_height = 2 * np.tan(angle if "nohalf" in WRONG else angle / 2)
    if "no2" in WRONG:
        view_height /= 2
    view_width = view_height * width / height
    if "aspect-inv" in WRONG:
        view_width = view_height * height / width
    if "aspect-none" in WRONG:
        view_width = view_height
    if "fov-horiz" in WRONG:
        view_width, view_height = view_height, view_height * height / width

    centers = (camera.get("sample", "corner") == "center") != ("center" in WRONG)
    shift = 0.5 if centers else 0.0
    x = np.arange(width) + shift
    y = np.arange(height - 1, -1, -1) + shift  # the picture's first line is the highest row
    last = 1 if "wm1" in WRONG else 0
    if "pix-int" in WRONG:
        across, along = x // width, y // height
    else:
        across, along = x / (width - last), y / (height - last)
    if "no-center" not in WRONG:
        across, along = across - 0.5, along - 0.5
    u, v = np.meshgrid(across * view_width, along * view_height)
    d = np.stack([u, v, -np.ones_like(u)], axis=-1) @ matrix.T
    return d if "dir-unnorm" in WRONG else normalize(d)


def draw(scene):
    camera = scene["camera"]
    width, height = int(camera.get("width", 500)), int(camera.get("height", 500))
    near, far, bias = camera.get("zNear", 0.01), camera.get("zFar", 100), camera.get("bias", 1e-6)
    position = vector(camera["position"])
    matrix = camera_matrix(camera)
    d = directions(camera, width, height, matrix)
    depth_of_1 = -(d @ matrix)[..., 2]

    def clipped(t):
        depth, distance = t * depth_of_1, t
        if camera.get("clip", "depth") == "distance":
            depth, distance = distance, depth
        too_near = (distance if "znear-t" in WRONG else depth) < near
        too_far = (distance if "zfar-t" in WRONG else depth) > far
        if "no-znear" in WRONG or "no-t0" in WRONG:
            too_near[:] = False
        if "no-zfar" in WRONG:
            too_far[:] = False
        return too_near | too_far

    def refused(t):
        behind = t < 0 if bias == 0 else t <= bias
        if "no-t0" in WRONG:
            behind[:] = False
        return behind if "clip-after" in WRONG else behind | clipped(t)

    nothing = -np.inf if "far-hit" in WRONG else np.inf
    layers = []
    for model in scene["models"]:
        ts = crossings(model, position, d)
        t = ts[0]
        if len(ts) == 2:
            t = np.where(refused(t), ts[1], t)
        no_hit = refused(t)
        if not ("disc-nan" in WRONG and model["type"] == "sphere"):
            no_hit |= np.isnan(t)
        layers.append(np.where(no_hit, nothing, t))
    layers = np.array(layers)

    if "far-hit" in WRONG:
        winner = layers.argmax(axis=0)
    elif "last-hit" in WRONG:
        winner = len(layers) - 1 - (layers != nothing)[::-1].argmax(axis=0)
    else:
        winner = layers.argmin(axis=0)
    t = np.take_along_axis(layers, winner[None], axis=0)[0]
    hit = ~np.isinf(t)
    if "clip-after" in WRONG:
        hit &= ~clipped(t)

    distance = length(position - vector(camera["target"]))
    attenuation = 1 - t / (2 * distance)
    if "att-no2" in WRONG:
        attenuation = 1 - t / distance
    if "att-none" in WRONG:
        attenuation = np.ones_like(t)
    if "noclamp" not in WRONG:
        attenuation = np.maximum(attenuation, 0)
    colors = np.array([color_of(model.get("color", [1, 1, 1])) for model in scene["models"]])
    return np.where(hit[..., None], attenuation[..., None] * colors[winner], color_of(scene.get("background", [0, 0, 0])))


def to_bytes(image):
    if "noclamp" not in WRONG:
        image = np.clip(image, 0, 1)
    return np.nan_to_num(image * 255 + 0.5, nan=0).astype(np.int64).astype(np.uint8)


def main():
    with np.errstate(all="ignore"):
        image = to_bytes(draw(read_scene(sys.argv[1])))
    if "rows" in WRONG:
        image = image[::-1]
    if "bgr" in WRONG:
        image = image[..., ::-1]
    if "transpose" in WRONG:
        image = image.transpose(1, 0, 2)
    height, width = image.shape[:2]
    if "whswap" in WRONG:
        width, height = height, width
    line_end = b"\r\n" if "crlf" in WRONG else b"\n"
    sys.stdout.buffer.write(b"P6\n%d %d\n255" % (width, height) + line_end + image.tobytes())


main()
