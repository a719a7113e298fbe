# SPDX-License-Identifier: MIT
"""Points and directions as plain tuples of three floats."""

import math


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(a, s):
    return (a[0] * s, a[1] * s, a[2] * s)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def length(a):
    return math.sqrt(dot(a, a))


def normalized(a):
    return scale(a, 1.0 / length(a))


def rotated_y(p, degrees):
    """Rotation about y, right-handed: 90 degrees takes z to x. Exact for multiples of 90."""
    c, s = cos_sin(degrees)
    return (c * p[0] + s * p[2], p[1], c * p[2] - s * p[0])


def cos_sin(degrees):
    quarter, rest = divmod(degrees, 90.0)
    if rest == 0.0:
        return ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[int(quarter) % 4]
    return math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
