# SPDX-License-Identifier: MIT
"""The skinned figure: a dancer of 1.7 m, 17 joints, surfaces that blend from limb to limb."""

import math

from .. import motion, shapes, surface_nets
from .. import vector as v
from ..mesh import Vertices
from ..surface_nets import Rod
from .figure import Figure

CELL = 0.021  # metres; of the surface's triangles

FIGURE = Figure(
    [
        ("hips", None, (0.0, 0.95, 0.0)), ("spine", "hips", (0.0, 1.07, 0.0)),
        ("chest", "spine", (0.0, 1.23, -0.005)), ("neck", "chest", (0.0, 1.45, -0.01)),
        ("head", "neck", (0.0, 1.53, 0.0)), ("upper arm.l", "chest", (0.165, 1.395, -0.01)),
        ("lower arm.l", "upper arm.l", (0.375, 1.215, -0.01)),
        ("hand.l", "lower arm.l", (0.56, 1.055, 0.0)), ("thigh.l", "hips", (0.092, 0.91, 0.0)),
        ("shin.l", "thigh.l", (0.10, 0.49, 0.008)), ("foot.l", "shin.l", (0.10, 0.085, -0.02)),
    ],
    [("foot.l", (0.10, 0.0, -0.05)), ("foot.l", (0.11, 0.0, 0.175))],
)
P = FIGURE.place
HEAD = (0.0, 1.62, 0.015)
TIPS = {"hand.l": (0.66, 0.965, 0.01), "hand.r": (-0.66, 0.965, 0.01), "foot.l": (0.11, 0.03,
    0.15), "foot.r": (-0.11, 0.03, 0.15), "head": (0.0, 1.70, 0.0), "chest": (0.0, 1.42, -0.01)}


def _both(rods):
    """Rods of the left side and their mirror images."""
    mirror = lambda p: (-p[0], p[1], p[2])
    return rods + [Rod(mirror(r.a), mirror(r.b), r.radius_a, r.radius_b, r.flat) for r in rods]


def _mix(a, b, t):
    return v.add(a, v.scale(v.sub(b, a), t))


def _arms():
    shoulder, elbow, wrist = (P[n] for n in ("upper arm.l", "lower arm.l", "hand.l"))
    hand = [Rod(wrist, _mix(wrist, TIPS["hand.l"], 0.55), 0.026, 0.034, 0.55),
        Rod(_mix(wrist, TIPS["hand.l"], 0.5), TIPS["hand.l"], 0.033, 0.020, 0.55),
        Rod(_mix(wrist, TIPS["hand.l"], 0.2), (0.615, 1.02, 0.055), 0.016, 0.012)]
    arm = [Rod((0.05, 1.405, -0.02), shoulder, 0.05, 0.055), Rod(shoulder, _mix(shoulder, elbow,
        0.4), 0.052, 0.045), Rod(_mix(shoulder, elbow, 0.4), elbow, 0.045, 0.034), Rod(elbow, _mix(
            elbow, wrist, 0.3), 0.036, 0.039), Rod(_mix(elbow, wrist, 0.3), wrist, 0.038, 0.024)]
    trunk = [Rod((0.0, 1.30, 0.0), (0.0, 1.43, -0.02), 0.09, 0.055), Rod((0.0, 1.42, -0.02),
        (0.0, 1.57, 0.0), 0.052, 0.047)]
    return surface_nets.skin(trunk + _both(arm + hand), CELL, 0.035)


def _trunk():
    rods = [Rod((0.0, 1.30, -0.015), (0.0, 1.34, -0.02), 0.115, 0.10, 0.8), Rod((0.0, 1.05, 0.0),
        (0.0, 1.24, -0.005), 0.098, 0.112, 0.85), Rod((0.0, 0.94, -0.01), (0.0, 1.04, 0.0), 0.125,
            0.10, 0.85)]
    side = [Rod((0.055, 1.27, 0.055), (0.062, 1.27, 0.06), 0.058, 0.058), Rod((0.06, 0.93, -0.03),
        (0.07, 0.88, -0.02), 0.105, 0.10), Rod((0.05, 1.25, -0.01), (0.085, 1.345, -0.02), 0.09,
            0.068, 0.85)]
    return surface_nets.skin(rods + _both(side), CELL, 0.05)


def _legs():
    hip, knee, ankle = P["thigh.l"], P["shin.l"], P["foot.l"]
    calf = v.add(_mix(knee, ankle, 0.36), (0.0, 0.0, -0.014))
    leg = [Rod(v.add(hip, (0.0, 0.02, -0.01)), knee, 0.094, 0.048), Rod(knee, calf, 0.046, 0.045),
        Rod(calf, ankle, 0.045, 0.029)]
    return surface_nets.skin([Rod((0.0, 0.90, -0.005), (0.0, 0.93, -0.005), 0.09, 0.09)]
        + _both(leg), CELL, 0.03)


def _shoes():
    ankle = P["foot.l"]
    shoe = [Rod(v.add(ankle, (0.0, 0.01, 0.0)), (0.10, 0.042, -0.035), 0.037, 0.038), Rod((0.10,
        0.04, -0.035), (0.108, 0.036, 0.08), 0.036, 0.036), Rod((0.106, 0.05, 0.0), (0.11, 0.03,
            0.12), 0.036, 0.029), Rod((0.108, 0.036, 0.08), (0.112, 0.026, 0.148), 0.036, 0.024)]
    return surface_nets.skin(_both(shoe), 0.016, 0.03)


