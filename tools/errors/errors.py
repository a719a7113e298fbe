#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Mean absolute error of ambient occlusion by each method at its best values, over all cameras of
the built-in scenes, as a table. Options that are not its own are passed on to `romascope render`."""

import argparse
import json
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

METHODS = {
    "shear (`roma`)": ("--technique", "roma"),
    "rotation, box (`roma-rotate`)": ("--technique", "roma-rotate"),
    "as published (`roma-snap`)": ("--technique", "roma-snap"),
    "likewise, offset 0.5, escape 2": ("--technique", "roma-snap", "--set",
                                       "roma.normal_offset=0.5", "--set", "roma.escape=2"),
    "`dda`": ("--technique", "dda"),
    "`dda2d`": ("--technique", "dda2d"),
    "`samples`": ("--technique", "samples"),
}


def run(*words):
    result = subprocess.run([str(word) for word in words], capture_output=True, text=True)
    if result.returncode:
        sys.exit(result.stderr.strip() or f"{words[0]} ended with status {result.returncode}")
    return result.stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--romascope", required=True, help="the program")
    parser.add_argument("--jobs", type=int, default=1, help="renders at a time")
    # Enough rays for noise to count for little: what is left is the method's own.
    parser.add_argument("--rays", type=int, default=16, help="per pixel and frame")
    for name, default in (("frames", 64), ("size", "320x180"), ("reference", 1024)):
        parser.add_argument(f"--{name}", default=str(default), help="as of romascope render")
    options, passed_on = parser.parse_known_args()
    asked = ["--frames", options.frames, "--size", options.size, "--reference", options.reference,
             "--set", f"ao.rays={options.rays}", *passed_on]
    scenes = [line.split()[0] for line in run(options.romascope, "info", "--scenes").splitlines()]
    views = [(scene, camera["name"]) for scene in scenes
             for camera in json.loads(run(options.romascope, "info", scene, "--json"))["cameras"]]
    tasks = [(method, *view) for method in METHODS for view in views]

    with tempfile.TemporaryDirectory() as folder:
        def errors_of(task):
            method, scene, camera = task
            report = Path(folder) / f"{tasks.index(task)}.json"
            run(options.romascope, "render", scene, "--camera", camera, *METHODS[method], *asked,
                "--report", report)
            if os.isatty(2):
                print(f"\r{tasks.index(task) + 1} of {len(tasks)} ", end="", file=sys.stderr)
            return json.loads(report.read_text())

        with ThreadPoolExecutor(options.jobs) as pool:
            reports = dict(zip(tasks, pool.map(errors_of, tasks)))
    if os.isatty(2):
        print("\r" + " " * 20 + "\r", end="", file=sys.stderr)

    def mean(method, scene, key):
        values = [reports[method, *view]["errors"][key] for view in views
                  if scene in ("mean", view[0])]
        return sum(values) / len(values)

    columns = [*scenes, "mean"]
    print(f"| mean absolute error | {' | '.join(columns)} | bias | FLIP |")
    print("|---" * (len(columns) + 3) + "|")
    for method in METHODS:
        cells = [f"{mean(method, scene, 'mae'):.4f}" for scene in columns]
        print(f"| {method} | {' | '.join(cells)} | {mean(method, 'mean', 'bias'):+.4f} "
              f"| {mean(method, 'mean', 'flip'):.3f} |")
    driver = reports[tasks[0]]["driver"]
    print(f"\n{len(views)} cameras, {driver['renderer']}, {driver['gl_version']}, "
          f"{' '.join(asked)}")


if __name__ == "__main__":
    main()
