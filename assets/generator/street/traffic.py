# SPDX-License-Identifier: MIT
"""Parked cars and bicycles. They point to +x and stand on y = 0."""

import math

from .. import shapes
from ..polygon import arc
from . import plan as p


def add_to(stage):
    red = stage.mesh("car", car())
    colours = [red] + [stage.variant(red, {"car red": name}) for name in ("car cream", "car blue",
        "car green")]
    places = ((0, -38.5, -1, 0.0), (2, -33.2, -1, 0.0), (1, -33.6, 1, 180.0), (3, -24.5, 1, 180.0),
        (1, -19.0, -1, 0.0), (2, -3.0, 1, 180.0), (0, 8.6, -1, 0.0), (3, 13.9, -1, 180.0),
        (1, 15.0, 1, 180.0), (0, 20.4, 1, 180.0), (2, 34.5, -1, 0.0))
    for colour, x, side, turn in places:
        stage.put("car", colours[colour], [(x, 0.035, side * 2.62, turn)])
    stage.add("bicycle", bicycle(), [(-8.9, p.PAVEMENT, -5.62, 6.0), (9.8, p.PAVEMENT, 5.60, 184.0),
        (-27.9, p.PAVEMENT, -5.62, 176.0), (29.3, p.PAVEMENT, 5.6, 2.0)])


def _section(outline, half_width, ends):
    """Draws a side view out across z; `ends`: (share of the half width, inset) towards a side.

    The inset shrinks the outline about its middle, so that the sides are rounded.
    """
    xs, ys = [q[0] for q in outline], [q[1] for q in outline]
    cx, cy = (min(xs) + max(xs)) / 2.0, (min(ys) + max(ys)) / 2.0
    hx, hy = (max(xs) - min(xs)) / 2.0, (max(ys) - min(ys)) / 2.0
    rings = []
    for share, inset in [(-s, i) for s, i in reversed(ends)] + list(ends):
        rings.append([(cx + (x - cx) * (1.0 - inset / hx), cy + (y - cy) * (1.0 - inset / hy),
            share * half_width) for x, y in outline])
    return shapes.loft(rings, crease=35.0)


def _cabin(z_low, z_high, points, crease=40.0):
    """Greenhouse: the same side view at four stations, narrower at its top."""
    rings = []
    top = max(y for _, y in points)
    low = min(y for _, y in points)
    for side in (-1.0, -0.86, 0.86, 1.0):
        ring = []
        for x, y in points:
            t = (y - low) / (top - low)
            shrink = 0.0 if abs(side) < 0.9 else 0.05
            ring.append((x * (1.0 - 0.02 * shrink), y - shrink * t, side * (z_low + (z_high - z_low)
                * t)))
        rings.append(ring)
    return shapes.loft(rings, crease)


def car():
    """A small saloon of the fifties: 3.9 m long, 1.55 m wide, 1.45 m high."""
    arches = (-1.18, 1.22)
    under = [(-1.86, 0.32)]
    for x in arches:
        under += [q for q in reversed(arc(x, 0.30, 0.36, 0.36, 3.0, 177.0, 10))]
    under += [(1.84, 0.30)]
    upper = [(1.93, 0.42), (1.92, 0.62), (1.78, 0.78), (1.30, 0.86), (0.72, 0.90), (-1.15, 0.92),
        (-1.62, 0.86), (-1.88, 0.70), (-1.93, 0.45)]
    body = _section(under + upper, 0.76, ((0.55, 0.0), (0.88, 0.02), (0.97, 0.05), (1.0, 0.09)))
    shell = [body]
    glass = _cabin(0.67, 0.50, [(-1.28, 0.88), (0.92, 0.86), (0.50, 1.30), (0.15, 1.38), (-0.55,
        1.37), (-0.92, 1.24)])
    roof = _cabin(0.545, 0.47, [(-0.88, 1.285), (0.46, 1.325), (0.15, 1.425), (-0.50, 1.415),
        (-0.80, 1.355)])
    shell.append(roof)
    for side in (-1, 1):
        for x0, y0, x1, y1 in ((0.90, 0.87, 0.49, 1.31), (-1.26, 0.88, -0.90, 1.27), (-0.22, 0.88,
                -0.20, 1.36)):
            shell.append(shapes.bar((x0, y0, side * 0.668), (x1, y1, side * 0.532), 0.05, 0.05))
        for x in arches:  # mudguards
            ring = [(x + 0.44 * math.cos(t), 0.30 + 0.42 * math.sin(t)) for t in (math.pi * k / 10
                for k in range(11))]
            inner = [(x + 0.365 * math.cos(t), 0.30 + 0.345 * math.sin(t)) for t in (math.pi
                * (1.0 - k / 10) for k in range(11))]
            z = sorted((side * 0.60, side * 0.80))
            shell.append(shapes.prism(ring + inner, z[0], z[1]))
    chrome = []
    for x, sign in ((1.99, 1), (-1.99, -1)):
        path = [(x - 0.22 * sign, 0.43, -0.80), (x, 0.43, -0.66), (x + 0.03 * sign, 0.43, 0.0),
            (x, 0.43, 0.66), (x - 0.22 * sign, 0.43, 0.80)]
        chrome.append(shapes.cord(path, [0.045] * 5, 8))
        chrome += [shapes.sphere(0.06, 8, 6, (x + 0.02 * sign, 0.43, z)) for z in (-0.35, 0.35)]
    lamp = [(0.0, 0.0), (0.115, 0.0), (0.125, 0.03), (0.10, 0.05), (0.0, 0.07)]
    lens = []
    for z in (-0.55, 0.55):
        ring = shapes.lathe(lamp, 16, 30.0).mapped(lambda q: (1.86 + q[1], 0.66 - q[0], q[2]))
        lens.append(ring.moved(0.0, 0.0, z))
        chrome.append(shapes.sphere(0.05, 10, 6, (-1.90, 0.62, z)))
    for k in range(6):  # radiator
        chrome.append(shapes.box((1.86, 0.47 + 0.04 * k, -0.30), (1.945 - 0.004 * k, 0.485
            + 0.04 * k, 0.30)))
    for z in (-0.755, 0.755):
        chrome.append(shapes.box((-0.10, 0.74, z - 0.02), (0.02, 0.76, z + 0.025)))
        chrome.append(shapes.box((-1.5, 0.585, z - 0.02), (1.45, 0.605, z + 0.018)))
    wheels, hubs = [], []
    for x in arches:
        for side in (-1, 1):
            tyre = [(0.0, -0.09), (0.24, -0.09), (0.30, -0.07), (0.315, 0.0), (0.30, 0.07), (0.24,
                0.09), (0.19, 0.075), (0.0, 0.07)]
            hub = [(0.0, 0.06), (0.185, 0.06), (0.18, 0.085), (0.10, 0.09), (0.06, 0.115), (0.0,
                0.12)]
            for profile, target in ((tyre, wheels), (hub, hubs)):
                wheel = shapes.lathe(profile, 20, 40.0).along_y().moved(0.0, 0.0, 0.0)
                wheel = wheel.mapped(lambda q: (q[0], q[1], -q[2]), flip=True)
                if side < 0:
                    wheel = wheel.turned_y(180.0)
                target.append(wheel.facing_outward().moved(x, 0.315, side * 0.665))
    floor = shapes.box((-1.75, 0.20, -0.55), (1.75, 0.36, 0.55))
    return [("car red", shell), ("glass", [glass]), ("chrome", chrome + hubs), ("tyre", wheels
        + [floor]), ("white paint", lens)]


