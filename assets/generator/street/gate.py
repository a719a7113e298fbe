# SPDX-License-Identifier: MIT
"""The gatehouse that closes the street: an archway, a clock, a pediment, turrets."""

import math

from .. import shapes
from ..polygon import arched, rectangle
from . import openings, ornament
from . import plan as p

DEEP = p.EAST - p.GATE


def add_to(stage):
    """Modelled facing +z with x across, then turned to face the street."""
    half, low = p.WIDTH / 2.0 - 0.02, p.LOW + 0.04
    arches = [arched(0.0, 2.5, low, 3.1, 28), arched(-4.75, 0.95, low, 2.2, 16), arched(4.75,
        0.95, low, 2.2, 16)]
    outline = [(-half, low)]
    for arch in (arches[1], arches[0], arches[2]):
        head = arch[2:]  # from the right springing over to the left
        outline += [arch[0]] + head[::-1] + [arch[1]]
    outline += [(half, low), (half, 8.2), (-half, 8.2)]
    clean = []
    for q in outline:
        if not clean or q != clean[-1]:
            clean.append(q)
    walls = [shapes.prism(clean, -DEEP, -0.02)]
    stone = []
    for x, radius, spring in ((0.0, 2.5, 3.1), (-4.75, 0.95, 2.2), (4.75, 0.95, 2.2)):
        profile = [(0.02, -0.06), (0.02, 0.10), (0.10, 0.10), (0.12, 0.15), (0.24, 0.16),
            (0.28, 0.22), (0.34, 0.18), (0.34, -0.06)]
        stone.append(shapes.moulding(profile, shapes.arch_path(x, spring, radius, 0.0, spring
            - 0.15, 24), crease=30.0))
        stone.append(shapes.prism([(x - 0.16, spring + radius - 0.02), (x + 0.16, spring + radius
            - 0.02), (x + 0.25, spring + radius + 0.5), (x - 0.25, spring + radius + 0.5)], -0.05,
            0.27, crease=0.0))
    for y, out in ((6.05, 0.42), (8.0, 0.5)):  # dentils only where the houses leave them in view
        stone += [m.moved(-half, 0.0, 0.0) for m in ornament.cornice(2.0 * half, y, out)]
        for x in ornament.runs(12.2):
            stone += [m.moved(x - 6.1, y, 0.04) for m in ornament.dentils()]
    for x in (-3.25, 3.25, -6.1, 6.1):
        stone.append(shapes.box((x - 0.32, 0.0, -0.1), (x + 0.32, 6.06, 0.14)))
        stone.append(shapes.chamfered((x - 0.42, -0.05, -0.1), (x + 0.42, 0.75, 0.24), 0.04))
        stone.append(shapes.box((x - 0.40, 5.7, -0.1), (x + 0.40, 6.07, 0.22)))
    # Attic with a clock under a pediment.
    walls.append(shapes.box((-3.6, 8.1, -DEEP + 0.3), (3.6, 9.95, -0.10)))
    stone += [m.moved(-3.7, 0.0, -0.1) for m in ornament.cornice(7.4, 9.75, 0.40)]
    for x in ornament.runs(7.4):
        stone += [m.moved(x - 3.7, 9.75, -0.09) for m in ornament.dentils()]
    stone.append(shapes.prism([(-3.75, 10.06), (3.75, 10.06), (0.0, 11.30)], -0.9, 0.02,
        crease=0.0))
    for side in (-1, 1):
        stone.append(shapes.bar((side * 4.05, 10.10, -0.35), (-side * 0.06, 11.42, -0.35), 1.35,
            0.14))
    # The ball on the ridge is the scene's highest point.
    stone.append(shapes.lathe([(0.0, -0.3), (0.16, -0.3), (0.10, -0.18), (0.05, -0.12)] + [(0.17
        * math.cos(a), 0.0 + 0.17 * math.sin(a)) for a in (math.pi * (i / 10.0 - 0.3) for i in
            range(8))] + [(0.0, 0.17)], 16).moved(0.0, p.TOP - 0.17, -0.35))
    clock = shapes.lathe([(0.0, -0.1), (0.86, -0.1), (0.86, 0.06), (0.74, 0.06), (0.72, 0.0),
        (0.0, 0.0)], 40, 30.0).along_y().facing_outward().moved(0.0, 8.98, -0.08)
    face = shapes.lathe([(0.0, -0.08), (0.73, -0.08), (0.73, 0.005), (0.0, 0.005)], 40,
        30.0).along_y().facing_outward().moved(0.0, 8.98, -0.07)
    hands = [shapes.bar((0.0, 8.98, -0.035), (0.20, 9.33, -0.035), 0.02, 0.07, (-0.35, 0.2, 0.0)),
        shapes.bar((0.0, 8.98, -0.02), (-0.54, 9.16, -0.02), 0.02, 0.05, (0.18, 0.54, 0.0))]
    for k in range(12):
        a = math.pi * k / 6
        c, s = math.cos(a), math.sin(a)
        hands.append(shapes.bar((0.58 * c, 8.98 + 0.58 * s, -0.05), (0.68 * c, 8.98 + 0.68 * s,
            -0.05), 0.03, 0.05, (-s, c, 0.0)))
    holes = []
    window = stage.mesh("gate window", openings.window(1.05, 1.35, top="cornice"))
    spots = [(-2.4, 6.62), (0.0, 6.62), (2.4, 6.62), (-4.75, 6.62), (4.75, 6.62), (-4.75, 4.1),
        (4.75, 4.1)]
    for x, y in spots:
        holes.append(rectangle(x - 0.525, y, x + 0.525, y + 1.35))
    walls.append(shapes.prism(rectangle(-half + 0.01, 6.3, half - 0.01, 8.1), -0.25, 0.0,
        [h for h in holes if h[0][1] > 6.0], crease=0.0))
    for hole in holes[5:]:
        (x0, y0), (x1, y1) = hole[0], hole[2]
        walls.append(shapes.prism(rectangle(x0 - 0.35, y0 - 0.3, x1 + 0.35, y1 + 0.36), -0.25, 0.03,
            [hole], crease=0.0))
    turret = []
    for x in (-7.1, 7.1):
        turret.append(shapes.lathe([(0.0, 8.1), (0.95, 8.1), (0.95, 9.0), (1.08, 9.06), (1.08, 9.2),
            (0.9, 9.25), (0.86, 9.6), (0.6, 10.05), (0.22, 10.4), (0.08, 10.75), (0.13, 10.9),
            (0.0, 11.05)], 20, 30.0).moved(x, 0.0, -2.2))
    turn = -90.0
    at = (p.GATE, 0.0, 0.0, turn)
    stage.add("gate", [("ochre", walls), ("stone", stone), ("lead", turret + [clock]),
        ("white paint", [face]), ("iron", hands)], [at])
    places = []
    for i, (x, y) in enumerate(spots):
        places.append((p.GATE - (0.03 if i > 4 else 0.0), y, x, turn))
    stage.put("gate window", window, places)
