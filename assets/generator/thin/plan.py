# SPDX-License-Identifier: MIT
"""Where things are in the studio's garden, and its materials.

x runs along the house, z from its back wall (-) to the garden's fence (+). Metres.
"""

from ..stage import Stage

LENGTH = 9.6  # of the ground: the scene's longest side
BACK, FRONT = -3.4, 4.55  # z of its ends
CELL = LENGTH / 127.0  # a grid of 128 cells: 76 mm, and so thick are walls and roof
FLOOR = 0.30  # of house and veranda
WEST, EAST = -4.55, 1.75  # outer faces of the house
NORTH, SOUTH = -3.1, -0.35
PARTITION = -1.9  # x of the wall between the rooms, its west face
CEILING = 2.72
DECK_EAST, DECK_SOUTH = 2.55, 1.35
# (x or z from, to, sill, head) of each wall's windows and doors, above the floor
NORTH_WINDOWS = ((-4.15, -2.45, 0.85, 2.0), (-1.35, -0.05, 0.85, 2.0), (0.15, 1.35, 0.85, 2.0))
SOUTH_DOOR = (-1.35, 1.25, 0.0, 2.1)
SOUTH_WINDOW = (-4.1, -2.3, 0.7, 2.05)
EAST_WINDOW = (-2.75, -1.05, 0.75, 2.0)
PARTITION_DOOR = (-1.55, -0.75, 0.0, 2.05)
# x from, to, z from, to
SKYLIGHTS = ((-4.05, -2.45, -2.65, -1.15), (-1.25, 1.15, -2.55, -1.15))
FENCE = 3.12  # z; beyond it is the footpath


def new_stage():
    return Stage(
        "thin",
        {
            "plaster": (0.74, 0.70, 0.62),
            "roof": (0.16, 0.17, 0.18),
            "frame": (0.09, 0.24, 0.25),
            "floor boards": (0.40, 0.24, 0.13),
            "deck": (0.47, 0.34, 0.22),
            "cedar": (0.42, 0.22, 0.10),
            "lawn": (0.20, 0.30, 0.09),
            "paving": (0.50, 0.47, 0.42),
            "footpath joints": (0.24, 0.23, 0.21),
            "beech": (0.62, 0.44, 0.26),
            "dark wood": (0.17, 0.10, 0.06),
            "red lacquer": (0.52, 0.07, 0.05),
            "white paint": (0.80, 0.79, 0.75),
            "steel": (0.36, 0.38, 0.40),
            "blind": (0.78, 0.74, 0.64),
            "clay": (0.58, 0.25, 0.13),
            "books": (0.16, 0.25, 0.38),
            "ochre": (0.68, 0.42, 0.10),
            "paper": {"color": (0.82, 0.80, 0.74), "double_sided": True},
            "drawing": {"color": (0.66, 0.50, 0.34), "double_sided": True},
            "linen": {"color": (0.83, 0.82, 0.79), "double_sided": True},
            "indigo cloth": {"color": (0.06, 0.12, 0.34), "double_sided": True},
            "madder cloth": {"color": (0.55, 0.11, 0.08), "double_sided": True},
            "saffron cloth": {"color": (0.72, 0.44, 0.08), "double_sided": True},
            "leaf": {"color": (0.10, 0.26, 0.08), "double_sided": True},
        },
    )
