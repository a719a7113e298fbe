# SPDX-License-Identifier: MIT
"""Picket fence along the garden's front with a gate, wire fence along its side."""

import math

from .. import shapes
from . import plan as p

GATE = (-0.42, 0.92)  # x
EDGE = p.LENGTH / 2.0 - 0.06


def add_to(stage):
    bay = (GATE[0] + EDGE - 0.05) / 3.0
    west = [(-EDGE + bay * k, 0.0, p.FENCE, 0.0) for k in range(3)]
    stage.add("pickets", _pickets(bay), west)
    bay = (EDGE - GATE[1] - 0.05) / 3.0
    east = [(GATE[1] + 0.05 + bay * k, 0.0, p.FENCE, 0.0) for k in range(3)]
    stage.add("pickets", _pickets(bay), east)
    posts = [(x, 0.0, p.FENCE - 0.045) for x in (GATE[0] - 0.03, GATE[1] + 0.03, EDGE - 0.02)]
    posts += [place[:2] + (p.FENCE - 0.045,) for place in west + east[1:]]
    stage.add("post", [("white paint", _post())], posts)
    gate = _gate(GATE[1] - GATE[0] - 0.05)
    stage.add("gate", gate, [(GATE[0] + 0.01, 0.0, p.FENCE - 0.03, 62.0)])

    length = (p.FENCE - 0.22 - p.BACK - 0.08) / 4.0
    wire = [(EDGE, 0.0, p.FENCE - 0.22 - length * k, 90.0) for k in range(4)]
    stage.add("wire fence", _wire(length, 1.15), wire)
    stage.add("wire fence post", [("steel", _pole(1.28))], [(EDGE, 0.0, place[2]) for place in wire]
        + [(EDGE, 0.0, p.FENCE - 0.22 - 4 * length)])


def _picket(height, width=0.062, thick=0.016):
    """Pointed board in the plane z = 0, centred on x = 0."""
    h = width / 2.0
    outline = [(-h, 0.05), (h, 0.05), (h, height - 0.07), (0.6 * h, height - 0.035),
        (0.0, height), (-0.6 * h, height - 0.035), (-h, height - 0.07)]
    return shapes.prism(outline, 0.0, thick, crease=0.0)


def _pickets(length):
    """A bay whose pickets' tops follow a shallow hollow; two rails behind."""
    count = int(length / 0.108)
    boards = []
    for i in range(count):
        u = (i + 0.5) / count
        boards.append(_picket(1.02 - 0.10 * math.sin(math.pi * u)).moved(u * length))
    for y in (0.24, 0.74):
        boards.append(shapes.box((-0.01, y, -0.027), (length + 0.01, y + 0.065, 0.002)))
    return [("white paint", boards)]


def _post():
    cap = [(0.0, 1.10), (0.062, 1.10), (0.062, 1.125), (0.0, 1.17)]
    return [shapes.box((-0.04, -0.02, -0.04), (0.04, 1.11, 0.04)),
        shapes.lathe(cap, 4, crease=0.0).turned_y(45.0)]


def _gate(width):
    boards, count = [], int(width / 0.108)
    for i in range(count):
        u = (i + 0.5) / count
        boards.append(_picket(0.92 + 0.14 * math.sin(math.pi * u)).moved(u * width))
    for y in (0.22, 0.72):
        boards.append(shapes.box((0.0, y, -0.024), (width, y + 0.06, 0.002)))
    boards.append(shapes.bar((0.05, 0.27, -0.010), (width - 0.05, 0.74, -0.010), 0.018, 0.055))
    return [("white paint", boards)]


def _wire(length, height):
    """Wire of 3 mm woven to squares that stand on their corners, 70 mm apart; along x."""
    wires, pitch, z = [], 0.099, 0.0016
    k = -int(length / pitch)
    while k * pitch < height:
        c = k * pitch  # the wire is y = x + c, cut off by the bay's edges
        x0, x1 = max(0.0, -c), min(length, height - c)
        for side, edge, way in ((z, 0.0, 1.0), (-z, length, -1.0)):
            wires.append(shapes.rod((edge + way * x0, x0 + c + 0.04, side),
                (edge + way * x1, x1 + c + 0.04, side), 0.0015, 5))
        k += 1
    for y in (0.04, 0.04 + height):
        wires.append(shapes.rod((0.0, y, 0.0), (length, y, 0.0), 0.0025, 6))
    return [("steel", wires)]


def _pole(height):
    return [shapes.cord([(0.0, -0.02, 0.0), (0.0, height, 0.0)], [0.021, 0.021], 10),
        shapes.sphere(0.026, 12, 6, (0.0, height, 0.0))]
