# SPDX-License-Identifier: MIT
"""Places the program may find itself in."""

import shutil
import tempfile
from pathlib import Path

import helper
from helper import CliTest


class Environment(CliTest):
    def test_current_folder_that_is_not_writable(self):
        folder = self.folder / "locked"
        folder.mkdir(mode=0o500)
        self.succeed("render", self.scene, "-o", self.path("out.png"), "--size", "8x8",
                     cwd=folder, **self.without_root())
        self.assertEqual(list(folder.iterdir()), [])

    def test_nothing_is_left_in_the_current_folder(self):
        self.render("out.png", "--reference", "1")
        self.assertEqual({str(path) for path in self.files()}, {"out.png", "scene.glb"})

    def test_without_home(self):
        self.render("out.png", "--reference", "1", env={"HOME": None})

    def test_without_any_place_for_the_cache(self):
        # Every place the cache could go to is a file: the reference is computed all the same.
        self.write("file", "")
        nowhere = {"HOME": str(self.path("file")), "XDG_CACHE_HOME": str(self.path("file")),
                   "MESA_SHADER_CACHE_DISABLE": "1"}  # Mesa would tell that it has no place
        self.render("out.png", "--reference", "1", env=nowhere)

    def test_language_does_not_matter(self):
        words = ("--set", "ao.radius=0.5", "--camera", "0.5,2.5,3.5/0,0,0/59.5")
        first = self.picture_bytes(*words)
        for language in ("C.UTF-8", "de_DE.UTF-8", "tr_TR.UTF-8"):
            self.assertEqual(self.picture_bytes(*words, env={"LC_ALL": language}), first)

    def test_names_with_spaces_and_accents(self):
        (self.folder / "a folder").mkdir()
        scene = self.folder / "a folder" / "sçène 100%.glb"
        shutil.copy(self.scene, scene)
        self.render("a folder/büld.png", "--report", "a folder/r.json", scene=scene)

    def test_own_scenes_by_name_and_by_default(self):
        own = self.succeed("render", "cornell", "-o", "own.png", "--size", "16x9")
        self.assertEqual(own.stderr, "")
        shutil.copy(self.scene, self.path("hall.glb"))
        env = {"ROMASCOPE_ASSETS": str(self.folder)}
        for name, words in (("named.png", ["hall"]), ("default.png", [])):
            self.succeed("render", *words, "-o", name, "--size", "64x48", env=env)
        self.render("file.png")
        self.assertEqual(len({self.path(name).read_bytes()
                              for name in ("named.png", "default.png", "file.png")}), 1)

    def test_moved_binary_finds_scenes_beside_it(self):
        with tempfile.TemporaryDirectory() as place:
            program = shutil.copy(helper.PROGRAM, place)
            (Path(place) / "assets").mkdir()
            shutil.copy(self.scene, Path(place) / "assets" / "mine.glb")
            result = self.command(program, "info", "--scenes")
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertRegex(result.stdout, r"\Amine [^\n]*\n\Z")
