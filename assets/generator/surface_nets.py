# SPDX-License-Identifier: MIT
"""Closed smooth surfaces around rods: the zero set of a blended distance, as triangles.

Naive surface nets (Gibson 1998: Constrained Elastic Surface Nets): a vertex in each cell that the
surface crosses, a quad around each edge it crosses. Only + - * / and square roots: the same on
every machine.
"""

import math

from . import vector as v
from .mesh import DIGITS, Vertices


class Rod:
    """A segment with a radius at either end; `flat` makes it thinner along z."""

    def __init__(self, a, b, radius_a, radius_b, flat=1.0):
        self.a, self.b, self.flat = a, b, flat
        self.radius_a, self.radius_b = radius_a, radius_b
        self.d = v.sub(b, a)
        self.dd = max(v.dot(self.d, self.d), 1e-9)

    def distance(self, p):
        """To the surface, about; negative inside."""
        q = v.sub(p, self.a)
        t = min(1.0, max(0.0, v.dot(q, self.d) / self.dd))
        e = v.sub(q, v.scale(self.d, t))
        z = e[2] / self.flat
        size = math.sqrt(e[0] * e[0] + e[1] * e[1] + z * z)
        return size - (self.radius_a + (self.radius_b - self.radius_a) * t)


def blended(values, k):
    """Smooth minimum (Quilez, polynomial) of distances; k: metres over which two blend."""
    result = values[0]
    for value in values[1:]:
        h = max(k - abs(result - value), 0.0) / k
        result = min(result, value) - h * h * k * 0.25
    return result


def skin(rods, cell, blend=0.04):
    """Vertices of the surface around all rods, in cells of that size."""
    field = {}
    for rod in rods:
        reach = max(rod.radius_a, rod.radius_b) + blend + 2.0 * cell
        spans = [
            range(math.floor((min(a, b) - reach) / cell), math.ceil((max(a, b) + reach) / cell) + 1)
            for a, b in zip(rod.a, rod.b)
        ]
        for i in spans[0]:
            for j in spans[1]:
                for k in spans[2]:
                    d = rod.distance((i * cell, j * cell, k * cell))
                    key = (i, j, k)
                    field[key] = blended((field[key], d), blend) if key in field else d

    def near(p):
        return blended([rod.distance(p) for rod in rods], blend)

    out, index_of = Vertices(), {}
    corners = [(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    edges = [(a, b) for a in corners for b in corners
        if sum(b) == sum(a) + 1 and all(x <= y for x, y in zip(a, b))]

    def vertex(key):
        if key not in index_of:
            values = {c: field.get(_sum(key, c), 1.0) for c in corners}
            total, count = (0.0, 0.0, 0.0), 0
            for a, b in edges:
                if (values[a] < 0.0) != (values[b] < 0.0):
                    t = values[a] / (values[a] - values[b])
                    total = v.add(total, v.add(a, v.scale(v.sub(b, a), t)))
                    count += 1
            p = v.scale(v.add(key, v.scale(total, 1.0 / count)), cell)
            step = 0.25 * cell
            gradient = v.normalized(tuple(
                near(v.add(p, v.scale(axis, step))) - near(v.add(p, v.scale(axis, -step)))
                for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
            ))
            p = v.sub(p, v.scale(gradient, max(-0.4 * cell, min(0.4 * cell, near(p)))))
            index_of[key] = len(out.positions)
            out.positions.append(tuple(round(x, DIGITS) + 0.0 for x in p))
            rounded = tuple(round(x, DIGITS) + 0.0 for x in gradient)
            out.normals.append(v.normalized(rounded))
        return index_of[key]

    for key in sorted(field):
        if field[key] >= 0.0:
            continue
        for axis in range(3):
            one, two = (axis + 1) % 3, (axis + 2) % 3
            for way in (1, -1):
                other = tuple(x + way * (n == axis) for n, x in enumerate(key))
                if field.get(other, 1.0) < 0.0:
                    continue
                base = min(key, other)
                ring = []
                for s, t in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    cell_key = list(base)
                    cell_key[one] -= 1 - s
                    cell_key[two] -= 1 - t
                    ring.append(vertex(tuple(cell_key)))
                if way < 0:
                    ring.reverse()
                a, b, c, d = ring
                out.indices += [a, b, c, a, c, d]
    return out


def _sum(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])