def bicycle():
    """Leans a little to -z."""
    iron, tyres = [], []
    for x in (-0.52, 0.52):
        tyre = [(0.335 + 0.017 * math.cos(t), 0.017 * math.sin(t)) for t in (2.0 * math.pi * k / 6
            for k in range(6))]
        wheel = shapes.hoop(tyre, 24).along_y().facing_outward()
        tyres.append(wheel.moved(x, 0.352, 0.0))
        for k in range(12):
            a = math.pi * k / 6 + 0.1
            iron.append(shapes.rod((x, 0.352, 0.014 * (-1) ** k), (x + 0.33 * math.cos(a), 0.352
                + 0.33 * math.sin(a), 0.0), 0.0016, 5))
        iron.append(shapes.rod((x, 0.352, -0.05), (x, 0.352, 0.05), 0.018, 6))
    crank, seat, head = (-0.06, 0.29, 0.0), (-0.18, 0.78, 0.0), (0.36, 0.80, 0.0)
    frame = [shapes.rod(a, b, 0.014, 6) for a, b in ((crank, seat), (seat, head), (crank, (0.38,
        0.70, 0.0)), ((0.33, 0.92, 0.0), (0.40, 0.62, 0.0)))]
    for z in (-0.045, 0.045):
        frame += [shapes.rod((-0.52, 0.352, z), (seat[0], seat[1] - 0.04, 0.3 * z), 0.008, 5),
            shapes.rod((-0.52, 0.352, z), (crank[0], crank[1], 0.4 * z), 0.008, 5), shapes.rod(
                (0.52, 0.352, z), (0.40, 0.63, 0.5 * z), 0.009, 5)]
    iron += [shapes.cord([(0.20, 0.95, -0.26), (0.30, 0.98, -0.20), (0.33, 0.95, 0.0), (0.30, 0.98,
        0.20), (0.20, 0.95, 0.26)], [0.011] * 5, 6), shapes.rod(seat, (-0.21, 0.93, 0.0), 0.012, 6),
        shapes.hoop([(0.085, -0.004), (0.095, -0.004), (0.095, 0.004), (0.085, 0.004)], 20,
            30.0).along_y().facing_outward().moved(crank[0], crank[1], 0.05)]
    saddle = shapes.loft([[(-0.34 + 0.30 * t, 0.935 + 0.02 * t + h, w * side) for side, h in
        ((-1.0, 0.0), (-0.6, 0.04), (0.6, 0.04), (1.0, 0.0))] for t, w in ((0.0, 0.07), (0.35,
            0.085), (0.7, 0.03), (1.0, 0.015))])
    basket = shapes.box((0.40, 0.80, -0.15), (0.64, 1.0, 0.15))
    lean = lambda m: m.mapped(lambda q: (q[0], q[1], q[2] - 0.10 * q[1]))
    return [("iron", [lean(m) for m in iron]), ("green paint", [lean(m) for m in frame]), ("tyre",
        [lean(m) for m in tyres]), ("wood", [lean(m) for m in (saddle, basket)])]
