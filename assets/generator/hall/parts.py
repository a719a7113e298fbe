# SPDX-License-Identifier: MIT
"""Columns, arches, balusters and mouldings of the hall. Sizes in metres."""

import math

from .. import polygon, shapes
from .. import vector as v

FLUTES = 16
STEPS = 4  # around each flute


def plinth(width, height):
    """Square block a column or a statue stands on; sunk 2 cm into what is below."""
    h = width / 2.0
    return shapes.chamfered((-h, -0.02, -h), (h, height, h), 0.015)


def fluted_shaft(bottom_radius, top_radius, bottom, top, depth=0.014):
    """Shaft with sharp ridges between hollows, slightly swollen, its hollows fading at the ends."""
    length = top - bottom
    rings = []
    for t, fade in (
        (0.0, 0), (0.03, 0), (0.055, 1), (0.5, 1), (0.94, 1), (0.965, 0), (1.0, 0),
    ):
        radius = bottom_radius + (top_radius - bottom_radius) * t + 0.012 * math.sin(math.pi * t)
        ring = []
        for i in range(FLUTES * STEPS):
            u = (i % STEPS) / STEPS
            r = radius - fade * depth * (1.0 - (2.0 * u - 1.0) ** 2)
            a = 2.0 * math.pi * i / (FLUTES * STEPS)
            ring.append((r * math.cos(a), bottom + length * t, -r * math.sin(a)))
        rings.append(ring)
    return shapes.loft(rings)


def half_round(radius, y, height, points=6):
    """Profile points of a torus: bulges out by half its height."""
    return [
        (radius + height / 2.0 * math.cos(t), y + height / 2.0 * (1.0 + math.sin(t)))
        for t in (math.pi * (i / points - 0.5) for i in range(points + 1))
    ]


def attic_base(radius, bottom, height, segments=24):
    """Two tori with a hollow between."""
    h = height
    lower = half_round(radius + 0.045, bottom, 0.36 * h, 5)
    upper = half_round(radius + 0.012, bottom + 0.62 * h, 0.24 * h, 3)
    profile = [(0.0, bottom - 0.02), (radius + 0.045, bottom - 0.02)] + lower
    profile += [(radius + 0.04, bottom + 0.42 * h), (radius + 0.016, bottom + 0.46 * h)]
    profile += [(radius + 0.016, bottom + 0.56 * h)] + upper
    profile += [(radius, bottom + h), (0.0, bottom + h)]
    return shapes.lathe(profile, segments)


def leaf(radius, bottom, height, width, reach):
    """A leaf that stands against a bell of that radius and curls out at its tip, towards +x."""
    spine = (
        # out, up, half width, thickness: shares of reach, height, width; metres
        (-0.10, 0.00, 0.42, 0.020),
        (0.16, 0.58, 0.48, 0.020),
        (0.62, 0.95, 0.34, 0.015),
        (0.98, 0.98, 0.20, 0.012),
        (1.12, 0.88, 0.07, 0.008),
    )
    points = [(radius + out * reach, bottom + up * height) for out, up, _, _ in spine]
    rings = []
    for i, (_, _, half, thick) in enumerate(spine):
        (ax, ay), (bx, by) = points[max(i - 1, 0)], points[min(i + 1, len(points) - 1)]
        size = math.hypot(bx - ax, by - ay)
        nx, ny = (by - ay) / size, (ax - bx) / size  # away from the bell, then down
        x, y = points[i]
        rings.append(
            [
                (x, y, half * width),
                (x + 1.6 * thick * nx, y + 1.6 * thick * ny, 0.0),
                (x, y, -half * width),
                (x - thick * nx, y - thick * ny, 0.0),
            ]
        )
    return shapes.loft(rings, crease=50.0)


