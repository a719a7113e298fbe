# SPDX-License-Identifier: MIT
"""Roadway, gutters, kerbs, pavements and what is painted or let into them."""

from .. import shapes
from . import plan as p

PANEL = 6.0  # length of a pavement's panel; sixteen fill the street


def add_to(stage):
    stage.add("ground", [("joint", shapes.box((p.WEST, p.LOW, -p.WIDTH / 2.0), (p.EAST, -0.06,
        p.WIDTH / 2.0)))])
    stage.add("roadway", [("roadway", _roadway())])
    stage.add("pavement", _pavement(), [(p.WEST + PANEL * k, 0.0, 0.0) for k in range(16)] +
        [(p.WEST + PANEL * (k + 1), 0.0, 0.0, 180.0) for k in range(16)])
    bars = [shapes.box((-1.5, -0.02, -3.2 + 0.8 * k - 0.24), (1.5, 0.006, -3.2 + 0.8 * k + 0.24))
        .mapped(lambda q: (q[0], q[1] + _camber(q[2]) + 0.002, q[2])) for k in range(9)]
    stage.add("crossing", [("marking", bars)], [(-12.5, 0.0, 0.0), (27.0, 0.0, 0.0)])
    dash = shapes.box((-1.2, -0.02, -0.06), (1.2, _camber(0.0) + 0.006, 0.06))
    xs = [-45.6 + 4.8 * k for k in range(19)]
    stage.add("dash", [("marking", dash)], [(x, 0.0, 0.0) for x in xs if min(abs(x + 12.5),
        abs(x - 27.0)) > 3.0])
    lid = [shapes.lathe([(0.0, -0.02), (0.38, -0.02), (0.38, 0.004), (0.33, 0.004), (0.32, -0.003),
        (0.0, -0.003)], 24, 30.0)]
    for k in range(-3, 4):
        half = (0.30 ** 2 - (0.085 * k) ** 2) ** 0.5
        lid.append(shapes.box((-half, -0.01, 0.085 * k - 0.022), (half, 0.003, 0.085 * k + 0.022)))
    stage.add("manhole", [("iron", lid)], [(x, _camber(z) + 0.004, z) for x, z in ((-33.0, 1.6),
        (-6.0, -1.4), (13.0, 1.2), (36.0, -1.5))])
    grate = [shapes.box((-0.30 + 0.075 * k, -0.04, -0.16), (-0.30 + 0.075 * k + 0.04, 0.012, 0.16))
        for k in range(9)]
    grate += [shapes.box((-0.33, -0.04, z - 0.02), (0.37, 0.008, z + 0.02)) for z in (-0.17, 0.17)]
    stage.add("grate", [("iron", grate)], [(-36.0 + 24.0 * k, 0.0, s * (p.KERB - 0.28)) for k in
        range(4) for s in (-1, 1)])


def _camber(z):
    """Height of the roadway: 9 cm in the middle, falling to the gutters."""
    return 0.09 * max(0.0, 1.0 - (z / 3.2) ** 2)


def _roadway():
    zs = [-3.2 + 0.4 * k for k in range(17)]
    ring = [(_camber(z), z) for z in zs] + [(-0.08, 3.2), (-0.08, -3.2)]
    stations = [p.WEST + 0.01 + (p.LENGTH - 0.02) * k / 12 for k in range(13)]
    return shapes.loft([[(x, y, z) for y, z in ring] for x in stations])


def _pavement():
    """Slabs, kerb and gutter from x = 0 to PANEL, on the side z > 0."""
    slabs, kerb, setts = [], [], []
    rows, z0, z1 = 4, p.KERB + 0.19, p.FRONT + 0.02
    deep = (z1 - z0) / rows
    for row in range(rows):
        wide = 0.75
        shift = 0.0 if row % 2 else wide / 2.0
        edges = [0.0] + [shift + wide * k for k in range(0 if shift else 1, 8)] + [PANEL]
        for a, b in zip(edges, edges[1:]):
            if b - a > 0.1:
                z = z0 + deep * row
                slabs.append(shapes.chamfered((a + 0.006, -0.09, z + 0.006), (b - 0.006, p.PAVEMENT
                    - 0.004 * ((row + round(a / 0.375)) % 2), z + deep - 0.006), 0.008))
    for k in range(6):
        kerb.append(shapes.chamfered((k + 0.005, -0.1, p.KERB), (k + 0.995, p.PAVEMENT + 0.008,
            p.KERB + 0.18), 0.025))
    for k in range(24):
        x = PANEL * k / 24
        setts.append(shapes.chamfered((x + 0.008, -0.1, 3.21), (x + 0.242, 0.0, p.KERB - 0.008),
            0.012))
    return [("paving", slabs), ("kerbstone", kerb), ("setts", setts)]
