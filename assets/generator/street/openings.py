# SPDX-License-Identifier: MIT
"""Windows and doors. The opening's sill is at the origin, centred; the wall's face is z = 0."""

from .. import shapes
from ..polygon import arched, rectangle

REVEAL = 0.16  # the frames stand so far behind the wall's face


def outline(width, height, head="flat"):
    """The hole in the wall; `head`: flat or arch."""
    if head == "arch":
        return arched(0.0, width / 2.0, 0.0, height - width / 2.0, 14)
    return rectangle(-width / 2.0, 0.0, width / 2.0, height)


def _sashes(width, height, columns, rows, head="flat"):
    """Frame with glazing bars and a pane: (frame, pane)."""
    w, z0, z1 = 0.055, -REVEAL - 0.06, -REVEAL
    x0, y0 = -width / 2.0, 0.0
    top = height if head == "flat" else height - width / 2.0
    holes = []
    pane_w = (width - w * (columns + 1)) / columns
    pane_h = (top - w * (rows + 1)) / rows
    for i in range(columns):
        for j in range(rows):
            x, y = x0 + w + i * (pane_w + w), y0 + w + j * (pane_h + w)
            holes.append(rectangle(x, y, x + pane_w, y + pane_h))
    outer = outline(width + 0.02, height + 0.01, head)
    if head == "arch":
        holes.append(shapes.counter_clockwise(
            [(x * (width / 2.0 - w), top + y * (width / 2.0 - w)) for x, y in _half_disc()]))
    frame = shapes.prism(outer, z0, z1, holes, crease=0.0)
    pane = shapes.prism(outline(width + 0.02, height + 0.01, head), z0 + 0.02, z0 + 0.03, (), 0.0)
    return frame, pane


def _half_disc():
    return [(x, y) for x, y in arched(0.0, 1.0, 0.03, 0.0, 10)[2:] if y > 0.02] + [(-1.0, 0.03),
        (1.0, 0.03)]


def _sill(width, deep=0.10):
    return shapes.chamfered((-width / 2.0 - 0.10, -0.09, -0.10), (width / 2.0 + 0.10, 0.012, deep),
        0.015)


def _architrave(width, height, head, wide=0.13, out=0.045):
    """Band around the opening, a little outside its edge."""
    inner = outline(width + 0.02, height + 0.01, head)
    outer = outline(width + 2.0 * wide, height + wide, head)
    legs = [(x, max(y, 0.005)) for x, y in inner]
    if head == "flat":
        points = [outer[0], legs[0], legs[3], legs[2], legs[1], outer[1], outer[2], outer[3]]
    else:
        # From the left foot of the outer edge around, and back along the inner edge.
        points = outer[1:] + [outer[0], legs[0]] + legs[:1:-1] + [legs[1]]
    return shapes.prism(points, -0.02, out)


def window(width, height, head="flat", top=None, shutters=False, rows=3):
    """`top`: None, "cornice" or "pediment" over it."""
    frame, pane = _sashes(width, height, 2, rows, head)
    stone = [_sill(width), _architrave(width, height, head)]
    half = width / 2.0 + 0.2
    if top is not None:
        profile = [(0.0, -0.02), (0.0, 0.06), (0.05, 0.09), (0.09, 0.15), (0.12, 0.15),
            (0.12, -0.02)]
        stone.append(shapes.moulding([(s + height + 0.16, t) for s, t in profile],
            shapes.straight_path((-half, 0.0, 0.0), (half, 0.0, 0.0)), crease=0.0))
        for x in (-half + 0.07, half - 0.07):
            stone.append(shapes.box((x - 0.05, height - 0.08, -0.02), (x + 0.05, height + 0.17,
                0.07)))
    if top == "pediment":
        low = height + 0.27
        stone.append(shapes.prism([(-half + 0.02, low), (half - 0.02, low), (0.0, low + 0.27)],
            -0.02, 0.05))
        for side in (-1, 1):
            stone.append(shapes.bar((side * (half + 0.01), low + 0.015, 0.06), (-side * 0.02,
                low + 0.31, 0.06), 0.13, 0.06, (0.0, 1.0, 0.0)))
    elif head == "arch":
        stone.append(shapes.prism([(-0.07, height - 0.02), (0.07, height - 0.02), (0.11,
            height + 0.24), (-0.11, height + 0.24)], -0.02, 0.085, crease=0.0))
    pieces = [("white paint", [frame]), ("glass", [pane]), ("stone", stone)]
    if shutters:
        wood = []
        for side in (-1, 1):
            for leaf in _shutter(width / 2.0, height):
                wood.append(leaf.moved(side * (width / 2.0 + 0.15 + width / 4.0), 0.0, 0.062))
        pieces.append(("shutters", wood))
    return pieces


def _shutter(width, height):
    """A leaf with slanting slats, centred on x = 0."""
    w = width / 2.0
    parts = [shapes.prism(rectangle(-w, 0.02, w, height), -0.014, 0.022,
        [rectangle(-w + 0.05, 0.08, w - 0.05, height / 2.0 - 0.03),
            rectangle(-w + 0.05, height / 2.0 + 0.03, w - 0.05, height - 0.06)], crease=0.0)]
    for low, high in ((0.08, height / 2.0 - 0.03), (height / 2.0 + 0.03, height - 0.06)):
        count = int((high - low) / 0.075)
        for i in range(count):
            y = low + (i + 0.5) * (high - low) / count
            parts.append(shapes.bar((-w + 0.03, y, 0.004), (w - 0.03, y, 0.004), 0.008, 0.06,
                (0.0, 0.86, -0.5)))
    return parts


