# SPDX-License-Identifier: MIT
"""The commands in README.md and docs/user run as they are written, but for their sizes."""

import json
import re
import shlex
import sys
from pathlib import Path

import glb
import helper
from helper import SOURCE, CliTest

sys.path.insert(0, str(SOURCE / "tests" / "motion"))
import random_gltf

PROGRAM = "build/bin/romascope"
PAGES = [SOURCE / "README.md", *sorted((SOURCE / "docs" / "user").glob("*.md"))]


def shell_lines(page):
    """Lines of the indented blocks, with those that are continued joined."""
    blocks = re.findall(r"^    .*$", page.read_text().replace("\\\n", " "), re.MULTILINE)
    return [line.strip() for line in blocks]


def commands(page):
    """Those that run the program, and values of variables for them."""
    return [line for line in shell_lines(page)
            if line.startswith(PROGRAM) or re.match(r"[A-Z]+=\S", line)]


class Documented(CliTest):
    def setUp(self):
        super().setUp()
        self.path("build/bin").mkdir(parents=True)
        run = Path(__file__).with_name("small_run.py")
        program = self.path(PROGRAM)
        words = [sys.executable, "-B", str(run), helper.PROGRAM, str(self.path("FOLDER"))]
        program.write_text(f'#!/bin/sh\nexec {shlex.join(words)} "$@"\n')
        program.chmod(0o755)
        for folder in ("assets", "shaders"):
            self.path(folder).symlink_to(SOURCE / folder)
        # Files that the pages take for yours.
        glb.write_glb(self.path("file.glb"), *glb.box_on_floor())
        self.path("FOLDER").mkdir()
        glb.write_glb(self.path("FOLDER/a.glb"), *glb.box_on_floor())
        random_gltf.Writer(3).write(self.path("fox.glb"))
        fox = json.loads(self.path("fox.glb").read_text())
        fox["animations"][0]["name"] = "Run"
        self.path("fox.glb").write_text(json.dumps(fox))

    def test_commands_run(self):
        for page in PAGES:
            variables = []
            for line in commands(page):
                if not line.startswith(PROGRAM):
                    variables.append(line)
                    continue
                with self.subTest(page=page.name, line=line):
                    result = self.command("bash", "-euc", "\n".join([*variables, line]))
                    self.assertEqual(result.returncode, 0, result.stderr)

    def test_pages_say_where_the_program_is(self):
        found = 0
        for page in PAGES:
            for line in shell_lines(page):
                found += line.startswith(PROGRAM)
                self.assertNotRegex(line, r"^romascope( |$)", page.name)
        self.assertGreater(found, 40)
