# SPDX-License-Identifier: MIT
"""What is in the rooms: easel, shelves, folding screen, drawings, lantern, plants, lamp."""

import math
import random

from .. import shapes
from ..mesh import Mesh
from . import plan as p


def add_to(stage):
    y = p.FLOOR
    stage.add("easel", easel(), [(-0.62, y, -1.25, 62.0)])
    stage.add("shelves", shelves(), [(0.92, y, p.NORTH + p.CELL + 0.015, 0.0)])
    stage.add("folding screen", folding_screen(), [(-3.75, y, -2.42, 18.0)])
    stage.add("desk", desk(), [(-0.75, y, -2.70, 0.0)])
    stage.add("drawings on the wall", pinned(), [(p.PARTITION + p.CELL + 0.003, y, -2.45, 90.0)])
    stage.add("sheets on the floor", scattered(), [(0.1, y, -1.0, 0.0)])
    stage.add("lantern", lantern(), [(-1.5, p.CEILING, -2.35, 0.0), (-2.2, p.CEILING, -1.0, 40.0)])
    stage.add("blades in a pot", plant(3), [(-4.25, y - 0.004, 0.05, 70.0),
        (2.22, y - 0.004, -0.02, 160.0)])
    stage.add("clothes rail", [("steel", [shapes.cord(path, [0.009] * len(path), 6) for path in (
        [(-0.5, 0.0, 0.0), (-0.5, 1.45, 0.0), (0.5, 1.45, 0.0), (0.5, 0.0, 0.0)],
        [(-0.5, 0.01, -0.22), (-0.5, 0.01, 0.22)], [(0.5, 0.01, -0.22), (0.5, 0.01, 0.22)])]),
        ("madder cloth", _hung(-0.22, 0.36, 0.95)), ("linen", _hung(0.22, 0.30, 0.72))],
        [(-2.55, y, -2.72, 4.0)])


def _hung(x, width, drop):
    """One sheet thrown over the rail at 1.45 m, its folds deepening downwards."""

    def point(s, t):
        u, side = 2.0 * t - 1.0, 1.0 if t > 0.5 else -1.0
        down = max(0.0, abs(u) - 0.03) * drop
        fold = 0.022 * math.sin(6.5 * math.pi * s + side) * (down / drop)
        return (x + width * (s - 0.5) * (1.0 - 0.18 * down), 1.461 - down,
            0.013 * min(1.0, abs(u) * 30.0) * side + side * (0.02 * down) + fold)

    return shapes.sheet(point, 16, 16)


def easel():
    """Three thin legs, a ledge, and a canvas 18 mm thick with a painting as a sheet on it."""
    wood = [shapes.bar((-0.33, 0.0, 0.12), (-0.05, 1.75, -0.16), 0.028, 0.018, (0.0, 0.0, 1.0)),
        shapes.bar((0.33, 0.0, 0.12), (0.05, 1.75, -0.16), 0.028, 0.018, (0.0, 0.0, 1.0)),
        shapes.bar((0.0, 0.0, -0.62), (0.0, 1.72, -0.18), 0.028, 0.018, (0.0, 0.0, 1.0)),
        shapes.box((-0.36, 0.70, 0.0), (0.36, 0.722, 0.085)),
        shapes.bar((-0.24, 0.52, 0.040), (0.24, 0.52, 0.040), 0.018, 0.026),
        shapes.bar((-0.14, 1.25, -0.068), (0.14, 1.25, -0.068), 0.018, 0.026)]
    lean = lambda mesh: mesh.mapped(lambda q: (q[0], 0.724 + q[1], 0.055 + q[2] - 0.16 * q[1]))
    canvas = lean(shapes.box((-0.40, 0.0, -0.009), (0.40, 0.62, 0.009)))
    parts = [("beech", wood), ("white paint", [canvas])]
    # A still life of flat shapes, each a millimetre before the last.
    shapes_of = (("indigo cloth", [(-0.37, 0.24), (0.37, 0.24), (0.37, 0.59), (-0.37, 0.59)]),
        ("saffron cloth", [(-0.37, 0.03), (0.37, 0.03), (0.37, 0.26), (-0.37, 0.22)]),
        ("madder cloth", [(0.11 * math.cos(t) - 0.12, 0.22 + 0.10 * math.sin(t)) for t in
            (2.0 * math.pi * i / 20 for i in range(20))]),
        ("linen", [(0.05, 0.12), (0.21, 0.12), (0.19, 0.34), (0.15, 0.40), (0.15, 0.47),
            (0.10, 0.47), (0.10, 0.40), (0.06, 0.34)]))
    for layer, (material, outline) in enumerate(shapes_of):
        sheet = Mesh()
        for a, b, c in shapes.triangulate(outline):
            sheet.triangle(*((x, y, 0.010 + 0.001 * layer) for x, y in (a, b, c)))
        parts.append((material, lean(sheet)))
    return parts


