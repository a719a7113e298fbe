# SPDX-License-Identifier: MIT
"""Broken and hostile glTF files through the whole program: refused by name, within time and memory.

Each fault once or a few times; the unit tests of the importer have them in breadth."""

import base64
import json
import math
import os
import struct

import glb
import helper
from measured_run import run_measured

SECONDS = 10
BYTES = 1 << 30


def triangle():
    """glTF's JSON of one triangle with indices, its buffer as a data URI."""
    data = struct.pack("<9f3Hxx", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 2)
    return {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
             "min": [0, 0, 0], "max": [1, 1, 0]},
            {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36},
                        {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
        "buffers": [{"byteLength": len(data), "uri": data_uri(data)}],
    }


def data_uri(data):
    return "data:application/octet-stream;base64," + base64.b64encode(data).decode()


def triangle_with(*changes):
    """`changes`: pairs of a path such as "accessors.0.count" and the value put there."""
    document = triangle()
    for path, value in changes:
        *parents, last = [int(key) if key.isdigit() else key for key in path.split(".")]
        place = document
        for key in parents:
            place = place[key]
        place[last] = value
    return document


def with_vertices(*numbers):
    data = struct.pack("<9f3Hxx", *numbers, 0, 1, 2)
    return triangle_with(("buffers.0.uri", data_uri(data)))


def with_nodes(nodes):
    return triangle_with(("nodes", nodes))


