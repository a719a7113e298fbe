# SPDX-License-Identifier: MIT
"""test_headers.py compile_commands.json: every header compiles alone.

A header that some compiled .cpp includes before anything else has proved it in the build; the
others are compiled here one by one, with the flags of the build.
"""
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
FIRST_INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*["<]([^">]+)[">]', re.MULTILINE)


def headers():
    return sorted(path.relative_to(ROOT).as_posix()
                  for folder in ("renderer", "app", "shaders") for path in (ROOT / folder).rglob("*.h"))


def read_commands(file):
    """(compiler, flags that matter to headers, headers that the build has proved)."""
    compiler, flags, proved = None, [], set()
    for entry in json.loads(pathlib.Path(file).read_text()):
        source = pathlib.Path(entry["file"])
        if source.suffix != ".cpp" or not source.is_file():
            continue
        words = shlex.split(entry["command"])
        compiler = words[0]
        for word, following in zip(words, words[1:] + [""]):
            new = [word, following] if word == "-isystem" else [word]
            # ROMASCOPE_... belong to single sources.
            wanted = re.match(r"-isystem|-I|-std=|-W|-f(?!sanitize)|-D(?!ROMASCOPE)", word)
            if wanted and not any(flags[i:i + len(new)] == new for i in range(len(flags))):
                flags += new
        first = FIRST_INCLUDE.search(source.read_text())
        if first:
            proved.add(first.group(1))
    return compiler, flags, proved


def compile_alone(compiler, flags, header, root=ROOT):
    """The compiler's complaints; empty if it has none."""
    run = subprocess.run([compiler, *flags, f"-I{root}", "-Werror", "-fsyntax-only", "-x", "c++", "-"],
                         input=f'#include "{header}"\n', capture_output=True, text=True, cwd=root)
    return run.stderr if run.returncode else ""


class Headers(unittest.TestCase):
    def test_every_header_compiles_alone(self):
        compiler, flags, proved = read_commands(COMMANDS)
        remaining = [header for header in headers() if header not in proved]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            complaints = pool.map(lambda header: compile_alone(compiler, flags, header), remaining)
        failed = "".join(f"\n{header}:\n{text}" for header, text in zip(remaining, complaints) if text)
        print(f"{len(headers()) - len(remaining)} headers proved by the build, {len(remaining)} compiled here")
        self.assertFalse(failed, failed)

    def test_a_header_that_leans_on_others_is_found(self):
        compiler, flags, _ = read_commands(COMMANDS)
        with tempfile.TemporaryDirectory(prefix="romascope-structure-") as folder:
            (pathlib.Path(folder) / "planted.h").write_text("#pragma once\nstd::string planted();\n")
            self.assertIn("planted.h:2", compile_alone(compiler, flags, "planted.h", folder))


if __name__ == "__main__":
    COMMANDS = sys.argv.pop(1)
    unittest.main()
