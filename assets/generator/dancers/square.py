# SPDX-License-Identifier: MIT
"""The still part: a round square with a fan of paving, steps, a colonnade, urns, benches."""

import math

from .. import shapes
from .. import vector as v
from ..hall import objects
from ..hall.parts import half_round

RADIUS = 4.9  # of the paving
SECTORS = 16
COLUMNS = [18.0 + 144.0 * k / 8 for k in range(9)]  # degrees about y, from +x over -z
PODIUM = (1.75, 0.55)  # x, z of the puppet's


def add_to(stage):
    stage.add("paving", [("pale stone", _slabs(0)), ("grey stone", _slabs(1))], [(0.0, 0.0, 0.0,
        360.0 * k / SECTORS) for k in range(SECTORS)])
    base = [shapes.lathe([(0.0, -0.50), (5.75, -0.50), (5.75, -0.34), (0.0, -0.34)], 64, 30.0),
        shapes.lathe([(0.0, -0.36), (5.45, -0.36), (5.45, -0.17), (0.0, -0.17)], 64, 30.0),
        shapes.lathe([(0.0, -0.20), (5.15, -0.20), (5.15, -0.004), (5.13, 0.012), (4.915, 0.012),
            (4.905, -0.015), (0.0, -0.015)], 64, 30.0)]
    stage.add("steps", [("joint", [base[2]]), ("grey stone", base[:2])])
    rose = [shapes.lathe([(0.0, -0.02), (0.50, -0.02), (0.50, 0.010), (0.0, 0.010)], 48, 30.0)]
    for k in range(12):
        rose.append(_leaf().turned_y(30.0 * k))
    stage.add("rose", [("grey stone", rose[:1]), ("brass", rose[1:])])
    _colonnade(stage)
    stage.add("podium", [("grey stone", [shapes.lathe([(0.0, -0.02), (0.78, -0.02), (0.78, 0.05),
        (0.72, 0.09), (0.72, 0.24), (0.76, 0.26), (0.76, 0.30), (0.0, 0.30)], 48, 30.0)])],
        [(PODIUM[0], 0.0, PODIUM[1])])
    basin = [(0.0, -0.02), (0.82, -0.02), (0.82, 0.06), *half_round(0.74, 0.06, 0.10, 4), (0.74,
        0.30), (0.80, 0.36), (0.80, 0.42), (0.66, 0.42), (0.62, 0.30), (0.0, 0.27)]
    water = shapes.lathe([(0.0, 0.20), (0.70, 0.20), (0.70, 0.35), (0.0, 0.35)], 40, 30.0)
    stage.add("basin", [("pale stone", [shapes.lathe(basin, 48, 35.0)]), ("water", [water])],
        [(-0.15, 0.0, -2.0)])
    stage.add("urn", [("terracotta", objects.urn())], [(x, 0.0, z, turn) for x, z, turn in ((-4.35,
        0.35, 0.0), (4.35, 0.35, 40.0), (-3.6, 2.35, 70.0), (3.6, 2.35, 20.0))])
    for angle in (42.0, 90.0, 138.0):
        stage.put("bench", stage.mesh("bench", [("pale stone", _bench(angle))]), [(0.0, 0.0, 0.0)])
    _garlands(stage)


def _at(degrees, radius, y):
    c, s = v.cos_sin(degrees)
    return (radius * c, y, -radius * s)  # v.cos_sin: from +x towards -z, like rotated_y


def _slabs(kind):
    """The slabs of a sector, of one of two colours in turn."""
    edges, half = (0.515, 1.25, 2.1, 3.0, 3.95, RADIUS), 180.0 / SECTORS
    slabs = []
    for row, (r0, r1) in enumerate(zip(edges, edges[1:])):
        parts = 1 if row < 2 else 2 if row < 4 else 3
        for k in range(parts):
            if (row + k + (1 if row == 4 else 0)) % 2 != kind:
                continue
            a0 = -half + 2.0 * half * k / parts
            a1 = -half + 2.0 * half * (k + 1) / parts
            outline, gap, steps = [], 0.006, 3
            for r, way in ((r0 + gap, 1), (r1 - gap, -1)):
                lean = math.degrees(gap / r)
                arc = [a0 + lean + (a1 - a0 - 2.0 * lean) * i / steps for i in range(steps + 1)]
                outline += [_at(a, r, 0.0) for a in arc[::way]]
            lower = [(x, -0.03, z) for x, _, z in outline]
            upper = [(x, 0.008 - 0.002 * ((row + k) % 2), z) for x, _, z in outline]
            slabs.append(shapes.loft([lower, upper], crease=0.0))
    return slabs


