# SPDX-License-Identifier: MIT
"""Sizes of the window, screens with small pixels, the end."""

import subprocess

import viewer as gui
from viewer import GuiTest, Viewer
from x_display import XDisplay

FAST = ("--set", "ao.rays=1", "--set", "occupancy.resolution=48")


class Window(GuiTest):
    def setUp(self):
        self.screen = self.enterContext(XDisplay())

    def resize(self, viewer, width, height):
        self.screen.do("windowsize", viewer.window.id, width, height)
        # Below 1x1 and beyond what a picture may be there is nothing to try.
        viewer.wait_map(lambda now: now["size"] == [width, height] and now["at_rest"],
                        f"the picture is not {width}x{height}")

    def test_tiny_and_huge(self):
        viewer = Viewer(self, self.screen, "cornell", "--size", "300x200", *FAST, "--frames", 2)
        viewer.wait_rest()
        viewer.key("Tab")
        viewer.wait_map(lambda now: not now["panel"], "the panel stays")
        viewer.wait_rest()
        before = viewer.picture()
        for size in ((1, 1), (3, 400), (400, 2), (64, 48), (3000, 2200), (300, 200)):
            with self.subTest(size=size):
                self.resize(viewer, *size)
                self.assertEqual(viewer.setting("render.width"), size[0])
        viewer.wait(lambda: viewer.picture() == before, "another picture at the same size")
        viewer.key("Tab")
        viewer.wait_map(lambda now: now["panel"], "no panel")
        for size in ((1, 1), (20, 900), (1500, 12), (300, 200)):
            with self.subTest(size=size):
                self.resize(viewer, *size)
        self.assertEqual([message for message in viewer.map()["messages"]
                          if message["severity"] == "error"], [])
        viewer.close()

    def test_the_panel_is_as_wide_again(self):
        viewer = Viewer(self, self.screen, "cornell", "--size", "900x300", *FAST, "--frames", 1)
        viewer.wait_rest()
        before = viewer.widget("panel")
        for size in ((1, 1), (250, 90)):
            self.resize(viewer, *size)
        self.resize(viewer, 900, 300)
        viewer.wait_map(lambda now: now["widgets"].get("panel") == before, f"not {before}")
        viewer.close()

    def test_the_width_of_the_panel_is_kept_in_letters(self):
        folder, widths = self.new_folder(), []
        for dpi in (96, 192, 96):
            with XDisplay(3000, 1800, dpi) as screen:
                viewer = Viewer(self, screen, "cornell", *FAST, "--frames", 1, folder=folder)
                viewer.wait_rest()
                if not widths:
                    left, top, right, bottom = viewer.widget("panel")
                    y = (top + bottom) / 2
                    viewer.drag((right - 1, y), (right + 99, y))
                    viewer.wait_map(lambda now: now["widgets"]["panel"][2] > right + 90,
                                    "no wider panel")
                widths.append(viewer.widget("panel")[2])
                viewer.close()
        self.assertAlmostEqual(widths[1], 2 * widths[0], delta=3)  # whole pixels
        self.assertAlmostEqual(widths[2], widths[0], delta=2)

    def test_small_pixels(self):
        """Twice the pixels per inch: window and widgets are twice as large."""
        heights, sizes = [], []
        for dpi in (96, 192):
            with XDisplay(3000, 1800, dpi) as screen:
                viewer = Viewer(self, screen, "cornell", *FAST, "--frames", 1)
                viewer.wait_rest()
                left, top, right, bottom = viewer.map()["widgets"]["technique"]
                heights.append(bottom - top)
                sizes.append(viewer.map()["size"])
                viewer.close()
        self.assertEqual(sizes[1], [2 * value for value in sizes[0]])
        self.assertAlmostEqual(heights[1] / heights[0], 2, delta=0.1)

    def test_the_cross_closes_it(self):
        viewer = Viewer(self, self.screen, "cornell", "--size", "300x200", *FAST)
        self.screen.close(viewer.window)
        self.assertEqual(viewer.process.wait(gui.PATIENCE), 0)

    def test_plain_command_shows_the_default_scene(self):
        folder = self.new_folder()
        process = subprocess.Popen([gui.PROGRAM], cwd=folder, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL,
                                   env={"HOME": str(folder), "DISPLAY": self.screen.name})
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        for _ in range(gui.PATIENCE * 10):
            if self.screen.windows():
                break
            gui.time.sleep(0.1)
        window, = self.screen.windows()
        self.assertIn("hall", self.screen.title(window))
        # With a picture in it from the first moment on, but for what the display needs to show it.
        gui.time.sleep(0.2)
        width, height, rgb = self.screen.picture(window)
        self.assertGreater(len(set(rgb[3 * width * height // 2:])), 50)
        self.screen.close(window)
        self.assertEqual(process.wait(gui.PATIENCE), 0)
