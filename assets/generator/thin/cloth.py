# SPDX-License-Identifier: MIT
"""Washing on a line and a curtain in the door: cloth without thickness."""

import math

from .. import shapes
from . import plan as p


def add_to(stage):
    _washing(stage)
    _curtain(stage)


def _washing(stage):
    """Two lines between two posts on the lawn east of the house."""
    x, ends, height = 3.72, (-2.75, 0.75), 1.92
    steel, pegs = [], []
    for z in ends:
        steel.append(shapes.cord([(x, -0.02, z), (x, height + 0.05, z)], [0.022, 0.018], 10))
        steel.append(shapes.rod((x - 0.42, height, z), (x + 0.42, height, z), 0.013, 8))

    def line(u):
        """Height of the line, u in [0, 1] from end to end."""
        return height - 0.10 * 4.0 * u * (1.0 - u) - 0.004

    for offset in (-0.34, 0.34):
        path = [(x + offset, line(i / 16), ends[0] + (ends[1] - ends[0]) * i / 16)
            for i in range(17)]
        steel.append(shapes.cord(path, [0.0025] * 17, 5))
    washing = (
        # line, from, to, drop, cloth, wind
        (-0.34, 0.05, 0.42, 1.30, "linen", 0.16), (-0.34, 0.46, 0.66, 0.62, "madder cloth", 0.10),
        (-0.34, 0.70, 0.95, 0.85, "indigo cloth", 0.13), (0.34, 0.08, 0.26, 0.70,
            "saffron cloth", 0.10), (0.34, 0.30, 0.60, 1.05, "linen", 0.14),
        (0.34, 0.66, 0.78, 0.55, "indigo cloth", 0.08), (0.34, 0.81, 0.93, 0.55, "linen", 0.08),
    )
    for offset, low, high, drop, cloth, wind in washing:

        def point(s, t):
            u = low + (high - low) * s
            z = ends[0] + (ends[1] - ends[0]) * u
            blown = wind * t * t * (1.0 + 0.35 * math.sin(9.0 * s + 4.0 * u))
            ripple = 0.025 * t * math.sin(2.0 * math.pi * (2.5 * s + 0.4 * t + 3.0 * low))
            lifted = 0.30 * wind * t * t + 0.02 * math.sin(7.0 * s + 5.0 * high) * t
            return (x + offset + blown + ripple, line(u) + 0.004 - drop * t + lifted,
                z + 0.02 * t * math.sin(5.0 * s))

        stage.add("washing", [(cloth, shapes.sheet(point, 20, 18))])
        for s in (0.03, 0.5, 0.97):
            q = point(s, 0.0)
            pegs.append(shapes.box((q[0] - 0.006, q[1] - 0.045, q[2] - 0.005),
                (q[0] + 0.006, q[1] + 0.022, q[2] + 0.005)))
    stage.add("washing line", [("steel", steel), ("beech", pegs)])


def _curtain(stage):
    """A curtain in the door, drawn to one side, and its rod."""
    low, high, _, head = p.SOUTH_DOOR
    top, z = p.FLOOR + head + 0.10, p.SOUTH - p.CELL - 0.07

    def point(s, t):
        depth = 0.045 * math.sin(2.0 * math.pi * 7.0 * s + 0.5 * t)
        gather = 0.10 * math.exp(-((t - 0.55) / 0.13) ** 2) * (0.5 - s)
        return (high - 0.52 + 0.62 * s + gather, top - (head + 0.07) * t, z + depth
            * (0.6 + 0.4 * t))

    rod = [shapes.rod((low - 0.18, top, z), (high + 0.22, top, z), 0.010, 8)]
    rod += [shapes.sphere(0.022, 12, 8, (x, top, z)) for x in (low - 0.18, high + 0.22)]
    stage.add("curtain", [("linen", shapes.sheet(point, 84, 14)), ("dark wood", rod)])
