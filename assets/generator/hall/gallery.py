# SPDX-License-Identifier: MIT
"""The upper storey: columns and balustrades, beams, rafters, and the ribs over the open nave."""

from .. import polygon, shapes
from . import objects, parts
from .plan import (
    AISLE, AISLE_MIDDLE, AXES, BAY, BEAM, CORNER, EAST_OUT, GALLERY, MIDDLES, WALL_IN, WEST_IN,
    inward, outward, spread,
)
from .stairs import HEAD

CURB, HEIGHT = 0.14, 0.62  # tops of curb and balusters


def add_to(plan):
    pedestal = [m.moved(y=GALLERY) for m in objects.pedestal(0.56, 1.0)]
    column = parts.upper_column(GALLERY + 1.0, BEAM)
    pieces = [(plan.marble, column), (plan.trim, pedestal)]
    plan.add("gallery column", pieces, outward([*AXES, CORNER], 0.0, AISLE))
    balustrades(plan)
    beams(plan)
    ribs(plan)


def balustrades(plan):
    """Curb and rail are one mesh for each length; all balusters are instances of one more."""
    stub0, stub1 = AISLE + 0.22, HEAD + 0.06  # beside the stairs
    corner0, corner1 = AISLE + 0.22, WALL_IN + 0.02  # in front, between column and wall
    sides = (1, -1)
    runs = (
        # name, length, balusters, places of the middle
        ("gallery rail", BAY - 0.44, 7, outward(MIDDLES, GALLERY, AISLE)),
        ("bridge rail", 2 * AISLE - 0.44, 26, [(x, GALLERY, 0.0, 90.0)
            for x in (AXES[-1], CORNER)]),
        ("corner rail", corner1 - corner0, 7, [(CORNER, GALLERY, s * (corner0 + corner1) / 2.0,
            90.0) for s in sides]),
        ("stair rail", stub1 - stub0, 5, [(AXES[0] + 0.02, GALLERY, s * (stub0 + stub1) / 2.0,
            90.0) for s in sides]),
    )
    posts = []
    for name, length, count, places in runs:
        half = length / 2.0
        curb = parts.rail(parts.CURB_PROFILE, (-half, 0.0, 0.0), (half, 0.0, 0.0))
        top = parts.rail(parts.RAIL_PROFILE, (-half, CURB + HEIGHT, 0.0),
            (half, CURB + HEIGHT, 0.0))
        plan.add(name, [(plan.trim, [curb, top])], places)
        for x, y, z, turn in places:
            for d in spread(length - 0.16, count):
                along = (x, z + d) if turn == 90.0 else (x + d, z)
                posts.append((along[0], y + CURB, along[1], 0.0))
    plan.add("baluster", [(plan.trim, parts.baluster(HEIGHT))], posts)


def beams(plan):
    x0, x1, face = WEST_IN - 0.05, EAST_OUT + 0.02, 0.24
    beam = shapes.box((x0, BEAM, -face), (x1, BEAM + 0.62, face))
    fillet = shapes.box((x0 + 0.01, BEAM + 0.22, -0.27), (x1 + 0.01, BEAM + 0.28, 0.27))
    run = shapes.straight_path((x0 - 0.01, BEAM + 0.5, face), (x1 + 0.02, BEAM + 0.5, face))
    crown = shapes.moulding(parts.CORNICE_PROFILE, run, crease=25.0).scaled(1, 1, -1)
    plan.add_mirrored("gallery beam", [(plan.trim, [m.moved(z=AISLE)
        for m in (beam, fillet, crown)])])
    teeth = parts.dentils(BAY, 0.2, 0.10, 0.10, 0.13)
    plan.add("beam dentils", [(plan.trim, teeth)], inward(MIDDLES, BEAM + 0.54, AISLE - face))

    # From the beam to the wall, open to the sky.
    reach = (WALL_IN - AISLE) / 2.0
    rafter = shapes.box((-0.11, BEAM + 0.36, -reach - 0.05), (0.11, BEAM + 0.64, reach + 0.12))
    xs = [AXES[0] + BAY / 2.0 * k for k in range(-1, 14)]
    plan.add("rafter", [(plan.wood, rafter)], outward(xs, 0.0, AISLE_MIDDLE))


def ribs(plan):
    foot = BEAM + 0.80
    inner, outer, rise = AISLE - 0.20, AISLE + 0.20, 2.10

    def curve(inset, drop):
        return polygon.arc(0.0, foot - drop, inner + inset, rise + inset, 180.0, 0.0, 40)

    rib = arch(curve(0.0, 0.0), curve(outer - inner, 0.0), 0.15)
    band = arch(curve(0.10, 0.012), curve(0.30, 0.012), 0.20)
    feet = [shapes.block(0.62, 0.36, 0.58, x=s * AISLE, y=foot - 0.02) for s in (1, -1)]
    meshes = [m.along_x() for m in [rib, band, *feet]]
    plan.add("rib", [(plan.trim, meshes)], [(x, 0.0, 0.0, 0.0) for x in AXES[1::2]])
    low = (WEST_IN - 0.05, foot + rise + 0.06, -0.12)
    ridge = shapes.box(low, (AXES[5] + 0.35, foot + rise + 0.30, 0.12))
    plan.add("ridge", [(plan.trim, ridge)])


def arch(inner, outer, half):
    """Solid between two curves from -x to +x, `half` to either side of z = 0."""
    rings = []
    for (ax, ay), (bx, by) in zip(inner, outer):
        rings.append([(ax, ay, -half), (ax, ay, half), (bx, by, half), (bx, by, -half)])
    return shapes.loft(rings, crease=30.0)
