# SPDX-License-Identifier: MIT
"""The default scene: a colonnaded hall with an open nave, stairs, arches, niches and a gallery."""

from . import gallery, ground, stairs, walls
from .plan import Plan


def build():
    plan = Plan()
    plan.doc.add_camera("nave", (9.3, 1.9, 0.85), (-4.0, 2.85, -0.30), 58.0)
    plan.doc.add_camera("stairs", (-1.2, 1.7, 3.3), (-7.6, 3.0, -1.0), 62.0)
    plan.doc.add_camera("gallery", (10.9, 8.9, 3.3), (-3.6, 2.5, -1.0), 56.0)
    ground.add_to(plan)
    walls.add_to(plan)
    stairs.add_to(plan)
    gallery.add_to(plan)
    return plan.doc
