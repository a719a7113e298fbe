# SPDX-License-Identifier: MIT
"""Contact sheets."""

import glb
from helper import CliTest, read_png

TILE = (64, 48)


def colored(rows):
    """Pixels as triples, whatever the channels."""
    return [[tuple(pixel) if len(pixel) == 3 else tuple(pixel) * 3 for pixel in row]
            for row in rows]


def places_of(tile, sheet):
    """Upper left corners (x, y) of all places where the sheet holds the tile."""
    width = len(tile[0])
    return [(x, y) for y in range(len(sheet) - len(tile) + 1)
            for x in range(len(sheet[0]) - width + 1)
            if sheet[y][x] == tile[0][0] and all(
                sheet[y + i][x:x + width] == row for i, row in enumerate(tile))]


class Sheet(CliTest):
    def sheet(self, *words, output="sheet.png", **options):
        return self.run_program("sheet", *words, "-o", output, "--size", "%dx%d" % TILE,
                                "--frames", "2", "--reference", "4", **options)

    def picture(self, name):
        width, height, _, rows = read_png(self.path(name))
        self.assertEqual((width, height), (len(rows[0]), len(rows)))
        return colored(rows)

    def second_scene(self, name="other.glb"):
        document, buffer = glb.box_on_floor()
        document["nodes"][1]["translation"] = [0.7, 0, 0.3]
        glb.write_glb(self.path(name), document, buffer)
        return name

    def test_tiles_are_what_render_gives(self):
        other = self.second_scene()
        result = self.sheet("scene.glb", other)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertRegex(result.stdout, r"\Ascene, 24 triangles: MAE 0\.\d+, FLIP 0\.\d+\n"
                                        r"other, 24 triangles: MAE 0\.\d+, FLIP 0\.\d+\n\Z")
        sheet = self.picture("sheet.png")
        corners = []
        for scene in ("scene.glb", other):
            words = ("--frames", "2", "--technique", "roma")
            self.render("lit.png", "--set", "frame.view=lit", *words, scene=scene)
            text = self.render("ao.png", "--reference", "4", "--reference-output", "truth.png",
                               "--table", *words, scene=scene).stdout
            mae = float(text.split("MAE")[1].split()[0])
            self.assertIn(f"{scene[:-4]}, 24 triangles: MAE {mae:.4f}", result.stdout)
            places = [places_of(self.picture(f"{name}.png"), sheet)
                      for name in ("lit", "ao", "truth")]
            self.assertEqual([len(place) for place in places], [1, 1, 1], scene)
            corners.append([place[0] for place in places])
        # From left to right, the scenes below each other, all within the sheet.
        for row in corners:
            self.assertEqual(len({y for _, y in row}), 1)
            self.assertTrue(row[0][0] + TILE[0] <= row[1][0] <= row[2][0] - TILE[0])
        self.assertGreaterEqual(corners[1][0][1], corners[0][0][1] + TILE[1])
        self.assertLess(len(sheet[0]), 3 * TILE[0] + 40)
        self.assertLess(len(sheet), 2 * TILE[1] + 80)

    def test_columns(self):
        other = self.second_scene()
        sizes = {}
        for columns in ("1", "2", "3"):
            self.assertEqual(self.sheet("scene.glb", other, "--columns", columns).returncode, 0)
            sizes[columns] = read_png(self.path("sheet.png"))[:2]
        gap = sizes["1"][0] - 3 * TILE[0]  # four of them
        self.assertEqual(sizes["2"][0], 6 * TILE[0] + gap // 4 * 7)
        self.assertLess(sizes["2"][1], sizes["1"][1] - TILE[1])
        self.assertEqual(sizes["3"], sizes["2"])  # no empty column

    def test_settings_and_camera(self):
        self.assertEqual(self.sheet("scene.glb", "--camera", "above", "--set",
                                    "frame.view=normal", "--seed", "3").returncode, 0)
        words = ("--camera", "above", "--frames", "2", "--technique", "roma", "--seed", "3")
        self.render("normal.png", "--set", "frame.view=normal", *words)
        self.render("ao.png", *words)
        sheet = self.picture("sheet.png")
        for name in ("normal.png", "ao.png"):
            self.assertEqual(len(places_of(self.picture(name), sheet)), 1, name)

    def test_folder_with_a_refused_file(self):
        folder = self.folder / "scenes"
        (folder / "below").mkdir(parents=True)
        self.second_scene("scenes/below/b.GLB")
        glb.write_glb(folder / "z.glb", *glb.box_on_floor())
        self.write("scenes/a.gltf", "{}")
        self.write("scenes/notes.txt", "not a scene")
        result = self.sheet("scenes")
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, r"\Aromascope: scenes/a.gltf: [^\n]+\n\Z")
        self.assertEqual([line.split(",")[0] for line in result.stdout.splitlines()], ["b", "z"])
        refused = read_png(self.path("sheet.png"))[:2]
        self.assertEqual(self.sheet("scenes/z.glb", "scenes/z.glb", "scenes/z.glb").returncode, 0)
        self.assertEqual(read_png(self.path("sheet.png"))[:2], refused)

    def test_all_refused(self):
        self.write("a.gltf", "{}")
        self.assertEqual(self.sheet("a.gltf").returncode, 1)
        self.assertTrue(self.path("sheet.png").is_file())

    def test_built_in_scenes_where_none_is_named(self):
        result = self.sheet(env={"ROMASCOPE_ASSETS": str(self.folder)})
        self.assertEqual(result.returncode, 0)
        self.assertRegex(result.stdout, r"\Ascene, [^\n]*\n\Z")

    def test_refused_before_the_work(self):
        (self.folder / "empty").mkdir()
        frames = ("--frames", "1000000")
        for words, says in ((("scene.glb", "nowhere.glb"), "nowhere.glb"),
                            (("hal",), "did you mean 'hall'"),
                            (("empty",), "no .gltf or .glb file in empty"),
                            (("scene.glb", "--columns", "0"), "--columns"),
                            (("scene.glb", "--reference", "0"), "--reference"),
                            (("scene.glb", "--size", "8"), "WIDTHxHEIGHT"),
                            (("scene.glb", "--technique", "rom"), "did you mean 'roma'"),
                            (("scene.glb", "--max-memory", "1KiB"), "--max-memory")):
            self.refuse("sheet", *words, "-o", "sheet.png", *frames, says=says)
        self.refuse("sheet", "scene.glb", "-o", "sheet.jpg", *frames, says=".png or .hdr")
        self.refuse("sheet", "scene.glb", *frames, says="--output")
        self.path("in.png").symlink_to("scene.glb")
        self.refuse("sheet", "scene.glb", "-o", "in.png", *frames, says="input")
