# SPDX-License-Identifier: MIT
"""What the scenes promise: sizes, cameras, closed solids, and each scene's own purpose."""

import collections
import os
import struct
import sys
import unittest
import zlib

from glb_file import GlbFile, product

ASSETS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "assets")
sys.path.insert(0, ASSETS)
from generate_scenes import SCENES  # noqa: E402

# Where pieces of walls meet, an edge of one may be two edges of the other.
JOINED_IN_PIECES = ("cornell", "hall")

FILES = {name: GlbFile(os.path.join(ASSETS, name + ".glb")) for name in SCENES}


def solids_of(file, mesh):
    """The mesh's triangles of materials that have an inside, in pieces that hang together."""
    triangles = []
    for primitive in mesh["primitives"]:
        if not file.root["materials"][primitive["material"]].get("doubleSided", False):
            triangles += file.triangles(primitive)
    leader = {}

    def find(p):
        while leader.setdefault(p, p) != p:
            leader[p] = leader[leader[p]]
            p = leader[p]
        return p

    for a, b, c in triangles:
        leader[find(a)] = find(b)
        leader[find(b)] = find(c)
    pieces = collections.defaultdict(list)
    for triangle in triangles:
        pieces[find(triangle[0])].append(triangle)
    return pieces.values()


def volume(triangles):
    origin = triangles[0][0]  # near the piece: of six digits that cancel, the rest would be noise
    total = 0.0
    for corners in triangles:
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (
            tuple(x - o for x, o in zip(p, origin)) for p in corners
        )
        total += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
    return total / 6.0


class AllScenes(unittest.TestCase):
    def test_total_size_is_below_6_megabytes(self):
        self.assertLess(sum(file.size for file in FILES.values()), 6_000_000)

    def test_each_has_three_named_cameras(self):
        for name, file in FILES.items():
            with self.subTest(scene=name):
                cameras = [node["name"] for node in file.root["nodes"] if "camera" in node]
                self.assertEqual(len(set(cameras)), 3)

    def test_solids_are_closed_and_face_outward(self):
        for name, file in FILES.items():
            if name in JOINED_IN_PIECES:
                continue
            for mesh in file.root["meshes"]:
                for piece in solids_of(file, mesh):
                    with self.subTest(scene=name, mesh=mesh["name"], at=piece[0][0]):
                        edges = collections.Counter()
                        for a, b, c in piece:
                            for p, q in ((a, b), (b, c), (c, a)):
                                edges[p, q] += 1
                                edges[q, p] -= 1
                        self.assertFalse(any(edges.values()), "has open edges")
                        self.assertGreater(volume(piece), 0.0)

    def test_normals_are_of_unit_length(self):
        for name, file in FILES.items():
            for mesh in file.root["meshes"]:
                for primitive in mesh["primitives"]:
                    with self.subTest(scene=name, mesh=mesh["name"]):
                        for normal in file.rows[primitive["attributes"]["NORMAL"]]:
                            # Stored as floats: 1 to about 1e-7 for each component.
                            self.assertAlmostEqual(sum(x * x for x in normal), 1.0, delta=1e-5)


class Readme(unittest.TestCase):
    def test_lists_each_scene_with_its_size_and_cameras(self):
        with open(os.path.join(ASSETS, "README.md"), encoding="utf-8") as file:
            rows = [line for line in file if line.startswith("| `")]
        listed = {row.split("`")[1]: row for row in rows}
        self.assertEqual(sorted(listed), sorted(name + ".glb" for name in SCENES))
        for name, file in FILES.items():
            with self.subTest(scene=name):
                row = listed[name + ".glb"]
                self.assertIn(f"| {file.size:,} |", row)
                for node in file.root["nodes"]:
                    if "camera" in node:
                        self.assertIn(f"`{node['name']}`", row)


class Thin(unittest.TestCase):
    def test_walls_are_one_cell_thick(self):
        """At 128 cells along the longest side, which then is 127 cell sizes long (the 128th is
        room for the shift), to 2 %: so that either count of cells per length is met."""
        file = FILES["thin"]
        low, high = file.bounds()
        cell = max(b - a for a, b in zip(low, high)) / 128.0
        walls = next(m for m in file.root["meshes"] if m["name"] == "walls")
        pieces = list(solids_of(file, walls))
        self.assertEqual(len(pieces), 5)
        for piece in pieces:
            columns = list(zip(*(p for triangle in piece for p in triangle)))
            self.assertAlmostEqual(min(max(c) - min(c) for c in columns) / cell, 1.0, delta=0.02)

    def test_has_single_sheets(self):
        file = FILES["thin"]
        sheets = 0
        for mesh in file.root["meshes"]:
            for primitive in mesh["primitives"]:
                if file.root["materials"][primitive["material"]].get("doubleSided", False):
                    edges = collections.Counter()
                    for a, b, c in file.triangles(primitive):
                        edges.update(((a, b), (b, c), (c, a)))
                    sheets += any((b, a) not in edges for a, b in edges)
        self.assertGreater(sheets, 10)


