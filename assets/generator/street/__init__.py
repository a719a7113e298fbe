# SPDX-License-Identifier: MIT
"""A long street between two rows of houses, eight times as long as high, four times as wide."""

from .. import lights
from . import furniture, gate, houses, plan, road, traffic


def build():
    stage = plan.new_stage()
    stage.doc.add_camera("pavement", (-46.2, 1.72, 3.0), (10.0, 3.1, -0.75), 54.0)
    stage.doc.add_camera("shops", (-9.6, 1.65, 2.7), (-2.3, 2.75, -6.0), 66.0)
    stage.doc.add_camera("roofs", (41.2, 10.4, 2.6), (2.0, 2.6, -0.9), 50.0)
    lights.add_sun(stage.doc, "sun", (1.0, 0.93, 0.80), 3.4, (0.50, -1.0, -0.72))
    road.add_to(stage)
    houses.add_to(stage)
    gate.add_to(stage)
    furniture.add_to(stage)
    traffic.add_to(stage)
    return stage.doc
