# SPDX-License-Identifier: MIT
"""A painter's summer studio: things that are thinner than a cell, and walls exactly as thick."""

from . import cloth, fences, furniture, house, studio
from .plan import new_stage


def build():
    stage = new_stage()
    stage.doc.add_camera("veranda", (3.62, 1.66, 2.80), (-1.75, 1.02, -0.70), 52.0)
    stage.doc.add_camera("studio", (1.52, 1.72, -0.62), (-1.15, 1.02, -2.55), 66.0)
    stage.doc.add_camera("fence", (-4.45, 1.42, 4.25), (0.60, 0.72, 0.45), 54.0)
    house.add_to(stage)
    studio.add_to(stage)
    furniture.add_to(stage)
    cloth.add_to(stage)
    fences.add_to(stage)
    return stage.doc
