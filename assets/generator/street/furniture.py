# SPDX-License-Identifier: MIT
"""What stands on the pavements: lamps, bollards, benches, planters, a cafe, a pillar box."""

import math
import random

from .. import lights, shapes
from ..mesh import Mesh
from . import plan as p

Y = p.PAVEMENT


def add_to(stage):
    places, glows = [], []
    for x, side in p.LAMPS:
        z = side * (p.KERB + 0.42)
        places.append((x, Y, z, 90.0 * side))
        glows.append((x, Y + 4.12, z))
    stage.add("lamp", lamp(), places)
    lights.add_lamp(stage.doc, "lamp light", (1.0, 0.78, 0.48), 9.0, 16.0, glows)
    stage.add("bollard", bollard(), [(x + dx, Y, s * (p.KERB + 0.34)) for x in (-12.5, 27.0)
        for dx in (-2.2, 2.2) for s in (-1, 1)] + [(41.6, -0.02, z) for z in (-2.2, -0.75, 0.75,
            2.2)])
    stage.add("bench", bench(), [(-20.0, Y, -4.55, 0.0), (20.5, Y, 4.55, 180.0), (7.0, Y, -4.5,
        0.0), (-35.5, Y, 4.5, 180.0)])
    stage.add("planter", planter(), [(x, Y, s * 5.52) for x, s in ((-44.2, -1), (-26.6, 1), (-1.1,
        -1), (3.9, -1), (12.4, 1), (31.0, -1), (37.6, 1), (-31.4, -1), (-17.2, 1))])
    cone = stage.mesh("clipped tree", clipped_tree())
    stage.put("clipped tree", cone, [(x, Y, s * 5.45) for x, s in ((-39.0, 1), (-14.2, -1), (16.6,
        1), (24.1, -1), (40.9, -1), (40.9, 1))])
    stage.add("pillar box", pillar_box(), [(-23.4, Y, -4.15, 20.0), (32.0, Y, 4.2, 200.0)])
    stage.add("bin", bin_(), [(-18.3, Y, -4.3), (5.2, Y, 4.25), (22.6, Y, 4.3)])
    cafe = stage.mesh("cafe table", cafe_table())
    chair = stage.mesh("cafe chair", cafe_chair())
    shade = stage.mesh("parasol", parasol())
    for x, z in ((-6.0, -4.55), (-3.6, -4.75), (14.0, -4.6), (16.4, -4.6), (-29.0, 4.65)):
        stage.put("cafe table", cafe, [(x, Y, z)])
        for k, turn in enumerate((35.0, 150.0, 268.0)):
            a = math.radians(turn)
            if (round(10 * x) + k) % 4:
                stage.put("cafe chair", chair, [(x + 0.58 * math.sin(a), Y, z + 0.58 * math.cos(a),
                    turn + 180.0)])
    stage.put("parasol", shade, [(-3.6, Y, -4.75), (14.0, Y, -4.6)])
    stage.put("parasol", stage.variant(shade, {"red stripes": "green stripes"}), [(-29.0, Y, 4.65)])


def lamp():
    """Cast iron, 4.5 m, a six-sided lantern with a ladder bar under it."""
    post = [(0.0, -0.05), (0.20, -0.05), (0.20, 0.08), (0.15, 0.14), (0.13, 0.55), (0.16, 0.62),
        (0.10, 0.72), (0.065, 0.95), (0.048, 3.55), (0.075, 3.62), (0.045, 3.68), (0.045, 3.78),
        (0.10, 3.84), (0.0, 3.84)]
    iron = [shapes.lathe(post, 12, 40.0), shapes.rod((-0.34, 3.5, 0.0), (0.34, 3.5, 0.0), 0.016, 6)]
    iron += [shapes.sphere(0.032, 8, 6, (x, 3.5, 0.0)) for x in (-0.34, 0.34)]
    glass = [shapes.lathe([(0.0, 3.86), (0.115, 3.86), (0.19, 4.28), (0.0, 4.28)], 6, 0.0)]
    iron.append(shapes.lathe([(0.0, 4.27), (0.225, 4.27), (0.225, 4.31), (0.09, 4.47), (0.07, 4.55),
        (0.03, 4.58), (0.02, 4.68), (0.0, 4.70)], 6, 0.0))
    for k in range(6):
        a = math.pi * k / 3
        c, s = math.cos(a), -math.sin(a)
        iron.append(shapes.rod((0.118 * c, 3.83, 0.118 * s), (0.198 * c, 4.29, 0.198 * s), 0.011,
            5))
    return [("iron", iron), ("lamp glass", glass)]