def leaf_capital(radius, bottom, height, abacus, count=8):
    """Bell with two rows of leaves under a slab with hollow sides. A list of meshes."""
    h = height
    bell = [(0.0, -0.03), (radius, -0.03), *half_round(radius, 0.0, 0.07 * h, 3)]
    bell += [(radius, 0.09 * h), (1.02 * radius, 0.5 * h), (1.16 * radius, 0.78 * h),
        (1.34 * radius, 0.86 * h)]
    bell += [(0.0, 0.86 * h)]
    parts = [shapes.lathe([(r, bottom + y) for r, y in bell], 20)]
    for i in range(count):
        for turn, y, tall, reach in ((0.0, 0.08, 0.46, 0.07), (0.5, 0.10, 0.74, 0.13)):
            one = leaf(radius, bottom + y * h, tall * h, 5.2 * radius / count, reach)
            parts.append(one.turned_y(360.0 * (i + turn) / count))
    half = abacus / 2.0
    side = [(-half + 0.05 + (abacus - 0.1) * i / 8, half - 0.08 * math.sin(math.pi * i / 8))
        for i in range(9)]
    outline = []
    for k in range(4):
        c, s = v.cos_sin(90.0 * k)
        outline += [(c * x - s * y, s * x + c * y) for x, y in reversed(side)]
    slab = shapes.prism(outline, bottom + 0.82 * h, bottom + 0.96 * h).along_y()
    cap = shapes.prism([(1.06 * x, 1.06 * y) for x, y in outline], bottom + 0.94 * h, bottom + h)
    return parts + [slab, cap.along_y()]


def lower_column(height):
    """Fluted column of the arcade: (shaft and base, capital) lists of meshes."""
    body = [plinth(0.84, 0.14), attic_base(0.33, 0.14, 0.22)]
    body.append(fluted_shaft(0.32, 0.27, 0.34, height - 0.46))
    return body, leaf_capital(0.26, height - 0.46, 0.48, 0.78)


def upper_column(bottom, top):
    """Plain column of the gallery, from the top of its pedestal to the beam."""
    profile = [(0.0, bottom + 0.05), (0.205, bottom + 0.05),
        *half_round(0.205, bottom + 0.06, 0.08, 4)]
    profile += [(0.195, bottom + 0.15)]
    for t in (0.0, 0.3, 0.65, 1.0):
        profile.append((0.18 - 0.03 * t + 0.008 * math.sin(math.pi * t),
            bottom + 0.19 + t * (top - bottom - 0.50)))
    profile += [*half_round(0.15, top - 0.29, 0.05, 3), (0.15, top - 0.22)]
    profile += [(0.17, top - 0.17), (0.215, top - 0.11), (0.225, top - 0.07), (0.0, top - 0.07)]
    shaft = shapes.lathe(profile, 16)
    foot = shapes.chamfered((-0.26, bottom - 0.02, -0.26), (0.26, bottom + 0.06, 0.26), 0.01)
    slab = shapes.box((-0.25, top - 0.09, -0.25), (0.25, top + 0.02, 0.25))
    return [shaft, foot, slab]


def baluster(height):
    """Turned post with square ends, standing at y = 0."""
    h = height
    profile = [(0.055, 0.05), (0.045, 0.11), (0.068, 0.20), (0.082, 0.29), (0.068, 0.39)]
    profile += [(0.040, 0.53), (0.036, 0.70), (0.056, 0.74), (0.040, 0.79), (0.052, 0.95)]
    post = shapes.lathe([(r, y * h) for r, y in profile], 8, crease=50.0)
    foot = shapes.block(0.14, 0.08 * h, 0.14, y=-0.02)
    return [post, foot, shapes.block(0.13, 0.10 * h, 0.13, y=0.92 * h)]


RAIL_PROFILE = [
    (-0.13, 0.0), (-0.13, 0.03), (-0.16, 0.05), (-0.16, 0.09), (-0.13, 0.13),
    (0.13, 0.13), (0.16, 0.09), (0.16, 0.05), (0.13, 0.03), (0.13, 0.0),
]
CURB_PROFILE = polygon.rectangle(-0.16, -0.04, 0.16, 0.14)


