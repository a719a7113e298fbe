# SPDX-License-Identifier: MIT
"""Runs a program to its end within a time, and says what memory it took."""

import dataclasses
import os
import subprocess
import tempfile
import time


@dataclasses.dataclass
class Outcome:
    status: int         # exit status, or minus the signal that ended it
    stdout: str
    stderr: str
    seconds: float      # by the clock on the wall
    processor_seconds: float # of all its threads: less, where others keep it waiting
    peak: int           # largest resident set, bytes
    timed_out: bool     # it was killed at the end of its time


def run_measured(words, limit_seconds, **options):
    """`options`: of subprocess.Popen."""
    with tempfile.TemporaryFile() as stdout, tempfile.TemporaryFile() as stderr:
        start = time.monotonic()
        process = subprocess.Popen([str(word) for word in words], stdin=subprocess.DEVNULL,
                                   stdout=stdout, stderr=stderr, **options)
        timed_out = False
        while True:
            # wait4, as it tells the memory of this one process.
            ended, status, usage = os.wait4(process.pid, os.WNOHANG)
            if ended:
                break
            if not timed_out and time.monotonic() - start > limit_seconds:
                timed_out = True
                process.kill()
            time.sleep(0.005)
        process.returncode = os.waitstatus_to_exitcode(status)
        texts = []
        for file in (stdout, stderr):
            file.seek(0)
            texts.append(file.read().decode(errors="replace"))
        return Outcome(process.returncode, *texts, time.monotonic() - start,
                       usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024, timed_out)
