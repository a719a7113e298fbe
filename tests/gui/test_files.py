# SPDX-License-Identifier: MIT
"""Scenes that are opened and dropped, settings and layout that are kept, and where files go."""

import os

import viewer as gui
from viewer import SOURCE, GuiTest, Viewer
from x_display import XDisplay

FAST = ("--size", "700x600", "--set", "ao.rays=1", "--set", "occupancy.resolution=48",
        "--frames", "2")


class Files(GuiTest):
    def setUp(self):
        self.screen = self.enterContext(XDisplay())

    def below(self, folder):
        return {path.relative_to(folder) for path in folder.rglob("*") if path.is_file()}

    def test_drop(self):
        viewer = Viewer(self, self.screen, "cornell", *FAST, "--camera", "corner", "--no-panel")
        viewer.wait_rest()
        self.screen.drop(viewer.window, SOURCE / "assets" / "dancers.glb")
        viewer.wait_map(lambda now: now["scene"].endswith("dancers.glb") and now["at_rest"],
                        "the scene is not opened")
        self.assertIsNone(viewer.setting("render.camera"))
        self.assertIn("dancers", self.screen.title(viewer.window))
        # What is no scene is told, and the old one stays.
        broken = viewer.folder / "broken file.glb"
        broken.write_bytes(b"not a scene")
        self.screen.drop(viewer.window, broken)
        viewer.wait_message("broken file.glb", "error")
        self.assertTrue(viewer.map()["scene"].endswith("dancers.glb"))
        self.assertIn("broken file.glb", viewer.stderr())
        viewer.close()

    def test_what_cannot_be_opened_leaves_the_mean_as_it_is(self):
        viewer = Viewer(self, self.screen, "dancers", "--size", "200x150", "--camera", "wing",
                        *FAST[2:-1], "100000", "--set", "render.time=0.5", "--no-panel")
        settings = viewer.map()["settings"]
        empty = viewer.folder / "empty.gltf"
        empty.write_text('{"asset": {"version": "2.0"}}', encoding="utf-8")
        broken = viewer.folder / "broken.glb"
        broken.write_bytes(b"not a scene")
        for file in (empty, broken):
            before = viewer.wait_map(lambda now: now["frames_in_picture"] > 30, "no frames")
            self.screen.drop(viewer.window, file)
            viewer.wait_message(file.name, "error")
            after = viewer.map()
            self.assertGreaterEqual(after["frames_in_picture"], before["frames_in_picture"])
            self.assertEqual(after["settings"], settings)
        viewer.close()

    def test_open_by_typing(self):
        viewer = Viewer(self, self.screen, "cornell", *FAST)
        viewer.click("open")
        viewer.type("thin")
        viewer.wait_map(lambda now: now["scene"].endswith("thin.glb"), "the scene is not opened")
        viewer.click("open")
        viewer.type("nowhere.glb")
        viewer.wait_message("nowhere.glb", "error")
        viewer.close()

    def test_nothing_in_the_working_directory(self):
        viewer = Viewer(self, self.screen, "cornell", *FAST)
        viewer.wait_rest()
        viewer.key("F12")
        viewer.wait_message(r"saved .*cornell-\d{8}-\d{6}\.png")
        viewer.click("group:picture")
        viewer.click("save_settings")
        viewer.wait_message("viewer.toml")
        left, top, right, bottom = viewer.widget("panel")
        viewer.drag((right - 1, (top + bottom) / 2), (right + 80, (top + bottom) / 2))
        viewer.wait_map(lambda now: now["widgets"]["panel"][2] > right + 60, "no wider panel")
        viewer.close()
        self.assertEqual(os.listdir(viewer.work), [])
        home = self.below(viewer.folder / "home")
        self.assertIn(gui.Path(".config/romascope/viewer.toml"), home)
        self.assertIn(gui.Path(".local/state/romascope/viewer-layout.ini"), home)
        self.assertTrue(any(path.suffix == ".png" for path in home), home)
        # They are there again, unless one does without.
        again = Viewer(self, self.screen, "cornell", folder=viewer.folder)
        self.assertEqual(again.setting("occupancy.resolution"), 48)
        self.assertIn("viewer.toml", again.stderr())
        self.assertGreater(again.widget("panel")[2], right + 60)
        again.close()
        plain = Viewer(self, self.screen, "cornell", "--defaults", folder=viewer.folder)
        self.assertIsNone(plain.setting("occupancy.resolution"))
        plain.close()
