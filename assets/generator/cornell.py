# SPDX-License-Identifier: MIT
"""A Cornell box with a partition that is thinner than a cell of the usual grids."""

from . import shapes
from .gltf import Document
from .mesh import Mesh

HALF = 1.0  # the room is 2 m wide, high and deep
WALL = 0.06
PARTITION = 0.005  # a cell is about 17 mm at 128 cells along the longest side


def build():
    doc = Document("cornell")
    white = doc.add_material("white", (0.73, 0.72, 0.70))
    red = doc.add_material("red", (0.60, 0.06, 0.05))
    green = doc.add_material("green", (0.11, 0.42, 0.10))
    blue = doc.add_material("blue", (0.12, 0.22, 0.52))
    ochre = doc.add_material("ochre", (0.66, 0.44, 0.13))
    light = doc.add_material("light", (0.80, 0.80, 0.80), emissive=(1.0, 0.93, 0.80))

    doc.add_camera("front", (0.0, 1.0, 3.45), (0.0, 1.0, 0.0), 46.0)
    doc.add_camera("corner", (-0.78, 1.30, 1.02), (0.22, 0.56, -0.40), 64.0)
    doc.add_camera("partition", (0.92, 1.62, -0.30), (0.26, 0.28, -0.52), 66.0)

    room, left, right = _room()
    doc.add_node("room", doc.add_mesh("room", [(white, room), (red, left), (green, right)]))
    lamp = shapes.box((-0.3, -0.02, -0.3), (0.3, 0.02, 0.3))
    doc.add_node("lamp", doc.add_mesh("lamp", [(light, lamp)]), at=(0.0, 2.0, 0.0))
    # Solids are sunk into the floor a little, so that no two faces lie in one plane.
    tall = _tessellated_box((-0.29, -0.02, -0.29), (0.29, 1.2, 0.29), 6)
    doc.add_node("tall box", doc.add_mesh("tall box", [(white, tall)]), (-0.42, 0, -0.30), 17.0)
    ball = shapes.sphere(0.29, 64, 32)
    doc.add_node("ball", doc.add_mesh("ball", [(blue, ball)]), at=(0.30, 0.285, 0.38))
    half = PARTITION / 2.0
    sheet = _tessellated_box((-0.42, -0.02, -half), (0.42, 0.80, half), 8)
    partition = doc.add_mesh("partition", [(ochre, sheet)])
    doc.add_node("partition", partition, at=(0.42, 0.0, -0.34), turn=-9.0)
    return doc


def _steps(low, high, count):
    return [low + (high - low) * i / count for i in range(count + 1)]


def _sheet(corner, side, up, count):
    """A square of count x count quads; faces side x up."""
    mesh = Mesh()
    rows = []
    for j in range(count + 1):
        row = []
        for i in range(count + 1):
            s, t = i / count, j / count
            row.append(tuple(c + a * s + b * t for c, a, b in zip(corner, side, up)))
        rows.append(row)
    mesh.grid(rows)
    return mesh


def _tessellated_box(low, high, count):
    (x0, y0, z0), (x1, y1, z1) = low, high
    dx, dy, dz = x1 - x0, y1 - y0, z1 - z0
    mesh = Mesh()
    for corner, side, up in (
        ((x0, y0, z1), (dx, 0, 0), (0, dy, 0)),
        ((x1, y0, z0), (-dx, 0, 0), (0, dy, 0)),
        ((x1, y0, z1), (0, 0, -dz), (0, dy, 0)),
        ((x0, y0, z0), (0, 0, dz), (0, dy, 0)),
        ((x0, y1, z1), (dx, 0, 0), (0, 0, -dz)),
        ((x0, y0, z0), (dx, 0, 0), (0, 0, dz)),
    ):
        mesh.extend(_sheet(corner, side, up, count))
    return mesh


def _room(count=16):
    """Inside, outside and front rim of the room as one closed skin: (white, left, right)."""
    i, o = HALF, HALF + WALL
    low, high, back = 0.0, 2.0 * HALF, -HALF - WALL
    white, left, right = Mesh(), Mesh(), Mesh()
    d = 2.0 * HALF
    left.extend(_sheet((-i, low, i), (0, 0, -d), (0, d, 0), count))
    right.extend(_sheet((i, low, -i), (0, 0, d), (0, d, 0), count))
    white.extend(_sheet((-i, low, -i), (d, 0, 0), (0, d, 0), count))
    white.extend(_sheet((-i, low, i), (d, 0, 0), (0, 0, -d), count))
    white.extend(_sheet((-i, high, -i), (d, 0, 0), (0, 0, d), count))

    inner = _frame(i, low, high, count)
    outer = _frame(o, low - WALL, high + WALL, count)
    ring = len(inner)
    for k in range(ring):
        n = (k + 1) % ring
        a, b = inner[k], inner[n]
        c, e = outer[n], outer[k]
        white.quad((*a, i), (*e, i), (*c, i), (*b, i))
        for z0, z1 in zip(_steps(back, i, count), _steps(back, i, count)[1:]):
            white.quad((*e, z0), (*c, z0), (*c, z1), (*e, z1))
    width, height = 2.0 * o, high - low + 2.0 * WALL
    white.extend(_sheet((o, low - WALL, back), (-width, 0, 0), (0, height, 0), count))
    return white, left, right


def _frame(half, low, high, count):
    """Points around a square in x, y, counter-clockwise."""
    along, up = _steps(-half, half, count), _steps(low, high, count)
    points = [(x, low) for x in along[:-1]] + [(half, y) for y in up[:-1]]
    points += [(x, high) for x in along[:0:-1]] + [(-half, y) for y in up[:0:-1]]
    return points
