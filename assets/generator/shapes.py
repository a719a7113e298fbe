# SPDX-License-Identifier: MIT
"""Solids from which the scenes are put together. All are closed and face outward."""

import math

from . import vector as v
from .mesh import Mesh
from .polygon import counter_clockwise, triangulate

SMOOTH = 38.0  # degrees; the usual crease


def box(low, high):
    """Box between two corners."""
    outline = [(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])]
    return prism(outline, low[2], high[2], crease=0.0)


def block(width, height, depth, x=0.0, y=0.0, z=0.0):
    """Box that stands centred on (x, y, z)."""
    return box((x - width / 2, y, z - depth / 2), (x + width / 2, y + height, z + depth / 2))


def chamfered(low, high, chamfer):
    """Box whose upper edges are cut off by `chamfer`."""
    c = chamfer
    (x0, y0, z0), (x1, y1, z1) = low, high

    def ring(y, inset):
        i = inset
        return [(x0 + i, y, z1 - i), (x1 - i, y, z1 - i), (x1 - i, y, z0 + i), (x0 + i, y, z0 + i)]

    return loft([ring(y0, 0.0), ring(y1 - c, 0.0), ring(y1, c)], crease=0.0)


def prism(outline, z0, z1, holes=(), crease=SMOOTH):
    """A polygon in x, y, with holes, drawn out from z0 to z1."""
    return panel(outline, z0, z1, holes, [], crease)


def panel(outline, z0, z1, holes, recesses, crease=SMOOTH):
    """A prism with holes that go through, and recesses in the face at z1, left open there.

    The caller closes each recess (see `niche`).
    """
    mesh = Mesh(crease)
    outline = counter_clockwise(list(outline))
    holes = [counter_clockwise(list(hole))[::-1] for hole in holes]
    for a, b, c in triangulate(outline, holes + list(recesses)):
        mesh.triangle((*a, z1), (*b, z1), (*c, z1))
    for a, b, c in triangulate(outline, holes):
        mesh.triangle((*a, z0), (*c, z0), (*b, z0))
    for loop in [outline] + holes:
        for a, b in zip(loop, loop[1:] + loop[:1]):
            mesh.quad((*a, z0), (*b, z0), (*b, z1), (*a, z1))
    return mesh


def niche(x, half_width, bottom, spring, depth, z, segments=16, rows=8):
    """The inside of a niche in a wall that faces z: half a cylinder under a quarter of a sphere.

    Its rim is `niche_outline` at height z of a panel's face.
    """
    mesh = Mesh(SMOOTH)

    def point(alpha, beta):
        return (
            x - half_width * math.cos(alpha) * math.cos(beta),
            spring + half_width * math.sin(beta),
            z - depth * math.sin(alpha) * math.cos(beta),
        )

    across = [math.pi * i / segments for i in range(segments + 1)]
    wall = [(p[0], bottom, p[2]) for p in (point(alpha, 0.0) for alpha in across)]
    mesh.grid([wall] + [[point(a, math.pi / 2 * j / rows) for a in across]
        for j in range(rows + 1)])
    for a, b in zip(wall, wall[1:]):
        mesh.triangle((x, bottom, z), b, a)
    return mesh


def niche_outline(x, half_width, bottom, spring, rows=8):
    """Rim of `niche`, with a point in the middle of the sill."""
    head = []
    for j in range(2 * rows + 1):
        beta = math.pi / 2 * j / rows
        head.append((x + half_width * math.cos(beta), spring + half_width * math.sin(beta)))
    return [(x - half_width, bottom), (x, bottom), (x + half_width, bottom)] + head


def loft(rings, crease=SMOOTH):
    """Skin over closed rings of points, all of one length, with a flat lid at either end."""
    mesh = Mesh(crease)
    mesh.grid([ring + ring[:1] for ring in rings])
    _lid(mesh, rings[0], flip=True)
    _lid(mesh, rings[-1], flip=False)
    return mesh.facing_outward()


def _lid(mesh, ring, flip):
    """Closes a plane ring; `flip` for the ring seen from its back."""
    normal = (0.0, 0.0, 0.0)
    for a, b in zip(ring, ring[1:] + ring[:1]):
        normal = v.add(normal, v.cross(v.sub(a, ring[0]), v.sub(b, ring[0])))
    if v.length(normal) < 1e-9:
        return  # the ring is a point
    normal = v.normalized(normal)
    side = (1.0, 0.0, 0.0) if abs(normal[0]) < 0.8 else (0.0, 1.0, 0.0)
    s = v.normalized(v.cross(side, normal))
    t = v.cross(normal, s)
    point_at = {(v.dot(p, s), v.dot(p, t)): p for p in ring}
    for a, b, c in triangulate(list(point_at)):
        a, b, c = point_at[a], point_at[b], point_at[c]
        mesh.triangle(a, *((c, b) if flip else (b, c)))


