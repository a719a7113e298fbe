# SPDX-License-Identifier: MIT
"""Keys and mouse: camera, time, help, panel."""

from viewer import GuiTest, Viewer
from x_display import XDisplay


def numbers(text):
    """eye, target and fov of a free camera."""
    return [[float(value) for value in part.split(",")] for part in text.split("/")]


class Keys(GuiTest):
    def setUp(self):
        self.screen = self.enterContext(XDisplay())

    def open(self, *words):
        return Viewer(self, self.screen, *words, "--size", "300x200", "--set", "ao.rays=1",
                      "--set", "occupancy.resolution=48", "--frames", 2, "--no-panel")

    def camera(self, viewer, other_than=None):
        return viewer.wait(lambda: (viewer.setting("render.camera") or "") != (other_than or "")
                           and viewer.setting("render.camera"), "the camera stays")

    def test_help_and_panel(self):
        viewer = self.open("cornell")
        bare = viewer.map()
        self.assertFalse(bare["panel"] or bare["help"])
        viewer.key("F1")
        viewer.wait_map(lambda now: now["help"], "no help")
        viewer.key("F1")
        viewer.wait_map(lambda now: not now["help"], "help stays")
        viewer.key("Tab")
        viewer.wait_map(lambda now: now["panel"] and now["widgets"], "no panel")
        viewer.key("Tab")
        viewer.wait_map(lambda now: not now["panel"] and not now["widgets"], "the panel stays")
        viewer.close()

    def test_cameras_and_moves(self):
        viewer = self.open("cornell")
        viewer.key("3")
        viewer.wait_map(lambda now: now["settings"].get("render.camera") == "partition",
                        "not the third camera")
        viewer.key("9")  # there are three
        viewer.wait_rest_after_moving()
        self.assertEqual(viewer.setting("render.camera"), "partition")
        viewer.key("2")
        viewer.wait_map(lambda now: now["settings"].get("render.camera") == "corner",
                        "not the second camera")
        last = "corner"
        for move in (lambda: viewer.drag((150, 100), (200, 110)),     # orbit
                     lambda: viewer.drag((150, 100), (200, 110), 3),  # look
                     lambda: viewer.drag((150, 100), (200, 110), 2),  # pan
                     lambda: self.screen.do("click", 4),
                     lambda: viewer.key("w"),
                     lambda: viewer.key("f")):
            move()
            last = self.camera(viewer, last)
            viewer.wait_rest_after_moving()
            last = viewer.setting("render.camera")
            self.assertEqual(len(numbers(last)), 3)
        viewer.close()

    def test_orbit_keeps_the_target_and_look_the_eye(self):
        viewer = self.open("cornell")
        viewer.key("f")
        self.camera(viewer)
        viewer.wait_rest_after_moving()
        eye, target, _ = numbers(viewer.setting("render.camera"))
        viewer.drag((150, 100), (200, 100))
        viewer.wait_rest_after_moving()
        eye_2, target_2, _ = numbers(viewer.setting("render.camera"))
        self.assertEqual(target_2, target)
        self.assertNotEqual(eye_2, eye)
        viewer.drag((150, 100), (200, 100), 3)
        viewer.wait_rest_after_moving()
        eye_3, target_3, _ = numbers(viewer.setting("render.camera"))
        self.assertEqual(eye_3, eye_2)
        self.assertNotEqual(target_3, target)
        viewer.close()

    def test_animation(self):
        viewer = self.open("dancers")
        self.assertIsNone(viewer.setting("render.time"))
        viewer.key("space")
        first = viewer.wait(lambda: viewer.setting("render.time"), "time stands")
        viewer.wait(lambda: viewer.setting("render.time") != first, "time stands")
        viewer.key("space")
        viewer.wait_rest_after_moving()
        still = viewer.setting("render.time")
        viewer.key("comma")
        back = viewer.wait(lambda: viewer.setting("render.time") != still
                           and viewer.setting("render.time"), "no step back")
        self.assertAlmostEqual(back, still - 1 / 30, places=6)
        viewer.close()

    def test_a_still_scene_does_not_play(self):
        viewer = self.open("cornell")
        viewer.key("space", "period")
        viewer.wait_rest_after_moving()
        self.assertIsNone(viewer.setting("render.time"))
        viewer.close()
