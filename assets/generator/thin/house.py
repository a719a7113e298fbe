# SPDX-License-Identifier: MIT
"""The house: walls one cell thick, roof, windows with venetian blinds, deck and pergola."""

import math

from .. import shapes
from ..mesh import Mesh
from ..polygon import rectangle
from . import plan as p

SINK = 0.02  # of a piece into what carries it


def add_to(stage):
    half, kerb = p.LENGTH / 2, p.FENCE + 0.16
    stage.add("ground", [
        ("lawn", shapes.box((-half, -0.16, p.BACK), (half, 0.0, kerb))),
        ("footpath joints", shapes.box((-half, -0.16, kerb - 0.02), (half, -0.05, p.FRONT))),
        ("paving", _paving(kerb)),
    ])
    stage.add("stepping stones", [("paving", [_stone(i) for i in range(4)])])
    _walls(stage)
    _windows(stage)
    _deck(stage)
    _pergola(stage)


def _paving(kerb):
    """Slabs of the footpath in courses that are offset by half a slab, and its kerb."""
    half, slabs = p.LENGTH / 2, [shapes.box((-p.LENGTH / 2 + 0.005, -0.06, kerb),
        (p.LENGTH / 2 - 0.005, 0.03, kerb + 0.07))]
    courses, wide = 3, 0.6
    deep = (p.FRONT - kerb - 0.08) / courses
    for row in range(courses):
        x = -half - (0.3 if row % 2 else 0.0)
        while x < half - 0.01:
            low, high = max(x, -half), min(x + wide, half)
            z = kerb + 0.078 + deep * row
            slabs.append(shapes.chamfered((low + 0.004, -0.06, z), (high - 0.004, -0.030,
                z + deep - 0.008), 0.004))
            x += wide
    return slabs


def _stone(i):
    outline = []
    for k in range(11):
        a = 2.0 * math.pi * k / 11
        r = 1.0 + 0.09 * math.sin(3.0 * a + i) + 0.05 * math.cos(5.0 * a + 2.0 * i)
        outline.append((0.27 * r * math.cos(a), 0.20 * r * math.sin(a)))
    slab = shapes.prism(outline, -0.04, 0.022 + 0.004 * (i % 2)).along_y()
    return slab.moved(0.32 + 0.10 * math.sin(1.7 * i), 0.0, 1.92 + 0.42 * i - 0.04)


def _opening(window):
    low, high, sill, head = window
    return rectangle(low, p.FLOOR + sill, high, p.FLOOR + head)


def _wall(low, high, windows, top=p.CEILING):
    """A wall in the plane z = 0, one cell thick towards -z; a door cuts through its foot."""
    outline = [(low, p.FLOOR - 0.06)]
    for door in sorted(w for w in windows if w[2] == 0.0):
        a, b, _, head = door
        outline += [(a, p.FLOOR - 0.06), (a, p.FLOOR + head), (b, p.FLOOR + head),
            (b, p.FLOOR - 0.06)]
    outline += [(high, p.FLOOR - 0.06), (high, top), (low, top)]
    holes = [_opening(w) for w in windows if w[2] > 0.0]
    return shapes.prism(outline, -p.CELL, 0.0, holes, crease=0.0)


def _walls(stage):
    top = p.CEILING + SINK
    inner = (p.NORTH + p.CELL - SINK, p.SOUTH - p.CELL + SINK)
    turned = lambda mesh, x: mesh.mapped(lambda q: (x + q[2], q[1], q[0]), flip=True)
    walls = [
        _wall(p.WEST, p.EAST, p.NORTH_WINDOWS, top).moved(z=p.NORTH + p.CELL),
        _wall(p.WEST, p.EAST, (p.SOUTH_WINDOW, p.SOUTH_DOOR), top).moved(z=p.SOUTH),
        turned(_wall(*inner, (), top), p.WEST + p.CELL),
        turned(_wall(*inner, (p.EAST_WINDOW,), top), p.EAST),
        turned(_wall(*inner, (p.PARTITION_DOOR,), top), p.PARTITION + p.CELL),
    ]
    stage.add("walls", [("plaster", walls)])
    outline = rectangle(p.WEST - 0.22, -p.SOUTH - 0.62, p.EAST + 0.30, 0.15 - p.NORTH)
    holes = [rectangle(a, -d, b, -c) for a, b, c, d in p.SKYLIGHTS]
    slab = shapes.prism(outline, p.CEILING, p.CEILING + p.CELL, holes, crease=0.0).along_y()
    stage.add("roof", [("roof", slab), ("frame", [bar for s in p.SKYLIGHTS for bar in _bars(*s)])])
    boards = [shapes.box((p.WEST + 0.03, -0.02, p.NORTH + 0.03),
        (p.EAST - 0.03, p.FLOOR - 0.035, p.SOUTH - 0.03))]
    width, x = 0.1245, p.WEST + 0.05
    while x + width < p.EAST - 0.04:
        boards.append(shapes.box((x, p.FLOOR - 0.045, p.NORTH + 0.05),
            (x + width - 0.003, p.FLOOR, p.SOUTH - 0.05)))
        x += width
    stage.add("floor", [("floor boards", boards)])


