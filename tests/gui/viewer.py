# SPDX-License-Identifier: MIT
"""romascope's window as a user meets it, and what tests ask of it."""

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))

from png_file import read_png

PROGRAM = None  # the binary under test; set by test_gui.py
SOURCE = Path(__file__).resolve().parents[2]
# Generous: a software renderer on a busy machine.
PATIENCE = 60


def rgb_of_png(path):
    """(width, height, bytes) as XDisplay.picture() has them."""
    width, height, channels, rows = read_png(path)
    flat = bytes(value for row in rows for pixel in row for value in pixel)
    if channels == 1:
        rgb = bytearray(3 * width * height)
        for channel in range(3):
            rgb[channel::3] = flat
        flat = bytes(rgb)
    return width, height, flat


class Viewer:
    """A running `romascope view`; everything it writes goes below `folder`."""

    def __init__(self, test, screen, *words, folder=None):
        self.test, self.screen = test, screen
        self.folder = folder or test.new_folder()
        self.map_file = self.folder / "map.json"
        self.map_file.unlink(missing_ok=True)
        self.work = self.folder / "work"
        self.work.mkdir(exist_ok=True)
        self.errors = open(self.folder / "stderr.txt", "w+", encoding="utf-8")
        test.addCleanup(self.errors.close)
        self.process = subprocess.Popen(
            [PROGRAM, "view", *map(str, words), "--ui-map", self.map_file],
            cwd=self.work, env=self.environment(), stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL, stderr=self.errors)
        test.addCleanup(self.kill)
        self.window = self.wait(lambda: next(iter(screen.windows()), None), "no window is shown")
        screen.focus(self.window)
        self.wait(self.map_file.exists, "the widgets are not told")

    def environment(self):
        keep = {name: value for name, value in os.environ.items()
                if not name.startswith(("DISPLAY", "WAYLAND", "XDG_", "ROMASCOPE_", "MESA_",
                                        "LIBGL_", "GALLIUM_"))}
        return {**keep, "DISPLAY": self.screen.name, "HOME": str(self.folder / "home"),
                "XDG_CACHE_HOME": str(self.folder / "cache")}

    def kill(self):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()

    def stderr(self):
        self.errors.flush()
        return (self.folder / "stderr.txt").read_text(encoding="utf-8")

    # --- What it shows.

    def map(self):
        return json.loads(self.map_file.read_text(encoding="utf-8"))

    def wait(self, condition, what, patience=PATIENCE):
        """The first value of condition() that counts as true."""
        end = time.monotonic() + patience
        while time.monotonic() < end:
            value = condition()
            if value:
                return value
            if self.process.poll() is not None:
                self.test.fail(f"the viewer ended with {self.process.returncode}: {self.stderr()}")
            time.sleep(0.02)
        state = self.map_file.read_text(encoding="utf-8") if self.map_file.exists() else "no map"
        self.test.fail(f"{what}: {state}\n{self.stderr()}")

    def wait_map(self, condition, what):
        """The first map for which the condition holds."""
        def found():
            now = self.map()
            return now if condition(now) else None
        return self.wait(found, what)

    def wait_rest(self):
        return self.wait_map(lambda now: now["at_rest"], "the picture does not come to rest")

    def wait_rest_after_moving(self):
        """At rest, and told so twice: what was done last has been seen."""
        time.sleep(0.3)
        self.wait_rest()
        time.sleep(0.2)
        return self.wait_rest()

    def wait_message(self, pattern, severity=None):
        def found(now):
            return any(re.search(pattern, message["text"]) and
                       severity in (None, message["severity"]) for message in now["messages"])
        now = self.wait_map(found, f"no message {pattern!r}")
        return next(message["text"] for message in reversed(now["messages"])
                    if re.search(pattern, message["text"]))

    def picture(self):
        """What stands on the screen: a frame that the viewer has drawn may still be on its way to a
        busy X server. What never stands still is seen as it is."""
        last = self.screen.picture(self.window)
        for _ in range(10):
            time.sleep(0.15)
            now = self.screen.picture(self.window)
            if now == last:
                break
            last = now
        return last

    def setting(self, key):
        return self.map()["settings"].get(key)

    # --- What a user does.

    def key(self, *names):
        for name in names:
            self.screen.do("key", "--delay", "50", name)

    def hold_key(self, *names):
        """Long enough for a widget, which looks once a frame."""
        for name in names:
            self.screen.do("keydown", name)
        time.sleep(0.5)
        for name in reversed(names):
            self.screen.do("keyup", name)

    def type(self, text):
        """In place of what stands in the text field that has the focus; with Return."""
        self.hold_key("ctrl", "a")
        self.screen.do("type", "--delay", "60", text)
        time.sleep(0.3)
        self.hold_key("Return")

    def point(self, x, y):
        self.screen.do("mousemove", round(x), round(y))
        time.sleep(0.1)

    def button(self, action, number=1):
        self.screen.do(action, number)
        # A frame of a software renderer must see it before the next.
        time.sleep(0.4)

    def drag(self, start, end, number=1):
        self.point(*start)
        self.button("mousedown", number)
        for part in (1 / 3, 2 / 3, 1):
            self.point(*(a + part * (b - a) for a, b in zip(start, end)))
            time.sleep(0.2)
        self.button("mouseup", number)

    def widget(self, name):
        """Its rectangle, once it is seen; the panel is scrolled to it if need be."""
        now = self.map()
        if name not in now["widgets"]:
            self.scroll_to(name)
        return self.wait_map(lambda now: name in now["widgets"],
                             f"no widget {name}")["widgets"][name]

    def scroll_to(self, name):
        left, top, _, bottom = self.map()["widgets"]["panel"]
        self.point(left + 5, (top + bottom) / 2)
        for direction in (4, 5):  # the wheel, up and down
            for _ in range(60):
                if name in self.map()["widgets"]:
                    return
                self.screen.do("click", direction)
                time.sleep(0.15)

    def middle(self, name):
        left, top, right, bottom = self.widget(name)
        return (left + right) / 2, (top + bottom) / 2

    def click(self, name):
        self.point(*self.middle(name))
        self.button("mousedown")
        self.button("mouseup")

    def slide(self, name, begin, end):
        """Drags a slider from one fraction of its width to another."""
        left, top, right, bottom = self.widget(name)
        y = (top + bottom) / 2
        self.drag((left + begin * (right - left), y), (left + end * (right - left), y))

    def close(self):
        """By the key; it must end well."""
        self.key("ctrl+q")
        self.test.assertEqual(self.process.wait(PATIENCE), 0, self.stderr())


