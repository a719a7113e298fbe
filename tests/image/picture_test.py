#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Renders a picture and compares it with the stored one; see picture_test in CMakeLists.txt.

Where they differ by more than is allowed, the picture and its difference (black where equal) stay
in the folder --keep.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "support"))

from png_file import read_png


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("name")
    parser.add_argument("--backend", required=True)
    parser.add_argument("--max", type=int, required=True)
    parser.add_argument("--mean", type=float, required=True)
    parser.add_argument("--failing", type=float, required=True)
    parser.add_argument("--reason", required=True)
    parser.add_argument("--keep", type=Path, required=True)
    parser.add_argument("render", nargs="+")
    return parser.parse_args()


def render(args, output):
    command = [args.program, "render", *args.render, "--backend", args.backend, "--gl-debug", "-o", str(output)]
    print(" ".join(command))
    result = subprocess.run(command, stdin=subprocess.DEVNULL)
    if result.returncode != 0:
        sys.exit(f"the render ends with status {result.returncode}")


def differences(baseline, picture):
    """Per pixel the largest difference of a channel, and the mean of all, in steps of 8 bits."""
    *shape, rows = read_png(baseline)
    *shape_now, rows_now = read_png(picture)
    if shape != shape_now:
        sys.exit(f"width, height and channels are {shape_now}, those of the baseline {shape}")
    pixels = [[abs(a - b) for a, b in zip(pixel, pixel_now)]
              for row, row_now in zip(rows, rows_now) for pixel, pixel_now in zip(row, row_now)]
    mean = sum(map(sum, pixels)) / (len(pixels) * shape[2])
    return [max(pixel) for pixel in pixels], mean


def keep(args, baseline, picture):
    args.keep.mkdir(parents=True, exist_ok=True)
    kept = args.keep / f"{args.name}.{args.backend}.png"
    shutil.copy(picture, kept)
    difference = kept.with_suffix(".difference.png")
    subprocess.run([args.program, "compare", str(baseline), str(kept), "--metric", "mae",
                    "--error-map", str(difference)], stdout=subprocess.DEVNULL)
    print(f"picture: {kept}\ndifference: {difference}\nbaseline: {baseline}")


def main():
    args = arguments()
    baseline = HERE / "baseline" / f"{args.name}.png"
    with tempfile.TemporaryDirectory() as folder:
        picture = Path(folder) / "picture.png"
        render(args, picture)
        if os.environ.get("ROMASCOPE_UPDATE_PICTURES") == "1":
            shutil.copy(picture, baseline)
            print(f"replaced {baseline}: look at it before you commit it")
            return
        if not baseline.is_file():
            sys.exit(f"there is no {baseline}: make it with ROMASCOPE_UPDATE_PICTURES=1")
        largest, mean = differences(baseline, picture)
        failing = sum(value > args.max for value in largest) / len(largest)
        print(f"largest difference {max(largest)} steps, more than {args.max}: {failing:.5f} of the "
              f"pixels (allowed {args.failing}); mean {mean:.4f} (allowed {args.mean})")
        if failing > args.failing or mean > args.mean:
            keep(args, baseline, picture)
            sys.exit(f"{args.name} differs from its baseline. Tolerances: {args.reason}")


if __name__ == "__main__":
    main()
