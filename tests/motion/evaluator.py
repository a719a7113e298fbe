# SPDX-License-Identifier: MIT
"""Where the triangles of a glTF file stand at a time, in double precision, from the specification
alone: nothing here is shared with the renderer. Plain and slow.

Takes what is valid glTF 2.0 without compression; the default scene, or the first.
"""
import base64
import bisect
import json
import math
import pathlib
import struct
import urllib.parse

FORMATS = {5120: "b", 5121: "B", 5122: "h", 5123: "H", 5125: "I", 5126: "f"}
LARGEST = {5120: 127.0, 5121: 255.0, 5122: 32767.0, 5123: 65535.0}
COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


# --- matrices: lists of four rows ----------------------------------------------------------------

def multiply(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def from_columns(numbers):
    return [[float(numbers[4 * column + row]) for column in range(4)] for row in range(4)]


IDENTITY = [[float(i == j) for j in range(4)] for i in range(4)]


def rotated(q, v):
    """v turned by the unit quaternion (x, y, z, w): v + 2 u x (u x v + w v)."""
    u, w = q[:3], q[3]
    inner = [a + w * b for a, b in zip(cross(u, v), v)]
    return [a + 2.0 * b for a, b in zip(v, cross(u, inner))]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(v):
    size = math.sqrt(dot(v, v))
    return [x / size for x in v] if size > 0.0 else list(v)


def inverse_transpose(matrix):
    """Rows of it, of the upper left 3 x 3; None if there is none. The columns of the inverse are cross
    products of the rows, over the determinant."""
    x, y, z = (row[:3] for row in matrix[:3])
    determinant = dot(x, cross(y, z))
    if abs(determinant) <= 1e-9 * math.prod(math.sqrt(dot(row, row)) for row in (x, y, z)):
        return None
    return [[value / determinant for value in pair] for pair in (cross(y, z), cross(z, x), cross(x, y))]


class File:
    def __init__(self, path):
        self.folder = pathlib.Path(path).parent
        content = pathlib.Path(path).read_bytes()
        self.chunk = b""
        if content[:4] == b"glTF":
            length = struct.unpack_from("<I", content, 12)[0]
            self.json = json.loads(content[20:20 + length])
            self.chunk = content[28 + length:]
        else:
            self.json = json.loads(content)
        self.buffers = [self.read_buffer(buffer) for buffer in self.all("buffers")]

    def all(self, name):
        return self.json.get(name, [])

    def read_buffer(self, buffer):
        uri = buffer.get("uri")
        if uri is None:
            return self.chunk
        if uri.startswith("data:"):
            return base64.b64decode(uri.split(",", 1)[1])
        return (self.folder / urllib.parse.unquote(uri)).read_bytes()

    # --- accessors -------------------------------------------------------------------------------

    def elements(self, view, offset, kind, width, count):
        view = self.json["bufferViews"][view]
        data = self.buffers[view["buffer"]]
        layout = "<" + width * FORMATS[kind]
        stride = view.get("byteStride", struct.calcsize(layout))
        start = view.get("byteOffset", 0) + offset
        return [struct.unpack_from(layout, data, start + i * stride) for i in range(count)]

    def accessor(self, index):
        """A tuple of numbers for each element."""
        accessor = self.json["accessors"][index]
        kind, width, count = accessor["componentType"], COMPONENTS[accessor["type"]], accessor["count"]
        if "bufferView" in accessor:
            values = self.elements(accessor["bufferView"], accessor.get("byteOffset", 0), kind, width, count)
        else:
            values = [(0,) * width] * count
        if "sparse" in accessor:
            sparse = accessor["sparse"]
            places = self.elements(sparse["indices"]["bufferView"], sparse["indices"].get("byteOffset", 0),
                                   sparse["indices"]["componentType"], 1, sparse["count"])
            others = self.elements(sparse["values"]["bufferView"], sparse["values"].get("byteOffset", 0),
                                   kind, width, sparse["count"])
            for (place,), other in zip(places, others):
                values[place] = other
        if accessor.get("normalized"):
            values = [tuple(max(x / LARGEST[kind], -1.0) for x in element) for element in values]
        return values

    # --- animation -------------------------------------------------------------------------------

    def duration(self, animation):
        return max((self.accessor(sampler["input"])[-1][0]
                    for sampler in self.json["animations"][animation]["samplers"]), default=0.0)

    def sample(self, sampler, path, seconds):
        """The numbers of a sampler at a time: appendix C."""
        times = [t for (t,) in self.accessor(sampler["input"])]
        way = sampler.get("interpolation", "LINEAR")
        numbers = self.accessor(sampler["output"])
        per_key = len(numbers) // len(times)
        groups = [numbers[i * per_key:(i + 1) * per_key] for i in range(len(times))]
        if path == "weights":
            groups = [[x for (x,) in group] for group in groups]
            width = per_key // (3 if way == "CUBICSPLINE" else 1)
            keys = [[group[i:i + width] for i in range(0, per_key, width)] for group in groups]
        else:
            keys = [[list(element) for element in group] for group in groups]
        middle = 1 if way == "CUBICSPLINE" else 0
        if seconds <= times[0]:
            return keys[0][middle]
        if seconds >= times[-1]:
            return keys[-1][middle]
        k = bisect.bisect_right(times, seconds) - 1
        interval = times[k + 1] - times[k]
        t = (seconds - times[k]) / interval
        if way == "STEP":
            return keys[k][0]
        if way == "CUBICSPLINE":
            (_, v0, b0), (a1, v1, _) = keys[k], keys[k + 1]
            return [(2 * t**3 - 3 * t**2 + 1) * p + interval * (t**3 - 2 * t**2 + t) * m
                    + (-2 * t**3 + 3 * t**2) * q + interval * (t**3 - t**2) * n
                    for p, m, q, n in zip(v0, b0, v1, a1)]
        v0, v1 = keys[k][0], keys[k + 1][0]
        if path != "rotation":
            return [p + t * (q - p) for p, q in zip(v0, v1)]
        v0, v1 = unit(v0), unit(v1)
        cosine = dot(v0, v1)
        angle = math.acos(min(abs(cosine), 1.0))
        if angle < 1e-6:
            return unit([p + t * (math.copysign(q, q * cosine) - p) for p, q in zip(v0, v1)])
        sign = math.copysign(1.0, cosine)
        return [(math.sin(angle * (1 - t)) * p + sign * math.sin(angle * t) * q) / math.sin(angle)
                for p, q in zip(v0, v1)]

    # --- the scene at a time ---------------------------------------------------------------------

    def animate(self, animation, seconds):
        """The nodes as dictionaries, with what the animation changes."""
        nodes = [dict(node) for node in self.all("nodes")]
        for node in nodes:
            if "mesh" in node and "weights" not in node:
                mesh = self.json["meshes"][node["mesh"]]
                targets = mesh["primitives"][0].get("targets", [])
                node["weights"] = mesh.get("weights", [0.0] * len(targets))
        if animation is not None:
            chosen = self.json["animations"][animation]
            for channel in chosen["channels"]:
                target = channel["target"]
                if "node" in target:
                    nodes[target["node"]][target["path"]] = self.sample(
                        chosen["samplers"][channel["sampler"]], target["path"], seconds)
        return nodes

    @staticmethod
    def local_matrix(node):
        if "matrix" in node:
            return from_columns(node["matrix"])
        turn = unit(node.get("rotation", [0, 0, 0, 1]))
        scale = node.get("scale", [1, 1, 1])
        columns = [rotated(turn, [scale[i] * (i == j) for j in range(3)]) for i in range(3)]
        shift = node.get("translation", [0, 0, 0])
        return [[columns[0][i], columns[1][i], columns[2][i], shift[i]] for i in range(3)] + [IDENTITY[3]]

    def world_matrices(self, nodes):
        """Of all nodes; and the order in which the scene draws them."""
        parent = {child: i for i, node in enumerate(nodes) for child in node.get("children", [])}

        def world(i):
            local = self.local_matrix(nodes[i])
            return multiply(world(parent[i]), local) if i in parent else local

        return [world(i) for i in range(len(nodes))]

    def drawn_nodes(self):
        scenes = self.all("scenes")
        wanted = list(scenes[self.json.get("scene", 0)].get("nodes", [])) if scenes else []
        for i in wanted:  # which grows
            wanted.extend(self.all("nodes")[i].get("children", []))
        return wanted

    def triangles(self, animation, seconds):
        """(corners, normals or None) of each triangle."""
        nodes = self.animate(animation, seconds)
        world = self.world_matrices(nodes)
        found = []
        for i in self.drawn_nodes():
            if "mesh" in nodes[i]:
                for primitive in self.json["meshes"][nodes[i]["mesh"]]["primitives"]:
                    found.extend(self.primitive(primitive, nodes[i], world[i], world))
        return found

    def primitive(self, primitive, node, own_matrix, world):
        mode = primitive.get("mode", 4)
        if mode < 4:
            return []
        attributes = primitive["attributes"]
        positions = self.with_targets(primitive, "POSITION", node["weights"])
        normals = self.with_targets(primitive, "NORMAL", node["weights"])
        matrices = self.vertex_matrices(attributes, node, world) or [own_matrix] * len(positions)
        positions = [[dot(row, p) + row[3] for row in matrix[:3]] for matrix, p in zip(matrices, positions)]
        if normals:
            turns = {id(matrix): inverse_transpose(matrix) for matrix in matrices}
            turned = [turns[id(matrix)] for matrix in matrices]
            normals = [turn and unit([dot(row, n) for row in turn]) for turn, n in zip(turned, normals)]
        order = ([i for (i,) in self.accessor(primitive["indices"])] if "indices" in primitive
                 else range(len(positions)))
        if mode == 4:
            corners = [order[i:i + 3] for i in range(0, len(order), 3)]
        elif mode == 5:
            corners = [[order[i], order[i + 1 + i % 2], order[i + 2 - i % 2]] for i in range(len(order) - 2)]
        else:
            corners = [[order[0], order[i], order[i + 1]] for i in range(1, len(order) - 1)]
        return [([positions[i] for i in three], [normals[i] for i in three] if normals else None)
                for three in corners]

    def with_targets(self, primitive, name, weights):
        if name not in primitive["attributes"]:
            return None
        values = [list(v) for v in self.accessor(primitive["attributes"][name])]
        for weight, target in zip(weights, primitive.get("targets", [])):
            if name in target:
                for value, delta in zip(values, self.accessor(target[name])):
                    for axis in range(3):
                        value[axis] += weight * delta[axis]
        return values

    def vertex_matrices(self, attributes, node, world):
        if "skin" not in node:
            return None
        skin = self.json["skins"][node["skin"]]
        inverse = ([from_columns(m) for m in self.accessor(skin["inverseBindMatrices"])]
                   if "inverseBindMatrices" in skin else [IDENTITY] * len(skin["joints"]))
        joint_matrices = [multiply(world[joint], m) for joint, m in zip(skin["joints"], inverse)]
        sums = None
        for k in range(len([name for name in attributes if name.startswith("JOINTS_")])):
            joints = self.accessor(attributes[f"JOINTS_{k}"])
            weights = self.accessor(attributes[f"WEIGHTS_{k}"])
            sums = sums or [[[0.0] * 4 for _ in range(4)] for _ in joints]
            for sum_, four, shares in zip(sums, joints, weights):
                for joint, share in zip(four, shares):
                    for i in range(4):
                        for j in range(4):
                            sum_[i][j] += share * joint_matrices[joint][i][j]
        # The last row holds the sum of the weights, which is 1 but for rounding.
        return [[[x / m[3][3] for x in row] for row in m] for m in sums]
