# SPDX-License-Identifier: MIT
"""The morphing figure: a silk lantern in the shape of a jellyfish that swims in the air.

Its mesh hangs from (0, 0, 0), the top of the bell, downwards.
"""

import math

from .. import motion, shapes
from ..mesh import Vertices

RADIUS, DOWN = 0.62, 0.66  # of the bell
LOBES = 8


def _bell():
    """Closed: outside, scalloped rim, hollow underside."""
    profile = []
    for i in range(11):
        a = math.pi / 2.0 * (1.0 - i / 10.0)
        profile.append((RADIUS * math.cos(a), DOWN * (math.sin(a) - 1.0), 1.0 - a / (math.pi / 2)))
    profile += [(1.03 * RADIUS, -DOWN - 0.09, 1.0), (0.97 * RADIUS, -DOWN - 0.095, 1.0)]
    for i in range(7):
        a = math.pi / 2.0 * i / 6.0
        profile.append((0.93 * RADIUS * math.cos(a), -DOWN + (DOWN - 0.10) * math.sin(a) - 0.02,
            1.0 - i / 6.0))
    segments = 5 * LOBES
    rings = []
    for r, y, edge in profile:
        ring = []
        for i in range(segments):
            a = 2.0 * math.pi * i / segments
            lobe = math.cos(LOBES * a)
            radius = r * (1.0 + 0.045 * edge * lobe)
            ring.append((radius * math.cos(a), y - 0.05 * edge ** 3 * lobe, -radius * math.sin(a)))
        rings.append(ring)
    return shapes.loft(rings, crease=60.0)


def _ribs():
    """Cords along the bell's lobes, half sunk into it."""
    ribs = []
    for k in range(LOBES):
        a = 2.0 * math.pi * k / LOBES
        path = []
        for i in range(9):
            b = math.pi / 2.0 * (1.0 - (i + 0.5) / 9.5)
            r = RADIUS * math.cos(b) * (1.0 + 0.045 * (1.0 - b / (math.pi / 2)))
            path.append((r * math.cos(a), DOWN * (math.sin(b) - 1.0) - 0.05 * (1.0 - b / (math.pi
                / 2)) ** 3, -r * math.sin(a)))
        ribs.append(shapes.cord(path, [0.009] * 9, 5))
    return ribs


def _tentacles():
    """Cords with beads from the rim, and four ribbons from the middle."""
    cords, beads, ribbons = [], [], []
    for k in range(LOBES):
        a = 2.0 * math.pi * (k + 0.5) / LOBES
        length = 1.0 + 0.25 * (k % 3)
        path = []
        for i in range(13):
            t = i / 12.0
            r = 0.92 * RADIUS * (1.0 - 0.25 * t) + 0.05 * math.sin(5.0 * t + k)
            path.append((r * math.cos(a), -DOWN - 0.02 - length * t, -r * math.sin(a)))
        cords.append(shapes.cord(path, [0.010 - 0.006 * i / 12.0 for i in range(13)], 5))
        for i in (6, 12):
            beads.append(shapes.sphere(0.034 - 0.0012 * i, 7, 4, path[i]))
    for k in range(4):
        turn = math.pi / 2.0 * k + 0.4

        def point(s, t):
            w = 0.085 * (1.0 - 0.7 * t) * (1.0 + 0.25 * math.sin(14.0 * t + k))
            a = turn + 2.2 * t
            r = 0.10 + 0.10 * math.sin(3.0 * t + k)
            x, z = r * math.cos(a), -r * math.sin(a)
            side = (2.0 * s - 1.0) * w
            return (x - side * math.sin(a), -0.22 - 1.45 * t, z - side * math.cos(a))

        ribbons.append(shapes.sheet(point, 2, 16))
    heart = shapes.sphere(0.12, 16, 10, (0.0, -0.34, 0.0))
    return cords, beads, ribbons, heart


def _squeezed(p):
    """The stroke: the rim draws in and down, the bell grows taller, what trails is drawn up."""
    x, y, z = p
    edge = min(1.0, max(0.0, -y / DOWN))
    tail = max(0.0, -y - DOWN)
    k = 1.0 - 0.42 * edge * edge + 0.10 * math.sin(3.0 * tail)
    return (x * k, y * 1.16 + 0.30 * tail + 0.02, z * k)


def _bent(p):
    """Leans over to +x, the more the lower."""
    x, y, z = p
    t = -y
    return (x + 0.16 * t * t + 0.05 * math.sin(3.2 * t), y + 0.10 * x * t, z + 0.04 * t
        * math.sin(2.5 * t))


def _curled(p):
    """What trails winds about the axis and sways to +z."""
    x, y, z = p
    tail = max(0.0, -y - 0.25)
    a = 0.75 * tail * tail / (0.6 + tail)
    c, s = math.cos(a), math.sin(a)
    return (c * x + s * z, y, c * z - s * x + 0.13 * tail * tail)


TARGETS = ("squeezed", "bent", "curled")


def pieces():
    """(material, vertices) pairs with three morph targets."""
    cords, beads, ribbons, heart = _tentacles()
    result = []
    for material, meshes in (("silk", [_bell()]), ("cord", _ribs() + cords), ("beads", beads),
            ("ribbon", ribbons), ("glow", [heart])):
        vertices = Vertices()
        for mesh in meshes:
            vertices.extend(Vertices.of(mesh))
        for function in (_squeezed, _bent, _curled):
            motion.add_target(vertices, function)
        result.append((material, vertices))
    return result


def swim(period):
    """Keys of the weights: two strokes in a period, sudden in, slow out."""
    keys = ((0.0, (0.0, 0.10, 0.5)), (0.34, (0.08, 0.45, 0.75)), (0.56, (1.0, 0.60, 0.30)),
        (0.95, (0.55, 0.35, -0.25)), (1.35, (0.10, -0.15, -0.55)), (1.75, (0.0, -0.45, -0.30)),
        (1.97, (0.92, -0.55, 0.10)), (2.40, (0.50, -0.35, 0.40)), (2.80, (0.12, -0.05, 0.55)))
    return motion.periodic_spline([t for t, _ in keys], [w for _, w in keys], period)
