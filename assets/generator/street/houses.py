# SPDX-License-Identifier: MIT
"""The two rows of houses: designs in several colours, and what hangs on them as instances."""

from .. import shapes
from ..polygon import arched, rectangle
from . import openings, ornament
from . import plan as p
from .designs import all_designs


def _items(stage):
    """Meshes that several designs share."""
    window = openings.window
    items = {
        "tall window": window(1.05, 1.85, top="pediment"),
        "corniced window": window(1.05, 1.85, top="cornice"),
        "plain window": window(1.05, 1.55),
        "shuttered window": window(1.0, 1.6, shutters=True),
        "long window": window(1.15, 2.25, rows=4, top="cornice"),
        "arched window": window(1.1, 2.0, head="arch"),
        "small window": window(0.7, 0.95, head="arch", rows=2),
        "big arch": window(2.1, 2.75, head="arch", rows=2),
        "balcony": ornament.balcony(2.0),
        "long balcony": ornament.balcony(4.6),
        "chimney": ornament.chimney(1.9),
        "dormer": ornament.dormer(),
        "dentils": [("stone", ornament.dentils())],
        "balusters": [("stone", ornament.balusters(ornament.parapet_gaps(p.WIDTHS["shop"])[1]))],
        "more balusters": [("stone", ornament.balusters(ornament.parapet_gaps(p.WIDTHS["arcade"])[
            1]))],
        "downpipe": ornament.downpipe(6.0),
        "door": openings.door(1.2, 2.75),
        "shopfront": openings.shopfront(5.2, 2.75),
        "narrow shopfront": openings.shopfront(3.6, 2.75),
        "awning": ornament.awning(5.5, "red stripes"),
        "narrow awning": ornament.awning(3.9, "red stripes"),
    }
    return {name: stage.mesh(name, pieces) for name, pieces in items.items()}


def add_to(stage):
    items = _items(stage)
    designs = all_designs()
    meshes = {name: stage.mesh(name + " house", [(key, meshes) for key, meshes in
        house.pieces.items() if meshes]) for name, house in designs.items()}
    variants = {}

    def variant(kind, mesh, swap):
        key = (kind, *sorted(swap.items()))
        if key not in variants:
            variants[key] = stage.variant(mesh, swap)
        return variants[key]

    for side, row in ((-1, p.NORTH_SIDE), (1, p.SOUTH_SIDE)):
        x = p.WEST
        for entry in row:
            if entry is None:
                _passage(stage, x, side)
                x += p.PASSAGE
                continue
            design, wall, paint, cloth = entry
            house = designs[design]
            mesh = meshes[design] if wall == "cream" else variant(design, meshes[design],
                {"cream": wall})
            at, turn = ((x, 0.0, -p.FRONT), 0.0) if side < 0 else ((x + house.width, 0.0, p.FRONT),
                180.0)
            node = stage.doc.add_node(f"{design} house", mesh, at, turn)
            for name, *place in house.items:
                item = items[name]
                if name == "door" or name.endswith("shopfront"):
                    item = variant(name, item, {"black paint": paint})
                elif name.endswith("awning"):
                    item = variant(name, item, {"red stripes": cloth})
                stage.put(name, item, [tuple(place)], node)
            x += house.width
            if x < p.GATE - 1.0:  # at the joint to the next one
                stage.put("downpipe", items["downpipe"], [(house.width if side < 0 else 0.0, 0.0,
                    0.0)], node)


def _passage(stage, x, side):
    """A gap between two houses, closed at its back by a wall with a round-headed gate."""
    wall = shapes.prism(rectangle(0.04, p.LOW + 0.05, p.PASSAGE - 0.04, 4.2), -0.3, 0.0, [arched(
        p.PASSAGE / 2.0, 0.62, 0.13, 1.9)])
    gate = shapes.prism(arched(p.PASSAGE / 2.0, 0.63, 0.125, 1.905), -0.22, -0.14)
    turn, z = (0.0, -p.FRONT - 4.0) if side < 0 else (180.0, p.FRONT + 4.0)
    ground = shapes.box((0.005, p.LOW, -2.0), (p.PASSAGE - 0.005, 0.115, 4.2))
    stage.add("passage", [("stone", [wall]), ("green paint", [gate]), ("setts", [ground])], [(x
        + (p.PASSAGE if side > 0 else 0.0), 0.0, z, turn)])