def _leaf():
    points = [(0.10, 0.0), (0.25, 0.045), (0.40, 0.0), (0.25, -0.045)]
    return shapes.prism(points, 0.0, 0.016, crease=0.0).along_y().moved(0.0, 0.0, 0.0)


def _ring_wall(profile, start, end, steps):
    """Draws (out, up) points about the y axis between two angles."""
    path = []
    for i in range(steps + 1):
        c, s = v.cos_sin(start + (end - start) * i / steps)
        path.append(((0.0, 0.0, 0.0), (c, 0.0, -s), (0.0, 1.0, 0.0)))
    return shapes.moulding(profile, path, crease=30.0)


def _colonnade(stage):
    """Nine columns on a low wall, a curved beam on them, screens between some of them."""
    low, high = COLUMNS[0] - 5.0, COLUMNS[-1] + 5.0
    profile = [(0.0, 0.42), (0.20, 0.42), (0.20, 0.50), *half_round(0.17, 0.50, 0.09, 4), (0.165,
        0.62)]
    for t in (0.0, 0.25, 0.6, 1.0):
        profile.append((0.155 - 0.028 * t + 0.006 * math.sin(math.pi * t), 0.64 + 1.92 * t))
    profile += [*half_round(0.125, 2.58, 0.05, 3), (0.13, 2.66), (0.19, 2.74), (0.215, 2.80),
        (0.215, 2.86), (0.0, 2.86)]
    column = [shapes.lathe(profile, 20)]
    stage.add("column", [("pale stone", column)], [(*_at(a, 4.45, 0.0), 0.0) for a in COLUMNS])
    plinth = [(4.10, -0.02), (4.10, 0.10), (4.16, 0.14), (4.16, 0.36), (4.10, 0.40), (4.10, 0.46),
        (4.80, 0.46), (4.80, -0.02)]
    beam = [(4.22, 2.83), (4.22, 3.00), (4.19, 3.02), (4.19, 3.16), (4.12, 3.20), (4.05, 3.27),
        (4.05, 3.33), (4.85, 3.33), (4.85, 3.27), (4.78, 3.20), (4.71, 3.16), (4.71, 3.02), (4.68,
            3.00), (4.68, 2.83)]
    stage.add("beam", [("pale stone", [_ring_wall(plinth, low, high, 36), _ring_wall(beam, low,
        high, 36)])])
    count = 60
    dentils = []
    for k in range(count):
        a = low + (high - low) * (k + 0.5) / count
        block = shapes.box((4.14, 3.06, -0.035), (4.25, 3.15, 0.035)).turned_y(a)
        dentils.append(block)
    stage.add("dentils", [("pale stone", dentils)])
    stage.add("finial", [("pale stone", [objects.finial(0.13)])], [_at(a, 4.45, 3.32) for a in
        COLUMNS[::2]])
    curtain = []
    for k in range(len(COLUMNS) - 1):
        a0, a1 = COLUMNS[k] + 2.6, COLUMNS[k + 1] - 2.6
        if k not in (3, 4):
            curtain.append(_ring_wall([(4.52, 0.44), (4.52, 2.05), (4.60, 2.05), (4.60, 0.44)],
                a0, a1, 6))
            curtain.append(_ring_wall([(4.48, 2.02), (4.48, 2.12), (4.64, 2.12), (4.64, 2.02)],
                a0 - 0.3, a1 + 0.3, 6))
    stage.add("screens", [("ochre plaster", curtain)])


def _bench(angle):
    seat = [(3.42, 0.42), (3.42, 0.49), (3.86, 0.49), (3.86, 0.42)]
    parts = [_ring_wall(seat, angle - 13.0, angle + 13.0, 10)]
    for a in (angle - 10.0, angle, angle + 10.0):
        parts.append(_ring_wall([(3.48, -0.02), (3.52, 0.43), (3.76, 0.43), (3.80, -0.02)], a - 1.0,
            a + 1.0, 1))
    return parts


def _garlands(stage):
    """Cords with lamps that hang from column to column."""
    cords, lamps = [], []
    for a0, a1 in zip(COLUMNS, COLUMNS[1:]):
        p, q, path = _at(a0, 4.20, 2.62), _at(a1, 4.20, 2.62), []
        for i in range(11):
            t = i / 10.0
            x, y, z = (a + (b - a) * t for a, b in zip(p, q))
            path.append((x, y - 0.30 * 4.0 * t * (1.0 - t), z))
        cords.append(shapes.cord(path, [0.007] * 11, 5))
        lamps += [shapes.sphere(0.045, 8, 5, (path[i][0], path[i][1] - 0.05, path[i][2])) for i in
            (2, 4, 6, 8)]
    stage.add("garlands", [("cord", cords), ("lamp", lamps)])