def bollard():
    profile = [(0.0, -0.05), (0.11, -0.05), (0.11, 0.10), (0.085, 0.14), (0.07, 0.72),
        (0.095, 0.76), (0.095, 0.80), (0.06, 0.84), (0.075, 0.90), (0.05, 0.97), (0.0, 0.99)]
    return [("iron", [shapes.lathe(profile, 12, 40.0)])]


def bench():
    """Faces +z; slats on iron ends."""
    wood = [shapes.box((-0.85, 0.44, -0.20 + 0.105 * i), (0.85, 0.475, -0.20 + 0.105 * i + 0.085))
        for i in range(4)]
    wood += [shapes.bar((-0.85, 0.56 + 0.125 * i, -0.25 - 0.035 * i), (0.85, 0.56 + 0.125 * i,
        -0.25 - 0.035 * i), 0.095, 0.03, (0.0, 0.27, 1.0)) for i in range(3)]
    iron = []
    for x in (-0.68, 0.68):
        iron.append(shapes.cord([(x, -0.02, 0.22), (x, 0.22, 0.16), (x, 0.43, 0.20)], [0.026, 0.020,
            0.024], 6))
        iron.append(shapes.cord([(x, -0.02, -0.30), (x, 0.24, -0.20), (x, 0.46, -0.24), (x, 0.88,
            -0.37)], [0.026, 0.020, 0.024, 0.016], 6))
        iron.append(shapes.rod((x, 0.43, -0.24), (x, 0.43, 0.22), 0.020, 6))
        iron.append(shapes.cord([(x, 0.62, -0.28), (x, 0.66, -0.05), (x, 0.64, 0.16), (x, 0.45,
            0.20)], [0.016] * 4, 6))
    return [("wood", wood), ("iron", iron)]


def _shrub(radius, seed, squash=1.0, segments=16, rows=9):
    """A ball with an uneven surface."""
    chance = random.Random(seed)
    waves = [(2.0 + 4.0 * chance.random(), 6.28 * chance.random()) for _ in range(9)]
    rings = []
    for j in range(rows + 1):
        b = math.pi * (j / rows - 0.5)
        ring = []
        for i in range(segments):
            a = 2.0 * math.pi * i / segments
            k = sum(math.sin(round(f) * a + q + (n + 2) * b) for n, (f, q) in enumerate(waves))
            k /= len(waves)
            r = radius * (1.0 + 0.22 * k) * (math.cos(b) if 0 < j < rows else 0.0)
            ring.append((r * math.cos(a), squash * radius * (1.0 + 0.15 * k * math.cos(b))
                * math.sin(b), -r * math.sin(a)))
        rings.append(ring)
    return shapes.loft(rings, crease=75.0)


def planter():
    """Box of 1.3 m with shrubs and flowers."""
    tub = shapes.loft([[(x * w, y, z * d) for x, z in ((-1, 1), (1, 1), (1, -1), (-1, -1))] for
        y, w, d in ((-0.02, 0.56, 0.19), (0.42, 0.66, 0.24), (0.42, 0.62, 0.20), (0.36, 0.62,
            0.20))], crease=0.0)
    green = [_shrub(0.25, 3).moved(-0.38, 0.55, 0.0), _shrub(0.29, 4).moved(0.05, 0.58, -0.02),
        _shrub(0.22, 5).moved(0.43, 0.52, 0.02)]
    chance, blossom = random.Random(8), []
    for _ in range(12):
        x, a, b = 1.1 * chance.random() - 0.55, 6.28 * chance.random(), chance.random()
        blossom.append(shapes.sphere(0.036, 6, 3, (x, 0.62 + 0.17 * b, 0.21 * math.cos(a))))
    return [("terracotta", [tub]), ("leaves", green), ("blossom", blossom)]


def clipped_tree():
    """Two balls and a cone on a stem, in a tub."""
    tub = [(0.0, -0.02), (0.25, -0.02), (0.33, 0.46), (0.36, 0.46), (0.36, 0.52), (0.31, 0.52),
        (0.29, 0.44), (0.0, 0.44)]
    green = [_shrub(0.46, 12, 0.9, 24, 14).moved(0.0, 1.10, 0.0), _shrub(0.35, 13, 0.9, 20,
        11).moved(0.0, 1.78, 0.0), _shrub(0.24, 14, 1.1, 16, 9).moved(0.0, 2.28, 0.0)]
    return [("terracotta", [shapes.lathe(tub, 20, 40.0)]), ("leaves", green), ("wood",
        [shapes.rod((0.0, 0.4, 0.0), (0.0, 2.2, 0.0), 0.035, 6)])]


