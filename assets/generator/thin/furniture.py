# SPDX-License-Identifier: MIT
"""Chairs and a table: slender legs, spindles, slats and slings. Sitters face +z."""

import math

from .. import shapes
from . import plan as p


def add_to(stage):
    y = p.FLOOR - 0.004
    tx, tz = -2.95, 0.52
    chair = spindle_chair()
    stage.add("spindle chair", chair, [(tx - 0.98, y, tz - 0.02, 96.0), (tx + 0.1, y, tz - 0.62,
        12.0), (tx + 1.12, y, tz + 0.12, -74.0), (tx - 0.22, y, tz + 0.52, 186.0),
        (-0.95, p.FLOOR, -2.32, 215.0)])
    stage.add("table", table(), [(tx, y, tz, 0.0)])
    stage.add("sling chair", sling_chair("saffron cloth"), [(1.0, y, 0.42, 48.0)])
    stage.add("sling chair", sling_chair("indigo cloth"), [(-2.35, 0.0, 2.30, 205.0)])
    stage.add("slatted bench", slatted_bench(), [(-4.05, 0.0, 2.42, 132.0)])
    stage.add("stool", stool(), [(0.62, p.FLOOR, -1.66, 20.0), (0.25, y, 0.92, 0.0)])


def _turned(low, high, radius, segments=8):
    """Turned leg, thickest a third of the way down from `high`."""
    path, radii = [], []
    for t, r in ((0.0, 0.55), (0.35, 0.75), (0.65, 1.0), (0.9, 0.8), (1.0, 0.7)):
        path.append(tuple(a + (b - a) * t for a, b in zip(low, high)))
        radii.append(radius * r)
    return shapes.cord(path, radii, segments)


