# SPDX-License-Identifier: MIT
"""Writes a small scene, a box on a floor seen by two cameras, as a binary glTF file."""

import json
import math
import struct

# Corner signs of each face of a cube, counter-clockwise seen from outside.
FACES = {
    (1, 0, 0): [(1, -1, 1), (1, -1, -1), (1, 1, -1), (1, 1, 1)],
    (-1, 0, 0): [(-1, -1, -1), (-1, -1, 1), (-1, 1, 1), (-1, 1, -1)],
    (0, 1, 0): [(-1, 1, 1), (1, 1, 1), (1, 1, -1), (-1, 1, -1)],
    (0, -1, 0): [(-1, -1, -1), (1, -1, -1), (1, -1, 1), (-1, -1, 1)],
    (0, 0, 1): [(-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)],
    (0, 0, -1): [(1, -1, -1), (-1, -1, -1), (-1, 1, -1), (1, 1, -1)],
}


def box(center, half):
    """Positions, normals and triangle indices of an axis-aligned box."""
    positions, normals, indices = [], [], []
    for normal, corners in FACES.items():
        first = len(positions)
        indices += [first, first + 1, first + 2, first, first + 2, first + 3]
        for corner in corners:
            positions.append([c + h * s for c, h, s in zip(center, half, corner)])
            normals.append(normal)
    return positions, normals, indices


def camera_node(index, eye, pitch):
    """A node that looks down its -z axis, turned down by `pitch` radians."""
    turn = [-math.sin(pitch / 2), 0, 0, math.cos(pitch / 2)]
    return {"camera": index, "translation": eye, "rotation": turn}


def box_on_floor():
    """The scene as glTF's JSON and its buffer."""
    buffer = bytearray()
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "buffers": [{}],
        "bufferViews": [],
        "accessors": [],
        "meshes": [],
        "materials": [],
        "cameras": [],
    }

    def accessor(rows, form, component, kind, bounds):
        data = b"".join(struct.pack(form, *row) for row in rows)
        document["bufferViews"].append(
            {"buffer": 0, "byteOffset": len(buffer), "byteLength": len(data)})
        buffer.extend(data)
        entry = {"bufferView": len(document["bufferViews"]) - 1, "componentType": component,
                 "count": len(rows), "type": kind}
        if bounds:
            entry["min"] = [min(column) for column in zip(*rows)]
            entry["max"] = [max(column) for column in zip(*rows)]
        document["accessors"].append(entry)
        return len(document["accessors"]) - 1

    parts = [((0, -0.1, 0), (3, 0.1, 3), [0.8, 0.8, 0.8, 1]),
             ((0, 0.5, 0), (0.5, 0.5, 0.5), [0.8, 0.3, 0.2, 1])]
    for center, half, color in parts:
        positions, normals, indices = box(center, half)
        document["materials"].append({"pbrMetallicRoughness": {"baseColorFactor": color}})
        document["meshes"].append({"primitives": [{
            "attributes": {"POSITION": accessor(positions, "<3f", 5126, "VEC3", True),
                           "NORMAL": accessor(normals, "<3f", 5126, "VEC3", False)},
            "indices": accessor([[i] for i in indices], "<I", 5125, "SCALAR", False),
            "material": len(document["meshes"])}]})
    document["cameras"] = [
        {"name": name, "type": "perspective", "perspective": {"yfov": 0.9, "znear": 0.01}}
        for name in ("front", "above")]
    document["nodes"] = [{"mesh": 0}, {"mesh": 1}, camera_node(0, [0, 1.2, 3.5], 0.25),
                         camera_node(1, [0, 5, 0.01], math.pi / 2)]
    document["scenes"] = [{"nodes": list(range(len(document["nodes"])))}]
    document["buffers"][0]["byteLength"] = len(buffer)
    return document, bytes(buffer)


def write_glb(path, document, buffer):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    buffer += b"\0" * (-len(buffer) % 4)
    with open(path, "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + len(buffer)))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text)
        file.write(struct.pack("<I4s", len(buffer), b"BIN\0") + buffer)
