# SPDX-License-Identifier: MIT
"""The pictures on the leaf cards: twigs with leaves, ivy, grass, daisies, a fern's frond."""

import math
import random

from ..textures import Painting

SIZE = 128


def _leaf(painting, base, angle, length, width, tone, lobes=0):
    """A pointed leaf from its base; with `lobes` its outline swells and shrinks (ivy)."""
    c, s = math.cos(angle), math.sin(angle)

    def outline(x, y):
        dx, dy = x - base[0], y - base[1]
        along, across = (c * dx + s * dy) / length, -s * dx + c * dy
        if not 0.0 < along < 1.0:
            return 0.05, tone
        half = width * (4.0 * along * (1.0 - along)) ** 0.7 * (1.25 - 0.5 * along)
        if lobes:
            half = width * (0.35 + 0.75 * abs(math.sin(math.pi * (along * lobes * 0.5 + 0.12)))) * (
                1.0 - along) ** 0.55 * min(1.0, 9.0 * along)
        vein = 0.10 if abs(across) < 0.004 else 0.0
        side = abs(across) / max(half, 1e-6)
        ribs = 0.05 * math.sin(40.0 * along - 26.0 * abs(across) / width)
        light = tone + vein + ribs + (0.10 if across > 0.0 else -0.06) - 0.16 * side * side
        return abs(across) - half, light

    reach = length + 2.0 * width
    painting.paint((base[0] - reach, base[1] - reach), (base[0] + reach, base[1] + reach), outline)


def _stem(painting, points, thick, tone):
    for (ax, ay), (bx, by) in zip(points, points[1:]):
        dx, dy = bx - ax, by - ay
        dd = dx * dx + dy * dy

        def outline(x, y):
            t = min(1.0, max(0.0, ((x - ax) * dx + (y - ay) * dy) / dd))
            return math.sqrt((x - ax - t * dx) ** 2 + (y - ay - t * dy) ** 2) - thick, tone

        painting.paint((min(ax, bx) - thick, min(ay, by) - thick), (max(ax, bx) + thick, max(ay, by)
            + thick), outline)


def twig():
    """A twig that grows up from the middle of the lower edge, with eleven leaves."""
    painting, chance = Painting(SIZE), random.Random(1)
    spine = [(0.5 + 0.06 * math.sin(3.0 * t), 0.99 - 0.80 * t) for t in (i / 8.0 for i in range(9))]
    _stem(painting, spine, 0.010, 0.12)
    for i, (x, y) in enumerate(spine[1:]):
        for side in (-1, 1):
            lean = -math.pi / 2.0 + side * (1.05 - 0.05 * i + 0.25 * chance.random())
            long = 0.31 + 0.08 * chance.random() - 0.018 * i
            if i % 2 == (side > 0) or i > 4:
                _leaf(painting, (x, y), lean, long, 0.068, 0.40 + 0.35 * chance.random())
    _leaf(painting, spine[-1], -math.pi / 2.0, 0.19, 0.05, 0.72)
    return painting


def ivy():
    """Lobed leaves in rows on a winding stem."""
    painting, chance = Painting(SIZE), random.Random(2)
    spine = [(0.5 + 0.13 * math.sin(5.0 * t), 0.98 - 0.9 * t) for t in (i / 10.0 for i in
        range(11))]
    _stem(painting, spine, 0.009, 0.10)
    for i, (x, y) in enumerate(spine):
        side = 1 if i % 2 else -1
        angle = -math.pi / 2.0 + side * (1.15 + 0.5 * chance.random())
        start = (x + 0.05 * math.cos(angle), y + 0.05 * math.sin(angle))
        _stem(painting, [(x, y), start], 0.006, 0.2)
        _leaf(painting, start, angle, 0.27, 0.125, 0.30 + 0.45 * chance.random(), 3)
        if i % 2 == 0:
            other = -math.pi / 2.0 - side * (0.7 + 0.5 * chance.random())
            _leaf(painting, (x, y), other, 0.22, 0.10, 0.35 + 0.4 * chance.random(), 3)
    return painting