def _bars(x0, x1, z0, z1):
    """Kerb and glazing bars of a skylight; it has no panes."""
    y, bars = p.CEILING + p.CELL, []
    for low, high in (((x0 - 0.04, z0 - 0.04), (x1 + 0.04, z0)), ((x0 - 0.04, z1), (x1 + 0.04,
            z1 + 0.04)), ((x0 - 0.04, z0 - 0.01), (x0, z1 + 0.01)), ((x1, z0 - 0.01), (x1 + 0.04,
            z1 + 0.01))):
        bars.append(shapes.box((low[0], y - 0.01, low[1]), (high[0], y + 0.07, high[1])))
    count = round((x1 - x0) / 0.4)
    for i in range(1, count):
        x = x0 + (x1 - x0) * i / count
        bars.append(shapes.box((x - 0.009, y + 0.01, z0 - 0.01), (x + 0.009, y + 0.055,
            z1 + 0.01)))
    return bars


def _frame(width, height, bars, depth=0.05):
    """Window frame with upright bars, its lower left corner at the origin, about z = 0."""
    w, d = 0.045, depth / 2.0
    outer, inner = rectangle(-0.012, -0.012, width + 0.012, height + 0.012), []
    clear = (width - w * (2 + bars)) / (bars + 1)
    x = w
    for _ in range(bars + 1):
        inner.append(rectangle(x, w, x + clear, height - w))
        x += clear + w
    return shapes.prism(outer, -d, d, inner, crease=0.0)


def _slat(width, z, y, tilt):
    """A slat 50 mm broad and 1.2 mm thick, cambered, along x."""
    c, s = math.cos(math.radians(tilt)), math.sin(math.radians(tilt))
    top, under = [], []
    for i in range(5):
        u = -0.025 + 0.0125 * i
        camber = 0.004 * (1.0 - (u / 0.025) ** 2)
        for row, h in ((top, camber + 0.0006), (under, camber - 0.0006)):
            row.append((z + c * u - s * h, y + s * u + c * h))
    outline = top + under[::-1]
    return shapes.loft([[(x, b, a) for a, b in outline] for x in (0.0, width)], crease=30.0)


def _blind(width, height, drop, tilt):
    """Venetian blind that hangs down `drop` of the height: (slats, cords)."""
    slats = [shapes.box((0.0, height - 0.032, -0.028), (width, height + 0.004, 0.028))]
    y, low = height - 0.06, height * (1.0 - drop)
    while y > low:
        slats.append(_slat(width, 0.0, y, tilt))
        y -= 0.042
    slats.append(shapes.box((0.0, y - 0.004, -0.026), (width, y + 0.012, 0.026)))
    cords = []
    for x in (0.12, width - 0.12):
        for z in (-0.027, 0.027):
            cords.append(shapes.rod((x, y + 0.005, z), (x, height - 0.02, z), 0.0015, 5))
    cords.append(shapes.rod((width - 0.05, 0.25 * height, 0.034), (width - 0.05, height, 0.034),
        0.002, 5))
    return slats, cords


def _windows(stage):
    walls = (
        # windows, tilt of the slats and share that is let down, plane of the wall's outer face
        (p.NORTH_WINDOWS, ((32.0, 1.0), (-28.0, 0.96), (58.0, 0.62)), p.NORTH, 0.0),
        ((p.SOUTH_WINDOW,), ((24.0, 0.9),), p.SOUTH - p.CELL, 0.0),
        ((p.EAST_WINDOW,), ((40.0, 0.97),), p.EAST - p.CELL, -90.0),
    )
    for windows, blinds, plane, turn in walls:
        for (low, high, sill, head), (tilt, drop) in zip(windows, blinds):
            width, height = high - low, head - sill
            slats, cords = _blind(width - 0.10, height - 0.05, drop, tilt)
            inside = 0.085 if plane == p.NORTH else -0.01 if turn == 0.0 else 0.085
            move = lambda m: m.moved(0.05, 0.02, inside + 0.03 * (1 if inside > 0 else -1))
            pieces = [("frame", [_frame(width, height, 1).moved(z=p.CELL / 2)]),
                ("blind", [move(m) for m in slats]), ("white paint", [move(m) for m in cords])]
            if turn:
                stage.add("window", pieces, [(p.EAST, p.FLOOR + sill, low, turn)])
            else:
                stage.add("window", pieces, [(low, p.FLOOR + sill, plane, 0.0)])
    low, high, _, head = p.SOUTH_DOOR
    leaf = _leaf((high - low) / 3.0 + 0.02, head - 0.03)
    stage.add("sliding door", leaf, [(low - 0.02, p.FLOOR + 0.012, p.SOUTH + 0.035, 0.0),
        (low + 0.06, p.FLOOR + 0.012, p.SOUTH + 0.075, 0.0)])
    rails = [shapes.box((low - 0.25, p.FLOOR + head - 0.01, p.SOUTH - 0.01),
        (high + 0.25, p.FLOOR + head + 0.05, p.SOUTH + 0.11))]
    stage.add("door rail", [("frame", rails)])