def _head():
    x, y, z = HEAD
    rods = [Rod((x, y + 0.03, z - 0.018), (x, y + 0.035, z - 0.008), 0.092, 0.092), Rod((x, y,
        z + 0.014), (x, y - 0.055, z + 0.034), 0.072, 0.044), Rod((x, y + 0.022, z + 0.087), (x,
            y - 0.014, z + 0.103), 0.007, 0.012), Rod((x, y - 0.066, z + 0.046), (x, y - 0.072,
                z + 0.048), 0.024, 0.021)]
    side = [Rod((x + 0.078, y - 0.005, z - 0.012), (x + 0.080, y + 0.018, z - 0.016), 0.012,
        0.015), Rod((x + 0.03, y - 0.02, z + 0.05), (x + 0.036, y - 0.015, z + 0.046), 0.036,
            0.034), Rod((x + 0.014, y - 0.041, z + 0.074), (x, y - 0.041, z + 0.079), 0.007,
                0.009)]
    return surface_nets.skin(rods + _both(side), 0.0115, 0.018)


def _hair():
    x, y, z = HEAD
    rods = [Rod((x, y + 0.045, z - 0.032), (x, y + 0.052, z - 0.022), 0.099, 0.097), Rod((x,
        y + 0.0, z - 0.055), (x, y - 0.03, z - 0.055), 0.070, 0.042), Rod((x, y + 0.105, z - 0.105),
            (x, y + 0.11, z - 0.11), 0.048, 0.048)]
    return surface_nets.skin(rods, 0.015, 0.02)


def _eyes():
    """Small dark lenses that look out of the face: (mesh, joint) by shapes."""
    eyes = [shapes.sphere(0.0105, 10, 6, (0.031 * s, HEAD[1] + 0.018, HEAD[2] + 0.075)) for s in
        (-1, 1)]
    vertices = Vertices()
    for eye in eyes:
        vertices.extend(Vertices.of(eye))
    return vertices


def _skirt():
    """A sheet from the waist to the knees in folds that deepen downwards."""
    rows, around = 11, 60

    def point(s, t):
        a = 2.0 * math.pi * s
        fold = 1.0 + t * (0.075 * math.cos(9.0 * a) + 0.03 * math.cos(5.0 * a + 1.0))
        # bell-shaped, a little to the back
        reach = 0.130 + 0.09 * math.sqrt(t) + 0.20 * t
        depth = 0.116 + 0.10 * math.sqrt(t) + 0.20 * t
        return (reach * fold * math.cos(a), 1.035 - 0.50 * t + 0.02 * t * math.cos(9.0 * a),
            -depth * fold * math.sin(a) - 0.01)

    mesh = shapes.sheet(lambda s, t: point(s, 1.0 - t), around, rows)
    vertices = Vertices.of(mesh)
    joints = {name: i for i, name in enumerate(FIGURE.names)}
    for x, y, _ in vertices.positions:
        t = max(0.0, min(1.0, (1.0 - y) / 0.45))
        side = max(0.0, min(1.0, 0.5 + x / 0.30))
        side = side * side * (3.0 - 2.0 * side)
        share = 0.85 * t * (2.0 - t)
        ids, weights = motion.influences({joints["hips"]: 1.0 - share, joints["thigh.l"]: share
            * side, joints["thigh.r"]: share * (1.0 - side)})
        vertices.joints.append(ids)
        vertices.weights.append(weights)
    return vertices


def _bones():
    """Segments that stand for each joint: by name."""
    bones = {name: [] for name in FIGURE.names}
    for name in FIGURE.names:
        parent = FIGURE.parent[name]
        if parent in ("hips", "chest") and name not in ("spine", "neck"):
            bones[parent].append((_mix(P[name], P[parent], 0.35), P[parent]))
        elif parent is not None:
            bones[parent].append((P[parent], P[name]))
    for name, tip in TIPS.items():
        bones[name].append((P[name], tip))
    return bones


BONES = _bones()


def _bind(vertices, only=None):
    """Gives each vertex its joints: the nearest bone and its neighbours, by distance to the fourth
    power."""
    joints = {name: i for i, name in enumerate(FIGURE.names)}
    names = only or FIGURE.names
    for p in vertices.positions:
        squares = {name: min(_square(p, *bone) for bone in BONES[name]) for name in names}
        nearest = min(squares, key=lambda name: (squares[name], joints[name]))
        shares = {}
        for name in names:
            if name == nearest or FIGURE.parent[name] == nearest or (FIGURE.parent[nearest]
                    == name):
                shares[joints[name]] = 1.0 / (squares[name] + 2e-4) ** 2
        ids, weights = motion.influences(shares)
        vertices.joints.append(ids)
        vertices.weights.append(weights)
    return vertices


def _square(p, a, b):
    d, q = v.sub(b, a), v.sub(p, a)
    t = min(1.0, max(0.0, v.dot(q, d) / v.dot(d, d)))
    e = v.sub(q, v.scale(d, t))
    return v.dot(e, e)


def _limb(*names):
    return [f"{name}.{side}" for name in names for side in "lr"]


def pieces():
    """(material, vertices) pairs."""
    trunk = ["hips", "spine", "chest"]
    return [
        ("skin", _bind(_arms(), ["chest", "neck"] + _limb("upper arm", "lower arm", "hand"))),
        ("skin", _bind(_head(), ["head"])),
        ("dark hair", _bind(_hair(), ["head"])),
        ("dark hair", _bind(_eyes(), ["head"])),
        ("leotard", _bind(_trunk(), trunk + _limb("thigh"))),
        ("tights", _bind(_legs(), ["hips"] + _limb("thigh", "shin", "foot"))),
        ("shoes", _bind(_shoes(), _limb("foot"))),
        ("skirt", _skirt()),
    ]