def grass():
    """Blades from the lower edge that bend over."""
    painting, chance = Painting(SIZE), random.Random(3)
    for k in range(26):
        foot = 0.08 + 0.84 * chance.random()
        tall, lean = 0.45 + 0.5 * chance.random(), 0.5 * (chance.random() - 0.5)
        wide, tone = 0.011 + 0.009 * chance.random(), 0.25 + 0.6 * chance.random()

        def outline(x, y):
            up = (1.0 - y) / tall
            if up > 1.0:
                return 0.05, tone
            middle = foot + lean * up * up
            return abs(x - middle) - wide * (1.0 - up) ** 0.6, tone * (0.55 + 0.45 * up) + (0.06
                if x > middle else 0.0)

        painting.paint((foot - 0.32, 1.0 - tall), (foot + 0.32, 1.0), outline)
    return painting


def daisies():
    """Five flowers above leaves. Shades from 0.6 on are petals, 1 their hearts."""
    painting, chance = Painting(SIZE), random.Random(4)
    for k in range(7):
        angle = -math.pi / 2.0 + (k - 3) * 0.30
        _leaf(painting, (0.5, 0.99), angle, 0.36 + 0.12 * chance.random(), 0.035, 0.10 + 0.3
            * chance.random())
    for x, y in ((0.20, 0.42), (0.42, 0.20), (0.63, 0.34), (0.82, 0.18), (0.80, 0.56)):
        bend = 0.5 + 0.5 * (x - 0.5)
        _stem(painting, [(0.5, 0.98), (bend, 0.5 * (y + 0.9)), (x, y)], 0.009, 0.22)
        turn, petals = chance.random(), 11

        def flower(px, py):
            dx, dy = px - x, (py - y) * 1.25
            r = math.sqrt(dx * dx + dy * dy)
            a = math.atan2(dy, dx) / (2.0 * math.pi) * petals + turn
            edge = 0.066 + 0.052 * abs(math.sin(math.pi * a)) ** 0.6
            shade = 1.0 if r < 0.036 else 0.66 + 0.14 * min(1.0, r / 0.11)
            return r - edge, shade

        painting.paint((x - 0.13, y - 0.13), (x + 0.13, y + 0.13), flower)
    return painting


def frond():
    """A fern's frond: leaflets in pairs, shorter towards the tip."""
    painting = Painting(SIZE)
    spine = [(0.5 + 0.03 * math.sin(2.5 * t), 0.99 - 0.95 * t) for t in (i / 16.0 for i in
        range(17))]
    _stem(painting, spine, 0.008, 0.2)
    for i, (x, y) in enumerate(spine[1:-1]):
        long = 0.40 * math.sin(math.pi * (0.22 + 0.76 * i / 16.0)) ** 0.9
        for side in (-1, 1):
            _leaf(painting, (x, y), -math.pi / 2.0 + side * 1.22, long, 0.021, 0.35 + 0.3 * i / 16.0
                + 0.1 * side)
    return painting


GREENS = [(30, 50, 16), (66, 110, 34), (112, 156, 54), (180, 204, 100)]
DEEP = [(24, 46, 22), (52, 94, 40), (88, 136, 62), (158, 186, 122)]
COPPER = [(48, 18, 16), (112, 38, 30), (164, 66, 44), (214, 128, 92)]
MEADOW = [(58, 76, 22), (100, 140, 42), (150, 182, 70), (204, 214, 128)]
FLOWERS = [(36, 68, 26), (82, 124, 50), (110, 146, 70), (238, 238, 236), (250, 250, 248), (236, 176,
    30)]

# name: (painting, ramp of colours)
ALL = {
    "twig": (twig, GREENS), "copper twig": (twig, COPPER), "ivy": (ivy, DEEP), "grass": (grass,
        MEADOW), "daisies": (daisies, FLOWERS), "frond": (frond, GREENS),
}
