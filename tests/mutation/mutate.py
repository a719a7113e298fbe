#!/usr/bin/env python3
"""Plants one fault at a time and demands that the test named beside it fails.

mutate.py [NUMBER...]: the mutants of mutants.json, all or those. Works in a copy of the checkout's
committed files below build-mutation/, with a build folder of its own; the checkout is not touched.
Exit status 1 if a fault went unnoticed, a fault's place is gone, or a test fails without any.
"""
import json
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
COPY = ROOT / "build-mutation" / "source"
BUILD = ROOT / "build-mutation" / "build"


def run(*command, **more):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **more)


def passes(test):
    """Whether the test builds and passes."""
    built = run("ninja", "-C", str(BUILD), test)
    if built.returncode:
        sys.exit(f"{test} does not build:\n{built.stdout[-2000:]}")
    return run(str(BUILD / "tests" / test), "--gtest_brief=1").returncode == 0


def main():
    mutants = json.loads((ROOT / "tests/mutation/mutants.json").read_text())
    chosen = [int(number) for number in sys.argv[1:]] or range(len(mutants))
    shutil.rmtree(COPY, ignore_errors=True)
    COPY.mkdir(parents=True)
    archive = subprocess.run(["git", "-C", str(ROOT), "archive", "HEAD"], stdout=subprocess.PIPE, check=True)
    # -m: newer than what the last run built, perhaps with a fault in it.
    subprocess.run(["tar", "-x", "-m", "-C", str(COPY)], input=archive.stdout, check=True)
    configured = run("cmake", "-S", str(COPY), "-B", str(BUILD), "-G", "Ninja")
    if configured.returncode:
        sys.exit(configured.stdout)
    failures = 0
    for test in sorted({mutants[number]["test"] for number in chosen}):
        if not passes(test):
            sys.exit(f"{test} fails without any fault")
    for number in chosen:
        mutant = mutants[number]
        file = COPY / mutant["file"]
        text = file.read_text()
        if mutant["old"] not in text:
            print(f"{number}: {mutant['file']} no longer has '{mutant['old']}'")
            failures += 1
            continue
        file.write_text(text.replace(mutant["old"], mutant["new"], 1))
        noticed = not passes(mutant["test"])
        file.write_text(text)
        failures += not noticed
        print(f"{number}: {mutant['file']}: {'noticed' if noticed else 'NOT NOTICED'} by {mutant['test']}", flush=True)
    print(f"{len(list(chosen)) - failures} of {len(list(chosen))} faults noticed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
