# SPDX-License-Identifier: MIT
"""Where things are in the street, and its materials.

x runs along the street to the gate at its far end (+x), z across. Metres.
"""

from ..stage import Stage

LENGTH, HEIGHT, WIDTH = 96.0, 12.0, 24.0  # 8 : 1 : 2
WEST, EAST = -LENGTH / 2.0, LENGTH / 2.0
LOW = -0.3  # underside of the ground
TOP = LOW + HEIGHT  # of the gate's finials, the highest point
FRONT = 6.0  # |z| of the houses' faces
DEPTH = WIDTH / 2.0 - FRONT  # of the houses
KERB = 3.6  # |z| of the roadway's edge
PAVEMENT = 0.14
GATE = 43.0  # x of its face
FLOORS = (0.0, 3.6, 6.6)  # of the storeys
EAVES = (6.45, 9.35)  # of houses with two storeys, with three

LAMPS = [(-40.0 + 16.0 * k, -1.0 if k % 2 else 1.0) for k in range(6)]  # x, side

# Design, wall, paint of shop and doors, awning; in the order along x.
NORTH_SIDE = (
    ("corner", "ochre", "green paint", None), ("shop", "cream", "red paint", "red stripes"),
    ("gable", "brick", "blue paint", None), ("arcade", "grey", "green paint", None),
    ("mansard", "rose", "black paint", "blue stripes"), ("balcony", "sage", "red paint", None),
    ("shop", "pale blue", "green paint", "green stripes"), ("corner", "rose", "black paint", None),
    ("arcade", "cream", "blue paint", None), ("gable", "sage", "red paint", None),
    ("balcony", "ochre", "black paint", None),
)
SOUTH_SIDE = (
    ("mansard", "cream", "blue paint", "red stripes"), ("arcade", "rose", "green paint", None),
    ("corner", "brick", "red paint", None), ("balcony", "pale blue", "black paint", None),
    ("gable", "ochre", "green paint", None), None,  # a passage
    ("shop", "grey", "blue paint", "blue stripes"), ("mansard", "sage", "red paint",
        "green stripes"),
    ("gable", "cream", "black paint", None), ("arcade", "ochre", "red paint", None),
    ("shop", "rose", "green paint", "red stripes"), ("corner", "pale blue", "blue paint", None),
)
PASSAGE = 2.4
WIDTHS = {"shop": 8.4, "gable": 6.0, "arcade": 11.2, "mansard": 7.2, "balcony": 9.6,
    "corner": 6.6}


def new_stage():
    return Stage(
        "street",
        {
            "cream": (0.70, 0.64, 0.50),
            "ochre": (0.62, 0.42, 0.18),
            "rose": (0.60, 0.36, 0.28),
            "pale blue": (0.42, 0.52, 0.58),
            "sage": (0.42, 0.48, 0.34),
            "grey": (0.50, 0.49, 0.47),
            "brick": (0.36, 0.13, 0.08),
            "stone": (0.66, 0.62, 0.55),
            "plinth": (0.33, 0.31, 0.29),
            "white paint": (0.78, 0.77, 0.73),
            "red paint": (0.38, 0.035, 0.03),
            "green paint": (0.03, 0.14, 0.09),
            "blue paint": (0.03, 0.08, 0.20),
            "black paint": (0.035, 0.035, 0.04),
            "red stripes": (0.56, 0.07, 0.05),
            "green stripes": (0.08, 0.30, 0.16),
            "blue stripes": (0.08, 0.16, 0.40),
            "canvas": (0.78, 0.74, 0.64),
            "shutters": (0.10, 0.24, 0.22),
            "glass": (0.055, 0.075, 0.09),
            "slate": (0.13, 0.14, 0.17),
            "tiles": (0.40, 0.16, 0.09),
            "lead": (0.28, 0.30, 0.31),
            "iron": (0.045, 0.05, 0.05),
            "lamp glass": {"color": (0.8, 0.75, 0.6), "emissive": (1.0, 0.80, 0.50)},
            "roadway": (0.17, 0.17, 0.18),
            "setts": (0.27, 0.26, 0.25),
            "paving": (0.47, 0.45, 0.41),
            "kerbstone": (0.56, 0.55, 0.52),
            "joint": (0.19, 0.18, 0.17),
            "marking": (0.80, 0.79, 0.74),
            "leaves": (0.08, 0.20, 0.06),
            "blossom": (0.62, 0.14, 0.20),
            "terracotta": (0.55, 0.23, 0.12),
            "wood": (0.34, 0.20, 0.10),
            "tyre": (0.03, 0.03, 0.03),
            "chrome": (0.55, 0.56, 0.57),
            "car red": (0.42, 0.03, 0.03),
            "car cream": (0.70, 0.64, 0.48),
            "car blue": (0.10, 0.22, 0.36),
            "car green": (0.10, 0.22, 0.12),
        },
    )