def shelves():
    """Boards of 10 mm on uprights of 14 mm, with books and sheets of paper. Stands at z >= 0."""
    wood, books, red, paper = [], [], [], []
    for x in (-0.40, 0.0, 0.40):
        wood.append(shapes.box((x - 0.007, 0.0, 0.0), (x + 0.007, 0.82, 0.24)))
    chance = random.Random(11)
    for k, y in enumerate((0.06, 0.32, 0.58, 0.80)):
        wood.append(shapes.box((-0.425, y, 0.004), (0.425, y + 0.010, 0.244)))
        if k == 3:
            continue
        for side in (-1, 1):
            x = -0.39 if side < 0 else 0.012
            while x < (-0.05 if side < 0 else 0.33):
                wide = 0.012 + 0.028 * chance.random()
                tall = 0.15 + 0.085 * chance.random()
                deep = 0.13 + 0.07 * chance.random()
                book = shapes.box((x, y + 0.008, 0.03), (x + wide, y + 0.01 + tall, 0.03 + deep))
                (books, red, paper)[int(3 * chance.random())].append(book)
                x += wide + 0.002
    bowl = [(0.0, 0.808), (0.05, 0.808), (0.12, 0.86), (0.116, 0.862), (0.045, 0.818), (0.0, 0.816)]
    return [("beech", wood), ("books", books), ("red lacquer", red), ("ochre", paper),
        ("clay", [shapes.lathe(bowl, 24).moved(0.2, 0.0, 0.12)])]


def folding_screen():
    """Four leaves in zigzag: frames of 18 mm, lattice of 8 mm, paper without thickness."""
    wood, paper, x, z = [], [], 0.0, 0.0
    for k in range(4):
        turn = 32.0 if k % 2 else -28.0
        width, height = 0.46, 1.62
        bars = []
        for at in (0.009, width - 0.009):
            bars.append(shapes.box((at - 0.009, 0.0, -0.009), (at + 0.009, height, 0.009)))
        for y in (0.05, 0.46, height - 0.018):
            bars.append(shapes.box((0.01, y, -0.008), (width - 0.01, y + 0.018, 0.008)))
        for i in range(1, 4):
            at = width * i / 4
            bars.append(shapes.box((at - 0.004, 0.47, -0.006), (at + 0.004, height - 0.01, 0.006)))
        for i in range(1, 6):
            y = 0.46 + (height - 0.46) * i / 6
            bars.append(shapes.box((0.012, y - 0.004, -0.005), (width - 0.012, y + 0.004, 0.005)))
        leaf = shapes.box((0.012, 0.06, -0.003), (width - 0.012, 0.465, 0.003))
        sheet = Mesh()
        sheet.quad((0.012, 0.466, -0.007), (width - 0.012, 0.466, -0.007),
            (width - 0.012, height - 0.012, -0.007), (0.012, height - 0.012, -0.007))
        place = lambda m: m.turned_y(turn).moved(x, 0.0, z)
        wood += [place(m) for m in bars + [leaf]]
        paper.append(place(sheet))
        x += (width + 0.004) * math.cos(math.radians(turn))
        z -= (width + 0.004) * math.sin(math.radians(turn))
    return [("dark wood", wood), ("paper", paper)]


def desk():
    """Board on trestles, a lamp on a jointed arm, paper on it."""
    wood = [shapes.box((-0.70, 0.715, -0.28), (0.70, 0.735, 0.28))]
    for x in (-0.52, 0.52):
        for z in (-0.22, 0.22):
            wood.append(shapes.bar((x - 0.11, 0.0, z), (x, 0.72, 0.7 * z), 0.022, 0.03, (0, 0, 1)))
            wood.append(shapes.bar((x + 0.11, 0.0, z), (x, 0.72, 0.7 * z), 0.022, 0.03, (0, 0, 1)))
        wood.append(shapes.bar((x - 0.07, 0.28, -0.22), (x - 0.07, 0.28, 0.22), 0.016, 0.022))
    joints = [(0.50, 0.735, -0.14), (0.42, 1.02, -0.16), (0.20, 1.22, -0.06)]
    lamp = [shapes.lathe([(0.0, -0.01), (0.075, -0.01), (0.075, 0.01), (0.012, 0.02), (0.0, 0.02)],
        24).moved(*joints[0])]
    for a, b in zip(joints, joints[1:]):
        lamp.append(shapes.rod(a, b, 0.005, 6))
        lamp.append(shapes.sphere(0.011, 10, 6, b))
    shade = [(0.016, 0.05), (0.016, 0.03), (0.085, -0.06), (0.089, -0.06), (0.022, 0.036),
        (0.022, 0.05)]
    lamp.append(shapes.hoop(shade, 24, 30.0).moved(*joints[-1]))
    paper = []
    for k, (x, z, turn) in enumerate(((-0.35, 0.02, 8), (-0.28, 0.06, -14), (0.10, 0.10, 24),
            (0.02, -0.10, -5))):
        paper.append(_curled(0.21, 0.297, 0.006 + 0.012 * (k % 2)).turned_y(turn)
            .moved(x, 0.7375 + 0.0015 * k, z))
    return [("beech", wood), ("frame", lamp), ("paper", paper)]


