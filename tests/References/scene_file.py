"""Reads a scene file with all its defaults, from the format's description alone: nothing here is shared with the C# program."""

import json
import math
import pathlib

import mesh_file


def read(path):
    """The scene as plain dictionaries, every key present; a mesh becomes a list of placed triangles under the key "triangles"."""
    path = pathlib.Path(path)
    scene = json.loads(without_comments(path.read_text(encoding="utf-8-sig")))
    camera = {"up": [0, 0, 1], "fovY": 45, "width": 500, "height": 500, "zNear": 0.01, "zFar": 100, "bias": 1e-6,
              "clip": "depth", "sample": "corner", **scene["camera"]}
    models = [{"color": [1, 1, 1], **model} for model in scene["models"]]
    for model in models:
        model["color"] = color(model["color"])
        if model["type"] == "mesh":
            model["triangles"] = placed(mesh_file.read(path.parent / model["file"]), model)
    return {"camera": camera, "background": color(scene.get("background", [0, 0, 0])), "models": models}


def without_comments(text):
    """JSON proper: // and /* */ comments and trailing commas become spaces, strings stay as they are."""
    kept, i = [], 0
    while i < len(text):
        if text[i] == '"':
            end = i + 1
            while text[end] != '"':
                end += 2 if text[end] == "\\" else 1
            kept.append(text[i:end + 1])
            i = end + 1
        elif text.startswith("//", i):
            while i < len(text) and text[i] not in "\r\n":
                i += 1
        elif text.startswith("/*", i):
            i = text.index("*/", i) + 2
            kept.append(" ")
        else:
            if text[i] in "]}":
                last = len(kept) - 1
                while kept[last].isspace():
                    last -= 1
                if kept[last] == ",":
                    kept[last] = " "
            kept.append(text[i])
            i += 1
    return "".join(kept)


def color(value):
    if isinstance(value, str):
        return [int(value[i:i + 2], 16) / 255 for i in (1, 3, 5)]
    return value


def placed(triangles, model):
    """Rz Ry Rx (scale p) + translate for each corner; triangles without an area are dropped."""
    scale = model.get("scale", 1)
    scale = scale if isinstance(scale, list) else [scale] * 3
    turns = [turn(degrees) for degrees in model.get("rotate", [0, 0, 0])]
    move = model.get("translate", [0, 0, 0])

    def place(p):
        x, y, z = (s * c for s, c in zip(scale, p))
        (sx, cx), (sy, cy), (sz, cz) = turns
        y, z = cx * y - sx * z, sx * y + cx * z
        x, z = cy * x + sy * z, cy * z - sy * x
        x, y = cz * x - sz * y, sz * x + cz * y
        return [x + move[0], y + move[1], z + move[2]]

    return [t for t in ([place(p) for p in triangle] for triangle in triangles) if has_area(*t)]


def turn(degrees):
    """Sine and cosine, exact for quarter turns."""
    quarter = {0: (0, 1), 90: (1, 0), 180: (0, -1), 270: (-1, 0)}
    radians = math.radians(degrees)
    return quarter.get(degrees % 360) or (math.sin(radians), math.cos(radians))


def has_area(a, b, c):
    longest = max(math.dist(a, b), math.dist(b, c), math.dist(c, a))
    return length(cross(minus(b, a), minus(c, a))) > 1e-12 * longest * longest


def minus(a, b):
    return [p - q for p, q in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def times(k, a):
    return [k * p for p in a]


def length(a):
    return math.hypot(*a)
