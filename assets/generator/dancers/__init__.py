# SPDX-License-Identifier: MIT
"""Three figures that dance on a still floor: one skinned, one rigid, one morphing."""

from .. import motion
from ..stage import Stage
from . import dance, dancer, lantern, puppet, square

MATERIALS = {
    "pale stone": (0.68, 0.63, 0.54),
    "grey stone": (0.34, 0.34, 0.35),
    "joint": (0.24, 0.22, 0.20),
    "ochre plaster": (0.62, 0.40, 0.18),
    "terracotta": (0.55, 0.23, 0.12),
    "brass": (0.62, 0.44, 0.16),
    "water": (0.05, 0.16, 0.20),
    "cord": (0.10, 0.07, 0.05),
    "lamp": {"color": (0.85, 0.80, 0.65), "emissive": (1.0, 0.82, 0.50)},
    "pale wood": (0.68, 0.48, 0.28),
    "red lacquer": (0.52, 0.06, 0.04),
    "skin": (0.55, 0.32, 0.21),
    "dark hair": (0.035, 0.022, 0.018),
    "leotard": (0.05, 0.22, 0.26),
    "tights": (0.70, 0.62, 0.54),
    "shoes": (0.05, 0.16, 0.19),
    "skirt": {"color": (0.08, 0.36, 0.40), "double_sided": True},
    "silk": (0.74, 0.36, 0.12),
    "ribbon": {"color": (0.76, 0.58, 0.36), "double_sided": True},
    "beads": (0.60, 0.10, 0.08),
    "glow": {"color": (0.85, 0.80, 0.65), "emissive": (1.0, 0.72, 0.35)},
}


def build():
    stage = Stage("dancers", MATERIALS)
    doc = stage.doc
    doc.add_camera("stalls", (0.6, 1.75, 6.3), (-0.05, 1.35, -0.4), 44.0)
    doc.add_camera("wing", (-4.55, 2.3, 3.15), (0.45, 1.05, -0.55), 52.0)
    doc.add_camera("above", (3.1, 5.3, 3.7), (-0.1, 0.65, -0.4), 48.0)
    square.add_to(stage)
    clip = motion.Clip(doc, "dance")

    place = doc.add_node("dancer", at=(-1.65, 0.008, 0.75), turn=18.0)
    joints = dancer.FIGURE.add_nodes(doc, place)
    mesh = stage.mesh("dancer", dancer.pieces())
    names = dancer.FIGURE.names
    skin = motion.add_skin(doc, "dancer", [joints[name] for name in names],
        [dancer.FIGURE.place[name] for name in names])
    doc.add_node("dancer's body", mesh, skin=skin)
    dancer.FIGURE.animate(clip, joints, *dance.dancer())

    x, z = square.PODIUM
    place = doc.add_node("puppet", at=(x, 0.30, z), turn=-16.0)
    joints = puppet.FIGURE.add_nodes(doc, place, puppet.meshes(stage))
    puppet.FIGURE.animate(clip, joints, *dance.puppet())

    mesh = stage.mesh("lantern", lantern.pieces(), weights=[0.0, 0.0, 0.0],
        extras={"targetNames": list(lantern.TARGETS)})
    floating = doc.add_node("lantern", mesh, at=(-0.15, 2.62, -2.0))
    clip.add(floating, "weights", *lantern.swim(dance.PERIOD), "CUBICSPLINE")
    return doc
