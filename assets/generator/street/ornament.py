# SPDX-License-Identifier: MIT
"""What is put on houses: cornices, balconies, awnings, chimneys, dormers, roofs, downpipes."""

import math

from .. import shapes
from ..polygon import rectangle


def cornice(width, y, out=0.34):
    """Eaves cornice along x from 0 to width, its underside at y."""
    o = out
    profile = [(0.0, -0.03), (0.0, 0.05), (0.06, 0.08), (0.10, 0.08), (0.12, 0.55 * o),
        (0.17, 0.60 * o), (0.20, 0.80 * o), (0.28, o), (0.34, o), (0.34, -0.03)]
    e = 0.012
    return [shapes.moulding([(s + y, t) for s, t in profile],
        shapes.straight_path((e, 0.0, 0.0), (width - e, 0.0, 0.0)), crease=0.0)]


RUN = 1.2  # length of a run of dentils


def dentils():
    """A run of four under a cornice, its underside at y = 0."""
    xs = [0.30 * (i + 0.5) for i in range(4)]
    return [shapes.box((x - 0.065, 0.02, -0.02), (x + 0.065, 0.13, 0.19)) for x in xs]


def runs(width):
    """Where runs of dentils begin along a front."""
    count = int(width / RUN)
    return [(width - RUN * count) / 2.0 + RUN * i for i in range(count)]


def balusters(length):
    """A row of them for a parapet, from x = 0 to `length`; the wall's top is y = 0."""
    row, count = [], int(length / 0.27)
    for i in range(count):
        x = length * (i + 0.5) / count
        row.append(shapes.lathe([(0.0, 0.12), (0.05, 0.12), (0.05, 0.18), (0.085, 0.30), (0.04,
            0.50), (0.06, 0.68), (0.0, 0.68)], 6, crease=50.0).moved(x, 0.0, 0.0))
    return row


def band(width, y, out=0.07, high=0.16):
    """String course."""
    profile = [(0.0, -0.03), (0.0, 0.5 * out), (0.03, out), (high - 0.04, out), (high, 0.4 * out),
        (high, -0.03)]
    return shapes.moulding([(s + y, t) for s, t in profile],
        shapes.straight_path((0.012, 0.0, 0.0), (width - 0.012, 0.0, 0.0)), crease=0.0)


def quoins(x, bottom, top):
    """Corner stones, long and short in turn."""
    stones, y, k = [], bottom, 0
    while y + 0.36 < top:
        half = 0.24 if k % 2 else 0.17
        stones.append(shapes.chamfered((x - half, y, -0.02), (x + half, y + 0.35, 0.045), 0.012))
        y += 0.37
        k += 1
    return stones


def balcony(width, out=0.75):
    """Slab on brackets with an iron railing; its floor is y = 0, centred on x = 0."""
    w = width / 2.0
    stone = [shapes.moulding([(-0.14, -0.02), (-0.14, 0.55 * out), (-0.10, 0.90 * out),
        (-0.06, out), (0.0, out), (0.0, -0.02)], shapes.straight_path((-w, 0.0, 0.0), (w, 0.0,
            0.0)), crease=0.0)]
    for x in (-w + 0.22, 0.0, w - 0.22):
        outline = [(0.02, -0.12), (-0.70 * out, -0.12), (-0.62 * out, -0.22), (-0.25 * out, -0.30),
            (-0.10 * out, -0.52), (0.02, -0.56)]
        stone.append(shapes.prism(outline, -0.06, 0.06).along_x().moved(x, 0.0, 0.0))
    iron, rim = [], out - 0.06
    corners = [(-w + 0.05, 0.0), (-w + 0.05, rim), (w - 0.05, rim), (w - 0.05, 0.0)]
    for (ax, az), (bx, bz) in zip(corners, corners[1:]):
        for y, size in ((0.08, 0.018), (0.95, 0.034)):
            # the side rails begin inside the front rail and end in the wall
            iron.append(shapes.bar((ax, y, az), (bx, y, bz), size, 0.8 * size))
        length = math.sqrt((bx - ax) ** 2 + (bz - az) ** 2)
        count = max(2, round(length / 0.12))
        for i in range(count + 1):
            t = i / count
            x, z = ax + (bx - ax) * t, az + (bz - az) * t
            if z > 0.02 and not (i == count and bz == rim and ax == bx):
                iron.append(shapes.rod((x, -0.01, z), (x, 0.94, z), 0.008, 5))
    return [("stone", stone), ("iron", iron)]


