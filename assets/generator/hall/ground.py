# SPDX-License-Identifier: MIT
"""Floor, arcades on columns, and the aisles' ceilings."""

from .. import polygon, shapes
from . import parts
from .plan import (
    AISLE, AISLE_MIDDLE, ARCADE_HALF, AXES, BAY, CEILING, EAST_IN, EAST_OUT, GALLERY, LANDING_EDGE,
    MIDDLES, SPRING, WALL_IN, WALL_OUT, inward, outward,
)

RADIUS = 1.08  # of the arches
JOINT = 0.01  # half the width


def add_to(plan):
    floor(plan)
    arcades(plan)
    ceilings(plan)


def floor(plan):
    x, z = EAST_OUT + 0.15, WALL_OUT + 0.15
    slab = shapes.box((-x, -0.4, -z), (x, -0.015, z))
    plan.add("floor slab", [(plan.joint, slab)])
    nave_floor(plan)
    aisle_floor(plan)
    sills = [tile(EAST_IN, z - half, EAST_OUT + 0.1, z + half) for z, half in
             ((0.0, 1.8), (AISLE_MIDDLE, 0.9), (-AISLE_MIDDLE, 0.9))]
    plan.add("portal floor", [(plan.light_tile, sills)])


def tile(x0, z0, x1, z1):
    low, high = (x0 + JOINT, -0.04, z0 + JOINT), (x1 - JOINT, 0.0, z1 - JOINT)
    return shapes.chamfered(low, high, 0.006)


def nave_floor(plan):
    """Light and dark tiles by turns between two red bands; one mesh per bay."""
    light, dark, red = [], [], []
    half, rows, columns = AISLE - 0.70, 11, 4
    size, length = 2.0 * half / rows, BAY / columns
    for i in range(columns):
        for k in range(rows):
            x, z = -BAY / 2.0 + i * length, -half + k * size
            (light if (i + k) % 2 else dark).append(tile(x, z, x + length, z + size))
    for side in (half, -half - 0.24):
        red.append(tile(-BAY / 2.0, side, BAY / 2.0, side + 0.24))
    pieces = [(plan.light_tile, light), (plan.dark_tile, dark), (plan.red_tile, red)]
    plan.add("nave floor", pieces, [(x, 0.0, 0.0, 0.0) for x in MIDDLES])


def aisle_floor(plan):
    """Tiles with their corners cut off, and small red squares set where four of them meet."""
    light, red = [], []
    z0, z1, rows, columns, cut = AISLE - 0.44, WALL_IN - 0.04, 3, 3, 0.13
    wide, deep = BAY / columns, (z1 - z0) / rows
    for i in range(columns):
        for k in range(rows):
            x, z = -BAY / 2.0 + i * wide, z0 + k * deep
            outline = []
            for sx, sz in ((0, 0), (1, 0), (1, 1), (0, 1)):
                cx, cz = x + JOINT + sx * (wide - 2 * JOINT), z + JOINT + sz * (deep - 2 * JOINT)
                pair = [(cx, cz + (1 - 2 * sz) * cut), (cx + (1 - 2 * sx) * cut, cz)]
                outline += pair if sx == sz else pair[::-1]
            light.append(shapes.prism([(a, -b) for a, b in outline], -0.04, 0.0).along_y())
            if k > 0:
                d = cut - JOINT
                square = [(x - d, -z), (x, -z - d), (x + d, -z), (x, -z + d)]
                red.append(shapes.prism(square, -0.045, 0.004).along_y())
    pieces = [(plan.light_tile, light), (plan.red_tile, red)]
    plan.add("aisle floor", pieces, outward(MIDDLES, 0.0, 0.0))


def arcades(plan):
    body, capital = parts.lower_column(SPRING)
    plan.add("column", [(plan.marble, body), (plan.gilt, capital)], outward(AXES, 0.0, AISLE))

    half, low, high = BAY / 2.0, SPRING - 0.01, 4.45
    outline = [(-half, low), (-RADIUS, low)]
    outline += polygon.arc(0.0, SPRING, RADIUS, RADIUS, 180.0, 0.0, 24)
    outline += [(RADIUS, low), (half, low), (half, high), (-half, high)]
    # Neighbours meet at open ends; the arcade's own ends run on into the walls, and close there.
    spandrel = shapes.prism(outline, -ARCADE_HALF, ARCADE_HALF).without(0, half).without(0, -half)
    band = parts.archivolt(0.0, SPRING, RADIUS, ARCADE_HALF)
    key = parts.keystone(SPRING, RADIUS, -ARCADE_HALF - 0.12, ARCADE_HALF + 0.12)
    pieces = [(plan.wall, spandrel), (plan.trim, [band, band.turned_y(180.0), key])]
    plan.add("arch", pieces, outward(MIDDLES, 0.0, AISLE))
    ends = []
    for x, beyond in ((AXES[0], -0.19), (AXES[-1], 0.19)):
        end = polygon.rectangle(min(x, x + beyond), low, max(x, x + beyond), high)
        end = shapes.prism(end, AISLE - ARCADE_HALF, AISLE + ARCADE_HALF)
        ends.append(end.without(0, round(x, 5)))
    plan.add_mirrored("arcade ends", [(plan.wall, ends)])

    face = AISLE - ARCADE_HALF
    plan.add("roundel", [(plan.marble, parts.roundel())], inward(AXES[1:-1], 3.72, face))
    run = shapes.straight_path((LANDING_EDGE - 0.03, 4.335, 0.0), (9.62, 4.335, 0.0))
    cornice = shapes.moulding(parts.CORNICE_PROFILE, run, crease=25.0)
    plan.add_mirrored("cornice", [(plan.trim, [cornice.scaled(1, 1, -1).moved(z=face)])])
    teeth = parts.dentils(BAY, 0.2, 0.11, 0.10, 0.16)
    plan.add("dentils", [(plan.trim, teeth)], inward(MIDDLES, 4.45, face))


def ceilings(plan):
    ends = (LANDING_EDGE - 0.03, 9.73)
    slab = shapes.box((ends[0], CEILING, AISLE - 0.24), (ends[1], GALLERY, WALL_IN + 0.1))
    plan.add_mirrored("gallery floor", [(plan.stair, [slab])])
    half, deep = BAY / 2.0 - 0.2, (WALL_IN - AISLE) / 2.0 - 0.2
    lattice = parts.coffers(-half, -deep, half, deep, 3, 3, CEILING)
    back = shapes.box((-half, CEILING - 0.015, -deep), (half, CEILING + 0.02, deep))
    pieces = [(plan.trim, lattice), (plan.coffer, back)]
    plan.add("coffers", pieces, outward(MIDDLES, 0.0, AISLE_MIDDLE))
    beam = shapes.box((-0.21, 3.86, -1.35), (0.21, CEILING + 0.04, 1.47))
    profile = [(1.44, 3.9), (0.95, 3.9), (1.12, 3.55), (1.44, 3.3)]
    corbel = shapes.prism([(-z, y) for z, y in profile], -0.16, 0.16).along_x()
    plan.add("aisle beam", [(plan.trim, [beam, corbel])], outward(AXES, 0.0, AISLE_MIDDLE))
