# SPDX-License-Identifier: MIT
"""Six designs of houses, without what they share. A house's face is z = 0, from x = 0 on."""

from .. import shapes
from ..polygon import arc, rectangle
from . import openings, ornament
from . import plan as p

THICK = 0.4  # of the front walls; behind them the houses are solid


class House:
    """One design: a mesh of its own, and what else hangs on it, by name and place."""

    def __init__(self, design, storeys):
        self.width = p.WIDTHS[design]
        self.storeys = storeys
        self.top = p.EAVES[storeys - 2]
        self.pieces = {"cream": [], "stone": [], "plinth": [], "slate": [], "tiles": []}
        self.holes = []
        self.items = []  # (name, x, y, z)

    def put(self, name, x, y, z=0.0):
        self.items.append((name, x, y, z))

    def opening(self, name, x, y, hole):
        """An item in a hole of the wall."""
        self.holes.append([(x + px, y + py) for px, py in hole])
        self.put(name, x, y)

    def bays(self, count, margin=0.0):
        return [margin + (self.width - 2 * margin) * (i + 0.5) / count for i in range(count)]

    def crown(self, y, out):
        """Cornice with dentils."""
        self.pieces["stone"] += ornament.cornice(self.width, y, out)
        for x in ornament.runs(self.width):
            self.put("dentils", x, y)

    def balustrade(self, row):
        """Parapet on the cornice; `row`: the balusters that fit."""
        self.pieces["stone"] += ornament.parapet(self.width, self.top + 0.1)
        for x, z in ornament.parapet_gaps(self.width)[0]:
            self.put(row, x, self.top + 0.1, z)

    def finish(self, outline=None, body_top=None):
        """The walls, once all holes are known."""
        e = 0.01
        outline = outline or rectangle(e, p.LOW + 0.05, self.width - e, self.top)
        self.pieces["cream"].append(shapes.prism(outline, -THICK, 0.0, self.holes))
        body_top = body_top or self.top - 0.02
        self.pieces["cream"].append(shapes.box((e + 0.005, p.LOW + 0.05, -p.DEPTH), (self.width - e
            - 0.005, body_top, -THICK + 0.02)))
        solid = sorted((min(q[0] for q in h), max(q[0] for q in h)) for h in self.holes if
            min(q[1] for q in h) < 0.5)
        x = 0.02
        for low, high in solid + [(self.width - 0.02, None)]:
            if low - 0.2 - x > 0.1:
                self.pieces["plinth"].append(shapes.chamfered((x, p.LOW + 0.06, -0.02), (low - 0.2
                    if high else low, 0.62, 0.05), 0.03))
            x = (high or 0.0) + 0.2
        return self


def _flat_roof(house):
    """Covering behind the parapet, and chimneys."""
    house.pieces["slate"].append(shapes.box((0.05, house.top - 0.05, -p.DEPTH + 0.03), (house.width
        - 0.05, house.top + 0.10, -0.36)))
    for x, z in ((0.9, -2.4), (house.width - 0.9, -4.2)):
        house.put("chimney", x, house.top + 0.08, z)


def _shop():
    house = House("shop", 3)
    stone = house.pieces["stone"]
    house.opening("shopfront", 2.95 + 0.25, 0.14, openings.outline(5.2, 2.75))
    house.put("awning", 3.2, 3.12, 0.16)
    house.opening("door", house.width - 1.25, 0.30, openings.outline(1.2, 2.75))
    for x in house.bays(3, 0.4):
        house.opening("tall window", x, p.FLOORS[1] + 0.75, openings.outline(1.05, 1.85))
        house.opening("plain window", x, p.FLOORS[2] + 0.65, openings.outline(1.05, 1.55))
    house.crown(house.top - 0.2, 0.34)
    house.balustrade("balusters")
    stone += [ornament.band(house.width, 3.72), ornament.band(house.width, p.FLOORS[2] + 0.35,
        0.05, 0.12)]
    stone += ornament.quoins(0.28, 3.95, house.top - 0.3)
    stone += ornament.quoins(house.width - 0.28, 3.95, house.top - 0.3)
    _flat_roof(house)
    return house.finish()