def door(width, height, paint="black paint"):
    """Panelled door under a fanlight, with two steps."""
    light = 0.55
    w, tall = width / 2.0, height - light
    panels = []
    for side in (-1, 1):
        for low, high in ((0.15, 0.72), (0.84, tall - 0.15)):
            a, b = sorted((side * 0.06, side * (w - 0.09)))
            panels.append(rectangle(a, low, b, high))
    leaf = shapes.prism(rectangle(-w - 0.01, 0.0, w + 0.01, tall), -0.24, -0.19, panels, crease=0.0)
    back = shapes.box((-w - 0.01, -0.005, -0.28), (w + 0.01, tall - 0.005, -0.215))
    frame, pane = _sashes(width, light, 3, 1)
    knob = shapes.sphere(0.03, 10, 6, (0.06, 1.0, -0.16))
    stone = [_architrave(width, height, "flat", 0.18, 0.06), shapes.box((-w - 0.28, -0.34, -0.30),
        (w + 0.28, 0.0, 0.22)), shapes.box((-w - 0.38, -0.34, -0.2), (w + 0.38, -0.10, 0.46))]
    profile = [(0.0, -0.02), (0.0, 0.10), (0.07, 0.14), (0.10, 0.26), (0.15, 0.26), (0.15, -0.02)]
    stone.append(shapes.moulding([(s + height + 0.2, t) for s, t in profile],
        shapes.straight_path((-w - 0.3, 0.0, 0.0), (w + 0.3, 0.0, 0.0)), crease=0.0))
    for x in (-w - 0.14, w + 0.14):
        stone.append(shapes.box((x - 0.07, height - 0.22, -0.02), (x + 0.07, height + 0.21, 0.12)))
    return [(paint, [leaf, back]), ("white paint", [frame.moved(y=tall)]), ("glass",
        [pane.moved(y=tall)]), ("stone", stone), ("chrome", [knob])]


def shopfront(width, height, paint="black paint"):
    """Wooden front: stallriser, mullions, door in the middle, pilasters, fascia."""
    w, wood, glass = width / 2.0, [], []
    bar, z0, z1 = 0.07, -REVEAL - 0.07, -REVEAL + 0.01
    door_w = 0.5
    bays = ((-w + 0.02, -door_w - bar), (door_w + bar, w - 0.02))
    holes = []
    for a, b in bays:
        step = (b - a) / 3.0
        for i in range(3):
            low, high = a + i * step + bar / 2.0, a + (i + 1) * step - bar / 2.0
            holes.append(rectangle(low, 0.62, high, height - 0.62))
            holes.append(rectangle(low, height - 0.55, high, height - 0.10))
        wood.append(shapes.box((a, 0.10, z1 - 0.02), (b, 0.50, z1 + 0.03)))
    holes.append(rectangle(-door_w + 0.10, 0.85, door_w - 0.10, height - 0.72))
    holes.append(rectangle(-door_w + 0.10, height - 0.55, door_w - 0.10, height - 0.10))
    wood.append(shapes.prism(rectangle(-w - 0.01, 0.0, w + 0.01, height + 0.01), z0, z1, holes,
        crease=0.0))
    glass.append(shapes.box((-w, 0.02, z0 + 0.02), (w, height, z0 + 0.032)))
    for x in (-w - 0.13, w + 0.13):
        wood.append(shapes.box((x - 0.15, -0.30, -0.02), (x + 0.15, height - 0.02, 0.09)))
        wood.append(shapes.box((x - 0.19, -0.30, -0.02), (x + 0.19, 0.34, 0.13)))
        wood.append(shapes.box((x - 0.19, height - 0.14, -0.02), (x + 0.19, height + 0.42, 0.18)))
    wood.append(shapes.box((-w - 0.10, height - 0.04, -0.02), (w + 0.10, height + 0.40, 0.11)))
    profile = [(0.0, -0.02), (0.0, 0.14), (0.05, 0.20), (0.08, 0.28), (0.12, 0.28), (0.12, -0.02)]
    wood.append(shapes.moulding([(s + height + 0.39, t) for s, t in profile],
        shapes.straight_path((-w - 0.36, 0.0, 0.0), (w + 0.36, 0.0, 0.0)), crease=0.0))
    letters, x = [], -w * 0.55
    for k in range(13):  # a name in block letters, none of any alphabet
        if k % 6 != 5:
            wide = 0.11 + 0.03 * (k % 3)
            letters.append(shapes.prism(rectangle(x, height + 0.08, x + wide, height + 0.29), 0.10,
                0.125, [rectangle(x + 0.035, height + 0.13 + 0.03 * (k % 2), x + wide - 0.03,
                    height + 0.25)], crease=0.0))
        x += w * 1.1 / 13
    knob = shapes.sphere(0.035, 10, 6, (-door_w + 0.05, 1.05, z1 + 0.03))
    return [(paint, wood), ("glass", glass), ("canvas", letters), ("chrome", [knob])]