def _curled(width, height, lift):
    """A sheet of paper that lies with two of its corners up; faces +y."""

    def point(s, t):
        up = lift * ((2.0 * s - 1.0) * (2.0 * t - 1.0)) ** 2 + lift * max(0.0, s - 0.7) ** 2 * 4.0
        return (width * (s - 0.5), up, height * (0.5 - t))

    return shapes.sheet(point, 6, 6)


def scattered():
    chance, paper, drawing = random.Random(5), [], []
    for k in range(9):
        sheet = _curled(0.297, 0.42, 0.01 + 0.05 * chance.random())
        sheet = sheet.turned_y(360.0 * chance.random())
        x, z = 1.9 * chance.random() - 1.1, 1.1 * chance.random() - 0.75
        (drawing if k % 4 == 1 else paper).append(sheet.moved(x, 0.002 + 0.0015 * k, z))
    return [("paper", paper), ("drawing", drawing)]


def pinned():
    """Drawings on a wall, in the plane z = 0 before it, their lower edges bent off the wall."""
    paper, drawing = [], []
    for k, (x, y, w, h) in enumerate(((-0.28, 1.25, 0.30, 0.42), (0.06, 1.30, 0.21, 0.30),
            (0.34, 1.18, 0.30, 0.42), (0.05, 0.88, 0.297, 0.21), (-0.28, 0.92, 0.21, 0.21))):
        bend = 0.03 + 0.02 * (k % 3)
        sheet = shapes.sheet(lambda s, t: (x + w * (s - 0.5), y + h * (t - 0.5),
            0.002 + bend * max(0.0, 0.6 - t) ** 2), 2, 8)
        (drawing if k % 2 else paper).append(sheet)
    return [("paper", paper), ("drawing", drawing)]


def lantern():
    """Paper lantern on a cord from the ceiling: one skin over wire hoops."""
    profile = []
    for i in range(25):
        a = math.pi * (0.06 + 0.88 * i / 24)
        bulge = 0.004 if i % 2 else 0.0
        profile.append((0.21 * math.sin(a) + bulge, -0.62 - 0.19 * math.cos(a)))
    rings = [shapes.ring_y(r, y, 32) for r, y in profile]
    skin = Mesh(70.0)
    skin.grid([ring + ring[:1] for ring in rings])
    wires = [shapes.hoop([(r - 0.003, y), (r + 0.001, y - 0.002), (r + 0.001, y + 0.002)], 32)
        for r, y in (profile[0], profile[-1])]
    wires.append(shapes.rod((0.0, -0.62, 0.0), (0.0, 0.01, 0.0), 0.003, 6))
    wires.append(shapes.rod((-0.04, profile[-1][1], 0.0), (0.04, profile[-1][1], 0.0), 0.0025, 5))
    return [("linen", skin), ("dark wood", wires)]


def plant(seed):
    """Long blades, each a bent single sheet, in a pot."""
    pot = [(0.0, 0.0), (0.10, 0.0), (0.145, 0.24), (0.155, 0.24), (0.155, 0.28), (0.14, 0.28),
        (0.13, 0.23), (0.0, 0.225)]
    chance, leaves = random.Random(seed), []
    for k in range(19):
        turn, long = 360.0 * (k * 0.382 + 0.1 * chance.random()), 0.45 + 0.5 * chance.random()
        lean, wide = 0.15 + 0.75 * chance.random(), 0.018 + 0.012 * chance.random()

        def point(s, t):
            w = wide * math.sin(math.pi * (0.12 + 0.88 * t)) ** 0.7 if t < 1.0 else 0.0
            out = 0.03 + long * lean * t * t * 0.75
            up = 0.22 + long * (t - 0.32 * lean * t * t)
            return (w * (2.0 * s - 1.0), up + 0.25 * w * (2.0 * s - 1.0) ** 2, out)

        leaves.append(shapes.sheet(point, 2, 9).turned_y(turn))
    return [("clay", shapes.lathe(pot, 28, 40.0)), ("leaf", leaves)]
