# SPDX-License-Identifier: MIT
"""Writes a .gltf that moves in all ways: every interpolation, one and two sets of joints in all
component types, morph targets, sparse or not, skins with morph targets, instances, mirrored scales,
matrices, strips and fans."""
import base64
import json
import math
import random
import struct


class Writer:
    def __init__(self, seed):
        self.random = random.Random(seed)
        self.data = bytearray()
        self.json = {"asset": {"version": "2.0"}, "scene": 0, "bufferViews": [], "accessors": [], "nodes": [],
                     "meshes": [], "skins": [], "animations": []}

    def add(self, name, item):
        self.json[name].append(item)
        return len(self.json[name]) - 1

    def view(self, layout, elements):
        while len(self.data) % 4:
            self.data.append(0)
        start = len(self.data)
        for element in elements:
            self.data += struct.pack("<" + layout, *element)
        return self.add("bufferViews", {"buffer": 0, "byteOffset": start, "byteLength": len(self.data) - start})

    def floats(self, kind, elements, bounds=False):
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4, "MAT4": 16}[kind]
        # As the file will have them: min and max must not lie beside by rounding.
        elements = [struct.unpack(f"<{width}f", struct.pack(f"<{width}f", *e)) for e in elements]
        accessor = {"bufferView": self.view(f"{width}f", elements), "componentType": 5126, "type": kind,
                    "count": len(elements)}
        if bounds:
            accessor["min"] = [min(column) for column in zip(*elements)]
            accessor["max"] = [max(column) for column in zip(*elements)]
        return self.add("accessors", accessor)

    def integers(self, component, kind, elements, normalized=False):
        letter = {5121: "B", 5123: "H"}[component]
        accessor = {"bufferView": self.view(f"{len(elements[0])}{letter}", elements), "componentType": component,
                    "type": kind, "count": len(elements)}
        if normalized:
            accessor["normalized"] = True
        return self.add("accessors", accessor)

    def sparse(self, elements):
        """VEC3 that are 0 but for some."""
        places = sorted(self.random.sample(range(len(elements)), max(1, len(elements) // 3)))
        values = [struct.unpack("<3f", struct.pack("<3f", *elements[i])) for i in places]
        all_values = values + ([(0.0, 0.0, 0.0)] if len(places) < len(elements) else [])
        return self.add("accessors", {
            "componentType": 5126, "type": "VEC3", "count": len(elements),
            "min": [min(column) for column in zip(*all_values)],
            "max": [max(column) for column in zip(*all_values)],
            "sparse": {"count": len(places),
                       "indices": {"bufferView": self.view("H", [(i,) for i in places]), "componentType": 5123},
                       "values": {"bufferView": self.view("3f", values)}}})

    # --- random things ---------------------------------------------------------------------------

    def vector(self, size):
        return [self.random.uniform(-size, size) for _ in range(3)]

    def unit(self, width):
        v = [self.random.gauss(0.0, 1.0) for _ in range(width)]
        size = math.sqrt(sum(x * x for x in v))
        return [x / size for x in v]

    def scale(self):
        scale = [self.random.uniform(0.7, 1.4) for _ in range(3)]
        if self.random.random() < 0.25:
            scale[self.random.randrange(3)] *= -1.0
        return scale

    def node(self, **more):
        if self.random.random() < 0.25:
            turn = [self.unit(3) for _ in range(3)]  # neither orthogonal nor of one handedness
            numbers = [*turn[0], 0, *turn[1], 0, *turn[2], 0, *self.vector(1.0), 1]
            return self.add("nodes", {"matrix": numbers, **more})
        return self.add("nodes", {"translation": self.vector(1.0), "rotation": self.unit(4),
                                  "scale": self.scale(), **more})

    def mesh(self, targets, sets, joints):
        """A soup of triangles, as a list, a strip or a fan."""
        count = 3 * self.random.randint(4, 12)
        attributes = {"POSITION": self.floats("VEC3", [self.vector(1.0) for _ in range(count)], True)}
        with_normals = self.random.random() < 0.7
        if with_normals:
            attributes["NORMAL"] = self.floats("VEC3", [self.unit(3) for _ in range(count)])
        for k in range(sets):
            wide = self.random.random() < 0.5
            attributes[f"JOINTS_{k}"] = self.integers(
                5123 if wide else 5121, "VEC4",
                [[self.random.randrange(joints) for _ in range(4)] for _ in range(count)])
        if sets:
            self.weights(attributes, sets, count)
        primitive = {"attributes": attributes, "mode": self.random.choice([4, 4, 5, 6])}
        if self.random.random() < 0.5:
            # The corners of a triangle differ, in a list, a strip and a fan: the importer may drop others.
            order = []
            for _ in range(3 * self.random.randint(4, 12)):
                order.append(self.random.choice([i for i in range(count) if i not in order[:1] + order[-2:]]))
            primitive["indices"] = self.integers(5123, "SCALAR", [(i,) for i in order])
        for _ in range(targets):
            deltas = [self.vector(0.6) for _ in range(count)]
            target = {"POSITION": self.sparse(deltas) if self.random.random() < 0.5
                      else self.floats("VEC3", deltas, True)}
            if with_normals:
                target["NORMAL"] = self.floats("VEC3", [self.vector(0.3) for _ in range(count)])
            primitive.setdefault("targets", []).append(target)
        mesh = {"primitives": [primitive]}
        if targets and self.random.random() < 0.7:
            mesh["weights"] = [self.random.uniform(0.0, 1.0) for _ in range(targets)]
        return self.add("meshes", mesh)

    def weights(self, attributes, sets, count):
        kinds = [self.random.choice([5126, 5121, 5123])] * sets
        per_vertex = []
        for _ in range(count):
            shares = [self.random.random() ** 3 for _ in range(4 * sets)]
            total = sum(shares)
            if kinds[0] == 5126:
                per_vertex.append([x / total for x in shares])
                continue
            largest = {5121: 255, 5123: 65535}[kinds[0]]
            whole = [int(x / total * largest) for x in shares]
            whole[whole.index(max(whole))] += largest - sum(whole)
            per_vertex.append(whole)
        for k, kind in enumerate(kinds):
            part = [shares[4 * k:4 * k + 4] for shares in per_vertex]
            attributes[f"WEIGHTS_{k}"] = (self.floats("VEC4", part) if kind == 5126
                                          else self.integers(kind, "VEC4", part, True))

    def channel(self, animation, node, path, width):
        interpolation = self.random.choice(["STEP", "LINEAR", "CUBICSPLINE"])
        time, times = self.random.uniform(0.0, 0.5), []
        for _ in range(self.random.randint(2, 5)):
            times.append((time,))
            time += self.random.uniform(0.1, 0.8)
        elements = []
        for _ in times:
            for group in range(3 if interpolation == "CUBICSPLINE" else 1):
                tangent = interpolation == "CUBICSPLINE" and group != 1
                numbers = (self.vector(1.0) if path == "translation" else self.scale() if path == "scale"
                           else self.unit(4) if path == "rotation"
                           else [self.random.uniform(-0.5, 1.5) for _ in range(width)])
                elements.append([0.4 * x if tangent else x for x in numbers])
        if path == "weights":
            elements = [(x,) for element in elements for x in element]
        kind = {"translation": "VEC3", "scale": "VEC3", "rotation": "VEC4", "weights": "SCALAR"}[path]
        animation["samplers"].append({"input": self.floats("SCALAR", times, True), "interpolation": interpolation,
                                      "output": self.floats(kind, elements)})
        animation["channels"].append({"sampler": len(animation["samplers"]) - 1,
                                      "target": {"node": node, "path": path}})

    def write(self, path):
        joints = [self.node() for _ in range(6)]
        nodes = self.json["nodes"]
        roots = [joints[0]]
        for joint in joints[1:]:
            parent = self.random.choice([None, *range(joint)])
            if parent is None:
                roots.append(joint)
            else:
                nodes[parent].setdefault("children", []).append(joint)
        morphing = []
        for targets, sets in [(0, 0), (0, 1), (0, 2), (3, 0), (2, 1)]:
            used = self.random.sample(joints, self.random.randint(1, len(joints)))
            mesh = self.mesh(targets, sets, len(used))
            more = {"mesh": mesh}
            if sets:
                binds = [[*self.unit(3), 0, *self.unit(3), 0, *self.unit(3), 0, *self.vector(0.5), 1] for _ in used]
                skin = {"joints": used}
                if self.random.random() < 0.8:
                    skin["inverseBindMatrices"] = self.floats("MAT4", binds)
                more["skin"] = self.add("skins", skin)
            for _ in range(2):  # twice the same mesh
                if targets and self.random.random() < 0.5:
                    more["weights"] = [self.random.uniform(-1.0, 1.0) for _ in range(targets)]
                node = self.node(**more)
                (roots if self.random.random() < 0.4 else
                 nodes[self.random.choice(joints)].setdefault("children", [])).append(node)
                if targets:
                    morphing.append((node, targets))
        for number in range(2):
            animation = {"name": f"animation {number}", "samplers": [], "channels": []}
            for joint in joints:
                for path_name in ("translation", "rotation", "scale"):
                    if "matrix" not in nodes[joint] and self.random.random() < 0.5:
                        self.channel(animation, joint, path_name, 3)
            for node, targets in morphing:
                if self.random.random() < 0.6:
                    self.channel(animation, node, "weights", targets)
            if animation["channels"]:
                self.add("animations", animation)
        self.json["scenes"] = [{"nodes": roots}]
        uri = "data:application/octet-stream;base64," + base64.b64encode(bytes(self.data)).decode()
        self.json["buffers"] = [{"byteLength": len(self.data), "uri": uri}]
        for name in [name for name, items in self.json.items() if items == []]:
            del self.json[name]
        path.write_text(json.dumps(self.json))
