# SPDX-License-Identifier: MIT
"""A bag of triangles, and the step from there to vertices with normals."""

import math

from . import vector as v

# Positions are rounded to 10 micrometres: the last bits of sin and cos, which differ between
# machines, then do not reach the files, and points that should meet do.
DIGITS = 5


class Mesh:
    """Triangles, counter-clockwise seen from outside, as triples of points.

    `crease`: degrees; faces that meet at a vertex share a normal there if the angle between them is
    smaller. 0 gives flat shading.
    """

    def __init__(self, crease=0.0):
        self.triangles = []
        self.crease = crease

    def triangle(self, a, b, c):
        """Adds a triangle; one without area (as at the pole of a sphere) is left out."""
        a, b, c = (tuple(round(x, DIGITS) + 0.0 for x in p) for p in (a, b, c))
        if v.length(v.cross(v.sub(b, a), v.sub(c, a))) > 1e-9:
            self.triangles.append((a, b, c))

    def quad(self, a, b, c, d):
        self.triangle(a, b, c)
        self.triangle(a, c, d)

    def grid(self, rows):
        """Quads between neighbouring rows of points, all rows of one length."""
        for low, high in zip(rows, rows[1:]):
            for i in range(len(low) - 1):
                self.quad(low[i], low[i + 1], high[i + 1], high[i])

    def extend(self, other):
        self.triangles += other.triangles
        return self

    def mapped(self, function, flip=False):
        result = Mesh(self.crease)
        for a, b, c in self.triangles:
            a, b, c = function(a), function(b), function(c)
            result.triangle(a, *((c, b) if flip else (b, c)))
        return result

    def moved(self, x=0.0, y=0.0, z=0.0):
        return self.mapped(lambda p: (p[0] + x, p[1] + y, p[2] + z))

    def scaled(self, x, y, z):
        """Scales; an odd number of negative factors mirrors, and the winding follows."""
        return self.mapped(lambda p: (p[0] * x, p[1] * y, p[2] * z), flip=x * y * z < 0.0)

    def turned_y(self, degrees):
        return self.mapped(lambda p: v.rotated_y(p, degrees))

    def along_x(self):
        """What was along z is along x, what was along x is along -z; y stays."""
        return self.turned_y(90.0)

    def along_y(self):
        """What was along z is along y, what was along y is along -z; x stays."""
        return self.mapped(lambda p: (p[0], p[2], -p[1]))

    def without(self, axis, value):
        """Drops the triangles in the plane where coordinate `axis` is `value`.

        For the faces at which two pieces are joined.
        """
        result = Mesh(self.crease)
        result.triangles = [
            t for t in self.triangles if any(abs(p[axis] - value) > 1e-4 for p in t)
        ]
        return result

    def volume(self):
        """Signed: positive if the mesh is closed and its triangles face outward."""
        return sum(v.dot(a, v.cross(b, c)) for a, b, c in self.triangles) / 6.0

    def facing_outward(self):
        """The closed mesh, turned inside out if it has to be."""
        if self.volume() < 0.0:
            self.triangles = [(a, c, b) for a, b, c in self.triangles]
        return self


class Vertices:
    """An indexed mesh. Lists per vertex; those that are empty are left out of the file.

    `joints`, `weights`: four each, weights in 1/255 with the sum 255. `targets`: per morph target
    two lists per vertex, how far it moves the position and how far the normal.
    """

    def __init__(self):
        self.positions, self.normals, self.texcoords = [], [], []
        self.joints, self.weights, self.targets = [], [], []
        self.indices = []

    @classmethod
    def of(cls, mesh):
        vertices = cls()
        vertices.positions, vertices.normals, vertices.indices = with_normals(mesh)
        return vertices

    def extend(self, other):
        self.indices += [len(self.positions) + i for i in other.indices]
        for mine, more in (
            (self.positions, other.positions),
            (self.normals, other.normals),
            (self.texcoords, other.texcoords),
            (self.joints, other.joints),
            (self.weights, other.weights),
        ):
            mine += more
        if not self.targets:
            self.targets = [([], []) for _ in other.targets]
        for mine, more in zip(self.targets, other.targets):
            mine[0].extend(more[0])
            mine[1].extend(more[1])
        return self


def with_normals(mesh):
    """Splits the vertices at creases.

    Returns (positions, normals, indices): normals are unit length, each the mean of the faces on
    its side of the creases, weighted by their angle at the vertex; three indices per triangle.
    """
    faces_at = {}
    face_normals = []
    angles = []
    for t, corners in enumerate(mesh.triangles):
        a, b, c = corners
        face_normals.append(v.normalized(v.cross(v.sub(b, a), v.sub(c, a))))
        angles.append([_angle(corners, i) for i in range(3)])
        for i in range(3):
            faces_at.setdefault(corners[i], []).append((t, i))

    limit = math.cos(math.radians(mesh.crease)) if mesh.crease > 0.0 else 1.0 - 1e-6
    positions, normals, indices, index_of = [], [], [], {}
    for t, corners in enumerate(mesh.triangles):
        for point in corners:
            total = (0.0, 0.0, 0.0)
            for other, i in faces_at[point]:
                if v.dot(face_normals[t], face_normals[other]) >= limit:
                    total = v.add(total, v.scale(face_normals[other], angles[other][i]))
            normal = tuple(round(x, DIGITS) + 0.0 for x in v.normalized(total))
            key = (point, normal)
            if key not in index_of:
                index_of[key] = len(positions)
                positions.append(point)
                normals.append(v.normalized(normal))
            indices.append(index_of[key])
    return positions, normals, indices


def _angle(corners, i):
    a = v.normalized(v.sub(corners[(i + 1) % 3], corners[i]))
    b = v.normalized(v.sub(corners[(i + 2) % 3], corners[i]))
    return math.acos(max(-1.0, min(1.0, v.dot(a, b))))
