# SPDX-License-Identifier: MIT
"""Runs a command of the documentation in little time: smaller pictures, fewer frames and rays, one
number where many are tried, one small scene in place of all that are built in.

    small_run.py PROGRAM FOLDER WORD ...

FOLDER: has that scene.
"""

import os
import re
import subprocess
import sys

SIZE, FRAMES, RAYS, SECONDS = "16x9", 3, "2", "0.1"
DRAWS = ("render", "bench", "split", "sheet")


def one_number(variation):
    """KEY=1,2,3 tries only 1; names are tried all, as what is told may need a certain one."""
    key, values = variation.split("=", 1)
    return f"{key}={values.split(',')[0]}" if re.fullmatch(r"[0-9.,]+", values) else variation


def smaller(words):
    words = list(words)
    for i in range(1, len(words) - 1):
        if words[i] == "--frames":
            words[i + 1] = str(min(int(words[i + 1]), FRAMES))
        elif words[i] == "--jump":
            words[i + 1] = "1"
        elif words[i] in ("--size", "--reference", "--seconds"):
            words[i + 1] = {"--size": SIZE, "--reference": RAYS, "--seconds": SECONDS}[words[i]]
        elif words[i] == "--vary":
            words[i + 1] = one_number(words[i + 1])
    if words and words[0] in DRAWS:
        added = {"--size": SIZE}
        if words[0] == "bench":
            added["--seconds"] = SECONDS
        if words[0] in ("split", "sheet"):
            added["--frames"] = "1"
        if words[0] == "sheet":
            added["--reference"] = RAYS
        words += [word for name, value in added.items() if name not in words
                  for word in (name, value)]
    return words


def main():
    program, folder, *words = sys.argv[1:]
    words = smaller(words)
    environment = dict(os.environ)
    if words[:1] == ["split"] and words[1].startswith("-"):
        environment["ROMASCOPE_ASSETS"] = folder
    result = subprocess.run([program, *words], env=environment, stderr=subprocess.PIPE, text=True)
    sys.stderr.write(result.stderr)
    # All is checked before a window is missed; and small pictures may well be above a bound.
    no_window = words[:1] in ([], ["view"]) and "no window can be opened" in result.stderr
    above = words[:1] == ["compare"] and "above the bound" in result.stderr
    sys.exit(0 if result.returncode == 1 and (no_window or above) else result.returncode)


if __name__ == "__main__":
    main()
