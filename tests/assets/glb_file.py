# SPDX-License-Identifier: MIT
"""Reads the scenes' .glb files and checks, on the way, what the format demands of them.

https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html
"""

import json
import struct

FORMATS = {5121: "B", 5123: "H", 5125: "I", 5126: "f"}
COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


class GlbFile:
    def __init__(self, path):
        with open(path, "rb") as file:
            content = file.read()
        self.size = len(content)
        magic, version, length = struct.unpack_from("<4sII", content)
        assert (magic, version, length) == (b"glTF", 2, len(content))
        length, kind = struct.unpack_from("<I4s", content, 12)
        assert kind == b"JSON" and length % 4 == 0
        self.root = json.loads(content[20 : 20 + length])
        start = 20 + length
        length, kind = struct.unpack_from("<I4s", content, start)
        assert kind == b"BIN\0" and start + 8 + length == len(content)
        self.binary = content[start + 8 :]
        self.rows = [self._rows(accessor) for accessor in self.root["accessors"]]

    def view(self, index):
        view = self.root["bufferViews"][index]
        first = view["byteOffset"]
        assert first % 4 == 0 and first + view["byteLength"] <= len(self.binary)
        return self.binary[first : first + view["byteLength"]]

    def _rows(self, accessor):
        """Tuples as stored; min and max, where given, are those of the data."""
        size = COMPONENTS[accessor["type"]]
        data = self.view(accessor["bufferView"])
        values = struct.unpack(f"<{accessor['count'] * size}{FORMATS[accessor['componentType']]}",
            data)
        rows = [values[i : i + size] for i in range(0, len(values), size)]
        if "min" in accessor:
            assert accessor["min"] == [min(column) for column in zip(*rows)]
            assert accessor["max"] == [max(column) for column in zip(*rows)]
        return rows

    def triangles(self, primitive):
        """Triples of positions, in the mesh's own space."""
        positions = self.rows[primitive["attributes"]["POSITION"]]
        indices = [i for (i,) in self.rows[primitive["indices"]]]
        return [tuple(positions[k] for k in indices[i : i + 3]) for i in range(0, len(indices), 3)]

    def parents(self):
        parent = [None] * len(self.root["nodes"])
        for i, node in enumerate(self.root["nodes"]):
            for child in node.get("children", []):
                assert parent[child] is None
                parent[child] = i
        return parent

    def matrices(self):
        """Per node: its matrix to the world without animation, three rows of four."""
        nodes, parent, known = self.root["nodes"], self.parents(), {}

        def of(i):
            if i not in known:
                own = local_matrix(nodes[i])
                known[i] = own if parent[i] is None else product(of(parent[i]), own)
            return known[i]

        return [of(i) for i in range(len(nodes))]

    def bounds(self):
        """Lowest and highest corner of everything drawn, without animation or morphing."""
        points = []
        for node, matrix in zip(self.root["nodes"], self.matrices()):
            if "mesh" in node:
                matrix = IDENTITY if "skin" in node else matrix
                for primitive in self.root["meshes"][node["mesh"]]["primitives"]:
                    for p in self.rows[primitive["attributes"]["POSITION"]]:
                        points.append(transformed(matrix, p))
        columns = list(zip(*points))
        return [min(c) for c in columns], [max(c) for c in columns]


IDENTITY = ((1.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0))


def local_matrix(node):
    x, y, z, w = node.get("rotation", (0.0, 0.0, 0.0, 1.0))
    s, t = node.get("scale", (1.0, 1.0, 1.0)), node.get("translation", (0.0, 0.0, 0.0))
    rotation = (
        (1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
        (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
        (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)),
    )
    return tuple(
        tuple(row[k] * s[k] for k in range(3)) + (shift,) for row, shift in zip(rotation, t)
    )


def product(a, b):
    return tuple(
        tuple(sum(row[k] * b[k][c] for k in range(3)) + (row[3] if c == 3 else 0.0)
            for c in range(4))
        for row in a
    )


def transformed(matrix, p):
    return tuple(row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3] for row in matrix)
