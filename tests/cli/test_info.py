# SPDX-License-Identifier: MIT
"""What `romascope info` and the help tell."""

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

    def test_help(self):
        for words in (("--help",), ("render", "--help"), ("compare", "-h"), ("info", "--help")):
            result = self.succeed(*words)
            self.assertIn("Usage: romascope", result.stdout)
            self.assertEqual(result.stderr, "")
        self.assertIn("--reference-output", self.succeed("render", "--help").stdout)

    def test_version(self):
        self.assertRegex(self.succeed("--version").stdout,
                         r"\Aromascope \d+\.\d+\.\d+ \(([0-9a-f]+(-modified)?|unknown)\)\n\Z")
