#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes the scenes of this folder, the same bytes on every run. Needs Python only."""

import argparse
import importlib
import os
import sys

SCENES = ("cornell", "dancers", "foliage", "hall", "street", "thin")


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scene", nargs="*", help="all if none is named: " + ", ".join(SCENES))
    parser.add_argument("--output", default=here, metavar="FOLDER", help="default: %(default)s")
    parser.add_argument(
        "--check", action="store_true", help="write nothing; fail if a file differs from its source"
    )
    arguments = parser.parse_args()
    for name in arguments.scene:
        if name not in SCENES:
            parser.error(f"no scene '{name}'; there are: {', '.join(SCENES)}")

    stale = False
    for name in arguments.scene or SCENES:
        document = importlib.import_module(f"generator.{name}").build()
        path = os.path.join(arguments.output, f"{name}.glb")
        facts = f"{document.triangle_count()} triangles, {len(document.to_bytes())} bytes"
        if not arguments.check:
            document.write(path)
            print(f"{path}: {facts}")
        elif not os.path.exists(path) or open(path, "rb").read() != document.to_bytes():
            print(f"{path}: differs from what its source gives ({facts}); write it anew")
            stale = True
        else:
            print(f"{path}: up to date ({facts})")
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
