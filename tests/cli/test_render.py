# SPDX-License-Identifier: MIT
"""Pictures that `romascope render` writes."""

import json
import re

from helper import CliTest, SIZE, SOURCE, read_png


class Pictures(CliTest):
    def test_ambient_occlusion_is_a_grey_png(self):
        self.render("out.png", "--frames", "4")
        width, height, channels, rows = read_png(self.path("out.png"))
        self.assertEqual((width, height, channels), (*SIZE, 1))
        self.assertEqual(rows[0][0], (255,))  # what is not there is not occluded
        self.assertLess(min(value for row in rows for value, in row), 250)

    def test_views_are_upright_and_in_colour(self):
        self.render("out.png", "--set", "frame.view=base_color")
        width, height, channels, rows = read_png(self.path("out.png"))
        self.assertEqual((width, height, channels), (*SIZE, 3))
        # Linear 0.8, 0.3, 0.2 and 0.8 of the scene, in sRGB.
        self.assertEqual(rows[height // 2][width // 2], (231, 149, 124))
        self.assertEqual(rows[height - 1][width // 2], (231, 231, 231))
        self.assertNotIn((231, 231, 231), rows[0])
        self.render("out.png", "--set", "frame.view=normal", "--camera", "above")
        centre = read_png(self.path("out.png"))[3][height // 2][width // 2]
        self.assertEqual(max(centre), centre[1])  # up is y
        self.render("out.png", "--set", "frame.view=lit")

    def test_hdr_holds_the_linear_values(self):
        self.render("out.png", "--set", "frame.view=lit")
        self.render("out.hdr", "--set", "frame.view=lit")
        self.assertTrue(self.path("out.hdr").read_bytes().startswith(b"#?RADIANCE\n"))
        self.render("grey.png", "--frames", "3")
        self.render("GREY.HDR", "--frames", "3")
        figures = self.figures("GREY.HDR", "grey.png")
        self.assertLess(figures["mae"], 1 / 255)
        self.assertLess(abs(figures["bias"]), 1 / 1000)

    def test_named_and_spelled_cameras(self):
        first = self.picture_bytes()
        self.assertEqual(self.picture_bytes("--camera", "front"), first)
        above = self.picture_bytes("--camera", "above")
        self.assertNotEqual(above, first)
        self.assertNotEqual(self.picture_bytes("--camera", "-.5,2,3/0,0,0/60"), above)

    def test_folders_are_made(self):
        self.render("new/folder/out.png")

    def test_a_file_is_replaced(self):
        self.write("out.png", "old")
        self.render("out.png")
        read_png(self.path("out.png"))
        self.assertEqual([path.name for path in self.folder.glob("*.part*")], [])

    def test_smallest_and_narrow_pictures(self):
        for size in ("1x1", "1x300", "300x1", "7x5"):
            self.succeed("render", "scene.glb", "-o", "out.png", "--size", size)
            self.assertEqual("%dx%d" % read_png(self.path("out.png"))[:2], size)

    def test_table(self):
        text = self.render("out.png", "--table", "--reference", "4").stdout
        for word in ("gbuffer", "roma shear", "ambient occlusion", "bytes", "FLIP", "RMSE",
                     "signed bias", "clock"):
            self.assertIn(word, text)

    def test_shaders_from_a_folder(self):
        self.assertEqual(self.picture_bytes("--shaders", SOURCE / "shaders"),
                         self.picture_bytes())


class Randomness(CliTest):
    def test_the_seed_decides(self):
        words = ("--frames", "2", "--technique", "roma")
        first = self.picture_bytes("--seed", "1", *words)
        for _ in range(3):
            self.assertEqual(self.picture_bytes("--seed", "1", *words), first)
        self.assertNotEqual(self.picture_bytes("--seed", "2", *words), first)
        self.assertEqual(self.picture_bytes(*words), self.picture_bytes("--seed", "0", *words))

    def test_number_of_threads_does_not_matter(self):
        self.assertEqual(self.picture_bytes(env={"LP_NUM_THREADS": "0"}),
                         self.picture_bytes(env={"LP_NUM_THREADS": "3"}))


class Reference(CliTest):
    def test_outputs(self):
        self.render("out.png", "--reference", "16", "--reference-output", "truth.png",
                    "--error-map", "error.png")
        self.assertEqual(read_png(self.path("truth.png"))[:3], (*SIZE, 1))
        self.assertEqual(read_png(self.path("error.png"))[:3], (*SIZE, 3))
        self.assertLess(self.figures("truth.png", "out.png")["flip"], 0.5)

    def test_frames_accumulate(self):
        self.render("truth.hdr", "--reference", "256", "--reference-output", "many.hdr")
        errors = []
        for frames in (1, 4, 16):
            self.render("out.hdr", "--frames", str(frames), "--set", "ao.rays=1")
            errors.append(self.figures("many.hdr", "out.hdr")["rmse"])
        self.assertGreater(errors[0], 1.4 * errors[1])
        self.assertGreater(errors[1], 1.2 * errors[2])
        self.assertLess(errors[2], 0.12)

    def test_cache(self):
        words = ("--reference", "16", "--reference-output")
        self.render("out.png", *words, "computed.hdr")
        stored = [path for path in (self.cache / "romascope").rglob("*") if path.is_file()]
        self.assertEqual(len(stored), 1)
        self.assertIn("from the cache",
                      self.render("out.png", *words, "cached.hdr", "--table").stdout)
        self.assertEqual(self.path("computed.hdr").read_bytes(),
                         self.path("cached.hdr").read_bytes())
        self.assertNotIn("from the cache",
                         self.render("out.png", *words, "new.hdr", "--table", "--no-cache").stdout)
        # A damaged file in the cache is not taken.
        stored[0].write_bytes(stored[0].read_bytes()[:50])
        self.render("out.png", *words, "again.hdr")
        self.assertEqual(self.path("computed.hdr").read_bytes(),
                         self.path("again.hdr").read_bytes())

    def test_flicker(self):
        def flicker(*words):
            text = self.render("out.png", "--reference", "16", "--flicker", "--frames", "8",
                               "--set", "ao.rays=1", "--table", *words).stdout
            return float(re.search(r"^flicker +([0-9.]+)$", text, re.MULTILINE)[1])

        alone = flicker("--set", "mean.enabled=false")
        self.assertGreater(alone, 0.02)
        # The eighth frame changes a mean by an eighth of what it differs.
        self.assertLess(flicker(), 0.3 * alone)
        filtered = flicker("--technique", "roma-filtered")
        self.assertGreater(filtered, 0)
        self.assertLess(filtered, 0.2 * alone)

    def test_flight(self):
        def fly(*words):
            text = self.succeed("render", "scene.glb", "-o", "last.hdr", "--size", "64x48",
                                "--technique", "roma-hash", "--set", "hash.capacity=10",
                                "--frames", "5", "--table", *words).stdout
            self.assertRegex(text, r"\A\S+, flight through front, above, ")
            return self.path("last.hdr").read_bytes(), text

        # What nothing can occlude is white everywhere, however full the table.
        last, text = fly("--path", "front", "--path", "above", "--set", "ao.radius=0.0001")
        self.assertRegex(text, r"\nmost in a frame +count\n")
        self.assertRegex(text, r"\nblack pixels +0 ")
        failed = [int(n) for n in re.findall(r"^hash failed pixels +(\d+)$", text, re.MULTILINE)]
        self.assertEqual(len(failed), 2)
        self.assertLessEqual(failed[0], failed[1])
        self.assertGreater(failed[1], 0)
        self.assertEqual(last, fly("--path", "all", "--set", "ao.radius=0.0001")[0])
        # The last frame is where the last camera stands.
        one = ("--set", "ao.rays=64", "--set", "hash.enabled=false", "--set", "mean.enabled=false")
        fly("--path", "all", *one)
        self.path("last.hdr").rename(self.path("flown.hdr"))
        self.render("above.hdr", "--technique", "roma-hash", "--camera", "above", "--frames",
                    "5", *one)
        self.assertEqual(self.path("flown.hdr").read_bytes(), self.path("above.hdr").read_bytes())

    def test_a_full_hash_table_is_told_of(self):
        words = ("render", "scene.glb", "--technique", "roma-hash", "--set", "ao.rays=2", "--set",
                 "hash.footprint=1", "--size", "64x48", "--frames", "4", "--report", "out.json",
                 "--set")
        told = self.succeed(*words, "hash.capacity=10").stderr
        counts = json.loads(self.path("out.json").read_text())["counts"]
        surfaces = (counts["hash rays traced"] + counts["hash rays saved"]) // 2
        self.assertLess(surfaces, 64 * 48)
        self.assertGreater(counts["hash failed pixels"], surfaces / 100)
        self.assertEqual(told, f"notice: scene.glb: hash table full: {counts['hash failed pixels']} "
                         f"of {surfaces} pixels found no room in the last frame and show their own "
                         "rays; pictures may differ from run to run; raise hash.capacity\n")
        self.assertEqual(self.succeed(*words, "hash.capacity=16").stderr, "")

    def test_view_of_a_stage_that_is_off(self):
        view = ("render", "scene.glb", "-o", "out.png", "--size", "8x8", "--set", "frame.view=history")
        self.assertEqual(self.succeed(*view).stderr, "notice: scene.glb: frame.view=history has "
                         "nothing to show without temporal.enabled=true\n")
        self.assertEqual(self.succeed(*view, "--set", "temporal.enabled=true").stderr, "")

    def test_flight_refused(self):
        self.refuse_render("--path", "all", says=("--frames 2",))
        self.refuse_render("--path", "front", "--frames", "2",
                           says=("two cameras", "for each further one\n"))
        self.refuse_render("--path", "all", "--camera", "front", "--frames", "2",
                           says=("--camera stands still",))
        self.refuse_render("--path", "front", "--path", "", "--frames", "2", says=("--path needs",))
        for same in ("front", "front", "front"), ("0,1,2/0,0,0/60", "0,1,2/0,0,0/60"):
            words = [word for camera in same for word in ("--path", camera)]
            self.refuse_render(*words, "--frames", "2", says=(same[0], "the same one"))
        self.render("rest.png", "--path", "front", "--path", "front", "--path", "above", "--frames",
                    "2")
        self.refuse_render("--path", "front", "--path", "abve", "--frames", "2",
                           says=("did you mean 'above'",))

    def test_flicker_refused(self):
        self.refuse_render("--flicker", "--frames", "4", says=("--reference",))
        self.refuse_render("--flicker", "--reference", "4", says=("--frames 2",))