def pillar_box():
    body = [(0.0, -0.02), (0.26, -0.02), (0.26, 0.12), (0.225, 0.16), (0.225, 1.22), (0.27, 1.26),
        (0.27, 1.33), (0.20, 1.42), (0.0, 1.46)]
    slot = shapes.box((-0.10, 1.08, 0.19), (0.10, 1.12, 0.229))
    plate = shapes.box((-0.07, 0.72, 0.19), (0.07, 0.94, 0.232))
    return [("red stripes", [shapes.lathe(body, 24, 40.0)]), ("iron", [slot]), ("canvas", [plate])]


def bin_():
    staves, iron = [], []
    for k in range(14):
        a = 360.0 * k / 14
        staves.append(shapes.box((-0.045, 0.08, 0.235), (0.045, 0.80, 0.255)).turned_y(a))
    iron += [shapes.hoop([(0.232, y), (0.262, y), (0.262, y + 0.04), (0.232, y + 0.04)], 28, 30.0)
        for y in (0.12, 0.70)]
    iron.append(shapes.lathe([(0.0, -0.02), (0.22, -0.02), (0.22, 0.66), (0.20, 0.66), (0.19, 0.10),
        (0.0, 0.10)], 20, 40.0))
    return [("wood", staves), ("iron", iron)]


def cafe_table():
    top = shapes.lathe([(0.0, 0.71), (0.33, 0.71), (0.35, 0.722), (0.35, 0.735), (0.33, 0.742),
        (0.0, 0.742)], 24, 40.0)
    iron = [shapes.rod((0.0, 0.1, 0.0), (0.0, 0.72, 0.0), 0.022, 8)]
    for k in range(3):
        iron.append(shapes.cord([(0.0, 0.16, 0.0), (0.14, 0.12, 0.0), (0.27, 0.0, 0.0)], [0.018,
            0.016, 0.014], 6).turned_y(120.0 * k))
    cups = [shapes.lathe([(0.0, 0.0), (0.024, 0.0), (0.036, 0.055), (0.032, 0.055), (0.0, 0.012)],
        12, 40.0).moved(x, 0.741, z) for x, z in ((0.12, 0.10), (-0.14, -0.05))]
    return [("stone", [top]), ("iron", iron), ("white paint", cups)]


def cafe_chair():
    """Bentwood chair that faces +z."""
    seat = shapes.lathe([(0.0, 0.44), (0.18, 0.44), (0.20, 0.452), (0.20, 0.464), (0.17, 0.466),
        (0.0, 0.458)], 20, 40.0)
    wood = [seat]
    for sx in (-1, 1):
        wood.append(shapes.cord([(0.18 * sx, 0.0, 0.17), (0.135 * sx, 0.45, 0.12)], [0.011, 0.014],
            6))
    bow = [(-0.19, 0.0, -0.20), (-0.165, 0.25, -0.165), (-0.16, 0.46, -0.15), (-0.175, 0.70, -0.20),
        (-0.13, 0.86, -0.235), (0.0, 0.91, -0.245)]
    bow += [(-x, y, z) for x, y, z in reversed(bow[:-1])]
    wood.append(shapes.cord(bow, [0.012] * len(bow), 6))
    inner = [(-0.10, 0.46, -0.15), (-0.11, 0.66, -0.19), (0.0, 0.78, -0.222), (0.11, 0.66, -0.19),
        (0.10, 0.46, -0.15)]
    wood.append(shapes.cord(inner, [0.009] * 5, 6))
    return [("wood", wood)]


def parasol():
    """Eight gores 5 mm thick in two colours, on a pole."""
    gores = ([], [])
    for k in range(8):
        a0, a1 = math.pi * k / 4 + 0.002, math.pi * (k + 1) / 4 - 0.002
        rings = []
        for drop in (0.0, -0.005):
            ring = []
            for r, y in ((0.02, 2.62), (0.65, 2.46), (1.25, 2.22)):
                ring.append((r * math.cos(a0), y + drop, -r * math.sin(a0)))
            for r, y in ((1.25, 2.22), (0.65, 2.46), (0.02, 2.62)):
                ring.append((r * math.cos(a1), y + drop, -r * math.sin(a1)))
            rings.append(ring)
        top, under = rings
        mesh = Mesh()
        for i, j in ((0, 5), (1, 4)):
            mesh.quad(top[i], top[i + 1], top[j - 1], top[j])
            mesh.quad(under[j], under[j - 1], under[i + 1], under[i])
        for i in range(6):
            mesh.quad(top[i], under[i], under[(i + 1) % 6], top[(i + 1) % 6])
        gores[k % 2].append(mesh.facing_outward())
    pole = [shapes.rod((0.0, 0.0, 0.0), (0.0, 2.68, 0.0), 0.022, 8)]
    pole.append(shapes.lathe([(0.0, -0.02), (0.28, -0.02), (0.28, 0.05), (0.05, 0.09), (0.0, 0.09)],
        20, 40.0))
    return [("red stripes", gores[0]), ("canvas", gores[1]), ("iron", pole)]
