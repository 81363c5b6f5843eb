"""Reads the triangles of OBJ, PLY and STL files: what the reference scenes need of these formats."""

import struct


def read(path):
    """A list of triangles, each of three corners, each of three coordinates; polygons are split as a fan from their first corner."""
    reader = {".obj": read_obj, ".ply": read_ply, ".stl": read_stl}[path.suffix.lower()]
    return reader(path.read_bytes())


def fan(corners):
    return [[corners[0], corners[i], corners[i + 1]] for i in range(1, len(corners) - 1)]


def read_obj(data):
    vertices, triangles = [], []
    for line in data.decode("utf-8").replace("\\\n", " ").splitlines():
        words = line.split("#")[0].split()
        if words[:1] == ["v"]:
            vertices.append([float(word) for word in words[1:4]])
        elif words[:1] == ["f"]:
            places = [int(word.split("/")[0]) for word in words[1:]]
            triangles += fan([vertices[place - 1 if place > 0 else place] for place in places])
    return triangles


def read_stl(data):
    if len(data) >= 84 and len(data) == 84 + 50 * struct.unpack_from("<I", data, 80)[0]:
        floats = [struct.unpack_from("<9f", data, start + 12) for start in range(84, len(data), 50)]
        return [[list(f[i:i + 3]) for i in (0, 3, 6)] for f in floats]
    words = data.decode("utf-8").split()
    corners = [[float(word) for word in words[i + 1:i + 4]] for i, word in enumerate(words) if word == "vertex"]
    return [corners[i:i + 3] for i in range(0, len(corners), 3)]


PLY_TYPES = {"char": "b", "int8": "b", "uchar": "B", "uint8": "B", "short": "h", "int16": "h", "ushort": "H", "uint16": "H",
             "int": "i", "int32": "i", "uint": "I", "uint32": "I", "float": "f", "float32": "f", "double": "d", "float64": "d"}


def read_ply(data):
    end = data.index(b"\n", data.index(b"end_header")) + 1
    form, elements = "ascii", []
    for words in (line.split() for line in data[:end].decode("ascii").splitlines()):
        if words[0] == "format":
            form = words[1]
        elif words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            elements[-1][2].append((words[-1], words[1:-1]))

    if form == "ascii":
        words = iter(data[end:].decode("ascii").split())

        def number(kind):
            return float(next(words)) if kind in "fd" else int(next(words))
    else:
        order, place = "<" if form == "binary_little_endian" else ">", end

        def number(kind):
            nonlocal place
            value, = struct.unpack_from(order + kind, data, place)
            place += struct.calcsize(order + kind)
            return value

    vertices, triangles = [], []
    for name, count, properties in elements:
        for _ in range(count):
            item = {}
            for key, kind in properties:
                if kind[0] == "list":
                    item[key] = [number(PLY_TYPES[kind[2]]) for _ in range(number(PLY_TYPES[kind[1]]))]
                else:
                    item[key] = number(PLY_TYPES[kind[0]])
            if name == "vertex":
                vertices.append([item["x"], item["y"], item["z"]])
            elif name == "face":
                triangles += fan([vertices[i] for i in item.get("vertex_indices") or item["vertex_index"]])
    return triangles
