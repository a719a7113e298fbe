# SPDX-License-Identifier: MIT
"""A virtual X display with a user in front of it: looks at windows, types, moves the mouse, drops
files."""

import os
import subprocess
import time

from Xlib import X, Xatom, display
from Xlib.error import XError
from Xlib.protocol import event


class XDisplay:
    """Xvfb with its own number, for as long as it is used in a `with`."""

    def __init__(self, width=1600, height=1000, dpi=96):
        reading, writing = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writing), "-screen", "0", f"{width}x{height}x24",
             "-nolisten", "tcp"],
            pass_fds=[writing], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as answer:
            number = answer.readline().strip()
        assert number, "Xvfb does not start"
        self.name = f":{number}"
        self.connection = display.Display(self.name)
        self.root = self.connection.screen().root
        # Where desktops tell programs how large to draw.
        self.root.change_property(Xatom.RESOURCE_MANAGER, Xatom.STRING, 8,
                                  f"Xft.dpi:\t{dpi}\n".encode())
        self.connection.flush()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.connection.close()
        self.server.terminate()
        self.server.wait()

    # --- Windows.

    def windows(self):
        """Visible windows with a title."""
        found = []
        for window in self.root.query_tree().children:
            try:
                if (window.get_attributes().map_state == X.IsViewable
                        and window.get_full_text_property(self.atom("_NET_WM_NAME"))):
                    found.append(window)
            except XError:
                pass  # it has just been closed
        return found

    def atom(self, name):
        return self.connection.intern_atom(name)

    def title(self, window):
        return window.get_full_text_property(self.atom("_NET_WM_NAME"))

    def size(self, window):
        shape = window.get_geometry()
        return shape.width, shape.height

    def picture(self, window):
        """(width, height, bytes of red, green, blue row by row) as the screen shows it."""
        width, height = self.size(window)
        data = window.get_image(0, 0, width, height, X.ZPixmap, 0xffffffff).data
        rgb = bytearray(3 * width * height)
        for channel in range(3):
            rgb[channel::3] = data[2 - channel::4]
        return width, height, bytes(rgb)

    def close(self, window):
        """What the cross in a title bar does."""
        message = event.ClientMessage(
            window=window, client_type=self.atom("WM_PROTOCOLS"),
            data=(32, [self.atom("WM_DELETE_WINDOW"), X.CurrentTime, 0, 0, 0]))
        window.send_event(message)
        self.connection.flush()

    # --- Input, by xdotool.

    def do(self, *words):
        subprocess.run(["xdotool", *map(str, words)], check=True, timeout=30,
                       env={**os.environ, "DISPLAY": self.name}, stdout=subprocess.DEVNULL)

    def focus(self, window):
        self.do("windowfocus", "--sync", window.id)

    def clipboard(self):
        return subprocess.run(["xclip", "-o", "-selection", "clipboard"], check=True, timeout=30,
                              env={**os.environ, "DISPLAY": self.name},
                              stdout=subprocess.PIPE, text=True).stdout

    # --- Drag and drop, by the XDND protocol, version 5.

    def drop(self, window, path, timeout=20):
        """Drags a file from another program to the middle of the window and lets go of it."""
        source = self.root.create_window(0, 0, 1, 1, 0, X.CopyFromParent)
        selection, uris = self.atom("XdndSelection"), self.atom("text/uri-list")
        source.set_selection_owner(selection, X.CurrentTime)
        width, height = self.size(window)
        place = ((width // 2) << 16) | (height // 2)

        def send(kind, *data):
            values = [source.id, *data] + [0] * (4 - len(data))
            window.send_event(event.ClientMessage(window=window, client_type=self.atom(kind),
                                                  data=(32, values)))
            self.connection.flush()

        send("XdndEnter", 5 << 24, uris)
        send("XdndPosition", 0, place, X.CurrentTime, self.atom("XdndActionCopy"))
        dropped, end = False, time.monotonic() + timeout
        while time.monotonic() < end:
            if not self.connection.pending_events():
                time.sleep(0.01)
                continue
            got = self.connection.next_event()
            if got.type == X.SelectionRequest:
                got.requestor.change_property(got.property, got.target, 8,
                                              f"{path.as_uri()}\r\n".encode())
                got.requestor.send_event(event.SelectionNotify(
                    time=got.time, requestor=got.requestor, selection=got.selection,
                    target=got.target, property=got.property))
                self.connection.flush()
            elif got.type == X.ClientMessage:
                if got.client_type == self.atom("XdndStatus") and not dropped:
                    assert got.data[1][1] & 1, "the window does not take the file"
                    send("XdndDrop", 0, X.CurrentTime)
                    dropped = True
                elif got.client_type == self.atom("XdndFinished"):
                    return
        raise AssertionError("the window does not answer what is dropped on it")


