# SPDX-License-Identifier: MIT
"""Side walls with niches and doors, what stands in the niches, the end wall, the portal."""

from .. import polygon, shapes
from . import objects, parts
from .plan import (
    AISLE, AISLE_MIDDLE, AXES, BAY, BEAM, EAST_IN, EAST_OUT, GALLERY, LANDING, MIDDLES, TOP,
    WALL_IN, WALL_OUT, WEST_IN, WEST_OUT, inward,
)

WINDOW = (0.0, 1.02, 5.45, 6.55)  # x, half width, sill, spring
NICHE = (0.0, 0.62, 0.95, 2.15)
DOOR_HALF, DOOR_SPRING = 0.92, 2.05
NICHE_BAYS, DOOR_BAYS = MIDDLES[0::2], MIDDLES[1::2]


def add_to(plan):
    side_walls(plan)
    wall_ends(plan)
    niche_objects(plan)
    end_wall(plan)
    portal(plan)


def side_walls(plan):
    half, thick = BAY / 2.0, WALL_OUT - WALL_IN
    window = polygon.arched(*WINDOW)
    _, w, sill, spring = WINDOW
    above = [
        parts.archivolt(0.0, spring, w, 0.0, jamb=spring - sill + 0.04, size=0.55),
        shapes.box((-w - 0.14, sill - 0.17, -0.05), (w + 0.14, sill - 0.02, 0.12)),
    ]

    outline = polygon.rectangle(-half, -0.1, half, TOP)
    wall = shapes.panel(outline, -thick, 0.0, [window], [shapes.niche_outline(*NICHE)])
    wall = wall.without(0, half).without(0, -half)
    shell = shapes.niche(*NICHE, 0.60, 0.0)
    _, w, sill, spring = NICHE
    bands = [
        parts.archivolt(0.0, spring, w, 0.0, jamb=spring - sill + 0.05, size=0.75),
        shapes.box((-w - 0.28, sill - 0.17, -0.05), (w + 0.28, sill - 0.025, 0.16)),
    ]
    pieces = [(plan.wall, wall), (plan.plaster, shell), (plan.trim, above + bands)]
    plan.add("niche bay", pieces, inward(NICHE_BAYS, 0.0, WALL_IN))

    outline = [(-half, -0.1), (-DOOR_HALF, -0.1)]
    outline += polygon.arc(0.0, DOOR_SPRING, DOOR_HALF, DOOR_HALF, 180.0, 0.0, 20)
    outline += [(DOOR_HALF, -0.1), (half, -0.1), (half, TOP), (-half, TOP)]
    wall = shapes.prism(outline, -thick, 0.0, [window]).without(0, half).without(0, -half)
    jamb = DOOR_SPRING + 0.02
    bands = [
        parts.archivolt(0.0, DOOR_SPRING, DOOR_HALF, 0.0, jamb),
        parts.keystone(DOOR_SPRING, DOOR_HALF, -thick - 0.12, 0.12),
    ]
    step = shapes.box((-DOOR_HALF - 0.05, -0.03, -thick - 0.1), (DOOR_HALF + 0.05, 0.012, 0.02))
    pieces = [(plan.wall, wall), (plan.trim, above + bands), (plan.stair, step)]
    plan.add("door bay", pieces, inward(DOOR_BAYS, 0.0, WALL_IN))

    pilaster = [
        shapes.box((-0.24, -0.025, -0.05), (0.24, 3.6, 0.105)),
        shapes.box((-0.27, -0.03, -0.055), (0.27, 0.36, 0.14)),
        shapes.box((-0.27, 3.42, -0.055), (0.27, 3.56, 0.14)),
        shapes.box((-0.17, 4.6, -0.05), (0.17, BEAM + 0.12, 0.09)),
        shapes.box((-0.21, BEAM - 0.14, -0.055), (0.21, BEAM - 0.02, 0.13)),
    ]
    plan.add("pilaster", [(plan.trim, pilaster)], inward(AXES, 0.0, WALL_IN))


def wall_ends(plan):
    """The side walls beside the stairs and the portal, and the stone on top of them."""
    spans = (("stair wall", WEST_IN - 0.1, AXES[0], AXES[0]),
        ("portal wall", AXES[-1], EAST_OUT, AXES[-1]))
    for name, x0, x1, joint in spans:
        opening = polygon.arched((x0 + x1) / 2.0, 0.45, WINDOW[2], WINDOW[3] + 0.3, 16)
        end = shapes.prism(polygon.rectangle(x0, -0.1, x1, TOP), WALL_IN, WALL_OUT, [opening])
        plan.add_mirrored(name, [(plan.wall, [end.without(0, joint)])])
    low = (WEST_IN - 0.05, TOP - 0.04, WALL_IN - 0.08)
    coping = shapes.box(low, (EAST_OUT + 0.08, TOP + 0.18, WALL_OUT + 0.08))
    plan.add_mirrored("coping", [(plan.trim, [coping])])


