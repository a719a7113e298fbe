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

    def mesh(self, name, pieces, **more):
        """`pieces`: (name of a material, meshes) pairs; `more`: as `Document.add_mesh`."""
        parts = [(self.materials[key], meshes) for key, meshes in pieces]
        return self.doc.add_mesh(name, parts, **more)

    def variant(self, mesh, swap):
        """The same mesh in other materials; `swap`: from name to name."""
        return self.doc.add_variant(
            mesh, {self.materials[old]: self.materials[new] for old, new in swap.items()}
        )

    def put(self, name, mesh, places, parent=None):
        """Instances of a mesh; `places`: (x, y, z) or (x, y, z, degrees about y)."""
        for place in places:
            turn = place[3] if len(place) > 3 else 0.0
            self.doc.add_node(name, mesh, place[:3], turn, parent)

    def add(self, name, pieces, places=((0.0, 0.0, 0.0, 0.0),)):
        """A mesh, as `mesh`, and its instances, as `put`."""
        self.put(name, self.mesh(name, pieces), places)
