# SPDX-License-Identifier: MIT
"""Plants of cards: each card is a picture on two quads that are folded along the middle."""

import math
import random

from .. import shapes
from .. import vector as v
from ..mesh import DIGITS, Vertices


def card(foot, up, side, width, height, fold=0.18):
    """A card whose lower edge is centred on `foot`; `up` and `side` are unit vectors at a right
    angle, it faces side x up and is folded away from there at its edges."""
    out, face = Vertices(), v.cross(side, up)
    for i, s in enumerate((-1.0, 0.0, 1.0)):
        back = -fold * width * abs(s)
        normal = v.normalized(v.add(face, v.scale(side, 1.4 * fold * s)))
        for t in (0.0, 1.0):
            p = v.add(v.add(foot, v.scale(side, 0.5 * width * s)), v.add(v.scale(up, height * t),
                v.scale(face, back)))
            out.positions.append(_rounded(p))
            out.normals.append(v.normalized(_rounded(normal)))
            out.texcoords.append((0.5 + 0.5 * s, 1.0 - t))
    out.indices = [0, 2, 3, 0, 3, 1, 2, 4, 5, 2, 5, 3]
    return out


def _rounded(p):
    return tuple(round(x, DIGITS) + 0.0 for x in p)


def _toward(direction, roll):
    """(up, side) with `up` that way, turned about it by `roll` radians."""
    up = v.normalized(direction)
    level = (0.0, 1.0, 0.0) if abs(up[1]) < 0.95 else (1.0, 0.0, 0.0)
    a = v.normalized(v.cross(up, level))
    b = v.cross(up, a)
    return up, v.add(v.scale(a, math.cos(roll)), v.scale(b, math.sin(roll)))


def _direction(chance, low=-1.0):
    """Evenly over the part of the sphere above the height `low`."""
    y, a = low + (1.0 - low) * chance.random(), 2.0 * math.pi * chance.random()
    r = math.sqrt(1.0 - y * y)
    return (r * math.cos(a), y, r * math.sin(a))


def clump(seed, count, radius, size, low=-0.6):
    """Cards that grow from inside a ball of that radius outward, upward rather than down."""
    chance, out = random.Random(seed), Vertices()
    for _ in range(count):
        d = _direction(chance, low)
        foot = v.scale(d, radius * (0.25 + 0.55 * chance.random()))
        lean = v.add(d, v.add((0.0, 0.25, 0.0), v.scale(_direction(chance), 0.45)))
        up, side = _toward(lean, 2.0 * math.pi * chance.random())
        long = size * (0.75 + 0.5 * chance.random())
        out.extend(card(foot, up, side, 0.95 * long, long))
    return out


def ivy_patch(seed, count=46, half=0.62):
    """Cards that lie against a wall in the plane z = 0, a little off it, most hanging up."""
    chance, out = random.Random(seed), Vertices()
    for _ in range(count):
        a, r = 2.0 * math.pi * chance.random(), half * math.sqrt(chance.random())
        foot = (r * math.cos(a), r * math.sin(a), 0.015 + 0.04 * chance.random())
        roll = 1.5 * (chance.random() - 0.5) + (0.5 if chance.random() < 0.3 else 0.0)
        lift = 0.10 + 0.42 * chance.random()
        up = v.normalized((math.sin(roll), math.cos(roll), lift))
        side = v.normalized((math.cos(roll), -math.sin(roll), 0.25 * (chance.random() - 0.5)))
        side = v.normalized(v.sub(side, v.scale(up, v.dot(side, up))))
        long = 0.30 + 0.16 * chance.random()
        out.extend(card(foot, up, side, long, long, 0.12))
    return out


