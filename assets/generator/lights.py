# SPDX-License-Identifier: MIT
"""Lights by KHR_lights_punctual: lux for the sun, candela for lamps.

https://github.com/KhronosGroup/glTF/tree/main/extensions/2.0/Khronos/KHR_lights_punctual
"""

from .gltf import looking

NAME = "KHR_lights_punctual"


def add_sun(doc, name, color, lux, direction):
    """`direction`: the way the light travels, not straight up or down."""
    light = {"type": "directional", "name": name, "color": list(color), "intensity": lux}
    index = _add(doc, light)
    doc.add_node(name, extensions={NAME: {"light": index}}, rotation=looking(direction))


def add_lamp(doc, name, color, candela, reach, places):
    """Point lights at places (x, y, z) that reach so many metres."""
    light = {
        "type": "point", "name": name, "color": list(color), "intensity": candela, "range": reach
    }
    index = _add(doc, light)
    for place in places:
        doc.add_node(name, at=place, extensions={NAME: {"light": index}})


def _add(doc, light):
    if NAME not in doc.root.setdefault("extensionsUsed", []):
        doc.root["extensionsUsed"].append(NAME)
    lights = doc.root.setdefault("extensions", {}).setdefault(NAME, {"lights": []})["lights"]
    lights.append(light)
    return len(lights) - 1
