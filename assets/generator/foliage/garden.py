# SPDX-License-Identifier: MIT
"""The garden without its plants: ground, path, brick walls with a gate, bench, bird bath, pots."""

import math

from .. import shapes
from ..hall.parts import half_round
from ..polygon import arched
from ..thin.furniture import slatted_bench

BRICK = (0.24, 0.075)  # with its joint; two courses make a panel's row
WALL = -3.75  # z of the wall's face
HIGH = 2.4
GATE = 1.56  # x of its middle
PANEL = (0.96, 0.60)


def add_to(stage):
    stage.add("ground", [("soil", shapes.box((-5.2, -0.25, -4.25), (5.2, -0.03, 4.2))), ("lawn",
        _lawn())])
    stage.add("flags", [("flagstone", [_flag(i) for i in range(11)])])
    _wall(stage)
    for place in ((-2.95, -0.006, 0.42, 38.0),):
        stage.add("bench", [("bark" if key == "dark wood" else "white paint", meshes) for key,
            meshes in slatted_bench()], [place])
    bath = [(0.0, -0.03), (0.27, -0.03), (0.27, 0.04), (0.22, 0.08), *half_round(0.12, 0.09, 0.06,
        3), (0.085, 0.20), (0.075, 0.62), (0.11, 0.70), (0.20, 0.74), (0.36, 0.82), (0.40, 0.88),
        (0.37, 0.89), (0.30, 0.84), (0.0, 0.82)]
    water = shapes.lathe([(0.0, 0.80), (0.315, 0.80), (0.315, 0.853), (0.0, 0.853)], 28, 30.0)
    stage.add("bird bath", [("stone", [shapes.lathe(bath, 28, 40.0)]), ("water", [water])],
        [(2.75, 0.0, 0.35)])
    stage.add("pot", [("terracotta", [shapes.lathe([(0.0, -0.02), (0.15, -0.02), (0.22, 0.32),
        (0.25, 0.33), (0.25, 0.40), (0.21, 0.40), (0.195, 0.31), (0.0, 0.31)], 24, 40.0)])],
        [(GATE - 1.05, 0.0, -3.25), (GATE + 1.05, 0.0, -3.25), (4.35, 0.0, 2.9)])


def _lawn():
    """Gently uneven, closed below."""
    nx, nz, rings = 26, 20, []
    for i in range(nx + 1):
        x = -5.2 + 10.4 * i / nx
        ring = []
        for j in range(nz + 1):
            z = -3.0 + 7.2 * j / nz
            edge = min(i, nx - i, j, nz - j) > 0
            ring.append((x, (0.012 + 0.018 * math.sin(1.3 * x + 0.8 * z) * math.sin(0.9 * z - 0.5
                * x)) if edge else 0.0, z))
        ring += [(x, -0.06, 4.2), (x, -0.06, -3.0)]
        rings.append(ring)
    return shapes.loft([[(x * 0.9995, y, z - 0.002) for x, y, z in ring] for ring in rings], 60.0)


def path_x(z):
    return GATE - 0.05 - 1.15 * (0.5 - 0.5 * math.cos(math.pi * (z + 3.7) / 7.9))


def _flag(i):
    z = -3.45 + 0.72 * i
    outline = []
    for k in range(9):
        a = 2.0 * math.pi * (k + 0.3 * math.sin(2.1 * k + 1.7 * i)) / 9
        r = (abs(math.cos(a)) ** 3 + abs(math.sin(a)) ** 3) ** (-1.0 / 3.0)
        outline.append((0.43 * r * math.cos(a), 0.295 * r * math.sin(a)))
    top = 0.048 + 0.006 * math.sin(2.3 * i)
    rings = [[(x * k, y, z2 * k) for x, z2 in outline] for y, k in ((-0.05, 1.0), (top - 0.012,
        1.0), (top, 0.965))]
    return shapes.loft(rings, 0.0).turned_y(9.0 * math.sin(1.9 * i)).moved(path_x(z) + 0.05
        * math.sin(4.0 * i), 0.0, z)


def _panel():
    """Bricks of a panel in running bond, standing 22 mm before the plane z = 0."""
    bricks, (w, h) = [], BRICK
    for row in range(8):
        x = 0.0 if row % 2 == 0 else -w / 2.0
        while x < PANEL[0] - 0.01:
            a, b = max(x, 0.0), min(x + w, PANEL[0])
            out = 0.018 + 0.006 * math.sin(5.0 * row + 9.0 * x)
            bricks.append(shapes.box((a + 0.005, h * row + 0.005, -0.01), (b - 0.005, h * (row + 1)
                - 0.005, out)))
            x += w
    return bricks


