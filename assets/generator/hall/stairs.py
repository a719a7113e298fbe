# SPDX-License-Identifier: MIT
"""A broad flight to a landing, and from there a flight to either side up to the galleries."""

from .. import polygon, shapes
from . import objects, parts
from .plan import (
    AISLE, AXES, CEILING, FLIGHT_HALF, GALLERY, LANDING, LANDING_EDGE, RISE, STEPS, TREAD,
    UPPER_TREAD, WALL_IN, WEST_IN,
)

FOOT = LANDING_EDGE + (STEPS - 1) * TREAD  # x where the lower flight begins
HEAD = FLIGHT_HALF + (STEPS - 1) * UPPER_TREAD  # z where the upper ones end
CURB = 0.10  # top of the sloping curbs, over their line
HEIGHT = 0.62  # of the balusters


def add_to(plan):
    lower_flight(plan)
    upper_flights(plan)
    posts, newels = rails(plan)
    newel = [*objects.pedestal(0.44, 1.16), objects.finial(0.19).moved(y=1.16)]
    newel.append(shapes.block(0.415, 0.4, 0.415, y=-0.35))
    plan.add("newel", [(plan.trim, newel)], newels)
    plan.add("stair baluster", [(plan.trim, parts.baluster(HEIGHT))], posts)


def lower_flight(plan):
    flight = shapes.prism(outline(TREAD), -FLIGHT_HALF, FLIGHT_HALF, crease=0.0)
    runner = shapes.prism(runner_outline(TREAD), -0.95, 0.95, crease=0.0)
    flight, runner = (m.scaled(-1, 1, 1).moved(x=FOOT) for m in (flight, runner))
    half = FLIGHT_HALF + 0.1
    landing = shapes.box((WEST_IN - 0.05, -0.07, -half),
        (LANDING_EDGE - 0.012, LANDING - 0.004, half))
    low, high = (WEST_IN + 0.35, LANDING - 0.03, -0.945), (LANDING_EDGE - 0.24, LANDING + 0.018,
        0.945)
    rug = shapes.chamfered(low, high, 0.006)
    plan.add("lower flight", [(plan.stair, [flight, landing]), (plan.carpet, [runner, rug])])


def upper_flights(plan):
    depth = LANDING_EDGE - WEST_IN
    flight = shapes.prism(outline(UPPER_TREAD), -depth - 0.04, 0.0, crease=0.0)
    flight = flight.turned_y(-90.0).moved(x=WEST_IN - 0.04, y=LANDING, z=FLIGHT_HALF)
    z0, z1 = FLIGHT_HALF + 0.02, WALL_IN + 0.06
    side = [(z0, -0.06), (z1, -0.06), (z1, GALLERY - 0.4), (HEAD, GALLERY - 0.4),
        (z0, LANDING - 0.15)]
    mass = shapes.prism([(-z, y) for z, y in side], WEST_IN - 0.03, LANDING_EDGE - 0.02).along_x()
    low = (WEST_IN - 0.06, GALLERY - 0.45, HEAD + 0.04)
    top = shapes.box(low, (LANDING_EDGE + 0.007, GALLERY - 0.003, WALL_IN + 0.07))
    # Closes the end of the aisle.
    low = (LANDING_EDGE - 0.06, -0.08, AISLE - 0.285)
    screen = shapes.box(low, (AXES[0] - 0.045, CEILING + 0.03, WALL_IN + 0.065))
    plan.add_mirrored("upper flight", [(plan.stair, [flight, top]), (plan.wall, [mass, screen])])


def rails(plan):
    """Adds curbs and handrails; returns the places of the balusters and of the newels."""
    stone, posts, newels = [], [], []
    for side in (1, -1):
        z = side * (FLIGHT_HALF + 0.02)
        slope = RISE / TREAD
        start = (FOOT + 0.1, 0.16 - 0.1 * slope, z)
        length = FOOT + 0.1 - (LANDING_EDGE - 0.05)
        end = (start[0] - length, start[1] + length * slope, z)
        posts += flight_rail(stone, start, end, 12, 0.16)
        cheek = [(start[0] - 0.05, -0.03), (start[0] - 0.03, start[1] - 0.2)]
        cheek += [(end[0] + 0.035, end[1] - 0.2), (end[0] + 0.035, -0.03)]
        stone.append(shapes.prism(cheek, z - 0.145, z + 0.145, crease=0.0))
        newels += [(FOOT + 0.14, 0.0, z, 0.0), (LANDING_EDGE - 0.16, LANDING, z, 0.0)]

        x, slope = LANDING_EDGE - 0.03, RISE / UPPER_TREAD
        start = (x, LANDING + 0.16 + 0.26 * slope, side * (FLIGHT_HALF + 0.26))
        length = HEAD + 0.05 - (FLIGHT_HALF + 0.26)
        end = (x, start[1] + length * slope, side * (HEAD + 0.05))
        posts += flight_rail(stone, start, end, 11, 0.15)
        newels.append((x, GALLERY, side * (HEAD + 0.24), 0.0))
    plan.add("stair rails", [(plan.trim, stone)])
    return posts, newels


def flight_rail(stone, start, end, count, half):
    """Sloping curb and rail between two points, put into `stone`; places of the balusters."""
    stone.append(parts.rail(polygon.rectangle(-half, -0.55, half, CURB), start, end))
    lift = CURB + HEIGHT
    raised = [(p[0], p[1] + lift, p[2]) for p in (start, end)]
    stone.append(parts.rail(parts.RAIL_PROFILE, *raised))
    places = []
    for i in range(count):
        t = (i + 0.8) / (count + 0.5)
        x, y, z = (a + (b - a) * t for a, b in zip(start, end))
        places.append((x, y + CURB, z, 0.0))
    return places


def outline(tread):
    """Side view of a flight that climbs along +x from the origin; each step with a nosing."""
    nose, lip = 0.03, 0.05
    points = [(0.0, -0.05)]
    for i in range(STEPS):
        x, y = i * tread, (i + 1) * RISE
        points += [(x, y - lip), (x - nose, y - lip), (x - nose, y)]
        if i < STEPS - 1:
            points.append((x + tread, y))
    last = (STEPS - 1) * tread
    return points + [(last + 0.10, STEPS * RISE), (last + 0.10, -0.05)]


def runner_outline(tread):
    """Side view of a carpet, 2 cm thick, that lies on a flight."""
    nose, thick = 0.03 + 0.02, 0.02
    over = []
    for i in range(STEPS):
        x, y = i * tread - nose, (i + 1) * RISE + thick
        over += [(x, y), (x + tread, y)]
    end = over[-1][0]
    under = [(end, STEPS * RISE - 0.03)]
    for i in reversed(range(STEPS)):
        x, y = i * tread + 0.02, (i + 1) * RISE - 0.03
        under += [(x, y), (x, y - RISE if i else -0.02)]
    return over + under + [(-nose, -0.02)]
