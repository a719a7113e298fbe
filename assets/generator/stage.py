# SPDX-License-Identifier: MIT
"""A scene in the making: its document, its materials by name, and how pieces are placed."""

from .gltf import Document


class Stage:
    def __init__(self, name, materials):
        """`materials`: name to linear colour, or to the arguments of `Document.add_material`."""
        self.doc = Document(name)
        self.materials = {}
        for key, value in materials.items():
            arguments = value if isinstance(value, dict) else {"color": value}
            self.materials[key] = self.doc.add_material(key, **arguments)

    def mesh(self, name, pieces):
        """`pieces`: (name of a material, meshes) pairs."""
        return self.doc.add_mesh(name, [(self.materials[key], meshes) for key, meshes in pieces])

    def add(self, name, pieces, places=((0.0, 0.0, 0.0, 0.0),)):
        """A mesh and its instances. `pieces`: (name of a material, meshes) pairs; `places`:
        (x, y, z) or (x, y, z, degrees about y)."""
        mesh = self.mesh(name, pieces)
        for place in places:
            self.doc.add_node(name, mesh, place[:3], place[3] if len(place) > 3 else 0.0)