def niche_objects(plan):
    """One thing in each niche, and an urn at the end of each aisle."""
    spots = inward(NICHE_BAYS, NICHE[2], WALL_IN + 0.20)
    things = (
        ("amphora", objects.amphora(), plan.clay, 0.22, [spots[0], spots[5]]),
        ("sphere", objects.sphere_on_stand(), plan.bronze, 0.26, [spots[2], spots[4]]),
        ("urn", objects.urn(), plan.clay, 0.66, [(-6.6, 0.0, s * AISLE_MIDDLE, 90.0)
            for s in (1, -1)]),
    )
    for name, meshes, material, height, places in things:
        base = objects.pedestal(0.56, height)
        raised = [m.moved(y=height) for m in meshes]
        plan.add(name, [(material, raised), (plan.trim, base)], places)
    for arms, place in (("bowl", spots[1]), ("folded", spots[3])):
        raised = [m.scaled(0.86, 0.86, 0.86).moved(y=0.05) for m in objects.figure(arms)]
        plan.add(f"figure, {arms}", [(plan.marble, raised), (plan.trim, parts.plinth(0.62, 0.04))],
            [place])


def end_wall(plan):
    """Modelled facing z: a great niche above the landing, a round window, a curved gable."""
    thick, half, eaves = WEST_IN - WEST_OUT, WALL_OUT + 0.05, TOP + 0.10
    sill, spring, width = LANDING + 0.45, 4.6, 1.25
    centre, radius = 7.75, 0.85  # of the window
    outline = [(-half, -0.12), (half, -0.12), (half, eaves)]
    outline += polygon.arc(0.0, eaves, AISLE + 0.55, 2.30, 0.0, 180.0, 32) + [(-half, eaves)]
    window = polygon.circle(0.0, centre, radius, 32)
    rim = shapes.niche_outline(0.0, width, sill, spring, rows=12)
    wall = shapes.panel(outline, -thick, 0.0, [window], [rim])
    shell = shapes.niche(0.0, width, sill, spring, 1.05, 0.0, segments=24, rows=12)

    profile = [(0.02, -0.05), (0.02, 0.04), (0.10, 0.07), (0.22, 0.09), (0.28, 0.05), (0.28, -0.05)]
    ring = shapes.hoop([(radius + r, y) for r, y in profile], 48)
    string = shapes.straight_path((-WALL_IN - 0.02, 6.35, 0.0), (WALL_IN + 0.02, 6.35, 0.0))
    bands = [
        parts.archivolt(0.0, spring, width, 0.0, jamb=spring - sill + 0.05, segments=32, size=1.2),
        shapes.box((-1.62, sill - 0.19, -0.05), (1.62, sill - 0.03, 0.20)),
        shapes.moulding(parts.STRING_PROFILE, string, crease=25.0),
        parts.keystone(spring, width, -0.09, 0.2),
        ring.mapped(lambda p: (p[0], centre - p[2], p[1])),
    ]
    bands += [parts.roundel(0.55).moved(x=x, y=5.45) for x in (-3.5, 3.5)]
    pieces = [(plan.wall, wall.along_x()), (plan.plaster, shell.along_x())]
    pieces.append((plan.trim, [m.along_x() for m in bands]))
    plan.add("end wall", pieces, [(WEST_IN, 0.0, 0.0, 0.0)])

    base = [m.moved(y=sill) for m in objects.pedestal(1.0, 0.5)]
    statue = [m.scaled(1.22, 1.22, 1.22).moved(y=sill + 0.5) for m in objects.figure("raised")]
    spot = [(WEST_IN - 0.40, 0.0, 0.0, 90.0)]
    plan.add("statue", [(plan.bronze, statue), (plan.trim, base)], spot)


def portal(plan):
    """Modelled facing z: three deep arches; the gallery goes on over them."""
    bottom, spring, back, front = -0.11, 2.3, EAST_IN, EAST_OUT - 0.03
    half = WALL_IN + 0.12
    arches = ((-AISLE_MIDDLE, 0.85, 20), (0.0, 1.75, 28), (AISLE_MIDDLE, 0.85, 20))
    outline = [(-half, bottom)]
    for x, radius, segments in arches:
        outline.append((x - radius, bottom))
        outline += polygon.arc(x, spring, radius, radius, 180.0, 0.0, segments)
        outline.append((x + radius, bottom))
    outline += [(half, bottom), (half, GALLERY + 0.005), (-half, GALLERY + 0.005)]
    mass = shapes.prism(outline, back, front)
    bands = [parts.keystone(spring, 1.75, back - 0.13, front + 0.13)]
    for face, turn, reach in ((-back, 180.0, AISLE - 0.36), (front, 0.0, half - 0.01)):
        trim = [parts.archivolt(x, spring, radius, face, spring + 0.03, segments) for x, radius,
            segments in arches]
        run = shapes.straight_path((-reach, 4.33, face), (reach, 4.33, face))
        trim.append(shapes.moulding(parts.CORNICE_PROFILE, run, crease=25.0))
        bands += [m.turned_y(turn) for m in trim]
    pieces = [(plan.wall, mass.along_x()), (plan.trim, [m.along_x() for m in bands])]
    plan.add("portal", pieces)