def _mix(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def spindle_chair():
    seat = []
    for i in range(28):
        a = 2.0 * math.pi * i / 28
        c, s = math.cos(a), math.sin(a)
        r = (abs(c) ** 4 + abs(s) ** 4) ** -0.25
        seat.append((r * c * (0.205 + 0.02 * s * r), r * s * 0.205))
    ring = lambda k, y: [(k * x, y, k * z) for x, z in seat]
    wood = [shapes.loft([ring(0.90, 0.428), ring(0.985, 0.436), ring(1.0, 0.448),
        ring(0.97, 0.458), ring(0.80, 0.452), ring(0.4, 0.446)], crease=50.0)]
    feet = {}
    for sx in (-1, 1):
        for sz in (-1, 1):
            foot, head = (0.215 * sx, 0.0, 0.20 * sz - 0.01), (0.145 * sx, 0.44, 0.14 * sz)
            feet[sx, sz] = (foot, head)
            wood.append(_turned(foot, head, 0.019))
    for sx in (-1, 1):
        wood.append(shapes.rod(_mix(*feet[sx, -1], 0.38), _mix(*feet[sx, 1], 0.38), 0.008))
    wood.append(shapes.rod(_mix(_mix(*feet[-1, -1], 0.38), _mix(*feet[-1, 1], 0.38), 0.5),
        _mix(_mix(*feet[1, -1], 0.38), _mix(*feet[1, 1], 0.38), 0.5), 0.008))
    # The back: a bow of 15 mm that rises from the seat's corners, spindles of 10 mm in it.
    bow = []
    for i in range(17):
        a = math.pi * i / 16
        x, y = 0.20 * math.cos(a), 0.45 * abs(math.sin(a)) ** 0.62
        bow.append((x, 0.440 + y, -0.155 - 0.22 * y - 0.05 * (1.0 - (x / 0.20) ** 2)))
    wood.append(shapes.cord(bow, [0.0085] * len(bow), 7))
    for i in range(7):
        x = -0.135 + 0.045 * i
        y = 0.45 * math.sqrt(max(0.0, 1.0 - (x / 0.20) ** 2)) ** 0.62
        z = 0.05 * (1.0 - (x / 0.20) ** 2)
        wood.append(shapes.cord([(0.8 * x, 0.44, -0.155 - 0.6 * z),
            (0.92 * x, 0.44 + 0.4 * y, -0.155 - 0.088 * y - 0.8 * z),
            (x, 0.44 + y, -0.155 - 0.22 * y - z)], [0.0048, 0.0062, 0.0040], 6))
    return [("beech", wood)]


def table():
    """Round table of slats within a hoop, on three bent legs."""
    slats = []
    for i in range(9):
        z = -0.48 + 0.108 * i + 0.006
        half = math.sqrt(max(0.0, 0.48 ** 2 - max(abs(z), abs(z + 0.096)) ** 2)) + 0.012
        slats.append(shapes.box((-half, 0.715, z), (half, 0.733, z + 0.096)))
    hoop = shapes.hoop([(0.475, 0.70), (0.493, 0.70), (0.493, 0.740), (0.475, 0.740)], 48, 30.0)
    legs = [hoop]
    for k in range(3):
        path = [(0.40, 0.0, 0.0), (0.25, 0.16, 0.0), (0.13, 0.36, 0.0), (0.16, 0.56, 0.0),
            (0.34, 0.70, 0.0)]
        legs.append(shapes.cord(path, [0.011] * 5, 8).turned_y(120.0 * k + 30.0))
    legs.append(shapes.hoop([(0.128, 0.352), (0.140, 0.352), (0.140, 0.366), (0.128, 0.366)], 24))
    cups = []
    for x, z, h in ((-0.22, 0.10, 0.075), (0.18, -0.2, 0.075), (0.02, 0.26, 0.06)):
        cup = [(0.0, 0.0), (0.026, 0.0), (0.034, 0.3 * h), (0.040, h), (0.037, h),
            (0.031, 0.35 * h), (0.0, 0.12 * h)]
        cups.append(shapes.lathe(cup, 20).moved(x, 0.731, z))
    jug = [(0.0, 0.0), (0.05, 0.0), (0.075, 0.06), (0.07, 0.12), (0.038, 0.18), (0.042, 0.23),
        (0.038, 0.23), (0.034, 0.19), (0.0, 0.15)]
    cups.append(shapes.lathe(jug, 24).moved(0.10, 0.731, 0.06))
    handle = [(0.045, 0.20), (0.085, 0.19), (0.10, 0.14), (0.072, 0.08)]
    cups.append(shapes.cord([(0.10 + x, 0.731 + y, 0.06) for x, y in handle], [0.006] * 4, 6))
    return [("beech", slats), ("steel", legs), ("clay", cups)]


def sling_chair(cloth):
    """Folding frame with one sheet of cloth hung in it."""
    wood = []
    for sx in (-1, 1):
        wood.append(shapes.bar((0.29 * sx, 0.0, 0.46), (0.29 * sx, 0.98, -0.44), 0.020, 0.034))
        wood.append(shapes.bar((0.262 * sx, 0.0, -0.40), (0.262 * sx, 0.42, 0.42), 0.020, 0.034))
        wood.append(shapes.bar((0.316 * sx, 0.52, -0.02), (0.316 * sx, 0.0, -0.66), 0.020, 0.028))
    for y, z, half in ((0.965, -0.426, 0.31), (0.405, 0.39, 0.28), (0.045, -0.36, 0.28),
            (0.05, 0.415, 0.30), (0.06, -0.60, 0.33)):
        wood.append(shapes.rod((-half, y, z), (half, y, z), 0.011, 8))

    def point(s, t):
        top, front = (0.965, -0.426), (0.405, 0.39)
        sag = math.sin(math.pi * t) * (0.24 - 0.10 * t)
        y = top[0] + (front[0] - top[0]) * t - sag
        z = top[1] + (front[1] - top[1]) * t - 0.25 * sag
        return (0.225 * (2.0 * s - 1.0), y + 0.02 * (2.0 * s - 1.0) ** 2 * math.sin(math.pi * t), z)

    return [("dark wood", wood), (cloth, shapes.sheet(lambda s, t: point(1.0 - s, t), 6, 16))]


def slatted_bench():
    """Garden bench: seat and back of slats 12 mm thick with gaps."""
    wood, half = [], 0.62
    for x in (-half + 0.06, 0.0, half - 0.06):
        wood.append(shapes.bar((x, 0.0, 0.22), (x, 0.40, 0.19), 0.030, 0.040, (0.0, 0.0, 1.0)))
        wood.append(shapes.bar((x, 0.0, -0.24), (x, 0.40, -0.19), 0.030, 0.040, (0.0, 0.0, 1.0)))
        wood.append(shapes.bar((x, 0.38, -0.19), (x, 0.88, -0.31), 0.030, 0.036, (0.0, 0.0, 1.0)))
        wood.append(shapes.box((x - 0.014, 0.385, -0.21), (x + 0.014, 0.418, 0.23)))
    paint = []
    for i in range(6):
        z = -0.20 + 0.074 * i
        paint.append(shapes.box((-half, 0.415, z), (half, 0.427, z + 0.058)))
    for i in range(6):
        t = 0.10 + 0.155 * i
        y, z = 0.42 + 0.46 * t, -0.166 - 0.11 * t
        paint.append(shapes.bar((-half, y, z), (half, y, z), 0.058, 0.012, (0.0, 0.24, 1.0)))
    for sx in (-1, 1):
        x = sx * (half - 0.06)
        paint.append(shapes.box((x - 0.032, 0.615, -0.26), (x + 0.032, 0.631, 0.22)))
        wood.append(shapes.bar((x, 0.40, 0.17), (x, 0.62, 0.17), 0.028, 0.030, (0.0, 0.0, 1.0)))
    return [("dark wood", wood), ("red lacquer", paint)]


def stool():
    wood = [shapes.lathe([(0.0, 0.43), (0.15, 0.43), (0.165, 0.442), (0.165, 0.455), (0.15, 0.462),
        (0.0, 0.455)], 28, 50.0)]
    for k in range(3):
        wood.append(_turned((0.185, 0.0, 0.0), (0.10, 0.44, 0.0), 0.016).turned_y(120.0 * k))
    wood.append(shapes.hoop([(0.150, 0.150), (0.158, 0.142), (0.166, 0.150), (0.158, 0.158)], 28))
    return [("red lacquer", wood)]