def _leaf(width, height):
    """Sliding screen of thin bars with paper behind them."""
    bars = [_frame(width, height, 0, 0.028).moved(z=0.0)]
    for i in range(1, 4):
        x = width * i / 4
        bars.append(shapes.box((x - 0.006, 0.03, -0.009), (x + 0.006, height - 0.03, 0.009)))
    for i in range(1, 8):
        y = height * i / 8
        bars.append(shapes.box((0.03, y - 0.006, -0.007), (width - 0.03, y + 0.006, 0.007)))
    paper = Mesh()
    paper.quad((0.03, 0.03, -0.011), (width - 0.03, 0.03, -0.011),
        (width - 0.03, height - 0.03, -0.011), (0.03, height - 0.03, -0.011))
    return [("frame", bars), ("paper", paper)]


def _deck(stage):
    boards, z = [], p.SOUTH + 0.012
    while z + 0.11 < p.DECK_SOUTH:
        boards.append(shapes.box((p.WEST + 0.02, p.FLOOR - 0.030, z),
            (p.DECK_EAST, p.FLOOR - 0.004, z + 0.11)))
        z += 0.118
    joists = []
    for i in range(13):
        x = p.WEST + 0.08 + i * (p.DECK_EAST - p.WEST - 0.2) / 12
        joists.append(shapes.box((x, p.FLOOR - 0.16, p.SOUTH + 0.01), (x + 0.045, p.FLOOR - 0.028,
            z - 0.03)))
        for at in (p.SOUTH + 0.3, z - 0.2):
            joists.append(shapes.box((x - 0.02, -SINK, at), (x + 0.065, p.FLOOR - 0.15, at + 0.09)))
    step = []
    for k in range(3):
        step.append(shapes.box((-0.45, 0.11, z + 0.03 + 0.118 * k), (1.05, 0.136,
            z + 0.14 + 0.118 * k)))
    for x in (-0.38, 0.28, 0.93):
        step.append(shapes.box((x, -SINK, z + 0.05), (x + 0.045, 0.113, z + 0.35)))
    stage.add("deck", [("deck", boards + step), ("dark wood", joists)])


def _pergola(stage):
    """Slender posts and beams over the deck, under battens that stand on edge."""
    beam, posts, battens = p.CEILING - 0.16, [], []
    zs = (p.DECK_SOUTH - 0.16,)
    for x in (p.WEST + 0.14, -2.2, 0.15, p.DECK_EAST - 0.14):
        for z in zs:
            posts.append(shapes.box((x - 0.035, p.FLOOR - 0.02, z - 0.035),
                (x + 0.035, beam + 0.02, z + 0.035)))
    for z in zs:
        posts.append(shapes.box((p.WEST - 0.12, beam, z - 0.028), (p.DECK_EAST + 0.16,
            beam + 0.14, z + 0.028)))
    posts.append(shapes.box((p.WEST - 0.10, beam, p.SOUTH - 0.005), (p.DECK_EAST + 0.14,
        beam + 0.13, p.SOUTH + 0.045)))
    x = p.WEST - 0.06
    while x < p.DECK_EAST + 0.12:
        battens.append(shapes.box((x, beam + 0.125, p.SOUTH + 0.64), (x + 0.018, beam + 0.205,
            p.DECK_SOUTH + 0.16)))
        x += 0.115
    for x in (p.EAST + 0.36, p.DECK_EAST + 0.1):
        battens.append(shapes.box((x, beam + 0.115, p.SOUTH - 0.1), (x + 0.04, beam + 0.19,
            p.SOUTH + 0.66)))
    stage.add("pergola", [("cedar", posts + battens)])
