# SPDX-License-Identifier: MIT
"""The panel: sliders, fields, choices, resets."""

import re
import subprocess

import viewer as gui
from viewer import GuiTest, Viewer
from x_display import XDisplay


class Panel(GuiTest):
    def setUp(self):
        self.screen = self.enterContext(XDisplay())
        self.viewer = Viewer(self, self.screen, "cornell", "--size", "1000x900", "--frames", 2,
                             "--set", "ao.rays=1", "--set", "occupancy.resolution=48")
        self.viewer.wait_rest()

    def find(self, text):
        """Narrows the list of knobs down."""
        self.viewer.click("filter")
        self.viewer.type(text)

    def test_slider_and_resets(self):
        viewer = self.viewer
        self.find("angular")
        before = viewer.map()
        viewer.slide("roma.angular_resolution", 0.2, 0.9)
        changed = viewer.wait_map(
            lambda now: now["settings"].get("roma.angular_resolution", 0) > 8, "the knob stays")
        self.assertLessEqual(changed["settings"]["roma.angular_resolution"], 16)
        viewer.wait_rest_after_moving()
        viewer.click("reset:roma.angular_resolution")
        viewer.wait_map(lambda now: now["settings"] == before["settings"], "no reset")
        viewer.slide("roma.angular_resolution", 0.2, 0.6)
        viewer.wait_map(lambda now: "roma.angular_resolution" in now["settings"], "the knob stays")
        viewer.key("ctrl+r")
        viewer.wait_map(lambda now: not set(now["settings"]) & {
            "roma.angular_resolution", "ao.rays", "occupancy.resolution"}, "no reset of all")
        viewer.close()

    def test_number_typed_and_refused(self):
        viewer = self.viewer
        self.find("offset")
        self.type_number("roma.normal_offset", "2.25")
        viewer.wait_map(lambda now: now["settings"].get("roma.normal_offset") == 2.25, "not 2.25")
        self.type_number("roma.normal_offset", "99")
        viewer.wait_message(r"roma\.normal_offset.*99", "error")
        self.assertEqual(viewer.setting("roma.normal_offset"), 2.25)
        self.assertIn("roma.normal_offset", viewer.stderr())
        viewer.close()

    def type_number(self, key, text):
        viewer = self.viewer
        viewer.point(*viewer.middle(key))
        self.screen.do("keydown", "ctrl")
        viewer.button("mousedown")
        viewer.button("mouseup")
        self.screen.do("keyup", "ctrl")
        viewer.type(text)

    def test_a_wrong_name_is_told_until_it_is_mended(self):
        viewer = self.viewer
        self.find("render.camera")
        viewer.point(*viewer.middle("render.camera"))
        viewer.button("mousedown")
        viewer.button("mouseup")
        viewer.type("nosuch")
        viewer.wait_message("nosuch", "error")
        viewer.key("F12")  # what is still shown is of other settings
        viewer.wait_message("no screenshot", "error")
        viewer.drag((700, 500), (740, 480))  # no camera to turn: told, and no more
        viewer.key("2")
        viewer.wait_map(lambda now: now["at_rest"] and now["settings"].get("render.camera") ==
                        "corner" and not any(message["severity"] == "error" and
                                             "nosuch" in message["text"]
                                             for message in now["messages"]),
                        "the error stays")
        viewer.close()

    def test_escape_closes_a_list(self):
        viewer = self.viewer
        viewer.click("technique")
        listed = viewer.wait_map(lambda now: any(name.startswith("technique:")
                                                 for name in now["widgets"]), "no list")
        viewer.key("Escape")
        closed = viewer.wait_map(lambda now: not any(name.startswith("technique:")
                                                     for name in now["widgets"]), "the list stays")
        self.assertEqual(closed["settings"], listed["settings"])
        viewer.close()

    def test_every_knob_is_there(self):
        """Each key that `info --knobs` lists is found in the panel."""
        text = subprocess.run([gui.PROGRAM, "info", "--knobs"], check=True, timeout=60,
                              stdout=subprocess.PIPE, text=True).stdout
        keys = [line.split()[0] for line in text.splitlines()
                if re.match(r"[a-z_]+\.[a-z_]+ ", line)]
        self.assertGreater(len(keys), 15)
        for group in dict.fromkeys(key.split(".")[0] for key in keys):
            wanted = {key for key in keys if key.startswith(group + ".")}
            with self.subTest(group=group):
                self.find(group + ".")
                self.viewer.wait_map(lambda now: wanted <= set(now["widgets"]),
                                     f"not all widgets of {wanted}")
        self.viewer.close()
