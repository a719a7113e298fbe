# SPDX-License-Identifier: MIT
"""Settings from techniques, files and the command line."""

import re
import tomllib

from helper import CliTest, SOURCE


class Refused(CliTest):
    def test_unknown_key(self):
        self.refuse_render("--set", "ao.raduis=1", says=["'ao.raduis'", "did you mean 'ao.radius'"])
        line = self.refuse_render("--set", "roma.directions=1", says="'romascope info --knobs'")
        self.assertNotIn("did you mean", line)

    def test_out_of_range(self):
        self.refuse_render("--set", "occupancy.resolution=3000",
                           says=["occupancy.resolution", "'3000'", "32 to 256", "cells"])
        self.refuse_render("--set", "ao.radius=nan", says="ao.radius")
        self.refuse_render("--set", "ao.radius=-1", says=["ao.radius", "at least"])
        self.refuse_render("--set", "roma.sampling=snaps", says=["snap", "candidates"])
        self.refuse_render("--set", "frame.antialias=perhaps", says="frame.antialias")

    def test_not_an_assignment(self):
        self.refuse_render("--set", "ao.radius", says="key=value")

    def test_unknown_technique(self):
        self.refuse_render("--technique", "rom", says=["'rom'", "did you mean 'roma'"])

    def test_unknown_tracer(self):
        self.refuse_render("--set", "technique.tracer=rma", says=["'rma'", "'roma'"])

    def test_files_are_answered_with_the_line(self):
        for text, line, says in (("[ao]\nradius = = 2\n", 2, ""),
                                 ("[ao]\n\nraduis = 2\n", 3, "did you mean"),
                                 ("[ao]\nradius = 'wide'\n", 2, "radius"),
                                 ("# one\n# two\nao.rays = 65\n", 3, "1 to 64"),
                                 ("[ao]\nrays = 2\nrays = 3\n", 3, "")):
            with self.subTest(text):
                self.write("bad.toml", text)
                self.refuse_render("--config", "bad.toml", says=[f"bad.toml:{line}", says])

    def test_missing_file(self):
        self.refuse_render("--config", "nowhere.toml", says="nowhere.toml")
        self.refuse_render("--config", ".", says="folder")


class Effective(CliTest):
    def config(self, *words):
        return tomllib.loads(self.succeed("render", "--print-config", *words).stdout)

    def test_defaults_technique_file_command_line(self):
        self.write("file.toml", "[roma]\nsampling = 'candidates'\n[lit]\nsun_strength = 3\n")
        self.write("later.toml", "lit.sun_strength = 5\n")
        usual = self.config()["lit"]["sun_strength"]
        steps = [((), "candidates", usual),
                 (("--technique", "roma-snap"), "snap", usual),
                 (("--config", "file.toml"), "candidates", 3),
                 (("--config", "later.toml"), "candidates", 5),
                 (("--set", "lit.sun_strength=7", "--set", "lit.sun_strength=8"), "candidates", 8)]
        words = []
        for added, sampling, strength in steps:
            words += added
            config = self.config(*words)
            self.assertEqual((config["roma"]["sampling"], config["lit"]["sun_strength"]),
                             (sampling, strength))
        # Where a word stands on the command line does not matter.
        self.assertEqual(self.config("--set", "roma.sampling=candidates", "--technique",
                                     "roma-snap")["roma"]["sampling"], "candidates")

    def test_options_are_settings(self):
        config = self.config("--size", "33x22", "--frames", "4", "--seed", "4294967295",
                             "--camera", "1,2,3/0,0,0/60", "--time", "1.5", "--fps", "24",
                             "--animation", "walk")["render"]
        self.assertEqual(config, {"width": 33, "height": 22, "frames": 4, "seed": 4294967295,
                                  "camera": "1,2,3/0,0,0/60", "time": 1.5, "fps": 24,
                                  "animation": "walk"})

    def test_a_setting_does_not_take_the_next_word(self):
        self.write("file.toml", "")
        self.succeed("render", "--set", "ao.rays=2", "--config", "file.toml", "scene.glb", "-o",
                     "out.png", "--size", "8x8")

    def test_printed_settings_load_back(self):
        words = ["--technique", "roma-snap", "--size", "17x9", "--set", "ao.radius=0.1",
                 "--set", "occupancy.jitter=0.3333333333333333", "--set", "frame.view=normal",
                 "--set", "frame.antialias=on", "--seed", "123456789",
                 "--set", 'render.camera=a "quoted"\tname\\ of ümläut']
        first = self.succeed("render", "--print-config", *words).stdout
        self.write("printed.toml", first)
        second = self.succeed("render", "--print-config", "--config", "printed.toml").stdout
        self.assertEqual(first, second)
        self.assertNotEqual(first, self.succeed("render", "--print-config").stdout)
        for infinite in (first, self.succeed("render", "--print-config").stdout):
            tomllib.loads(infinite)

    def test_printed_settings_give_the_same_picture(self):
        words = ["--set", "ao.radius=0.7", "--technique", "roma-snap", "--seed", "5"]
        printed = self.succeed("render", "--print-config", "--size", "64x48", *words).stdout
        self.write("printed.toml", printed)
        self.assertEqual(self.picture_bytes(*words),
                         self.picture_bytes("--config", "printed.toml"))

    def test_printing_needs_no_scene_and_writes_nothing(self):
        before = self.files()
        self.succeed("render", "nowhere.glb", "-o", "out.png", "--print-config")
        self.assertEqual(self.files(), before)

    def test_every_knob_is_printed(self):
        listed = re.findall(r"^(\S+\.\S+) ", self.succeed("info", "--knobs").stdout, re.MULTILINE)
        self.assertGreater(len(listed), 15)
        config = self.config()
        self.assertEqual(sorted(listed), sorted(f"{group}.{key}" for group, keys in config.items()
                                                for key in keys))

    def test_every_technique_has_a_file_and_loads(self):
        names = [line.split()[0] for line in
                 self.succeed("info", "--techniques").stdout.splitlines()]
        self.assertEqual(sorted(names),
                         sorted(path.stem for path in (SOURCE / "config").glob("*.toml")))
        for name in names:
            self.config("--technique", name)