def _gable():
    """Narrow, its gable with shoulders and a small pediment."""
    house = House("gable", 3)
    w, top = house.width, house.top
    for x in house.bays(2, 0.3):
        house.opening("arched window", x, p.FLOORS[1] + 0.55, openings.outline(1.1, 2.0, "arch"))
        house.opening("plain window", x, p.FLOORS[2] + 0.55, openings.outline(1.05, 1.55))
    house.opening("door", 1.35, 0.30, openings.outline(1.2, 2.75))
    house.opening("big arch", 4.05, 0.55, openings.outline(2.1, 2.75, "arch"))
    left = [(0.01, top), (0.01, top - 0.6), (0.75, top - 0.6)]
    left += [(0.75 + 0.85 * x, top - 0.6 + 0.95 * y) for x, y in _ogee()]
    left += [(1.75, top + 0.55), (1.95, top + 0.75)]
    left = [(0.01, p.LOW + 0.05), (0.01, top - 0.35)] + left[2:]
    crown = arc(w / 2.0, top + 0.75, w / 2.0 - 1.95, 0.85, 180.0, 0.0, 14)[1:-1]
    right = [(w - x, y) for x, y in reversed(left)]
    outline = left + crown + right
    house.opening("small window", w / 2.0, top + 0.05, openings.outline(0.7, 0.95, "arch"))
    house.finish(outline, top - 0.9)
    for side in (0, 1):
        a = (0.02, top - 0.98) if side == 0 else (w - 0.02, top - 0.98)
        house.pieces["tiles"].append(shapes.bar((a[0], a[1], -p.DEPTH / 2.0 - 0.17), (w / 2.0
            + (0.05 if side == 0 else -0.05), top + 0.95, -p.DEPTH / 2.0 - 0.17), p.DEPTH - 0.38,
            0.16))
    house.pieces["cream"].append(shapes.prism([(0.1, top - 1.0), (w - 0.1, top - 1.0), (w / 2.0,
        top + 0.82)], -p.DEPTH + 0.05, -THICK + 0.015, crease=0.0))
    for y in (3.62, p.FLOORS[2] - 0.02):
        house.pieces["stone"].append(ornament.band(w, y))
    coping = outline[1:-1]
    stations = []
    for i, (x, y) in enumerate(coping):
        (ax, ay), (bx, by) = coping[max(i - 1, 0)], coping[min(i + 1, len(coping) - 1)]
        size = ((bx - ax) ** 2 + (by - ay) ** 2) ** 0.5
        across = (-(by - ay) / size, (bx - ax) / size, 0.0)
        stations.append(((x, y, 0.0), across, (0.0, 0.0, 1.0)))
    house.pieces["stone"].append(shapes.moulding(rectangle(-0.06, -THICK - 0.04, 0.07, 0.08),
        stations, crease=30.0))
    house.put("chimney", 4.9, top - 0.4, -4.6)
    return house


def _ogee():
    return [(0.0, 0.12), (0.30, 0.22), (0.60, 0.48), (0.75, 0.85), (1.0, 1.0)]


def _arcade():
    house = House("arcade", 3)
    stone = house.pieces["stone"]
    for i, x in enumerate(house.bays(4, 0.3)):
        if i == 1:
            house.opening("door", x, 0.30, openings.outline(1.2, 2.75))
        else:
            house.opening("big arch", x, 0.55, openings.outline(2.1, 2.75, "arch"))
        house.opening("corniced window", x, p.FLOORS[1] + 0.75, openings.outline(1.05, 1.85))
        house.opening("plain window", x, p.FLOORS[2] + 0.65, openings.outline(1.05, 1.55))
    for i in range(5):  # pilasters over two storeys
        x = 0.3 + (house.width - 0.6) * i / 4
        x = min(max(x, 0.32), house.width - 0.32)
        stone.append(shapes.box((x - 0.19, 3.85, -0.02), (x + 0.19, house.top - 0.15, 0.07)))
        stone.append(shapes.chamfered((x - 0.24, 3.84, -0.02), (x + 0.24, 4.2, 0.11), 0.03))
        stone.append(shapes.box((x - 0.25, house.top - 0.45, -0.02), (x + 0.25, house.top - 0.12,
            0.13)))
    stone.append(ornament.band(house.width, 3.62, 0.12, 0.24))
    house.crown(house.top - 0.2, 0.42)
    house.balustrade("more balusters")
    _flat_roof(house)
    return house.finish()


