#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Renders each file of a folder of hostile glTF files, and compares with what is expected.

The folder has a MANIFEST.json: `files`, each with `file`, `category`, `why` and
`khronos_validator.errors`. What must become of each file is in expectations.json beside this
script: it is drawn, so that something is to be seen unless `invisible` says why not, or refused
with a line that contains `says`. `reason` tells why that is other than the number of the
validator's errors suggests.

Always: within 10 s, by the clock or of processor time, as others may keep it waiting; 1 GiB of
memory; a picture and status 0, or status 2 with one line that names
the file and nothing written; no other status, no signal, no sanitizer's report."""

import argparse
import collections
import concurrent.futures
import json
import os
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "support"))

from measured_run import run_measured
from png_file import read_png

LIMIT_SECONDS = 10
HANGS_SECONDS = 120
LIMIT_BYTES = 1 << 30
SIZE = (64, 36)
REPORTS = ("Sanitizer", "runtime error:")
EXPECTATIONS = HERE / "expectations.json"


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", nargs="?", default=os.environ.get("ROMASCOPE_HOSTILE"),
                        help="default: $ROMASCOPE_HOSTILE")
    parser.add_argument("--romascope", required=True, help="the program")
    parser.add_argument("--sanitized", action="store_true",
                        help="the program is built with sanitizers, whose memory does not count")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--only", default="", help="files whose name contains this")
    parser.add_argument("--pictures", type=Path, help="keep what is drawn in this folder")
    parser.add_argument("--lines", action="store_true", help="print what was said of each file")
    parser.add_argument("--differences", action="store_true",
                        help="only list where expectations differ from the manifest's codes, and why")
    options = parser.parse_args()
    options.romascope = os.path.abspath(options.romascope)
    options.folder = options.folder and os.path.abspath(options.folder)
    return options


def time_of(outcome):
    return min(outcome.seconds, outcome.processor_seconds)


def faults_of(picture, expected):
    width, height, _, rows = read_png(picture)
    if (width, height) != SIZE:
        return [f"the picture has {width} x {height} pixels"]
    # The sky changes slowly from pixel to pixel, things have edges.
    visible = any(abs(a - b) > 6 for row in rows for left, right in zip(row, row[1:])
                  for a, b in zip(left, right))
    if visible == ("invisible" in expected):
        return ["something is to be seen" if visible else "nothing is to be seen"]
    return []


def render(options, name, expected):
    """What became of one file: 'drawn' or 'refused', what was said, what is wrong with that."""
    file = Path(options.folder) / name
    with tempfile.TemporaryDirectory(prefix="romascope-hostile-") as place:
        picture = Path(place) / "out.png"
        environment = {**os.environ, "XDG_CACHE_HOME": os.path.join(options.cache, "cache")}
        outcome = run_measured(
            [options.romascope, "render", file, "-o", picture, "--size", "%dx%d" % SIZE,
             "--frames", "1", "--backend", "egl", "--set", "frame.view=lit"], HANGS_SECONDS, cwd=place, env=environment)
        left = sorted(os.listdir(place))
        wrong = []
        if outcome.timed_out or time_of(outcome) > LIMIT_SECONDS:
            wrong.append(f"took more than {LIMIT_SECONDS} s")
        elif outcome.status not in (0, 2):
            wrong.append(f"ended with status {outcome.status}")
        if not options.sanitized and outcome.peak > LIMIT_BYTES:
            wrong.append(f"took {outcome.peak >> 20} MiB")
        if any(report in outcome.stderr for report in REPORTS):
            wrong.append("a sanitizer reports:\n" + outcome.stderr)
        drawn = outcome.status == 0
        if drawn and left != ["out.png"]:
            wrong.append(f"left {left} instead of a picture")
        elif drawn:
            wrong += faults_of(picture, expected)
            if options.pictures:
                (options.pictures / (name.replace("/", "__") + ".png")).write_bytes(
                    picture.read_bytes())
        elif outcome.status == 2:
            if left:
                wrong.append(f"refused, but left {left}")
            lines = outcome.stderr.splitlines()
            if len(lines) != 1 or not outcome.stderr.endswith("\n"):
                wrong.append(f"refused in {len(lines)} lines instead of one:\n{outcome.stderr}")
            elif str(file) not in lines[0]:
                wrong.append("the refusal does not name the file: " + lines[0])
    return "drawn" if drawn else "refused", outcome, wrong


def against_expectation(verdict, outcome, expected):
    said = outcome.stderr.strip()
    if expected is None:
        return [f"is not in {EXPECTATIONS.name}; it was {verdict}: {said}"]
    if verdict != expected["verdict"]:
        return [f"should be {expected['verdict']}, was {verdict}: {said}"]
    if verdict == "refused" and expected["says"] not in said:
        return [f"should be refused for '{expected['says']}', was for: {said}"]
    return []


def suggested(entry):
    """What the validator's codes suggest: it found errors, or could not read it at all."""
    return "drawn" if entry["khronos_validator"]["errors"] == 0 else "refused"


def print_differences(entries, expectations):
    for entry in entries:
        expected = expectations[entry["file"]]
        if expected["verdict"] != suggested(entry):
            codes = ", ".join(entry["khronos_validator"]["codes"] or {}) or "none"
            print(f"{entry['file']}: {expected['verdict']}, codes: {codes}\n"
                  f"    {expected['reason']}")


def main():
    options = arguments()
    if not options.folder:
        print("skipped: ROMASCOPE_HOSTILE names no folder of hostile files")
        return 0
    entries = [entry for entry in
               json.loads((Path(options.folder) / "MANIFEST.json").read_text())["files"]
               if options.only in entry["file"]]
    expectations = json.loads(EXPECTATIONS.read_text())
    if options.differences:
        print_differences(entries, expectations)
        return 0
    if options.pictures:
        options.pictures.mkdir(parents=True, exist_ok=True)

    count = collections.Counter()
    slowest = largest = 0
    with tempfile.TemporaryDirectory(prefix="romascope-hostile-cache-") as options.cache, \
            concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        names = [entry["file"] for entry in entries]
        for entry, (verdict, outcome, wrong) in zip(
                entries, pool.map(
                    lambda name: render(options, name, expectations.get(name, {})), names)):
            name = entry["file"]
            expected = expectations.get(name)
            wrong += against_expectation(verdict, outcome, expected)
            if expected and expected["verdict"] != suggested(entry) and "reason" not in expected:
                wrong.append("its verdict differs from the manifest's codes without a reason")
            if options.lines:
                print(f"{name}\t{verdict}\t{time_of(outcome):.2f} s\t{outcome.peak >> 20} MiB\t"
                      f"{outcome.stderr.strip()}")
            count[verdict] += 1
            count["timed out"] += time_of(outcome) > LIMIT_SECONDS
            count["crashed"] += outcome.status not in (0, 2) and not outcome.timed_out
            count["wrong"] += bool(wrong)
            slowest = max(slowest, time_of(outcome))
            largest = max(largest, outcome.peak)
            for line in wrong:
                print(f"WRONG {name}: {line}")
    print(f"{len(entries)} files: {count['drawn']} drawn, {count['refused']} refused; "
          f"{count['crashed']} crashed, {count['timed out']} timed out; "
          f"slowest {slowest:.1f} s, largest {largest >> 20} MiB; {count['wrong']} wrong")
    return 1 if count["wrong"] else 0


if __name__ == "__main__":
    sys.exit(main())
