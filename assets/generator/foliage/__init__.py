# SPDX-License-Identifier: MIT
"""A walled garden whose leaves, grass and flowers are alpha masks on cards."""

import random

from .. import textures
from ..stage import Stage
from . import garden, paintings, plants

MATERIALS = {
    "soil": (0.16, 0.10, 0.06),
    "lawn": (0.12, 0.19, 0.045),
    "flagstone": (0.47, 0.44, 0.39),
    "brick": (0.42, 0.17, 0.10),
    "mortar": (0.52, 0.46, 0.38),
    "stone": (0.60, 0.56, 0.48),
    "water": (0.06, 0.14, 0.18),
    "terracotta": (0.56, 0.24, 0.12),
    "green paint": (0.06, 0.20, 0.14),
    "white paint": (0.76, 0.74, 0.68),
    "iron": (0.05, 0.05, 0.05),
    "bark": (0.17, 0.11, 0.07),
    "birch bark": (0.58, 0.55, 0.49),
}
# Leaves: the picture, and a factor on its colours.
LEAVES = {
    "apple leaves": ("twig", (0.92, 0.95, 0.80)),
    "birch leaves": ("twig", (1.0, 1.0, 0.62)),
    "laurel leaves": ("twig", (0.62, 0.86, 0.68)),
    "copper leaves": ("copper twig", (1.0, 0.85, 0.85)),
    "ivy": ("ivy", (1.0, 1.0, 1.0)),
    "grass": ("grass", (1.0, 1.0, 1.0)),
    "daisies": ("daisies", (1.0, 1.0, 1.0)),
    "fern": ("frond", (0.90, 1.0, 0.75)),
}

SHRUBS = (  # leaves, x, z, width, height
    ("laurel leaves", -4.45, -2.9, 0.6, 1.1),
    ("copper leaves", -3.2, -3.25, 0.45, 0.75),
    ("laurel leaves", -0.75, -3.2, 0.5, 0.85),
    ("copper leaves", 3.45, -3.15, 0.5, 0.8),
    ("laurel leaves", 4.6, -3.0, 0.5, 1.2),
    ("laurel leaves", 4.7, -0.6, 0.4, 0.6),
    ("laurel leaves", 4.7, 0.3, 0.4, 0.6),
    ("laurel leaves", 4.7, 1.2, 0.4, 0.6),
    ("laurel leaves", 4.7, 2.1, 0.4, 0.6),
    ("copper leaves", -4.6, -1.1, 0.5, 0.8),
    ("laurel leaves", -4.75, -0.2, 0.4, 1.0),
    ("laurel leaves", -4.75, 0.7, 0.4, 0.95),
    ("laurel leaves", -4.75, 1.6, 0.4, 1.05),
    ("copper leaves", -4.7, 2.5, 0.5, 0.8),
    ("laurel leaves", -4.7, 3.4, 0.4, 0.9),
)
IVY = (  # x, up to which height
    (-4.45, 1.5), (-3.75, 0.9), (-2.95, 1.7), (-2.3, 2.3),
    (-1.5, 0.7), (-0.25, 2.2), (0.35, 1.7), (2.85, 0.9), (4.55, 2.0),
)


def build():
    stage = Stage("foliage", MATERIALS)
    doc = stage.doc
    pictures = {}
    for name, (paint, ramp) in paintings.ALL.items():
        painting = paint()
        painting.spread()
        pictures[name] = textures.add_texture(doc, name, painting.to_png(ramp))
    for name, (picture, color) in LEAVES.items():
        stage.materials[name] = doc.add_material(name, color, double_sided=True,
            mask=pictures[picture])
    doc.add_camera("garden", (3.55, 1.72, 4.05), (-0.85, 1.42, -1.6), 54.0)
    doc.add_camera("ivy", (-4.50, 1.62, -2.10), (1.1, 1.25, -3.75), 54.0)
    doc.add_camera("border", (0.55, 0.46, 3.35), (-2.2, 0.75, -0.9), 58.0)
    garden.add_to(stage)
    _trees(stage)
    _shrubs(stage)
    _ground(stage)
    return doc


def _put(stage, name, mesh, x, y, z, turn, size=1.0):
    scale = {} if size == 1.0 else {"scale": [round(size, 3)] * 3}
    stage.doc.add_node(name, mesh, (x, y, z), turn, **scale)


