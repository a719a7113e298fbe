# SPDX-License-Identifier: MIT
"""The picture in the window is the one that is rendered offscreen."""

import re
import shlex

from viewer import GuiTest, Viewer, rgb_of_png
from x_display import XDisplay

SIZE = ("--size", "320x200")


class Picture(GuiTest):
    def setUp(self):
        self.screen = self.enterContext(XDisplay())

    def offscreen(self, viewer, frames, *words):
        line = shlex.join(["romascope", "render", words[0], "-o", "x", "--frames", str(frames),
                           *words[1:]])
        return rgb_of_png(self.render(viewer, line, viewer.folder / "offscreen.png"))

    def compare(self, *words):
        viewer = Viewer(self, self.screen, *words, "--frames", 3, "--no-panel")
        viewer.wait_rest()
        self.assert_same_picture(viewer.picture(), self.offscreen(viewer, 3, *words))
        viewer.close()

    def test_ambient_occlusion(self):
        self.compare("cornell", *SIZE)

    def test_lit_with_other_knobs(self):
        self.compare("dancers", *SIZE, "--time", "1.25", "--camera", "wing",
                     "--set", "frame.view=lit", "--set", "frame.antialias=true",
                     "--set", "occupancy.resolution=65", "--seed", "9")

    def test_copied_command_and_screenshot(self):
        """What was changed by hand is in the copied command; its file, the screenshot and the
        window show the same."""
        viewer = Viewer(self, self.screen, "dancers", *SIZE, "--frames", 2, "--no-panel",
                        "--screenshots", "shots")
        viewer.wait_rest()
        viewer.drag((100, 100), (180, 90))
        self.screen.do("click", 4)
        viewer.key("period", "period", "period")
        viewer.wait_map(lambda now: now["at_rest"] and abs(
            now["settings"].get("render.time", 0) - 0.1) < 1e-6, "time does not go on")
        seen = viewer.picture()
        viewer.key("F12")
        told = viewer.wait_message(r"saved .*\.png")
        viewer.key("ctrl+c")
        viewer.wait_message("copied: romascope render")
        line = self.screen.clipboard()
        self.assertIn("--camera", line)
        shot = viewer.work / re.search(r"saved (\S+\.png) \(320x200, 2 frames\)", told)[1]
        self.render(viewer, line, viewer.folder / "again.png")
        self.assertEqual(shot.read_bytes(), (viewer.folder / "again.png").read_bytes())
        self.assert_same_picture(seen, rgb_of_png(shot))
        viewer.close()

    def test_rest_after_motion_is_as_if_it_had_never_moved(self):
        viewer = Viewer(self, self.screen, "cornell", *SIZE, "--frames", 4, "--no-panel")
        viewer.wait_rest()
        before = viewer.picture()
        viewer.key("2")
        viewer.wait_map(lambda now: now["settings"].get("render.camera") and now["at_rest"],
                        "no other camera")
        self.assertTrue(viewer.picture() != before)
        viewer.drag((100, 100), (140, 90))
        viewer.key("1")
        viewer.wait_map(lambda now: now["settings"].get("render.camera") == "front"
                        and now["at_rest"], "not the first camera")
        viewer.wait_rest_after_moving()
        self.assertTrue(viewer.picture() == before)
        viewer.close()

    def test_screenshot_of_another_size(self):
        viewer = Viewer(self, self.screen, "cornell", "--size", "900x600", "--frames", 2,
                        "--set", "ao.rays=1", "--screenshots", "shots")
        viewer.wait_rest()
        viewer.click("group:picture")
        left, top, right, bottom = viewer.widget("shot_size")
        for part, text in ((0.2, "123"), (0.7, "77")):  # two fields
            viewer.point(left + part * (right - left), (top + bottom) / 2)
            self.screen.do("click", "--repeat", 2, "--delay", 60, 1)
            viewer.type(text)
        viewer.key("shift+F12")
        told = viewer.wait_message(r"saved .*\(123x77\)")
        shot = viewer.work / re.search(r"saved (\S+\.png)", told)[1]
        viewer.key("ctrl+c")
        viewer.wait_message("copied")
        line = self.screen.clipboard().replace("900x600", "123x77")
        self.render(viewer, line, viewer.folder / "again.png")
        self.assertEqual(shot.read_bytes(), (viewer.folder / "again.png").read_bytes())
        viewer.close()