def lathe(profile, segments, crease=SMOOTH):
    """Turns (radius, y) points, from the bottom up, about the y axis."""
    return loft([ring_y(radius, y, segments) for radius, y in profile], crease)


def hoop(profile, segments, crease=SMOOTH):
    """Turns a closed profile of (radius, y) points about the y axis: a ring, like a torus."""
    mesh = Mesh(crease)
    rings = [ring_y(radius, y, segments) for radius, y in profile]
    mesh.grid([ring + ring[:1] for ring in rings + rings[:1]])
    return mesh.facing_outward()


def ring_y(radius, y, segments, depth=None):
    """Points of a circle (an ellipse with `depth` along z) in the plane at height y."""
    depth = radius if depth is None else depth
    points = []
    for i in range(segments):
        t = 2.0 * math.pi * i / segments
        points.append((radius * math.cos(t), y, -depth * math.sin(t)))
    return points


def sphere(radius, segments=32, rows=16, centre=(0.0, 0.0, 0.0)):
    profile = []
    for i in range(rows + 1):
        t = math.pi * (i / rows - 0.5)
        profile.append((radius * math.cos(t) if 0 < i < rows else 0.0, radius * math.sin(t)))
    return lathe(profile, segments).moved(*centre)


def tube(path, radii, segments=12):
    """Round rod along a path of points with a radius at each."""
    rings = []
    for i, (point, radius) in enumerate(zip(path, radii)):
        ahead = v.normalized(v.sub(path[min(i + 1, len(path) - 1)], path[max(i - 1, 0)]))
        side = (0.0, 0.0, 1.0) if abs(ahead[2]) < 0.9 else (1.0, 0.0, 0.0)
        s = v.normalized(v.cross(ahead, side))
        t = v.cross(ahead, s)
        ring = []
        for k in range(segments):
            a = 2.0 * math.pi * k / segments
            ring.append(
                v.add(point, v.add(v.scale(s, radius * math.cos(a)),
                    v.scale(t, radius * math.sin(a))))
            )
        rings.append(ring)
    return loft(rings)


def moulding(profile, path, crease=SMOOTH):
    """Draws a profile along a path.

    `profile`: (across, out) points. `path`: (origin, across, out) per station, the last two being
    the directions into which the profile's coordinates are laid.
    """
    rings = []
    for origin, across, out in path:
        ring = []
        for s, t in profile:
            ring.append(v.add(origin, v.add(v.scale(across, s), v.scale(out, t))))
        rings.append(ring)
    return loft(rings, crease)


def arch_path(x, spring, radius, z, jamb=0.0, segments=24):
    """Stations around a round arch in the plane at z: across is away from the arch's centre, out
    is +z. `jamb`: how far the path goes on below the spring on both sides."""
    stations = []
    if jamb > 0.0:
        stations.append(((x + radius, spring - jamb, z), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)))
    for i in range(segments + 1):
        t = math.pi * i / segments
        across = (math.cos(t), math.sin(t), 0.0)
        stations.append(
            ((x + radius * across[0], spring + radius * across[1], z), across, (0.0, 0.0, 1.0))
        )
    if jamb > 0.0:
        stations.append(((x - radius, spring - jamb, z), (-1.0, 0.0, 0.0), (0.0, 0.0, 1.0)))
    return stations


def straight_path(start, end, across=(0.0, 1.0, 0.0), out=(0.0, 0.0, 1.0)):
    """Two stations with fixed directions."""
    return [(start, across, out), (end, across, out)]


def bar(start, end, width, height, up=(0.0, 1.0, 0.0)):
    """Square-edged bar between two points; `height` is measured along `up`, which it must not
    be parallel to."""
    ahead = v.normalized(v.sub(end, start))
    side = v.normalized(v.cross(ahead, up))
    w, h = width / 2.0, height / 2.0
    profile = [(-w, -h), (w, -h), (w, h), (-w, h)]
    return moulding(profile, straight_path(start, end, side, v.cross(side, ahead)), crease=0.0)


def rod(start, end, radius, segments=6):
    """Round bar of one radius."""
    return cord([start, end], [radius, radius], segments)


def cord(path, radii, segments=5):
    """A tube that looks round with few sides, five at least; its ends stay sharp."""
    mesh = tube(path, radii, segments)
    mesh.crease = 80.0
    return mesh


def sheet(point, across, down, crease=60.0):
    """A single surface without thickness: `point(s, t)` for s and t in [0, 1]; it faces the
    direction of growing s x growing t."""
    mesh = Mesh(crease)
    mesh.grid([[point(i / across, j / down) for i in range(across + 1)] for j in range(down + 1)])
    return mesh