def tufts(seed, count, half, height):
    """Upright cards over a square of the ground."""
    chance, out = random.Random(seed), Vertices()
    for _ in range(count):
        x, z = half * (2.0 * chance.random() - 1.0), half * (2.0 * chance.random() - 1.0)
        a = 2.0 * math.pi * chance.random()
        long = height * (0.7 + 0.6 * chance.random())
        for k in range(2):
            b = a + math.pi * (0.5 * k + 0.1 * chance.random())
            lean = 0.25 * (chance.random() - 0.5)
            side = (math.cos(b), 0.0, math.sin(b))
            up = v.normalized((-lean * math.sin(b), 1.0, lean * math.cos(b)))
            out.extend(card((x, -0.02, z), up, side, 1.15 * long, long, 0.06))
    return out


def fern(seed, count=13, size=0.62):
    """Fronds that rise from one foot and bend over: each two cards end to end."""
    chance, out = random.Random(seed), Vertices()
    for k in range(count):
        a = 2.0 * math.pi * (k + 0.6 * chance.random()) / count
        long, rise = size * (0.8 + 0.4 * chance.random()), 0.55 + 0.75 * chance.random()
        c, s = math.cos(a), math.sin(a)
        side, rows = (-s, 0.0, c), []
        for i in range(5):
            t = i / 4.0
            r = long * (t - 0.12 * t * t)
            rows.append((t, (c * r, 0.02 + long * rise * t * (1.0 - 0.62 * t), s * r)))
        first = len(out.positions)
        for t, p in rows:
            for w in (-1.0, 1.0):
                out.positions.append(_rounded(v.add(p, v.scale(side, 0.26 * long * w))))
                slope = v.normalized((c, rise * (1.0 - 1.24 * t), s))
                out.normals.append(v.normalized(_rounded(v.cross(slope, side))))
                out.texcoords.append((0.5 + 0.5 * w, 1.0 - t))
        for i in range(4):
            b = first + 2 * i
            out.indices += [b, b + 2, b + 1, b + 1, b + 2, b + 3]
    return out


class Tree:
    """Trunk and boughs as tubes, and where clumps of leaves belong."""

    def __init__(self, seed, height, reach, girth):
        self.chance = random.Random(seed)
        self.wood, self.clumps = [], []
        bend = lambda: 0.10 * (self.chance.random() - 0.5) * height
        fork = 0.42 * height
        trunk = [(0.0, -0.05, 0.0), (0.1 * bend(), 0.10 * fork, 0.1 * bend()), (0.4 * bend(), 0.5
            * fork, 0.4 * bend()), (bend(), fork, bend())]
        self.wood.append(shapes.cord(trunk, [1.6 * girth, 1.1 * girth, 0.9 * girth, 0.72 * girth],
            12))
        count = 6
        for k in range(count):
            a = 2.0 * math.pi * (k + 0.5 * self.chance.random()) / count
            rise = 0.55 + 0.75 * (k % 3) / 2.0 + 0.15 * self.chance.random()
            self._bough(trunk[-1], (math.cos(a), rise, math.sin(a)), reach * (0.62 + 0.3
                * self.chance.random()), 0.50 * girth, 2)

    def _bough(self, start, direction, length, girth, depth):
        d = v.normalized(direction)
        drift = v.scale(_direction(self.chance), 0.22)
        middle = v.add(v.add(start, v.scale(d, 0.5 * length)), v.scale(drift, 0.35 * length))
        d2 = v.normalized(v.add(v.add(d, drift), (0.0, 0.12, 0.0)))
        end = v.add(middle, v.scale(d2, 0.5 * length))
        back = v.sub(start, v.scale(d, 0.8 * girth))
        self.wood.append(shapes.cord([back, middle, end], [girth, 0.72 * girth, 0.40 * girth],
            7 if depth == 2 else 5))
        if depth == 0:
            self.clumps.append(end)
            return
        if depth == 1:
            self.clumps.append(v.add(end, (0.0, 0.05, 0.0)))
        for at, spread in ((end, 0.75), (end, 0.75), (middle, 0.9)):
            turn = v.add(d2, v.scale(_direction(self.chance, -0.25), spread))
            self._bough(at, turn, 0.58 * length, 0.45 * girth, depth - 1)
