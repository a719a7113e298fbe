# SPDX-License-Identifier: MIT
"""What the tests of the command line share."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))

import glb
from png_file import read_png

PROGRAM = None  # the binary under test; set by test_cli.py
SOURCE = Path(__file__).resolve().parents[2]
SIZE = (64, 48)

# What could steer the program or the driver from outside.
STEERING = ("DISPLAY", "WAYLAND_DISPLAY", "MESA_", "LIBGL_", "GALLIUM_", "EGL_", "__EGL_",
            "ROMASCOPE_", "XDG_")


class CliTest(unittest.TestCase):
    """A folder of its own with `scene.glb`; commands run in it, without a display."""

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="romascope-cli-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.scene = self.folder / "scene.glb"
        glb.write_glb(self.scene, *glb.box_on_floor())
        self.cache = self.folder / "cache"
        self.env = {name: value for name, value in os.environ.items()
                    if not name.startswith(STEERING)}
        self.env["XDG_CACHE_HOME"] = str(self.cache)

    def without_root(self):
        """Options for a command whose rights count: root runs it as nobody."""
        if os.geteuid() != 0:
            return {}
        nobody = {"user": 65534, "group": 65534, "extra_groups": []}
        for path in (self.folder, *self.folder.rglob("*")):
            os.chown(path, 65534, 65534)
        try:
            self.command(PROGRAM, "--version", **nobody)
        except PermissionError:
            self.skipTest("root, in a folder that nobody else may read")
        return nobody

    def path(self, name):
        return self.folder / name

    def write(self, name, text):
        self.path(name).write_text(text)
        return name

    def files(self):
        """Everything in the folder but the cache, with contents."""
        return {path.relative_to(self.folder): path.read_bytes() if path.is_file() else None
                for path in self.folder.rglob("*")
                if self.cache not in (path, *path.parents)}

    def command(self, *words, env=None, **options):
        """Runs it; a crash fails the test. `env`: added variables, None takes one away."""
        variables = {**self.env, **(env or {})}
        variables = {name: value for name, value in variables.items() if value is not None}
        options.setdefault("cwd", self.folder)
        result = subprocess.run(words, env=variables, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                timeout=60, **options)
        self.assertGreaterEqual(result.returncode, 0, f"killed by a signal: {words}")
        self.assertLess(result.returncode, 128, f"crashed: {words}: {result.stderr}")
        return result

    def run_program(self, *words, **options):
        return self.command(PROGRAM, *map(str, words), **options)

    def succeed(self, *words, **options):
        result = self.run_program(*words, **options)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result

    def render(self, output, *words, scene="scene.glb", **options):
        """Renders the small scene; the result, with nothing but --verbose on stderr."""
        result = self.succeed("render", scene, "-o", output, "--size", "%dx%d" % SIZE, *words,
                              **options)
        if "--verbose" not in words:
            self.assertEqual(result.stderr, "")
        self.assertTrue(self.path(output).is_file(), output)
        return result

    def picture_bytes(self, *words, **options):
        self.render("bytes.png", *words, **options)
        return self.path("bytes.png").read_bytes()

    def refuse(self, *words, says=(), status=2, **options):
        """The command fails in the one way commands fail; the line on stderr."""
        before = self.files()
        result = self.run_program(*words, **options)
        self.assertEqual(result.returncode, status, f"{words}: {result.stderr}")
        self.assertEqual(result.stdout, "", words)
        self.assertRegex(result.stderr, r"\Aromascope: [^\n]+\n\Z", words)
        for text in [says] if isinstance(says, str) else says:
            self.assertIn(text, result.stderr)
        self.assertEqual(self.files(), before, f"{words} left something behind")
        return result.stderr

    def refuse_render(self, *words, **options):
        return self.refuse("render", "scene.glb", "-o", "out.png", "--size", "%dx%d" % SIZE,
                           *words, **options)

    def figures(self, reference, test, *words):
        """What `compare` prints, by name."""
        lines = self.succeed("compare", reference, test, *words).stdout.splitlines()
        return {name: float(value) for name, value in
                (line.split() for line in lines if not line.startswith("error map"))}
