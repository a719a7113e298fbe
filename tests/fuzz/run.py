#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fuzzes the importer on all cores, from the project's own corpus, and says how it went.

Each job is a libFuzzer of its own with its own seed; they share what they find. An input that
crashes, hangs, leaks or takes too much memory is kept, and ends the run with status 1."""

import argparse
import os
import re
import resource
import shutil
import subprocess
import sys
import time
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
LIMITS = ["-timeout=10", "-rss_limit_mb=1024", "-malloc_limit_mb=1024", "-max_len=4096"]
# Weighing inputs by how rare what they reach is takes libFuzzer a quarter of the time here.
FAST = ["-entropic=0"]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=Path, default=SOURCE / "build-fuzz",
                        help="build folder of the preset 'fuzz'")
    parser.add_argument("--out", type=Path, default=SOURCE / "out/fuzz",
                        help="where findings, logs and the grown corpus are kept")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--seed", type=int, default=1, help="of the first job")
    parser.add_argument("--keep", action="store_true", help="start from the corpus of the last run")
    amount = parser.add_mutually_exclusive_group(required=True)
    amount.add_argument("--seconds", type=int)
    amount.add_argument("--runs", type=int, help="inputs, all jobs together")
    return parser.parse_args()


def start_job(options, target, corpus, number):
    words = [target, f"-seed={options.seed + number}", *LIMITS, *FAST, "-print_final_stats=1",
             f"-dict={SOURCE / 'tests/fuzz/gltf.dict'}", f"-artifact_prefix={options.out}/"]
    if options.seconds:
        words.append(f"-max_total_time={options.seconds}")
    else:
        words.append(f"-runs={-(-options.runs // options.jobs)}")
    # Little freed memory kept from reuse, or large inputs exceed the limit, and short stacks of
    # allocations, which take time; the report of a single input has whole ones.
    sanitizer = ("quarantine_size_mb=16:malloc_context_size=4:" +
                 os.environ.get("ASAN_OPTIONS", ""))
    log = options.out / f"job-{number}.log"
    with open(log, "w") as out:
        return log, subprocess.Popen([str(word) for word in [*words, corpus]], stdout=out,
                                     stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                                     env={**os.environ, "ASAN_OPTIONS": sanitizer})


def number_after(pattern, text):
    found = re.findall(pattern + r"\s*(\d+)", text)
    return int(found[-1]) if found else 0


def report_failure(target, text):
    """The sanitizer's or libFuzzer's report, and how to see it again."""
    lines = text.splitlines()
    start = next((i for i, line in enumerate(lines)
                  if "ERROR" in line or "runtime error" in line or line.startswith("fuzz_gltf:")),
                 max(0, len(lines) - 20))
    print("\n".join(lines[start:start + 40]), file=sys.stderr)
    kept = re.findall(r"Test unit written to (\S+)", text)
    for file in kept:
        print(f"\nkept: {file}\nagain: {target} {file}\n"
              f"smaller: {target} -minimize_crash=1 -runs=100000 {file}\n"
              "mended: put it into tests/fuzz/regressions/", file=sys.stderr)


def main():
    options = arguments()
    target = options.build / "tests/fuzz/fuzz_gltf"
    corpus = options.out / "corpus"
    if not options.keep:
        shutil.rmtree(corpus, ignore_errors=True)
    subprocess.run([options.build / "tests/fuzz/make_corpus", corpus], check=True)
    for file in (SOURCE / "tests/fuzz/regressions").glob("*.gl*"):
        shutil.copy(file, corpus)
    seeds = sum(1 for _ in corpus.iterdir())

    start = time.monotonic()
    jobs = [start_job(options, target, corpus, number) for number in range(options.jobs)]
    try:
        failed = [log for log, job in jobs if job.wait() != 0]
    finally:
        for _, job in jobs:
            if job.poll() is None:
                job.terminate()
                job.wait()
    seconds = time.monotonic() - start

    texts = {log: log.read_text(errors="replace") for log, _ in jobs}
    runs = sum(number_after("stat::number_of_executed_units:", text) for text in texts.values())
    drawn = sum(number_after("\ndrawn:", text) for text in texts.values())
    moving = sum(number_after("\nmoving:", text) for text in texts.values())
    coverage = max(number_after("cov:", text) for text in texts.values())
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(f"{runs} inputs in {seconds:.0f} s by {options.jobs} jobs, {runs / seconds:.0f} per "
          f"second, {runs / (used.ru_utime + used.ru_stime):.0f} per second of one processor; "
          f"{100 * drawn / max(runs, 1):.0f} % drawn, {100 * moving / max(runs, 1):.0f} % moving; "
          f"{seeds} seeds, {sum(1 for _ in corpus.iterdir())} inputs kept, {coverage} "
          f"edges reached; {len(failed)} jobs failed")
    for log in failed:
        report_failure(target, texts[log])
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