def _mansard():
    house = House("mansard", 2)
    w, top = house.width, house.top
    house.opening("narrow shopfront", 2.35, 0.14, openings.outline(3.6, 2.75))
    house.put("narrow awning", 2.35, 3.12, 0.16)
    house.opening("door", w - 1.25, 0.30, openings.outline(1.2, 2.75))
    for x in house.bays(3, 0.2):
        house.opening("shuttered window", x, p.FLOORS[1] + 0.75, openings.outline(1.0, 1.6))
    house.crown(top - 0.25, 0.30)
    house.pieces["stone"].append(ornament.band(w, 3.72))
    rings = []
    for y, inset, back in ((top - 0.04, 0.02, 0.02), (top + 1.9, 0.14, 0.5), (top + 2.05, 0.30,
            0.7), (top + 2.55, 0.62, 2.4)):
        front = -0.02 if inset < 0.1 else -0.12 - 4.0 * (inset - 0.02)
        rings.append([(inset * 0.4 + 0.02, y, front), (w - inset * 0.4 - 0.02, y, front), (w
            - inset * 0.4 - 0.02, y, -p.DEPTH + back), (inset * 0.4 + 0.02, y, -p.DEPTH + back)])
    house.pieces["slate"].append(shapes.loft(rings, crease=0.0))
    for x in house.bays(2, 0.9):
        house.put("dormer", x, top + 0.35, -0.08)
    for x in (0.62, w - 0.62):
        house.put("chimney", x, top + 1.9, -3.2)
    return house.finish()


def _balcony():
    house = House("balcony", 3)
    stone = house.pieces["stone"]
    for i, x in enumerate(house.bays(3, 0.5)):
        if i == 1:
            house.opening("door", x, 0.30, openings.outline(1.2, 2.75))
        else:
            house.opening("big arch", x, 0.55, openings.outline(2.1, 2.75, "arch"))
        house.opening("long window", x, p.FLOORS[1] + 0.32, openings.outline(1.15, 2.25))
        house.opening("shuttered window", x, p.FLOORS[2] + 0.60, openings.outline(1.0, 1.6))
        house.put("balcony", x, p.FLOORS[1] + 0.30)
    house.crown(house.top - 0.2, 0.46)
    stone += ornament.quoins(0.28, 0.7, house.top - 0.3)
    stone += ornament.quoins(house.width - 0.28, 0.7, house.top - 0.3)
    w, top = house.width, house.top
    for side in (0, 1):  # a low roof, its ridge along the street
        z0, z1 = (0.30, -p.DEPTH / 2.0 - 0.05) if side == 0 else (-p.DEPTH + 0.08,
            -p.DEPTH / 2.0 + 0.05)
        house.pieces["tiles"].append(shapes.bar((w / 2.0, top + 0.06, z0), (w / 2.0, top + 1.25,
            z1), w - 0.03, 0.14, (0.0, 1.0, 0.0)))
    house.pieces["cream"].append(shapes.prism([(-0.1, top - 0.03), (p.DEPTH - 0.15, top - 0.03),
        (p.DEPTH / 2.0, top + 1.14)], 0.04, w - 0.04, crease=0.0).mapped(
            lambda q: (q[2], q[1], -q[0]), flip=False).facing_outward())
    for x in (1.2, w - 1.2):
        house.put("chimney", x, top + 0.5, -p.DEPTH / 2.0 - 0.9)
    return house.finish()


def _corner():
    house = House("corner", 3)
    w, stone = house.width, house.pieces["stone"]
    house.opening("narrow shopfront", 2.3, 0.14, openings.outline(3.6, 2.75))
    house.opening("door", w - 1.15, 0.30, openings.outline(1.2, 2.75))
    for x in house.bays(3, 0.3):
        house.opening("arched window", x, p.FLOORS[1] + 0.55, openings.outline(1.1, 2.0, "arch"))
        house.opening("plain window", x, p.FLOORS[2] + 0.65, openings.outline(1.05, 1.55))
    house.put("long balcony", w / 2.0, p.FLOORS[2] + 0.44)
    house.crown(house.top - 0.2, 0.38)
    stone += [ornament.band(w, 3.72), shapes.prism([(0.3, house.top + 0.13), (w - 0.3,
        house.top + 0.13), (w / 2.0, house.top + 1.15)], -0.30, 0.12, crease=0.0)]
    for side in (0, 1):
        x = 0.2 if side == 0 else w - 0.2
        stone.append(shapes.bar((x, house.top + 0.16, -0.07), (w / 2.0 + (0.02 if side == 0 else
            -0.02), house.top + 1.26, -0.07), 0.58, 0.13))
    stone.append(shapes.lathe([(0.0, -0.1), (0.26, -0.1), (0.26, 0.0), (0.0, 0.06)], 24).along_y()
        .moved(w / 2.0, house.top + 0.52, 0.10).facing_outward())
    _flat_roof(house)
    return house.finish()


def all_designs():
    return {"shop": _shop(), "gable": _gable(), "arcade": _arcade(), "mansard": _mansard(),
        "balcony": _balcony(), "corner": _corner()}
