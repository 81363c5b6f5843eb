#!/usr/bin/env python3
"""Writes a scene file as a POV-Ray 3.7 scene to standard output: scene_to_pov.py SCENE [WIDTH HEIGHT]"""

import math
import sys

import scene_file
from scene_file import cross, length, minus, times


def pov(scene, width=None, height=None, shift=(0, 0)):
    """The text of a .pov file. The shift moves every ray by a part of a pixel, to the right and upwards."""
    camera = scene["camera"]
    width, height = width or camera["width"], height or camera["height"]
    position = camera["position"]
    view = minus(camera["target"], position)

    # POV-Ray's limits are absolute (nothing nearer than 1e-4 or beyond 1e7, surfaces about 1e-6 thick), so the camera goes
    # to the origin and the target to a distance of about 10. A power of two changes no digit, and the picture is the same.
    unit = 2.0 ** -round(math.log2(length(view) / 10))

    W = times(-1 / length(view), view)
    U = cross(camera["up"], W)
    U = times(1 / length(U), U)
    V = cross(W, U)
    h = 2 * math.tan(math.radians(camera["fovY"]) / 2)
    w = h * width / height

    # POV-Ray's rays pass through the middle of a pixel: half a pixel to the left and down for its corner.
    half = 0.5 if camera["sample"] == "corner" else 0
    aside, above = w * (shift[0] - half) / width, h * (shift[1] - half) / height
    direction = [aside * u + above * v - q for u, v, q in zip(U, V, W)]

    near, far, bias = (unit * camera[key] for key in ("zNear", "zFar", "bias"))
    if camera["clip"] == "depth":
        clips = [f"plane {{ {vector(W)}, {-near!r} }}", f"plane {{ {vector(times(-1, W))}, {far!r} }}"]
    else:
        clips = [f"sphere {{ 0, {far!r} }}"] + ([f"sphere {{ 0, {near!r} inverse }}"] if near > 0 else [])
    if bias >= near and bias > 0:                # otherwise whatever passes zNear is beyond the bias too
        clips.append(f"sphere {{ 0, {bias!r} inverse }}")

    lines = [
        "#version 3.7;",
        "global_settings { assumed_gamma 1 ambient_light rgb 1 }",
        f"background {{ rgb {vector(scene['background'])} }}",
        # Explicit axes leave POV-Ray's left-handed coordinates nothing to turn round.
        f"camera {{ perspective location 0 direction {vector(direction)} right {vector(times(w, U))} up {vector(times(h, V))} }}",
    ]
    reach = 2 * unit * length(view)              # where the attenuation comes to 0
    for place, model in enumerate(scene["models"]):
        # Of two models at the same t the first in the file shows; POV-Ray shows either. Grown about the camera by one in 10^9 a model
        # looks the same and is that much farther away, so each stands behind those before it.
        grown = unit * (1 + place * 1e-9)

        def point(p):
            return vector(times(grown, minus(p, position)))

        shape = shapes[model["type"]](model, point, grown)
        if shape is None:
            continue
        kind, content = shape
        look = (f"pigment {{ spherical color_map {{ [0 rgb 0] [1 rgb {vector(model['color'])}] }} scale {reach!r} }} "
                "finish { ambient 1 diffuse 0 }")
        lines.append(f"{kind} {{ {content} clipped_by {{ {' '.join(clips)} }} {look} }}")
    return "\n".join(lines) + "\n"


def vector(v):
    return "<" + ", ".join(repr(float(c)) for c in v) + ">"


def plane(model, point, unit):
    n = model["normal"]
    n = times(1 / max(map(abs, n)), n)           # so that squares stay in range
    n = times(1 / length(n), n)
    # POV-Ray wants the distance from its origin; a plane at the origin that is moved afterwards keeps Q as it is.
    return "plane", f"{vector(n)}, 0 translate {point(model['point'])}"


def sphere(model, point, unit):
    return "sphere", f"{point(model['center'])}, {unit * model['radius']!r}"


def aabb(model, point, unit):
    low, high = model["min"], model["max"]
    flat = [axis for axis in range(3) if low[axis] == high[axis]]
    if not flat:
        return "box", f"{point(low)}, {point(high)}"
    if len(flat) > 1:
        return None                              # a line or a point: no ray of a reference scene meets it
    one, two = (axis for axis in range(3) if axis != flat[0])
    corners = [list(low), list(low), list(high), list(high)]
    corners[1][one] = high[one]
    corners[3][one] = low[one]
    return "polygon", "5, " + ", ".join(point(c) for c in corners + corners[:1])


def circle(model, point, unit):
    n = times(1 / max(map(abs, model["normal"])), model["normal"])
    return "disc", f"{point(model['center'])}, {vector(n)}, {unit * model['radius']!r}"


def triangle(model, point, unit):
    return "triangle", ", ".join(point(model[key]) for key in "abc")


def mesh(model, point, unit):
    return "mesh", "\n".join("triangle { " + ", ".join(map(point, corners)) + " }" for corners in model["triangles"])


shapes = {"plane": plane, "sphere": sphere, "aabb": aabb, "circle": circle, "triangle": triangle, "mesh": mesh}

if __name__ == "__main__":
    sys.stdout.write(pov(scene_file.read(sys.argv[1]), *map(int, sys.argv[2:4])))
