# SPDX-License-Identifier: MIT
"""What `romascope info` and the help tell."""

import json
import math
import re

from helper import CliTest


class Info(CliTest):
    def test_driver(self):
        text = self.succeed("info").stdout
        for word in ("backends", "window", "egl", "osmesa", "in use", "GL version", "GLSL version",
                     "EGL version", "renderer", "OpenGL 4.5 core", "OpenGL 4.6 core", "timestamps",
                     "conservative rasterisation", "shader storage block", "2D texture side"):
            self.assertIn(word, text)
        self.assertRegex(text, r"window +no +neither DISPLAY nor WAYLAND_DISPLAY is set")
        self.assertRegex(text, r"OpenGL 4.5 core +yes")

    def test_backend_in_use(self):
        self.assertRegex(self.succeed("info", "--backend", "osmesa").stdout,
                         r"in use +OSMesa[^\n]*\n(.*\n)*EGL version +not EGL")

    def test_knobs(self):
        text = self.succeed("info", "--knobs").stdout
        self.assertRegex(text, r"\noccupancy\.resolution +integer +128 +32 to 256 +cells")
        for key, words in re.findall(r"^(\S+\.\S+) +(.*)\n +\S.* \[default: \S.*\]$", text,
                                     re.MULTILINE):
            self.assertRegex(words, r"^(boolean|integer|real|choice|text) ", key)
        self.assertEqual(len(re.findall(r"^\S+\.\S+ ", text, re.MULTILINE)),
                         text.count("[default: "))

    def test_techniques(self):
        text = self.succeed("info", "--techniques").stdout
        self.assertRegex(text, re.compile(r"^roma +\w.+$", re.MULTILINE))
        self.assertRegex(text, re.compile(r"^roma-snap +\w.+$", re.MULTILINE))

    def test_scenes(self):
        text = self.succeed("info", "--scenes", env={"ROMASCOPE_ASSETS": str(self.folder)}).stdout
        self.assertRegex(text, r"scene +24 triangles, 6 x 1.2 x 6 m, cameras front, above")
        own = self.succeed("info", "--scenes").stdout
        self.assertIn("cornell", own)
        self.assertRegex(own, r"(?m)^hall .*\(the default scene\)$")
        for line in own.splitlines():
            self.assertRegex(line, r"cameras \S+, \S+, \S+")

    def test_scene(self):
        text = self.succeed("info", "scene.glb").stdout
        for line in (r"scene +scene \(scene.glb\)", r"triangles +24", r"vertices +48, of which 0 move",
                     r"size +6 x 1.2 x 6 m, from -3, -0.2, -3 to 3, 1, 3", r"memory +\d[.\d]* \w+",
                     r"cameras +front, 51.6 degrees", r" +above, 51.6 degrees", r"textures +none",
                     r"lights +none", r"animations +none", r"moving +none", r"notices +none"):
            self.assertRegex(text, f"(?m)^{line}$")
        self.assertIn("hall", self.succeed("info", "hall").stdout)

    def test_scene_as_json(self):
        told = json.loads(self.succeed("info", "scene.glb", "--json").stdout)
        self.assertEqual(list(told), ["schema", "scene", "cameras", "materials", "textures",
                                      "lights", "moving_parts"])
        self.render("out.png", "--report", "out.json")
        self.assertEqual(told["scene"], json.loads(self.path("out.json").read_text())["scene"])
        self.assertEqual([camera["name"] for camera in told["cameras"]], ["front", "above"])
        self.assertAlmostEqual(told["cameras"][0]["vertical_fov_degrees"], math.degrees(0.9), 4)
        for material, color in zip(told["materials"], ((0.8, 0.8, 0.8), (0.8, 0.3, 0.2))):
            for channel, known in zip(material["base_color"], color):
                self.assertAlmostEqual(channel, known, 6)
        self.assertRegex(told["schema"], r"\Aromascope-scene/\d+\Z")

    def test_scene_refused(self):
        self.write("bad.gltf", "{}")
        self.refuse("info", "bad.gltf", says="bad.gltf")
        self.refuse("info", "nowhere.glb", says="nowhere.glb")
        self.refuse("info", "hal", says=["'hal'", "did you mean 'hall'"])
        self.refuse("info", "--json", says="--json")
        self.refuse("info", "scene.glb", "--knobs", says="--knobs")

    def test_help(self):
        for words in (("--help",), ("render", "--help"), ("compare", "-h"), ("sheet", "--help"),
                      ("info", "--help")):
            result = self.succeed(*words)
            self.assertIn("Usage: romascope", result.stdout)
            self.assertEqual(result.stderr, "")
        self.assertIn("--reference-output", self.succeed("render", "--help").stdout)

    def test_version(self):
        self.assertRegex(self.succeed("--version").stdout,
                         r"\Aromascope \d+\.\d+\.\d+ \(([0-9a-f]+(-modified)?|unknown)\)\n\Z")
