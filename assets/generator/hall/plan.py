# SPDX-License-Identifier: MIT
"""Where things are in the hall, its materials, and how its pieces are placed.

x runs along the nave, from the stairs (-x) to the portal (+x); z runs across. Metres.
"""

from ..gltf import Document

BAY = 2.8
AXES = [-7.3 + BAY * k for k in range(7)]  # x of the columns
MIDDLES = [x + BAY / 2.0 for x in AXES[:-1]]  # x of the bays between them
CORNER = 10.66  # x of the last columns of the gallery, above the portal
AISLE = 4.6  # z of the columns' axes
WALL_IN, WALL_OUT = 7.2, 8.15  # z of the side walls' faces
AISLE_MIDDLE = (AISLE + WALL_IN) / 2.0
WEST_IN, WEST_OUT = -9.5, -11.0  # x of the end wall's faces
EAST_IN, EAST_OUT = 9.5, 11.0  # x of the portal's faces
ARCADE_HALF = 0.30  # half the thickness of the arcades
SPRING = 3.0  # the arches begin here, at the columns' tops
CEILING = 4.40  # of the aisles
GALLERY = 4.68  # floor of the gallery
BEAM = 7.25  # underside of the beam that the gallery's columns carry
TOP = 8.1  # of the side walls
RISE = 0.18
STEPS = 13  # in either flight
TREAD, UPPER_TREAD = 0.30, 0.28
LANDING = STEPS * RISE
LANDING_EDGE = -7.5  # x
FLIGHT_HALF = 2.6  # half the width of the lower flight


class Plan:
    """The document in the making, and its materials."""

    def __init__(self):
        self.doc = Document("hall")
        add = self.doc.add_material
        self.wall = add("limestone", (0.64, 0.57, 0.46))
        self.trim = add("pale stone", (0.76, 0.72, 0.64))
        self.marble = add("white marble", (0.83, 0.81, 0.77))
        self.gilt = add("gilded stone", (0.70, 0.53, 0.27))
        self.light_tile = add("light tile", (0.72, 0.67, 0.58))
        self.dark_tile = add("dark tile", (0.10, 0.13, 0.12))
        self.red_tile = add("red tile", (0.42, 0.16, 0.10))
        self.joint = add("joint", (0.30, 0.27, 0.23))
        self.stair = add("stair stone", (0.66, 0.62, 0.56))
        self.carpet = add("carpet", (0.42, 0.035, 0.04))
        self.plaster = add("blue plaster", (0.13, 0.26, 0.38))
        self.coffer = add("coffer", (0.48, 0.25, 0.11))
        self.wood = add("dark wood", (0.24, 0.13, 0.07))
        self.clay = add("terracotta", (0.60, 0.24, 0.12))
        self.bronze = add("green bronze", (0.17, 0.36, 0.29))

    def add(self, name, pieces, places=((0.0, 0.0, 0.0, 0.0),)):
        """A mesh and its instances. `pieces`: (material, meshes) pairs; `places`: (x, y, z,
        degrees about y)."""
        mesh = self.doc.add_mesh(name, pieces)
        for x, y, z, turn in places:
            self.doc.add_node(name, mesh, (x, y, z), turn)

    def add_mirrored(self, name, pieces):
        """A mesh modelled in its place at z > 0, and its mirror image at z < 0."""
        for side in (1, -1):
            flipped = [(material, [m.scaled(1, 1, side) for m in meshes]) for material,
                meshes in pieces]
            self.add(name, flipped)


def outward(xs, y, z):
    """Places at each x on either side of the nave, where a piece's +z is turned away from it."""
    return [(x, y, side * z, 0.0 if side > 0 else 180.0) for side in (1, -1) for x in xs]


def inward(xs, y, z):
    """The same, a piece's +z turned towards the nave."""
    return [(x, y, side * z, 180.0 if side > 0 else 0.0) for side in (1, -1) for x in xs]


def spread(length, count):
    """`count` positions centred on 0 that share out a length."""
    return [length * ((i + 0.5) / count - 0.5) for i in range(count)]