def _wall(stage):
    """Mortar slab with an arch, faced with panels; piers and coping."""
    arch = arched(GATE, 0.60, -0.2, 1.62, 18)
    outline = [(-5.1, -0.2), (GATE - 0.60, -0.2)] + arch[2:][::-1] + [(GATE + 0.60, -0.2), (5.1,
        -0.2), (5.1, HIGH), (-5.1, HIGH)]
    clean = [q for i, q in enumerate(outline) if q != outline[i - 1]]
    stage.add("wall", [("mortar", [shapes.prism(clean, WALL - 0.32, WALL)])])
    panel = stage.mesh("bricks", [("brick", _panel())])
    places, x = [], -5.02
    columns = []
    while x + PANEL[0] < GATE - 0.88:
        columns.append(x)
        x += PANEL[0]
    x = GATE + 0.92
    while x + PANEL[0] < 5.1:
        columns.append(x)
        x += PANEL[0]
    for x in columns:
        places += [(x, PANEL[1] * k, WALL) for k in range(4)]
    stage.put("bricks", panel, places)
    stone, voussoirs = [], []
    for k in range(17):
        a = math.pi * k / 16
        voussoirs.append(shapes.box((-0.055, 0.60, -0.03), (0.055, 0.86, 0.045)).mapped(lambda q: (
            GATE + q[0] * math.sin(a) + q[1] * math.cos(a), 1.62 - q[0] * math.cos(a) + q[1]
            * math.sin(a), WALL + q[2])).facing_outward())
    for side in (-1, 1):
        for k in range(7):
            wide = 0.30 if k % 2 else 0.22
            a, b = sorted((GATE + side * 0.595, GATE + side * (0.595 + wide)))
            stone.append(shapes.chamfered((a, -0.1 + 0.245 * k, WALL - 0.05), (b, 0.135 + 0.245 * k,
                WALL + 0.05), 0.012))
    x = -5.15
    while x < 5.1:
        stone.append(shapes.loft([[(x + 0.004, y, z) for y, z in _coping()], [(x + 0.682, y, z) for
            y, z in _coping()]], 30.0))
        x += 0.686
    stage.add("dressings", [("stone", stone), ("brick", voussoirs)])
    door, iron = [], []
    for k in range(8):
        x0 = GATE - 0.59 + 0.1475 * k
        edges = [x0 + 0.002 + 0.1435 * i / 3 for i in range(4)]
        head = [(x, 1.62 + math.sqrt(max(0.0, 0.597 ** 2 - (x - GATE) ** 2))) for x in edges]
        door.append(shapes.prism([(edges[0], 0.03), (edges[3], 0.03)] + head[::-1], WALL - 0.20,
            WALL - 0.155, crease=0.0))
    for y in (0.40, 1.45):
        iron.append(shapes.box((GATE - 0.57, y, WALL - 0.17), (GATE + 0.40, y + 0.05, WALL
            - 0.145)))
    iron.append(shapes.hoop([(0.05, -0.006), (0.062, -0.006), (0.062, 0.006), (0.05, 0.006)], 20,
        30.0).along_y().facing_outward().moved(GATE + 0.42, 1.0, WALL - 0.14))
    stage.add("garden door", [("green paint", door), ("iron", iron), ("stone", [shapes.box((GATE
        - 0.62, -0.1, WALL - 0.3), (GATE + 0.62, 0.055, WALL + 0.12))])])
    pier = [shapes.box((-0.21, -0.2, -0.17), (0.21, HIGH + 0.18, 0.16)), shapes.chamfered((-0.27,
        HIGH + 0.16, -0.23), (0.27, HIGH + 0.28, 0.22), 0.05)]
    ball = shapes.lathe([(0.0, HIGH + 0.25), (0.10, HIGH + 0.25), (0.07, HIGH + 0.32)] + [(0.15
        * math.cos(t), HIGH + 0.46 + 0.15 * math.sin(t)) for t in (math.pi * (i / 9.0 - 0.32) for i
            in range(8))] + [(0.0, HIGH + 0.61)], 18)
    stage.add("pier", [("brick", pier[:1]), ("stone", pier[1:] + [ball])], [(x, 0.0, WALL - 0.14)
        for x in (-4.93, 4.93, GATE - 1.08, GATE + 1.08)])


def _coping():
    return [(HIGH - 0.02, WALL + 0.07), (HIGH + 0.04, WALL + 0.07), (HIGH + 0.13, WALL - 0.06),
        (HIGH + 0.13, WALL - 0.26), (HIGH + 0.04, WALL - 0.39), (HIGH - 0.02, WALL - 0.39)]
