# SPDX-License-Identifier: MIT
"""Shaders that change while they are looked at."""

import re
import shutil

from viewer import SOURCE, GuiTest, Viewer, rgb_of_png
from x_display import XDisplay

ESTIMATOR = "estimators/ambient_occlusion.comp.glsl"


class Shaders(GuiTest):
    def setUp(self):
        self.screen = self.enterContext(XDisplay())
        self.shaders = self.new_folder() / "shaders"
        shutil.copytree(SOURCE / "shaders", self.shaders)
        self.viewer = Viewer(self, self.screen, "cornell", "--size", "300x200", "--frames", 2,
                             "--no-panel", "--shaders", self.shaders)
        self.viewer.wait_rest()

    def change(self, file, change):
        path = self.shaders / file
        path.write_text(change(path.read_text(encoding="utf-8")), encoding="utf-8")

    def test_break_and_mend(self):
        before = self.viewer.picture()
        whole = (self.shaders / ESTIMATOR).read_text(encoding="utf-8")
        self.change(ESTIMATOR, lambda text: text.replace("void main() {", "void main() { oops;"))
        line = 1 + whole[:whole.index("void main() {")].count("\n")
        told = self.viewer.wait_message("oops", "error")
        self.assertIn(f"{ESTIMATOR}:{line}", told)
        self.assertIn("oops", self.viewer.stderr())
        self.viewer.wait_rest_after_moving()
        self.viewer.wait_rest_after_moving()
        # The error is shown over the picture, which is still the old program's.
        self.viewer.key("F12")
        told = self.viewer.wait_message(r"saved .*\.png")
        self.assert_same_picture(rgb_of_png(re.search(r"saved (\S+\.png)", told)[1]), before)
        # Mended, and another picture: nothing is occluded.
        self.change(ESTIMATOR, lambda _: whole.replace("tracer_any_hit(", "false && tracer_any_hit(")
                    .replace("tracer_candidate_any_hit(", "false && tracer_candidate_any_hit("))
        self.viewer.wait(lambda: self.viewer.picture() != before, "the picture stays")
        self.viewer.wait(lambda: set(self.viewer.picture()[2]) == {255}, "not all is open")
        self.assertEqual([message for message in self.viewer.map()["messages"]
                          if message["severity"] == "error"], [])
        self.change(ESTIMATOR, lambda _: whole)
        self.viewer.wait(lambda: self.viewer.picture() == before, "the picture does not come back")
        self.viewer.close()

    def test_a_header_is_followed(self):
        before = self.viewer.picture()
        header = "common/random.h"
        whole = (self.shaders / header).read_text(encoding="utf-8")
        self.change(header, lambda text: text.replace("#pragma once", "#pragma once\n#error broken"))
        self.viewer.wait_message("broken", "error")
        (self.shaders / header).unlink()
        self.viewer.wait_message(header, "error")
        self.change_back(header, whole)
        self.viewer.wait(lambda: self.viewer.picture() == before, "the picture does not come back")
        self.viewer.close()

    def change_back(self, file, text):
        (self.shaders / file).write_text(text, encoding="utf-8")
