#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Tests of the window as a user meets it: real input to a real window of a virtual display.

    tests/gui/test_gui.py BINARY [TOPIC ...] [-v]

Without a topic (the ends of the names of the test_*.py files beside this one) all are tested.
"""

import shutil
import sys
import unittest
from pathlib import Path

TOPICS = sorted(path.stem[5:] for path in Path(__file__).parent.glob("test_*.py")
                if path.stem != "test_gui")


def main():
    words = [word for word in sys.argv[1:] if word != "-v"]
    if not words or not Path(words[0]).is_file() or not set(words[1:]) <= set(TOPICS):
        sys.exit(f"usage: {sys.argv[0]} BINARY [{' | '.join(TOPICS)} ...] [-v]")
    missing = [tool for tool in ("Xvfb", "xdotool", "xclip") if not shutil.which(tool)]
    try:
        import Xlib  # noqa: F401
    except ImportError:
        missing.append("python3-xlib")
    if missing:
        print(f"this machine lacks {', '.join(missing)}")
        return
    import viewer

    viewer.PROGRAM = str(Path(words[0]).resolve())
    suite = unittest.defaultTestLoader.loadTestsFromNames(
        [f"test_{topic}" for topic in words[1:] or TOPICS])
    result = unittest.TextTestRunner(verbosity=2 if "-v" in sys.argv else 1).run(suite)
    sys.exit(0 if result.wasSuccessful() and result.testsRun > 0 else 1)


if __name__ == "__main__":
    main()
