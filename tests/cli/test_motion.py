# SPDX-License-Identifier: MIT
"""Scenes that move, from the command line."""

import json
import re
import sys

from helper import SOURCE, CliTest

sys.path.insert(0, str(SOURCE / "tests" / "motion"))
import random_gltf


class Moving(CliTest):
    def setUp(self):
        super().setUp()
        # All kinds of motion; animations "animation 0" and "animation 1", each over a second long.
        random_gltf.Writer(3).write(self.path("moving.gltf"))

    def at(self, *words):
        return self.picture_bytes(*words, scene="moving.gltf")

    def report(self, *words):
        self.render("out.png", "--report", "report.json", *words, scene="moving.gltf")
        return json.loads(self.path("report.json").read_text())

    def test_pictures_of_other_moments_differ_and_of_one_do_not(self):
        start = self.at("--animation", "0")
        self.assertEqual(self.at(), start)
        self.assertEqual(self.at("--animation", "animation 0", "--time", "0"), start)
        for other in (("--time", "0.75"), ("--animation", "1"), ("--animation", "none")):
            self.assertNotEqual(self.at(*other), start, other)

    def test_a_run_of_frames_is_the_same_each_time_and_ends_at_its_last_moment(self):
        run = ("--time", "0.25", "--fps", "4", "--frames", "3")
        truth = ("--reference", "4", "--reference-output")
        first = self.at(*run, *truth, "run.hdr")
        self.assertEqual(self.at(*run), first)
        self.assertIn("from the cache", self.run_at("0.75", *truth, "last.hdr"))
        self.assertNotIn("from the cache", self.run_at("0.25", *truth, "start.hdr"))
        pictures = {name: self.path(name).read_bytes() for name in ("run.hdr", "last.hdr", "start.hdr")}
        self.assertEqual(pictures["run.hdr"], pictures["last.hdr"])
        self.assertNotEqual(pictures["run.hdr"], pictures["start.hdr"])

    def run_at(self, time, *words):
        return self.render("out.png", "--time", time, *words, scene="moving.gltf").stdout

    def test_frames_of_one_moment_accumulate(self):
        self.render("one.hdr", "--time", "0.5", scene="moving.gltf")
        self.render("many.hdr", "--time", "0.5", "--frames", "8", scene="moving.gltf")
        self.run_at("0.5", "--reference", "64", "--reference-output", "truth.hdr")
        errors = [self.figures("truth.hdr", name)["rmse"] for name in ("one.hdr", "many.hdr")]
        self.assertLess(errors[1], errors[0])

    def test_the_report_has_the_bounds_of_the_last_moment(self):
        start = self.report()
        later = self.report("--time", "0.25", "--fps", "4", "--frames", "3")
        self.assertNotEqual(start["scene"]["bounds_max_m"], later["scene"]["bounds_max_m"])
        self.assertEqual(self.report("--time", "0.75")["scene"], later["scene"])
        self.assertGreater(later["bytes"]["motion"], 0)
        self.assertEqual([p["n"] for p in later["passes"] if p["name"] == "deform"], [2])

    def test_a_jump_shows_another_moment_from_its_frame_on(self):
        still = ("--set", "mean.enabled=false", "--frames", "3")
        jumped = self.at("--time", "0.25", "--jump", "1", "0.75", *still)
        self.assertEqual(jumped, self.at("--time", "0.75", *still))
        self.assertEqual(jumped, self.at("--time", "0.25", "--jump", "2", "0.75", *still))
        report = self.report("--time", "0.25", "--jump", "1", "0.75", *still)
        self.assertEqual(report["jump"], {"frame": 1, "seconds": 0.75})
        self.assertNotIn("jump", self.report("--time", "0.25", *still))
        time = report["time"]
        self.assertEqual((time["first_s"], time["last_s"]), (0.25, 0.75))
        for words, says in ((("--jump", "3", "1"), "from 1 to 2"), (("--jump", "0", "1"), "from 1 to 2"),
                            (("--jump", "1", "-1"), "0 seconds or more"),
                            (("--jump", "1", "nan"), "0 seconds or more"),
                            (("--jump", "1", "1", "--fps", "2"), "--fps")):
            self.refuse("render", "moving.gltf", "-o", "out.png", *still, *words, says=[says])
        self.refuse("render", "moving.gltf", "-o", "out.png", "--jump", "1", "1.2",
                    says=["--jump needs at least --frames 2"])
        self.refuse("render", "cornell", "-o", "out.png", *still, "--jump", "1", "1",
                    says=["nothing in it moves,"])
        self.refuse("render", "moving.gltf", "-o", "out.png", *still, "--jump", "1", "1",
                    "--animation", "none", says=["nothing in it moves with --animation none"])
        told = self.succeed("render", "moving.gltf", "-o", "out.png", "--size", "8x8", *still,
                            "--time", "0.25", "--jump", "1", "0.25").stderr
        self.assertRegex(told, r"\Anotice: moving.gltf: stands after --jump as before it[^\n]*\n\Z")

    def test_lag(self):
        def lag(*words):
            text = self.succeed("render", "dancers", "--size", "96x54", "--time", "0.4", "--jump", "32",
                                "1.2", "--frames", "48", "--reference", "32", "--set", "ao.radius=2",
                                "--set", "mean.enabled=false", "--table", *words).stdout
            return int(re.search(r"^lag in frames +([0-9]+)$", text, re.MULTILINE)[1])

        self.assertEqual(lag(), 0)
        self.assertLessEqual(lag("--technique", "roma-hash"), 8)
        self.refuse("render", "dancers", "-o", "out.png", "--size", "1000x1000", "--jump", "1", "1",
                    "--frames", "2", "--reference", "1", "--max-memory", "100MiB", says=["all twice"])
        # A history that is never held to what is seen.
        self.assertGreater(lag("--set", "temporal.enabled=true", "--set", "temporal.clamp=inf"), 8)

    def test_all_truths_count(self):
        def errors(*words):
            return self.report("--reference", "4", "--set", "mean.enabled=false", *words)["errors"]

        def told(found):
            return found["reference_from_cache"], found["reference_seconds"]

        moves = ("--flicker", "--time", "0.25", "--fps", "4", "--frames", "4")
        jumps = ("--time", "0.3", "--jump", "1", "0.8", "--frames", "3")
        for words, moments in ((moves, (0.5, 0.75, 1.0)), (jumps, (0.3, 0.8))):
            with self.subTest(words):
                from_cache, seconds = told(errors(*words))
                self.assertFalse(from_cache)  # though the last frame's is there twice
                self.assertEqual(told(errors(*words)), (True, seconds))
                alone = [told(errors("--time", str(moment))) for moment in moments]
                self.assertTrue(all(cached for cached, _ in alone))
                self.assertAlmostEqual(sum(each for _, each in alone), seconds, places=9)
                self.assertFalse(told(errors(*words, "--no-cache"))[0])
        # One that is missing is enough.
        errors("--time", "0.6")
        self.assertFalse(told(errors("--time", "0.6", "--jump", "1", "0.7", "--frames", "2"))[0])

    def test_nothing_to_lag_behind(self):
        words = ("render", "dancers", "--size", "32x18", "--time", "0.4", "--jump", "1", "0.4",
                 "--frames", "3", "--reference", "4", "--set", "ao.radius=2")
        text = self.succeed(*words, "--table").stdout
        self.assertNotIn("lag in frames", text)
        self.assertRegex(text, r"\nno lag: ")
        self.succeed(*words, "--report", "out.json")
        self.assertNotIn("lag_frames", json.loads(self.path("out.json").read_text())["errors"])

    def test_what_moves_is_told(self):
        scene = self.report()["scene"]
        self.assertEqual([animation["name"] for animation in scene["animations"]],
                         ["animation 0", "animation 1"])
        self.assertGreater(scene["moving_vertices"], 0)
        told = json.loads(self.succeed("info", "moving.gltf", "--json").stdout)
        self.assertEqual(told["scene"], scene)
        self.assertEqual(sum(part["vertices"] for part in told["moving_parts"]),
                         scene["moving_vertices"])
        text = self.succeed("info", "moving.gltf").stdout
        for animation in scene["animations"]:
            self.assertIn(f"{animation['name']}, {animation['seconds']:.4g} s", text)
        time = self.report("--animation", "1", "--time", "0.5", "--fps", "8", "--frames", "3")["time"]
        self.assertEqual(time, {"animation": "animation 1", "first_s": 0.5, "last_s": 0.75})

    def test_sheet_shows_a_quarter_of_the_animation(self):
        seconds = self.report()["scene"]["animations"][0]["seconds"]
        words = ("sheet", "moving.gltf", "--size", "64x48", "--frames", "1", "--reference", "1", "-o")
        self.assertIn(f", {seconds / 4:.4g} s: MAE", self.succeed(*words, "a.png").stdout)
        self.succeed(*words, "b.png", "--time", repr(seconds / 4))
        self.assertEqual(self.path("a.png").read_bytes(), self.path("b.png").read_bytes())
        self.succeed(*words, "c.png", "--time", "0.01")
        self.assertNotEqual(self.path("a.png").read_bytes(), self.path("c.png").read_bytes())

    def test_unknown_animations_are_refused_with_the_nearest(self):
        self.refuse("render", "moving.gltf", "-o", "out.png", "--animation", "animation 7",
                    says=["no animation 'animation 7'", "did you mean 'animation 0'", "0 to 1"])
        self.refuse("render", "moving.gltf", "-o", "out.png", "--animation", "foo",
                    says=["no animation 'foo' (it has animation 0, animation 1; numbers go"])