def _trees(stage):
    chance = random.Random(21)
    for name, at, tree, bark, leaves, count, size in (
        ("apple tree", (-2.35, 0.0, -0.75), plants.Tree(5, 4.3, 1.75, 0.155), "bark",
            "apple leaves", 30, 1.0),
        ("birch", (4.0, 0.0, -1.9), plants.Tree(9, 3.9, 1.15, 0.085), "birch bark", "birch leaves",
            24, 0.72),
    ):
        stage.add(name, [(bark, tree.wood)], [at])
        clump = [stage.mesh(leaves, [(leaves, plants.clump(seed, count, 0.46, 0.34))]) for seed in
            (31, 32)]
        for i, p in enumerate(tree.clumps):
            _put(stage, leaves, clump[i % 2], at[0] + p[0], at[1] + p[1], at[2] + p[2], 360.0
                * chance.random(), size * (0.8 + 0.4 * chance.random()))


def _shrubs(stage):
    chance = random.Random(22)
    meshes = {name: stage.mesh(name, [(name, plants.clump(seed, 44, 0.46, 0.30, -0.2))]) for name,
        seed in (("laurel leaves", 41), ("copper leaves", 42))}
    for name, x, z, wide, tall in SHRUBS:
        for k in range(5):
            y = 0.10 + (tall - 0.10) * k / 4.0
            r = wide * (1.0 - 0.55 * k / 4.0)
            _put(stage, name, meshes[name], x + r * (chance.random() - 0.5), y, z + r
                * (chance.random() - 0.5), 360.0 * chance.random(), 0.8 + 0.35 * chance.random())
    ivy = [stage.mesh("ivy", [("ivy", plants.ivy_patch(seed))]) for seed in (51, 52)]
    spots = []
    for x, top in IVY:
        y = 0.35
        while y < top:
            spots.append((x + 0.3 * (chance.random() - 0.5), y))
            y += 0.55
    spots += [(0.45, 2.30), (0.95, 2.55), (1.5, 2.66), (-0.9, 2.35), (2.15, 2.5), (-4.6, 2.2)]
    for i, (x, y) in enumerate(spots):
        _put(stage, "ivy", ivy[i % 2], x, y, garden.WALL + (0.02 if y < 2.2 else 0.05), 0.0, 0.8
            + 0.4 * chance.random())
    fern = stage.mesh("fern", [("fern", plants.fern(61))])
    for x, y, z, size in ((garden.GATE - 1.05, 0.31, -3.25, 0.85), (garden.GATE + 1.05, 0.31, -3.25,
            0.85), (4.35, 0.31, 2.9, 0.9), (-1.5, 0.0, -3.1, 1.0), (-2.45, 0.0, -3.0, 0.85),
            (-3.9, 0.0, -2.15, 1.0), (-3.75, 0.0, 3.1, 1.0), (2.75, 0.0, -2.95, 0.8), (-2.75, 0.0,
            -0.75, 0.7)):
        _put(stage, "fern", fern, x, y, z, 360.0 * chance.random(), size)


def _ground(stage):
    chance = random.Random(23)
    grass = [stage.mesh("grass", [("grass", plants.tufts(seed, 16, 0.5, 0.20))]) for seed in (71,
        72)]
    flowers = stage.mesh("daisies", [("daisies", plants.tufts(73, 7, 0.34, 0.34))])
    for i in range(46):
        x, z = 9.6 * chance.random() - 4.8, 6.4 * chance.random() - 2.7
        if abs(x - garden.path_x(z)) > 0.75:
            _put(stage, "grass", grass[i % 2], x, 0.01, z, 360.0 * chance.random(), 0.8 + 0.5
                * chance.random())
    for k in range(15):  # along both sides of the path
        z = -2.7 + 0.46 * k
        side = -1 if k % 2 else 1
        _put(stage, "grass", grass[k % 2], garden.path_x(z) + side * (0.72 + 0.1
            * chance.random()), 0.0, z, 360.0 * chance.random(), 0.62)
    for x, z in ((-1.25, 2.3), (-1.9, 1.7), (-0.6, 1.5), (-3.6, 1.9), (-4.2, 0.3), (-4.3, -0.9),
            (-4.25, -1.8), (-0.2, -2.55), (-1.0, -2.5), (3.3, -2.4), (3.9, 0.9), (4.0, 1.9), (3.4,
            2.5), (2.3, -2.6), (1.7, 2.6), (2.3, 1.1), (-2.9, 2.9), (-0.9, 3.2)):
        _put(stage, "daisies", flowers, x, 0.0, z, 360.0 * chance.random(), 0.8 + 0.4
            * chance.random())
