# SPDX-License-Identifier: MIT
"""Plane polygons: triangles that fill them, and outlines that are used often.

A polygon is a list of (x, y), its last point joined to its first.
"""

import math


def area(polygon):
    """Signed: positive if counter-clockwise."""
    total = 0.0
    for (ax, ay), (bx, by) in zip(polygon, polygon[1:] + polygon[:1]):
        total += ax * by - ay * bx
    return 0.5 * total


def counter_clockwise(polygon):
    return polygon if area(polygon) > 0.0 else polygon[::-1]


def triangulate(outline, holes=()):
    """Triples of points that fill a simple polygon without its holes, counter-clockwise.

    Ear clipping; always the ear with the widest smallest angle, to avoid needles.
    """
    loop = counter_clockwise(list(outline))
    holes = [counter_clockwise(list(hole))[::-1] for hole in holes]
    while holes:
        loop = _joined(loop, holes)

    triangles = []
    shape = {}  # of an ear with these three corners; ears that are no ears may become some
    while len(loop) > 3:
        best, best_shape = None, 0.0
        for i in range(len(loop)):
            ear = (loop[i - 1], loop[i], loop[(i + 1) % len(loop)])
            if ear not in shape:
                shape[ear] = _smallest_angle(*ear)
            if shape[ear] > best_shape and not any(_covers(ear, p) for p in loop):
                best, best_shape = i, shape[ear]
        if best is None:
            raise ValueError("cannot triangulate: the outline crosses itself or holes overlap")
        triangles.append((loop[best - 1], loop[best], loop[(best + 1) % len(loop)]))
        del loop[best]
    triangles.append(tuple(loop))
    return triangles


def _joined(loop, holes):
    """`loop` with the hole nearest to it cut open and joined in; takes that hole from `holes`."""
    pairs = sorted(
        (math.dist(p, q), k, i, j)
        for k, hole in enumerate(holes)
        for i, p in enumerate(loop)
        if loop.count(p) == 1  # at a bridge's end the sides of the cut could be confused
        for j, q in enumerate(hole)
    )
    edges = [e for ring in [loop] + holes for e in zip(ring, ring[1:] + ring[:1])]
    for _, k, i, j in pairs:
        bridge = (loop[i], holes[k][j])
        if not any(_cross(bridge, edge) for edge in edges):
            hole = holes.pop(k)
            return loop[: i + 1] + hole[j:] + hole[: j + 1] + loop[i:]
    raise ValueError("cannot join a hole to the outline")


def _turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _cross(s, t):
    """Whether two segments cross; sharing an end is no crossing."""
    if s[0] in t or s[1] in t:
        return False
    return (
        _turn(*s, t[0]) * _turn(*s, t[1]) <= 0.0 and _turn(*t, s[0]) * _turn(*t, s[1]) <= 0.0
    )


def _covers(triangle, p):
    a, b, c = triangle
    if p in triangle:
        return False
    return _turn(a, b, p) >= 0.0 and _turn(b, c, p) >= 0.0 and _turn(c, a, p) >= 0.0


def _smallest_angle(a, b, c):
    """Sine of the smallest angle, about; not positive if the corner at b is no convex one."""
    doubled = _turn(a, b, c)
    if doubled < 1e-9:
        return -1.0
    sides = sorted((math.dist(a, b), math.dist(b, c), math.dist(c, a)))
    return doubled / (sides[1] * sides[2])


def rectangle(x0, y0, x1, y1):
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def arc(x, y, rx, ry, start, end, segments):
    """Points of an ellipse's arc, both ends included; angles in degrees."""
    points = []
    for i in range(segments + 1):
        t = math.radians(start + (end - start) * i / segments)
        points.append((x + rx * math.cos(t), y + ry * math.sin(t)))
    return points


def circle(x, y, radius, segments):
    return arc(x, y, radius, radius, 0.0, 360.0, segments)[:-1]


def arched(x, half_width, bottom, spring, segments=20):
    """Outline of a round-headed opening: sill, jambs, half circle from `spring` up."""
    head = arc(x, spring, half_width, half_width, 0.0, 180.0, segments)
    return [(x - half_width, bottom), (x + half_width, bottom)] + head
