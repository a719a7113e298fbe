# SPDX-License-Identifier: MIT
"""Skins, morph targets and animations, and the quaternions (x, y, z, w) for them."""

import math

from . import vector as v
from .gltf import FLOAT
from .mesh import DIGITS

INFLUENCES = 4  # joints that move a vertex, at most


def add_skin(doc, name, joints, positions):
    """A skin whose joints stand unturned at these places in the space of its mesh, at rest.

    `joints`: nodes, the first one the root of the others.
    """
    inverse = [
        (1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -x + 0.0, -y + 0.0, -z + 0.0,
            1.0)
        for x, y, z in positions
    ]
    matrices = doc.add_accessor(inverse, FLOAT, "MAT4")
    return doc.append("skins", {"name": name, "inverseBindMatrices": matrices,
        "skeleton": joints[0], "joints": list(joints)})


def influences(shares):
    """(joints, weights) of a vertex from joint to share: the largest four, in 1/255."""
    largest = sorted(shares.items(), key=lambda item: (-item[1], item[0]))[:INFLUENCES]
    total = 0.0  # not sum(), which rounds in other ways from Python 3.12 on
    for _, share in largest:
        total += share
    weights = [int(255.0 * share / total + 0.5) for _, share in largest]
    weights[0] += 255 - sum(weights)
    pairs = [(joint, weight) for (joint, _), weight in zip(largest, weights) if weight > 0]
    pairs += [(0, 0)] * (INFLUENCES - len(pairs))
    return tuple(joint for joint, _ in pairs), tuple(weight for _, weight in pairs)


def add_target(vertices, function):
    """Adds the morph target that takes each position p to function(p), smooth; normals follow."""
    moves, turns, step = [], [], 1e-4
    for p, n in zip(vertices.positions, vertices.normals):
        q = function(p)
        side = (1.0, 0.0, 0.0) if abs(n[0]) < 0.8 else (0.0, 1.0, 0.0)
        s = v.normalized(v.cross(side, n))
        t = v.cross(n, s)
        ds, dt = (
            v.sub(function(v.add(p, v.scale(d, step))), function(v.add(p, v.scale(d, -step))))
            for d in (s, t)
        )
        moves.append(_rounded(v.sub(q, p), DIGITS))
        # Three digits: differences over 0.2 mm of positions with their last bits unknown.
        turns.append(_rounded(v.sub(v.normalized(v.cross(ds, dt)), n), 3))
    vertices.targets.append((moves, turns))


def _rounded(p, digits):
    return tuple(round(x, digits) + 0.0 for x in p)


def turned(x, y, z):
    """Rotation about z, then x, then y; degrees."""
    result = (0.0, 0.0, 0.0, 1.0)
    for axis, angle in ((1, y), (0, x), (2, z)):
        half = math.radians(angle) / 2.0
        q = [0.0, 0.0, 0.0, math.cos(half)]
        q[axis] = math.sin(half)
        result = product(result, q)
    return result


def product(a, b):
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by + ay * bw + az * bx - ax * bz,
        aw * bz + az * bw + ax * by - ay * bx,
        aw * bw - ax * bx - ay * by - az * bz,
    )


def rotated(q, p):
    u = q[:3]
    c = v.cross(u, p)
    return v.add(p, v.add(v.scale(c, 2.0 * q[3]), v.scale(v.cross(u, c), 2.0)))


class Clip:
    """An animation in the making. It loops: the last key of a channel is its first."""

    def __init__(self, doc, name):
        self.doc = doc
        self.inputs = {}
        self.clip = {"name": name, "samplers": [], "channels": []}
        doc.append("animations", self.clip)

    def add(self, node, path, times, values, interpolation="LINEAR"):
        """`values`: a tuple for each time; rotations are put on one side, so that neighbours are
        near each other."""
        rows, kind = [tuple(row) for row in values], "VEC3"
        if path == "rotation":
            kind = "VEC4"
            for i in range(1, len(rows)):
                if sum(a * b for a, b in zip(rows[i - 1], rows[i])) < 0.0:
                    rows[i] = tuple(-x for x in rows[i])
            rows[-1] = rows[0]
        rows = [tuple(round(x, 6) + 0.0 for x in row) for row in rows]
        if path == "weights":
            rows, kind = [x for row in rows for x in row], "SCALAR"
        times = tuple(round(t, 5) for t in times)
        if times not in self.inputs:
            self.inputs[times] = self.doc.add_accessor(times, FLOAT, "SCALAR", bounds=True)
        self.clip["samplers"].append({
            "input": self.inputs[times],
            "interpolation": interpolation,
            "output": self.doc.add_accessor(rows, FLOAT, kind),
        })
        self.clip["channels"].append({
            "sampler": len(self.clip["samplers"]) - 1,
            "target": {"node": node, "path": path},
        })


def periodic_spline(times, rows, period):
    """Keys of a smooth loop through `rows` at `times` (the first is 0) as CUBICSPLINE wants them:
    (times, rows), for each key in-tangent, value, out-tangent, a second key at `period` last."""
    count, keys = len(rows), []
    for i in range(count + 1):
        k = i % count
        before, after = rows[k - 1], rows[(k + 1) % count]
        ahead = (times[(k + 1) % count] - times[k]) % period
        behind = (times[k] - times[k - 1]) % period
        slope = tuple((b - a) / (ahead + behind) for a, b in zip(before, after))
        keys += [slope, rows[k], slope]
    return tuple(times) + (period,), keys
