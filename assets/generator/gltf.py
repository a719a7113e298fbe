# SPDX-License-Identifier: MIT
"""Writes glTF 2.0 binary files (.glb): materials, meshes, nodes, cameras.

Textures, lights and motion have modules of their own.

https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html
"""

import json
import math
import os
import struct
import tempfile

from . import vector as v
from .mesh import Vertices

FLOAT, UINT8, UINT16, UINT32 = 5126, 5121, 5123, 5125
VERTICES, INDICES = 34962, 34963
COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
FORMATS = {FLOAT: "f", UINT8: "B", UINT16: "H", UINT32: "I"}


class Document:
    """A glTF file in the making. Each `add_` function returns the index of what it added."""

    def __init__(self, name):
        self.name = name
        self.binary = bytearray()
        self.root = {
            "asset": {"version": "2.0", "generator": "romascope"},
            "scene": 0,
            "scenes": [{"name": name, "nodes": []}],
        }

    def append(self, key, value):
        """Adds to the array of that name."""
        values = self.root.setdefault(key, [])
        values.append(value)
        return len(values) - 1

    def add_view(self, data, target=None):
        """A buffer view of its own for these bytes; `target`: VERTICES, INDICES or None."""
        self.binary += bytes(-len(self.binary) % 4)
        view = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)}
        if target is not None:
            view["target"] = target
        self.binary += data
        return self.append("bufferViews", view)

    def add_accessor(
        self, values, component, kind, target=None, bounds=False, normalized=False
    ):
        """Stores a list of tuples (of numbers for SCALAR) in a buffer view of its own.

        `component`: a key of FORMATS; `kind`: a key of COMPONENTS; `target`: as `add_view`;
        `bounds`: whether to write min and max; `normalized`: whether integers stand for [0, 1].
        """
        rows = [(x,) for x in values] if kind == "SCALAR" else values
        flat = [x for row in rows for x in row]
        data = struct.pack(f"<{len(flat)}{FORMATS[component]}", *flat)
        accessor = {
            "bufferView": self.add_view(data, target),
            "componentType": component,
            "count": len(rows),
            "type": kind,
        }
        if normalized:
            accessor["normalized"] = True
        if bounds:
            # Of the values as stored, rounded to their component type.
            size = COMPONENTS[kind]
            stored = struct.unpack(f"<{len(flat)}{FORMATS[component]}", data)
            accessor["min"] = [min(stored[i::size]) for i in range(size)]
            accessor["max"] = [max(stored[i::size]) for i in range(size)]
        return self.append("accessors", accessor)

    def add_material(
        self, name, color, emissive=None, roughness=0.9, double_sided=False, mask=None
    ):
        """`color`: linear reflectance, three numbers in [0, 1]; `emissive`: likewise, or None;
        `mask`: a texture whose alpha below 0.5 is not there."""
        material = {
            "name": name,
            "pbrMetallicRoughness": {
                "baseColorFactor": [*color, 1.0],
                "metallicFactor": 0.0,
                "roughnessFactor": roughness,
            },
        }
        if emissive is not None:
            material["emissiveFactor"] = list(emissive)
        if double_sided:
            material["doubleSided"] = True
        if mask is not None:
            material["pbrMetallicRoughness"]["baseColorTexture"] = {"index": mask}
            material["alphaMode"] = "MASK"
            material["alphaCutoff"] = 0.5
        return self.append("materials", material)

    def add_mesh(self, name, parts, **more):
        """One primitive for each material.

        `parts`: (material, pieces) pairs, pieces a Mesh, Vertices, or a list of them; those of one
        material have the same attributes and morph targets. `more`: what else glTF knows.
        """
        by_material = {}
        for material, pieces in parts:
            vertices = by_material.setdefault(material, Vertices())
            for piece in pieces if isinstance(pieces, list) else [pieces]:
                vertices.extend(piece if isinstance(piece, Vertices) else Vertices.of(piece))
        primitives = [self._primitive(*item) for item in by_material.items()]
        return self.append("meshes", {"name": name, "primitives": primitives, **more})

    def add_variant(self, mesh, swap):
        """The same mesh in other materials; `swap`: from material to material."""
        copy = json.loads(json.dumps(self.root["meshes"][mesh]))
        for primitive in copy["primitives"]:
            primitive["material"] = swap.get(primitive["material"], primitive["material"])
        return self.append("meshes", copy)

    def _primitive(self, material, vertices):
        attributes = {
            "POSITION": self.add_accessor(vertices.positions, FLOAT, "VEC3", VERTICES, True),
            "NORMAL": self.add_accessor(vertices.normals, FLOAT, "VEC3", VERTICES),
        }
        if vertices.texcoords:
            attributes["TEXCOORD_0"] = self.add_accessor(
                vertices.texcoords, FLOAT, "VEC2", VERTICES
            )
        if vertices.joints:
            attributes["JOINTS_0"] = self.add_accessor(vertices.joints, UINT8, "VEC4", VERTICES)
            attributes["WEIGHTS_0"] = self.add_accessor(
                vertices.weights, UINT8, "VEC4", VERTICES, normalized=True
            )
        small = len(vertices.positions) < 65536
        primitive = {
            "attributes": attributes,
            "indices": self.add_accessor(
                vertices.indices, UINT16 if small else UINT32, "SCALAR", INDICES
            ),
            "material": material,
        }
        if vertices.targets:
            primitive["targets"] = [
                {
                    "POSITION": self.add_accessor(moves, FLOAT, "VEC3", VERTICES, True),
                    "NORMAL": self.add_accessor(turns, FLOAT, "VEC3", VERTICES),
                }
                for moves, turns in vertices.targets
            ]
        return primitive

    def add_node(self, name, mesh=None, at=(0.0, 0.0, 0.0), turn=0.0, parent=None, **more):
        """An instance of a mesh, or a group, or with `more` anything else that glTF knows.

        `at`: metres; `turn`: degrees about y, as `vector.rotated_y`; `parent`: index of a node.
        """
        node = {"name": name, **more}
        if mesh is not None:
            node["mesh"] = mesh
        if any(at):
            node["translation"] = [round(x, 5) + 0.0 for x in at]
        if turn:
            half = math.radians(turn) / 2.0
            node["rotation"] = [0.0, round(math.sin(half), 7), 0.0, round(math.cos(half), 7) + 0.0]
        index = self.append("nodes", node)
        if parent is None:
            self.root["scenes"][0]["nodes"].append(index)
        else:
            self.root["nodes"][parent].setdefault("children", []).append(index)
        return index

    def add_camera(self, name, eye, target, vertical_fov, near=0.05):
        """A perspective camera that looks at `target`, y up; the angle in degrees."""
        camera = {
            "name": name,
            "type": "perspective",
            "perspective": {"yfov": round(math.radians(vertical_fov), 6), "znear": near},
        }
        return self.add_node(
            name,
            at=eye,
            camera=self.append("cameras", camera),
            rotation=looking(v.sub(target, eye)),
        )

    def triangle_count(self):
        """Triangles drawn, every instance counted."""
        accessors, meshes = self.root["accessors"], self.root["meshes"]
        counts = [
            sum(accessors[primitive["indices"]]["count"] // 3 for primitive in mesh["primitives"])
            for mesh in meshes
        ]
        return sum(counts[node["mesh"]] for node in self.root["nodes"] if "mesh" in node)

    def to_bytes(self):
        binary = bytes(self.binary) + bytes(-len(self.binary) % 4)
        root = {**self.root, "buffers": [{"byteLength": len(binary)}]}
        text = json.dumps(root, separators=(",", ":"), allow_nan=False).encode()
        text += b" " * (-len(text) % 4)
        chunks = struct.pack("<I4s", len(text), b"JSON") + text
        chunks += struct.pack("<I4s", len(binary), b"BIN\0") + binary
        return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks

    def write(self, path):
        """Writes the file; one of that name is replaced only once the new one is whole."""
        folder = os.path.dirname(os.path.abspath(path))
        handle, temporary = tempfile.mkstemp(dir=folder, suffix=".tmp")
        try:
            with os.fdopen(handle, "wb") as file:
                file.write(self.to_bytes())
            os.chmod(temporary, 0o644)
            os.replace(temporary, path)
        except BaseException:
            os.unlink(temporary)
            raise


def looking(direction):
    """Rotation (x, y, z, w) that takes -z into a direction and keeps x level."""
    back = v.normalized(v.scale(direction, -1.0))
    right = v.normalized(v.cross((0.0, 1.0, 0.0), back))
    return _quaternion(right, v.cross(back, right), back)


def _quaternion(x, y, z):
    """Rotation (x, y, z, w) that takes the coordinate axes to these three."""
    candidates = [
        (1 + x[0] - y[1] - z[2], lambda s: (s, x[1] + y[0], z[0] + x[2], y[2] - z[1])),
        (1 - x[0] + y[1] - z[2], lambda s: (x[1] + y[0], s, y[2] + z[1], z[0] - x[2])),
        (1 - x[0] - y[1] + z[2], lambda s: (z[0] + x[2], y[2] + z[1], s, x[1] - y[0])),
        (1 + x[0] + y[1] + z[2], lambda s: (y[2] - z[1], z[0] - x[2], x[1] - y[0], s)),
    ]
    largest, make = max(candidates, key=lambda candidate: candidate[0])
    q = make(largest)
    size = math.sqrt(sum(c * c for c in q))
    return [round(c / size, 7) + 0.0 for c in q]