def awning(width, cloth, out=1.25, drop=0.55):
    """Striped canvas 6 mm thick with a scalloped edge; its upper rear edge is at the origin."""
    count = 2 * int(width / 0.56) + 1
    stripe, plain = [], []
    for i in range(count):
        x0, x1 = -width / 2.0 + width * i / count, -width / 2.0 + width * (i + 1) / count
        e = 0.0008  # neighbours do not share a plane
        x0, x1 = x0 + e, x1 - e
        target = stripe if i % 2 == 0 else plain
        target.append(shapes.loft([[(x, 0.0, -0.02), (x, -drop, out), (x, -drop - 0.006, out),
            (x, -0.008, -0.02)] for x in (x0, x1)], crease=0.0))
        edge = [(x0, -drop + 0.001)] + [(x0 + (x1 - x0) * k / 6, -drop - 0.17 - 0.06
            * math.sin(math.pi * k / 6)) for k in range(7)] + [(x1, -drop + 0.001)]
        target.append(shapes.prism(edge, out - 0.004, out + 0.002))
    iron = [shapes.rod((x, -0.9, 0.0), (x, -drop - 0.005, out - 0.02), 0.012, 5) for x in
        (-width / 2.0 + 0.04, width / 2.0 - 0.04)]
    iron.append(shapes.rod((-width / 2.0, -drop - 0.012, out - 0.015), (width / 2.0, -drop - 0.012,
        out - 0.015), 0.012, 5))
    return [(cloth, stripe), ("canvas", plain), ("iron", iron)]


def chimney(height):
    """Stack with two pots, standing on y = 0."""
    stack = [shapes.box((-0.55, -0.4, -0.26), (0.55, height - 0.52, 0.26)),
        shapes.box((-0.61, height - 0.62, -0.32), (0.61, height - 0.46, 0.32))]
    pot = [(0.0, -0.02), (0.13, -0.02), (0.10, 0.30), (0.13, 0.34), (0.13, 0.38), (0.08, 0.38),
        (0.07, 0.2), (0.0, 0.2)]
    pots = [shapes.lathe(pot, 12).moved(x, height - 0.46, 0.0) for x in (-0.3, 0.0, 0.3)]
    return [("brick", stack), ("terracotta", pots)]


def dormer():
    """Window in a mansard roof, its sill at the origin; it reaches 1.2 m back."""
    from .openings import window

    cheeks = shapes.prism([(-0.58, -0.15), (0.58, -0.15), (0.58, 1.42), (0.0, 1.86), (-0.58,
        1.42)], -1.2, -0.02, crease=0.0)
    front = shapes.prism([(-0.62, -0.12), (0.62, -0.12), (0.62, 1.40), (-0.62, 1.40)], -0.25, 0.0,
        [rectangle(-0.40, 0.0, 0.40, 1.25)], crease=0.0)
    gable = shapes.prism([(-0.70, 1.39), (0.70, 1.39), (0.0, 1.93)], -0.20, 0.05, crease=0.0)
    roof = [shapes.bar((side * 0.76, 1.40, -0.55), (-side * 0.02, 1.99, -0.55), 1.32, 0.06)
        for side in (-1, 1)]
    parts = [("lead", [cheeks] + roof), ("stone", [front, gable])]
    return parts + [piece for piece in window(0.8, 1.25, rows=2) if piece[0] != "stone"]


def downpipe(top):
    pipe = [shapes.rod((0.0, 0.1, 0.09), (0.0, top, 0.09), 0.045, 8),
        shapes.box((-0.10, top - 0.02, -0.01), (0.10, top + 0.20, 0.18))]
    pipe += [shapes.box((-0.075, y, -0.02), (0.075, y + 0.05, 0.06)) for y in (1.0, 3.3, 5.6)]
    return [("lead", pipe)]


def parapet(width, y, out=0.06):
    """Piers and rails along the wall's top; `parapet_gaps` have the balusters."""
    parts, z = [], -0.16 + out
    piers = [0.24] + [0.24 + (width - 0.48) * k / 3 for k in (1, 2)] + [width - 0.24]
    for x in piers:
        parts.append(shapes.box((x - 0.20, y - 0.02, z - 0.17), (x + 0.20, y + 0.82, z + 0.17)))
        parts.append(shapes.chamfered((x - 0.24, y + 0.79, z - 0.21), (x + 0.24, y + 0.91,
            z + 0.21), 0.05))
    for a, b in zip(piers, piers[1:]):
        parts.append(shapes.box((a + 0.18, y - 0.01, z - 0.12), (b - 0.18, y + 0.14, z + 0.12)))
        parts.append(shapes.box((a + 0.18, y + 0.66, z - 0.13), (b - 0.18, y + 0.80, z + 0.13)))
    return parts


def parapet_gaps(width):
    """(x, z) at which the rows of balusters begin, and their length."""
    length = (width - 0.48) / 3.0
    return [(0.44 + length * k, -0.10) for k in range(3)], length - 0.4