class GuiTest(unittest.TestCase):
    def new_folder(self):
        folder = Path(tempfile.mkdtemp(prefix="romascope-gui-"))
        self.addCleanup(shutil.rmtree, folder, ignore_errors=True)
        (folder / "home").mkdir()
        return folder

    def render(self, viewer, line, output):
        """Runs a command line of `romascope render` offscreen, as a user would who pasted it."""
        words = shlex.split(line)
        self.assertEqual(words[:2], ["romascope", "render"], line)
        words[0] = PROGRAM
        words[words.index("-o") + 1] = str(output)
        environment = viewer.environment()
        del environment["DISPLAY"]
        result = subprocess.run(words, cwd=viewer.work, env=environment, timeout=300,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertEqual(result.returncode, 0, f"{line}: {result.stdout}")
        return output

    def assert_same_picture(self, seen, wanted, tolerance=1):
        """Both as (width, height, rgb). Every value within `tolerance` of 255: window and file
        round the same numbers, so nothing but the driver's conversion on its way to the screen can
        differ."""
        self.assertEqual(seen[:2], wanted[:2])
        if seen[2] == wanted[2]:
            return
        worst = max(abs(a - b) for a, b in zip(seen[2], wanted[2]))
        self.assertLessEqual(worst, tolerance)