class Dancers(unittest.TestCase):
    file = FILES["dancers"]

    def test_one_animation_moves_a_skin_a_morphing_and_a_rigid_figure(self):
        root = self.file.root
        self.assertEqual([clip["name"] for clip in root["animations"]], ["dance"])
        moved = {}
        for channel in root["animations"][0]["channels"]:
            moved.setdefault(channel["target"]["path"], set()).add(channel["target"]["node"])
        skinned = [node for node in root["nodes"] if "skin" in node]
        self.assertEqual(len(skinned), 1)
        joints = root["skins"][skinned[0]["skin"]]["joints"]
        self.assertIn(len(joints), range(15, 21))
        self.assertLess(len(joints) / 2, len(moved["rotation"] & set(joints)))
        (morphing,) = moved["weights"]
        mesh = root["meshes"][root["nodes"][morphing]["mesh"]]
        self.assertTrue(all(len(p["targets"]) == 3 for p in mesh["primitives"]))
        rigid = [i for i in moved["rotation"] if "mesh" in root["nodes"][i]]
        self.assertGreater(len(rigid), 10)

    def test_loop_is_seamless(self):
        clip, ends = self.file.root["animations"][0], set()
        for channel in clip["channels"]:
            sampler = clip["samplers"][channel["sampler"]]
            times = [t for (t,) in self.file.rows[sampler["input"]]]
            self.assertTrue(all(a < b for a, b in zip(times, times[1:])))
            self.assertEqual(times[0], 0.0)
            ends.add(times[-1])
            rows = self.file.rows[sampler["output"]]
            size = len(rows) // len(times)  # rows of a key
            self.assertEqual(rows[:size], rows[-size:], channel)
        self.assertEqual(len(ends), 1)

    def test_weights_of_joints_sum_to_1(self):
        for mesh in self.file.root["meshes"]:
            for primitive in mesh["primitives"]:
                for name in {"JOINTS_0", "WEIGHTS_0"} & primitive["attributes"].keys():
                    self.assertIn("JOINTS_0", primitive["attributes"])
                    rows = self.file.rows[primitive["attributes"][name]]
                    if name == "WEIGHTS_0":
                        self.assertEqual({sum(row) for row in rows}, {255})
                    else:
                        self.assertLess(max(map(max, rows)), 17)

    def test_at_rest_the_skin_is_where_its_mesh_is(self):
        """Every joint's matrix is then the same: that of the figure's place."""
        matrices, parents = self.file.matrices(), self.file.parents()
        for skin in self.file.root["skins"]:
            place = matrices[parents[skin["joints"][0]]]
            for joint, inverse in zip(skin["joints"], self.file.rows[skin["inverseBindMatrices"]]):
                columns = tuple(tuple(inverse[4 * c + r] for c in range(4)) for r in range(3))
                for row, expected in zip(product(matrices[joint], columns), place):
                    for a, b in zip(row, expected):
                        # Places are rounded to 1e-5 from joint to joint.
                        self.assertAlmostEqual(a, b, delta=1e-4)

    def test_turns_are_of_unit_length(self):
        clip = self.file.root["animations"][0]
        for channel in clip["channels"]:
            if channel["target"]["path"] == "rotation":
                for q in self.file.rows[clip["samplers"][channel["sampler"]]["output"]]:
                    self.assertAlmostEqual(sum(x * x for x in q), 1.0, delta=1e-5)


class Foliage(unittest.TestCase):
    file = FILES["foliage"]

    def test_leaves_are_masks_of_two_sides(self):
        masks = [m for m in self.file.root["materials"] if m.get("alphaMode") == "MASK"]
        self.assertGreater(len(masks), 5)
        for material in masks:
            self.assertEqual(material["alphaCutoff"], 0.5)
            self.assertTrue(material["doubleSided"])
            self.assertIn("baseColorTexture", material["pbrMetallicRoughness"])

    def test_pictures_lie_on_both_sides_of_the_cutoff(self):
        for image in self.file.root["images"]:
            with self.subTest(picture=image["name"]):
                alphas = palette_alphas(self.file.view(image["bufferView"]))
                above = sum(a >= 128 for a in alphas) / len(alphas)
                self.assertGreater(above, 0.1)
                self.assertLess(above, 0.9)

    def test_cards_show_all_of_their_picture(self):
        for mesh in self.file.root["meshes"]:
            for primitive in mesh["primitives"]:
                if "TEXCOORD_0" in primitive["attributes"]:
                    us, vs = zip(*self.file.rows[primitive["attributes"]["TEXCOORD_0"]])
                    self.assertEqual((min(us), max(us), min(vs), max(vs)), (0.0, 1.0, 0.0, 1.0))


def palette_alphas(png):
    """Alpha of each pixel of a PNG with a palette and no filters."""
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    chunks, at = {}, 8
    while at < len(png):
        length, kind = struct.unpack_from(">I4s", png, at)
        data = png[at + 8 : at + 8 + length]
        assert struct.unpack_from(">I", png, at + 8 + length)[0] == zlib.crc32(kind + data)
        chunks[kind] = data
        at += 12 + length
    width, height = struct.unpack_from(">II", chunks[b"IHDR"])
    rows = zlib.decompress(chunks[b"IDAT"])
    assert len(rows) == height * (width + 1)
    assert not any(rows[y * (width + 1)] for y in range(height))
    pixels = (rows[y * (width + 1) + 1 + x] for y in range(height) for x in range(width))
    return [chunks[b"tRNS"][pixel] for pixel in pixels]


class Street(unittest.TestCase):
    def test_bounds_are_8_to_1_to_2(self):
        low, high = FILES["street"].bounds()
        length, height, width = (b - a for a, b in zip(low, high))
        # To 0.5 %: at 128 cells along the street, less than a cell across it.
        self.assertAlmostEqual(length / height, 8.0, delta=0.04)
        self.assertAlmostEqual(width / height, 2.0, delta=0.01)

    def test_has_a_sun_and_lamps(self):
        root = FILES["street"].root
        self.assertEqual(root["extensionsUsed"], ["KHR_lights_punctual"])
        lights = root["extensions"]["KHR_lights_punctual"]["lights"]
        used = [node["extensions"]["KHR_lights_punctual"]["light"] for node in root["nodes"]
            if "extensions" in node]
        kinds = [lights[i]["type"] for i in used]
        self.assertEqual((kinds.count("directional"), kinds.count("point")), (1, 6))


if __name__ == "__main__":
    unittest.main()
