# SPDX-License-Identifier: MIT
"""Error splits: what their tables hold and that they add up."""

import csv
import json

from helper import CliTest, glb
from png_file import read_png

QUICK = ("--size", "16x12", "--frames", "2", "--set", "occupancy.resolution=32")
STEPS = ["voxelisation", "snapping", "resampling", "whole", "own direction"]


class Split(CliTest):
    def split(self, *words, scenes=("scene.glb",)):
        """The facts and the rows of the CSV; the table is in self.table."""
        result = self.succeed("split", *scenes, "--csv", "out.csv", *QUICK, *words)
        self.assertEqual(result.stderr, "")
        self.table = result.stdout
        lines = self.path("out.csv").read_text().splitlines()
        facts = dict(line[2:].split(": ", 1) for line in lines if line.startswith("# "))
        rows = list(csv.DictReader(line for line in lines if not line.startswith("# ")))
        for row in rows:
            for key in ("rays", "wrong", "leaks", "false_shadows", "difference"):
                row[key] = int(row[key])
        return facts, rows

    def names(self, rows):
        return list(dict.fromkeys(row["variant"] for row in rows))

    def test_every_tracer_adds_up(self):
        facts, rows = self.split()
        self.assertEqual(self.names(rows), ["roma roma.alignment=rotate",
                                            "roma roma.alignment=shear", "dda", "dda2d", "samples"])
        self.assertIn("16x12", facts["rays"])
        self.assertNotIn("date", facts)
        cameras = len(facts["scene"].split("cameras: ")[1].split(", "))
        for name in self.names(rows):
            steps = [row for row in rows if row["variant"] == name]
            self.assertEqual([row["step"] for row in steps], STEPS)
            for row in steps:
                self.assertTrue(0 < row["rays"] <= 16 * 12 * 2 * cameras)
                self.assertEqual(row["wrong"], row["leaks"] + row["false_shadows"])
                self.assertEqual(row["difference"], row["leaks"] - row["false_shadows"])
                share = 100 * row["wrong"] / row["rays"]
                self.assertAlmostEqual(float(row["wrong_percent"]), share, places=3)
                self.assertIn(f"{share:.3f}", self.table)
            parts = {row["step"]: row["difference"] for row in steps}
            self.assertEqual(sum(parts[step] for step in STEPS[:3]), parts["whole"])
            if name in ("dda", "dda2d"):
                self.assertEqual((steps[1]["wrong"], steps[2]["wrong"]), (0, 0))
                self.assertEqual(steps[0]["wrong"], steps[3]["wrong"])

    def test_all_scenes_are_the_sum(self):
        glb.write_glb(self.path("other.glb"), *glb.box_on_floor())
        _, rows = self.split("--technique", "roma-rotate", scenes=("scene.glb", "other.glb"))
        self.assertEqual([row["scene"] for row in rows],
                         ["scene"] * 5 + ["other"] * 5 + ["all"] * 5)
        for step in STEPS:
            of_step = [row for row in rows if row["step"] == step]
            for key in ("rays", "wrong", "leaks", "difference"):
                self.assertEqual(of_step[0][key] + of_step[1][key], of_step[2][key])

    def test_a_scene_named_twice_counts_once(self):
        _, once = self.split("--technique", "dda")
        _, twice = self.split("--technique", "dda", scenes=("scene.glb", "./scene.glb"))
        self.assertEqual(twice, once)

    def test_the_same_bytes_on_every_run(self):
        words = ("--vary", "technique.tracer=roma,samples", "--set", "roma.alignment=shear")
        outcomes = []
        for name in ("a", "b"):
            self.split(*words, "--json", f"{name}.json", "--picture", f"{name}.png")
            outcomes.append((self.table, self.path("out.csv").read_bytes(),
                             self.path(f"{name}.json").read_bytes(),
                             self.path(f"{name}.png").read_bytes()))
        self.assertEqual(*outcomes)
        self.split(*words, "--seed", "1")
        self.assertNotEqual(self.table.split("settings: ")[1], outcomes[0][0].split("settings: ")[1])

    def test_json_holds_the_same(self):
        facts, rows = self.split("--technique", "roma", "--json", "out.json")
        found = json.loads(self.path("out.json").read_text())
        self.assertEqual(found["schema"], "romascope-split/1")
        self.assertEqual(found["facts"]["rays"], facts["rays"])
        for row, other in zip(found["rows"], rows, strict=True):
            for key in ("variant", "scene", "step", "rays", "wrong", "leaks", "false_shadows",
                        "difference"):
                self.assertEqual(row[key], other[key])

    def test_the_best_of_each(self):
        words = ("--vary", "technique.tracer=roma,dda", "--vary", "roma.alignment=rotate,shear",
                 "--vary", "roma.escape=0,2", "--vary", "dda.escape=0,1,2")
        _, rows = self.split(*words)
        _, best = self.split(*words, "--best", "roma.alignment")
        self.assertEqual(len(self.names(best)), 3)

        def wrong(name):
            return next(row["wrong"] for row in rows
                        if (row["variant"], row["step"]) == (name, "own direction"))

        for name in self.names(best):
            group = name.rsplit(" ", 1)[0]  # without the escape
            least = min(wrong(other) for other in self.names(rows) if other.startswith(group))
            self.assertEqual(wrong(name), least)

    def test_an_alignment_that_is_given_is_the_only_one(self):
        roma = ("--set", "technique.tracer=roma")
        both = ["roma roma.alignment=rotate", "roma roma.alignment=shear"]
        for words, names in ((roma, both), ((*roma, "--set", "roma.alignment=shear"), ["roma"]),
                             (("--technique", "roma"), ["roma"])):
            with self.subTest(words):
                self.assertEqual(self.names(self.split(*words)[1]), names)

    def test_cameras(self):
        facts, rows = self.split("--technique", "dda", "--camera", "3,2,4/0,0,0/50")
        self.assertIn("3,2,4/0,0,0/50", facts["scene"])

    def test_pictures(self):
        def colours(*words):
            self.split(*words, "--picture", "out.png")
            width, height, channels, rows = read_png(self.path("out.png"))
            self.assertEqual(channels, 3)
            self.assertGreaterEqual(width, 6 * 160)  # the truth and five steps, labels legible
            self.assertGreaterEqual(height, 12)
            pixels = [pixel for row in rows for pixel in row]
            return (sum(red > 2 * blue for red, _, blue in pixels),
                    sum(blue > 2 * red for red, _, blue in pixels))

        # Two samples a ray see next to nothing; an offset of nothing sees one's own surface.
        red, blue = colours("--technique", "samples", "--set", "samples.count=2")
        self.assertGreater(red, 20)
        self.assertLess(blue, red)
        red, blue = colours("--technique", "dda", "--set", "dda.normal_offset=0")
        self.assertGreater(blue, 100)
        self.assertLess(red, blue)

    def test_refused_before_the_work(self):
        for words, says in (
                (("--vary", "roma.taps=1,9"), "1 to 3"),
                (("--vary", "roma.taps=1", "--vary", "roma.taps=2"), "twice"),
                (("--vary", "render.width=64,128"), "share one picture"),
                (("--best", "roma.tap"), "did you mean 'roma.taps'"),
                (("--set", "technique.tracer=rom"), "did you mean 'roma'"),
                (("--fps", "25"), "--fps"),
                (("--camera", "nowhere"), "nowhere"),
                (("--picture", "out.jpg"), "out.jpg"),
                (("--max-memory", "1KiB"), "--max-memory")):
            self.refuse("split", "scene.glb", "--csv", "out.csv", *words, says=says)
        self.refuse("split", "nowhere.glb", says="nowhere.glb")
        self.refuse("split", "scene.glb", "--csv", "scene.glb", says="input")
        self.refuse("split", "scene.glb", "--csv", "a.csv", "--json", "a.csv", says="two outputs")
