# SPDX-License-Identifier: MIT
"""The rigid figure: a jointed wooden manikin of 1.6 m; each limb is a node with a mesh."""

from .. import shapes
from .figure import Figure

FIGURE = Figure(
    [
        ("pelvis", None, (0.0, 0.86, 0.0)), ("waist", "pelvis", (0.0, 0.96, 0.0)),
        ("ribs", "waist", (0.0, 1.10, 0.0)), ("skull", "ribs", (0.0, 1.40, 0.0)),
        ("upper.l", "ribs", (0.205, 1.30, 0.0)), ("fore.l", "upper.l", (0.215, 1.03, 0.0)),
        ("palm.l", "fore.l", (0.22, 0.79, 0.0)), ("femur.l", "pelvis", (0.09, 0.80, 0.0)),
        ("calf.l", "femur.l", (0.095, 0.44, 0.0)), ("sole.l", "calf.l", (0.10, 0.07, 0.0)),
    ],
    [("sole.l", (0.10, 0.0, -0.07)), ("sole.l", (0.10, 0.0, 0.16))],
)


def _turned(path, radii, segments=14):
    """A turned piece along a path; ends round off."""
    return shapes.cord(path, radii, segments)


def _limb(offset, thick, thin):
    """From one ball to the next, thickest near its upper end."""
    at = lambda t: tuple(x * t for x in offset)
    return _turned([at(t) for t in (0.10, 0.13, 0.28, 0.5, 0.75, 0.88, 0.91)], [0.45 * thick, 0.8
        * thick, thick, 0.95 * thick, 0.5 * (thick + thin), thin, 0.5 * thin])


def _ball(radius, at=(0.0, 0.0, 0.0)):
    return shapes.sphere(radius, 14, 9, at)


def meshes(stage):
    """By joint's name; both sides share a mesh where they are alike."""
    f = FIGURE
    pelvis = shapes.lathe([(0.0, -0.11), (0.07, -0.11), (0.135, -0.07), (0.15, 0.0), (0.11, 0.06),
        (0.05, 0.075), (0.0, 0.075)], 24).scaled(1.0, 1.0, 0.72)
    waist = shapes.lathe([(0.0, -0.045), (0.06, -0.045), (0.085, 0.0), (0.09, 0.05), (0.06, 0.10),
        (0.0, 0.10)], 24).scaled(1.0, 1.0, 0.78)
    ribs = shapes.lathe([(0.0, -0.035), (0.07, -0.035), (0.125, 0.02), (0.155, 0.10), (0.165, 0.18),
        (0.13, 0.235), (0.06, 0.26), (0.0, 0.26)], 28).scaled(1.0, 1.0, 0.70)
    neck = shapes.lathe([(0.0, 0.24), (0.045, 0.24), (0.036, 0.28), (0.036, 0.32), (0.0, 0.32)], 14)
    skull = shapes.lathe([(0.0, -0.03), (0.035, -0.03), (0.07, 0.02), (0.092, 0.09), (0.095, 0.14),
        (0.075, 0.20), (0.04, 0.225), (0.0, 0.232)], 24).scaled(1.0, 1.0, 1.12).moved(0.0, 0.02,
            0.01)
    nose = shapes.cord([(0.0, 0.135, 0.10), (0.0, 0.09, 0.128), (0.0, 0.08, 0.10)], [0.008, 0.015,
        0.008], 8)
    hat = shapes.lathe([(0.0, 0.19), (0.11, 0.19), (0.125, 0.20), (0.10, 0.215), (0.04, 0.36),
        (0.0, 0.38)], 24).moved(0.0, 0.012, 0.0)
    buttons = [_ball(0.016, (0.0, y, z)) for y, z in ((0.05, 0.098), (0.115, 0.112), (0.18, 0.112))]
    palm = [_turned([(0.0, -0.03, 0.0), (0.0, -0.05, 0.0), (0.0, -0.10, 0.005), (0.0, -0.155,
        0.012)], [0.018, 0.033, 0.034, 0.016], 10).scaled(0.55, 1.0, 1.0), _turned([(0.0, -0.05,
            0.025), (0.0, -0.085, 0.055)], [0.012, 0.010], 8)]
    sole = [shapes.loft([[(x * w, y, -0.075 + z) for x, z in ((1.0, 0.02), (1.0, 0.17), (0.6,
        0.225), (-0.6, 0.225), (-1.0, 0.17), (-1.0, 0.02), (-0.6, 0.0), (0.6, 0.0))] for y, w in
        ((-0.07, 0.042), (-0.045, 0.046), (-0.015, 0.030))], 30.0)]
    make = stage.mesh
    result = {
        "pelvis": make("pelvis", [("red lacquer", [pelvis])]),
        "waist": make("waist", [("pale wood", [waist])]),
        "ribs": make("ribs", [("red lacquer", [ribs]), ("brass", buttons), ("pale wood", [neck])]),
        "skull": make("skull", [("pale wood", [skull]), ("red lacquer", [nose]), ("brass", [hat])]),
    }
    for name, mesh in (
        ("upper", [("pale wood", [_limb(f.offset("fore.l"), 0.045, 0.032)]), ("brass",
            [_ball(0.047)])]),
        ("fore", [("pale wood", [_limb(f.offset("palm.l"), 0.037, 0.024)]), ("brass",
            [_ball(0.033)])]),
        ("palm", [("pale wood", palm), ("brass", [_ball(0.024)])]),
        ("femur", [("pale wood", [_limb(f.offset("calf.l"), 0.068, 0.044)]), ("brass",
            [_ball(0.063)])]),
        ("calf", [("pale wood", [_limb(f.offset("sole.l"), 0.052, 0.030)]), ("brass",
            [_ball(0.045)])]),
        ("sole", [("red lacquer", sole), ("brass", [_ball(0.032)])]),
    ):
        result[name + ".l"] = result[name + ".r"] = make(name, mesh)
    return result
