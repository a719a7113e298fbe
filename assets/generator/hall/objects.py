# SPDX-License-Identifier: MIT
"""Things that stand in the hall: vases, spheres, figures. All stand on y = 0, sizes in metres."""

import math

from .. import shapes
from .parts import half_round, plinth


def pedestal(width, height):
    """Square pedestal with foot and top slab."""
    w = width
    return [
        plinth(w, 0.10),
        shapes.block(0.8 * w, height - 0.12, 0.8 * w, y=0.06),
        shapes.chamfered((-0.48 * w, height - 0.09, -0.48 * w), (0.48 * w, height, 0.48 * w), 0.02),
    ]


def amphora():
    """Slender vase, 1.05 m, with two handles."""
    profile = [(0.0, -0.02), (0.16, -0.02), (0.16, 0.03), (0.10, 0.06), (0.075, 0.10),
        (0.12, 0.17), (0.20, 0.30)]
    profile += [(0.265, 0.45), (0.285, 0.57), (0.27, 0.68), (0.21, 0.77), (0.13, 0.83),
        (0.095, 0.89)]
    profile += [(0.09, 0.95), (0.115, 1.0), (0.15, 1.03), (0.15, 1.05), (0.11, 1.05), (0.07, 0.99),
        (0.0, 0.97)]
    meshes = [shapes.lathe(profile, 28, crease=50.0)]
    for side in (1.0, -1.0):
        path = []
        for i in range(11):
            t = i / 10.0
            path.append((side * (0.08 + 0.20 * math.sin(math.pi * t) ** 0.8 + 0.15 * (1.0 - t)),
                0.72 + 0.25 * t, 0.0))
        meshes.append(shapes.tube(path, [0.022] * 11, 8))
    return meshes


def urn():
    """Broad urn with a ribbed body and a lid, 0.95 m."""
    profile = [(0.17, -0.02), (0.17, 0.03), (0.12, 0.05), (0.07, 0.10), (0.07, 0.15), (0.14, 0.19)]
    body = [(0.20, 0.23), (0.28, 0.31), (0.325, 0.42), (0.33, 0.50)]
    neck = [(0.33, 0.52), (0.26, 0.57), (0.24, 0.62), (0.29, 0.67), (0.29, 0.69), (0.22, 0.73),
        (0.11, 0.80), (0.04, 0.83)]
    rings = [shapes.ring_y(r, y, 36) for r, y in profile]
    for r, y in body:
        ring = []
        for i, (x, _, z) in enumerate(shapes.ring_y(1.0, y, 36)):
            ribbed = r * (1.0 + (0.045 if i % 4 in (1, 2) else -0.02))
            ring.append((x * ribbed, y, z * ribbed))
        rings.append(ring)
    rings += [shapes.ring_y(r, y, 36) for r, y in neck]
    return [shapes.loft(rings, crease=42.0), shapes.sphere(0.06, 16, 8, (0.0, 0.87, 0.0))]


def sphere_on_stand():
    """Ball of 0.6 m on a small turned stand."""
    stand = [(0.0, -0.02), (0.22, -0.02), *half_round(0.20, 0.0, 0.08), (0.13, 0.10), (0.12, 0.16),
        (0.19, 0.22), (0.0, 0.22)]
    return [shapes.lathe(stand, 24), shapes.sphere(0.30, 32, 16, (0.0, 0.48, 0.0))]


def finial(radius):
    """Ball on a neck."""
    r = radius
    profile = [(0.0, -0.02), (0.75 * r, -0.02), (0.75 * r, 0.12 * r), (0.45 * r, 0.25 * r),
        (0.42 * r, 0.5 * r)]
    for i in range(1, 10):
        t = math.pi * (i / 10.0 - 0.5)
        if t > -1.15:
            profile.append((r * math.cos(t), 0.5 * r + 0.9 * r + r * math.sin(t)))
    profile.append((0.0, 2.4 * r))
    return shapes.lathe(profile, 16)


def figure(arms):
    """Draped standing figure, about 1.7 m; `arms`: 'raised', 'folded' or 'bowl'."""
    # height, half width, half depth, depth of the folds, lean to the front
    sections = (
        (-0.02, 0.27, 0.24, 0.030, 0.0), (0.05, 0.26, 0.23, 0.030, 0.0), (0.35, 0.23, 0.20, 0.026,
            0.0),
        (0.70, 0.205, 0.17, 0.018, 0.01), (0.92, 0.185, 0.145, 0.010, 0.01), (1.05, 0.155, 0.115,
            0.006, 0.0),
        (1.18, 0.175, 0.125, 0.004, 0.01), (1.30, 0.205, 0.125, 0.0, 0.01), (1.38, 0.20, 0.10, 0.0,
            0.0),
        (1.43, 0.12, 0.08, 0.0, 0.0), (1.46, 0.062, 0.062, 0.0, 0.01), (1.54, 0.055, 0.055, 0.0,
            0.02),
    )
    rings = []
    for y, width, depth, fold, lean in sections:
        ring = []
        for i in range(44):
            a = 2.0 * math.pi * i / 44
            wave = fold * (math.cos(11.0 * a) + 0.5 * math.cos(4.0 * a + 1.0))
            ring.append(((width + wave) * math.cos(a), y, lean - (depth + wave) * math.sin(a)))
        rings.append(ring)
    meshes = [shapes.loft(rings, crease=60.0)]
    head = shapes.sphere(1.0, 20, 12).scaled(0.098, 0.132, 0.112).moved(0.0, 1.63, 0.03)
    hair = shapes.sphere(1.0, 20, 12).scaled(0.112, 0.118, 0.118).moved(0.0, 1.665, -0.005)
    meshes += [head, hair, shapes.sphere(0.05, 12, 8, (0.0, 1.69, -0.13))]
    right = [(0.19, 1.335, 0.0), (0.25, 1.18, 0.02), (0.27, 1.02, 0.08), (0.20, 0.96, 0.20),
        (0.10, 0.98, 0.25)]
    left = [(-x, y, z) for x, y, z in right]
    if arms == "raised":
        right = [(0.18, 1.34, 0.0), (0.30, 1.36, 0.02), (0.39, 1.50, 0.05), (0.41, 1.70, 0.06),
            (0.40, 1.84, 0.05)]
        meshes.append(shapes.sphere(0.095, 20, 10, (0.40, 1.95, 0.05)))
    elif arms == "bowl":
        bowl = [(0.0, 0.93), (0.07, 0.93), (0.15, 0.99), (0.19, 1.07), (0.17, 1.07), (0.12, 1.02),
            (0.0, 1.0)]
        meshes.append(shapes.lathe(bowl, 24).moved(0.0, 0.0, 0.27))
    for arm in (right, left):
        meshes.append(shapes.tube(arm, [0.062, 0.056, 0.05, 0.042, 0.036], 10))
    return meshes