class HostileTest(helper.CliTest):

    def setUp(self):
        super().setUp()
        with open(helper.PROGRAM, "rb") as program:
            self.sanitized = b"__asan_init" in program.read()

    def attempt(self, scene, *words):
        """Renders; what came of it, after checks of what holds for every file."""
        before = self.files()
        result = run_measured(
            [helper.PROGRAM, "render", scene, "-o", "out.png", "--size", "64x36", *words],
            4 * SECONDS, cwd=self.folder, env=self.env)
        self.assertFalse(result.timed_out, f"{scene} hangs")
        self.assertLess(min(result.seconds, result.processor_seconds), SECONDS, scene)
        if not self.sanitized: # whose own memory is not the program's
            self.assertLess(result.peak, BYTES, scene)
        for report in ("Sanitizer", "runtime error:"):
            self.assertNotIn(report, result.stderr, scene)
        if result.status == 0:
            self.assertTrue(self.path("out.png").is_file(), scene)
            self.path("out.png").unlink()
        self.assertEqual(self.files(), before, f"{scene} left something behind")
        return result

    def refused(self, name, document, *says):
        """`document`: JSON, or a file's bytes."""
        content = document if isinstance(document, bytes) else json.dumps(document).encode()
        self.path(name).write_bytes(content)
        result = self.attempt(name)
        self.assertEqual(result.status, 2, f"{name}: {result.stderr}")
        self.assertEqual(result.stdout, "", name)
        self.assertRegex(result.stderr, r"\Aromascope: [^\n]+\n\Z", name)
        for text in (f"{name}: ", *says):
            self.assertIn(text, result.stderr, name)

    def drawn(self, name, document, *words):
        self.path(name).write_text(json.dumps(document))
        result = self.attempt(name, *words)
        self.assertEqual(result.status, 0, f"{name}: {result.stderr}")

    def test_the_triangle_itself_is_drawn(self):
        self.drawn("whole.gltf", triangle())

    def test_buffers_that_are_missing_or_short(self):
        self.refused("gone.gltf", triangle_with(("buffers.0.uri", "gone.bin")),
                     "buffers[0].uri", "'gone.bin'")
        document = triangle()
        del document["buffers"][0]["uri"]
        self.refused("none.gltf", document, "buffers[0]", "no data")
        self.refused("short.gltf", triangle_with(("buffers.0.byteLength", 1 << 40)),
                     "buffers[0]", str(1 << 40))
        self.refused("broken.gltf", triangle_with(
            ("buffers.0.uri", "data:application/octet-stream;base64,@@@@")), "buffers[0].uri")
        self.path("short.bin").write_bytes(b"12345678")
        self.refused("file.gltf", triangle_with(("buffers.0.uri", "short.bin")), "buffers[0]")

    def test_what_does_not_exist(self):
        for path, value, element in [
                ("scene", 1, "scene"), ("scenes.0.nodes", [1], "scenes[0].nodes[0]"),
                ("nodes.0.mesh", 7, "nodes[0].mesh"), ("nodes.0.camera", 0, "nodes[0].camera"),
                ("nodes.0.skin", 0, "nodes[0].skin"), ("nodes.0.children", [-1], "nodes[0].children"),
                ("meshes.0.primitives.0.indices", 4294967295, "meshes[0].primitives[0].indices"),
                ("meshes.0.primitives.0.material", 0, "meshes[0].primitives[0].material"),
                ("accessors.0.bufferView", 2, "accessors[0].bufferView"),
                ("bufferViews.1.buffer", 1, "bufferViews[1].buffer")]:
            with self.subTest(path):
                self.refused("absent.gltf", triangle_with((path, value)), element,
                             f"{value[0] if isinstance(value, list) else value} does not exist")

    def test_indices_out_of_range(self):
        data = struct.pack("<9f3Hxx", *range(9), 0, 1, 3)
        self.refused("index.gltf", triangle_with(("buffers.0.uri", data_uri(data))),
                     "meshes[0].primitives[0].indices", "vertex 3, there are 3")

    def test_spans_out_of_range(self):
        for path, value, element in [
                ("accessors.0.count", 4, "accessors[0]"),
                ("accessors.0.byteOffset", 4, "accessors[0]"),
                ("accessors.1.byteOffset", 1 << 52, "accessors[1]"),
                ("bufferViews.0.byteStride", 252, "accessors[0]"),
                ("bufferViews.0.byteLength", 1 << 20, "bufferViews[0]"),
                ("bufferViews.1.byteOffset", (1 << 32) - 4, "bufferViews[1]")]:
            with self.subTest(path):
                self.refused("span.gltf", triangle_with((path, value)), element, "reach beyond")
        for stride in (3, 256, -4):
            self.refused("stride.gltf", triangle_with(("bufferViews.0.byteStride", stride)),
                         "bufferViews[0].byteStride", str(stride))

    def test_absurd_counts(self):
        for count in (1 << 31, 1 << 62, (1 << 64) - 1, 1e300, -1, 0, 0.5, "3", None):
            with self.subTest(count):
                self.refused("count.gltf", triangle_with(("accessors.0.count", count)),
                             "accessors[0]")
        # No bytes are needed for these, as an accessor without a view is all zero: one point.
        document = triangle_with(("accessors.0.count", 4_000_000_000))
        del document["accessors"][0]["bufferView"]
        del document["meshes"][0]["primitives"][0]["indices"]
        self.drawn("zeros.gltf", document)

    def test_numbers_that_are_not_finite(self):
        for number in (math.nan, math.inf, -math.inf):
            self.refused("number.gltf", with_vertices(0, 0, 0, 1, number, 0, 0, 1, 0),
                         "attributes.POSITION", "not finite")
        self.refused("large.gltf", with_vertices(0, 0, 0, 1, 3e38, 0, 0, 1, 0), "beyond 1000000000")
        self.refused("matrix.gltf", triangle_with(
            ("nodes.0.scale", [1e308, 1e308, 1e308])), "nodes[0]")
        self.refused("turned.gltf", triangle_with(("nodes.0.rotation", [0, 0, 0, 0])),
                     "nodes[0].rotation")

    def test_node_trees(self):
        self.refused("cycle.gltf", with_nodes([{"children": [1]}, {"mesh": 0, "children": [0]}]),
                     "nodes[0]", "cycle")
        self.refused("itself.gltf", with_nodes([{"mesh": 0, "children": [0]}]), "nodes[0]")
        depth = 20_000
        chain = [{"children": [i + 1]} for i in range(depth)] + [{"mesh": 0}]
        self.refused("deep.gltf", with_nodes(chain), "deeper than")
        # 2^40 ways to the mesh.
        fan = [{"children": [i + 1, i + 1]} for i in range(40)] + [{"mesh": 0}]
        self.refused("twice.gltf", with_nodes(fan), "nodes[0].children")
        diamonds = [{"children": [2 * i + 2, 2 * i + 3]} for i in range(40) for _ in "ab"]
        self.refused("diamonds.gltf", with_nodes(diamonds + [{"mesh": 0}, {}]), "already")

    def test_empty_scenes(self):
        empty = {"asset": {"version": "2.0"}}
        self.refused("empty.gltf", empty, "no triangles")
        self.refused("points.gltf", triangle_with(("meshes.0.primitives.0.mode", 0)),
                     "no triangles", "points and lines")
        self.refused("other.gltf", triangle_with(("scenes.0.nodes", [1]), ("nodes", [{"mesh": 0}, {}])),
                     "no triangles")

    def test_files_that_are_no_gltf(self):
        for name, content in [
                ("nothing.glb", b""), ("noise.glb", bytes(range(256)) * 16),
                ("magic.glb", b"FTlg\2\0\0\0"), ("header.glb", b"glTF\2\0\0\0\x0c\0\0\0"),
                ("list.gltf", b"[]"), ("nested.gltf", b'{"a":' + b"[" * 200_000),
                ("text.gltf", b'{"asset": {"version": "2.0"}'), ("bytes.gltf", b'{"\xff": 1}'),
                ("version.gltf", b'{"asset": {"version": "3.0"}}')]:
            with self.subTest(name):
                self.refused(name, content)
        glb.write_glb(self.path("scene.glb"), *glb.box_on_floor())
        whole = self.path("scene.glb").read_bytes()
        for name, at, length in [("chunk.glb", 12, 0xFFFFFFFF), ("wrap.glb", 12, 0xFFFFFFEC),
                                 ("total.glb", 8, 0)]:
            self.refused(name, whole[:at] + struct.pack("<I", length) + whole[at + 4:], "GLB")
        self.refused("cut.glb", whole[:-50], "GLB")

    def test_paths_stay_in_the_folder_of_the_asset(self):
        data = base64.b64decode(triangle()["buffers"][0]["uri"].split(",")[1])
        below = self.path("asset")
        below.mkdir()
        self.path("secret.bin").write_bytes(data)
        (below / "inside.bin").write_bytes(data)
        os.symlink(self.path("secret.bin"), below / "link.bin")
        os.symlink(self.folder, below / "up")
        for uri in ("../secret.bin", str(self.path("secret.bin")), "file://" +
                    str(self.path("secret.bin")), "%2e%2e/secret.bin", "..%2Fsecret.bin", "link.bin",
                    "up/secret.bin", "up/asset/../secret.bin", "/dev/zero", "/proc/self/environ",
                    "http://localhost/secret.bin"):
            with self.subTest(uri):
                self.refused("asset/path.gltf", triangle_with(("buffers.0.uri", uri)),
                             "buffers[0].uri")
        self.drawn("asset/inside.gltf", triangle_with(("buffers.0.uri", "inside.bin")))
        self.drawn("asset/around.gltf", triangle_with(("buffers.0.uri", "../asset/inside.bin")))

    def test_names_are_not_executed(self):
        self.refused("shell.gltf", triangle_with(
            ("buffers.0.uri", "a`touch stolen`.bin")), "buffers[0].uri")
        self.refused("lines.gltf", triangle_with(("buffers.0.uri", "a\nromascope: b\x1b[31m")),
                     "buffers[0].uri")

    def test_extensions_that_are_required(self):
        self.refused("extension.gltf", triangle_with(
            ("extensionsUsed", ["EXT_does_not_exist"]),
            ("extensionsRequired", ["EXT_does_not_exist"])), "EXT_does_not_exist")
        self.drawn("optional.gltf", triangle_with(("extensionsUsed", ["EXT_does_not_exist"])))

    def test_memory_bound(self):
        document = triangle_with(("nodes", [{"mesh": 0} for _ in range(20_000)]),
                                 ("scenes.0.nodes", list(range(20_000))))
        name = "many.gltf"
        self.path(name).write_text(json.dumps(document))
        result = self.attempt(name, "--max-memory", "4MiB")
        self.assertEqual(result.status, 2, result.stderr)
        self.assertRegex(result.stderr, r"\Aromascope: [^\n]*many.gltf: [^\n]*--max-memory[^\n]*\n\Z")
        # Sixty million triangles by a file of half a megabyte, known before they are built.
        vast = triangle_with(("nodes", [{"mesh": 0} for _ in range(20_000)]),
                             ("scenes.0.nodes", list(range(20_000))))
        vast["meshes"][0]["primitives"] *= 3000
        self.refused("vast.gltf", vast, "more than 50000000 triangles")