def rail(profile, start, end):
    """A bar of that (sideways, up) profile between two points; the ends are upright."""
    flat = v.normalized((end[0] - start[0], 0.0, end[2] - start[2]))
    return shapes.moulding(
        profile, shapes.straight_path(start, end, (flat[2], 0.0, -flat[0]),
            (0.0, 1.0, 0.0)), crease=0.0
    )


ARCHIVOLT_PROFILE = [
    # begins a little outside the opening, to leave the wall's edge bare
    (0.02, -0.06), (0.02, 0.03), (0.08, 0.03), (0.085, 0.055), (0.14, 0.06), (0.155, 0.09),
    (0.20, 0.075), (0.20, -0.06),
]


def archivolt(x, spring, radius, z, jamb=0.0, segments=20, size=1.0):
    """Moulded band around a round arch in a wall that faces z, `radius` its inner edge."""
    profile = [(size * s, size * t) for s, t in ARCHIVOLT_PROFILE]
    return shapes.moulding(profile, shapes.arch_path(x, spring, radius, z, jamb, segments),
        crease=30.0)


def keystone(spring, radius, z0, z1):
    outline = [(-0.09, spring + radius - 0.03), (0.09, spring + radius - 0.03)]
    outline += [(0.14, spring + radius + 0.24), (-0.14, spring + radius + 0.24)]
    return shapes.prism(outline, z0, z1)


def roundel(radius=0.24):
    """Disc with a rim and a boss, standing in the plane z = 0 and facing z."""
    r = radius
    profile = [(0.0, -0.05), (r, -0.05), (r, 0.03), (0.92 * r, 0.055), (0.80 * r, 0.055),
        (0.76 * r, 0.02)]
    profile += [(0.42 * r, 0.02), (0.36 * r, 0.05), (0.2 * r, 0.075), (0.0, 0.085)]
    return shapes.lathe(profile, 20).mapped(lambda p: (p[0], -p[2], p[1]))


CORNICE_PROFILE = [
    # (up, out): bed moulding, drip, crown
    (0.0, -0.05), (0.0, 0.05), (0.05, 0.06), (0.08, 0.11), (0.12, 0.13), (0.12, 0.24),
    (0.20, 0.24), (0.21, 0.26), (0.26, 0.29), (0.30, 0.33), (0.34, 0.33), (0.34, -0.05),
]
STRING_PROFILE = [
    (0.0, -0.05), (0.0, 0.03), (0.03, 0.07), (0.07, 0.09), (0.07, 0.12), (0.13, 0.12), (0.16,
        0.06), (0.16, -0.05),
]


def dentils(length, pitch, width, height, depth):
    """Row of small blocks along x, hanging down from y = 0, jutting out in z."""
    count = int(length / pitch)
    return [
        shapes.box((x - width / 2, -height, -0.03), (x + width / 2, 0.02, depth))
        for x in ((i - (count - 1) / 2.0) * pitch for i in range(count))
    ]


def coffers(x0, z0, x1, z1, columns, rows, top, border=0.16, depth=0.24):
    """Lattice below a ceiling at `top`, each opening in two steps."""
    meshes = []
    for step, (margin, low) in enumerate(((0.0, 0.0), (0.09, 0.5))):
        width = (x1 - x0 - border * (columns + 1)) / columns
        length = (z1 - z0 - border * (rows + 1)) / rows
        holes = []
        for i in range(columns):
            for k in range(rows):
                x = x0 + border + i * (width + border) + margin
                z = z0 + border + k * (length + border) + margin
                holes.append(polygon.rectangle(x, -z - length + 2 * margin, x + width - 2 * margin,
                    -z))
        e = 0.004 * step  # the upper step ends short of the lower one's sides
        outline = polygon.rectangle(x0 + e, -z1 + e, x1 - e, -z0 - e)
        high = top + 0.01 if step else top - 0.4 * depth
        meshes.append(shapes.prism(outline, top - depth * (1.0 - low), high, holes).along_y())
    return meshes
