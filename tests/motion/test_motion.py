# SPDX-License-Identifier: MIT
"""Moving glTF files: where the importer and the CPU put their triangles, against evaluator.py.

test_motion.py DUMP_POSE: on files made at random, on the scenes in assets/ that move, and on those
in the folder that ROMASCOPE_SCENES names, if it does.
"""
import collections
import itertools
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import evaluator
import random_gltf

ASSETS = pathlib.Path(__file__).resolve().parents[2] / "assets"

# Of the largest coordinate: what is compared are floats (half a unit in the last place is 6e-8),
# from rest positions and matrices in double.
POSITION_TOLERANCE = 3e-7
# Sine of the angle between normals: floats likewise, of rest normals whose length the importer may
# make 1 in single precision.
NORMAL_TOLERANCE = 2e-6


def dumped(program, file, poses):
    """Per pose the triangles as (corners, normals)."""
    arguments = [str(word) for pose in poses for word in pose]
    done = subprocess.run([program, str(file), *arguments], capture_output=True, text=True, timeout=240)
    if done.returncode:
        raise AssertionError(f"{file}: {done.stderr}")
    lines = iter(done.stdout.splitlines())
    result = []
    for line in lines:
        triangles = []
        for _ in range(int(line.split()[3])):
            v = [float(word) for word in next(lines).split()]
            triangles.append(([v[0:3], v[3:6], v[6:9]], [v[9:12], v[12:15], v[15:18]]))
        result.append(triangles)
    return result


def cell_of(corners, size):
    return tuple(math.floor(sum(c[axis] for c in corners) / size) for axis in range(3))


def mismatch(found, expected):
    """What of `found` is not in `expected` or the reverse, in words; None if nothing.

    Neither the order of triangles nor the first of their corners nor the side counts."""
    if len(found) != len(expected):
        return f"{len(found)} triangles instead of {len(expected)}"
    size = max(abs(x) for corners, _ in expected for corner in corners for x in corner)
    slack = POSITION_TOLERANCE * size
    cells = collections.defaultdict(list)
    for triangle in expected:
        cells[cell_of(triangle[0], 16 * slack)].append(triangle)
    worst = None
    for corners, normals in found:
        base = cell_of(corners, 16 * slack)
        near = [(cell, triangle) for step in itertools.product((-1, 0, 1), repeat=3)
                for cell in [tuple(a + b for a, b in zip(base, step))] for triangle in cells.get(cell, ())]
        for cell, triangle in near:
            order = fitting_order(corners, triangle[0], slack)
            if order and normals_agree(normals, triangle[1], order):
                cells[cell].remove(triangle)
                break
        else:
            worst = worst or f"triangle {corners} with normals {normals} is nowhere"
    return worst


def fitting_order(corners, others, slack):
    for order in itertools.permutations(range(3)):
        if all(math.dist(corners[i], others[order[i]]) <= slack for i in range(3)):
            return order
    return None


def normals_agree(normals, others, order):
    for i in range(3):
        expected = others[order[i]] if others else None
        if expected is None:  # none in the file, or squashed: anything goes
            continue
        if not math.dist(normals[i], expected) <= NORMAL_TOLERANCE:
            return False
    return True


class Motion(unittest.TestCase):
    def check(self, path, moments=(0.0, 0.13, 0.5, 0.77, 1.0)):
        """At these parts of each animation's duration, and without animation."""
        file = evaluator.File(path)
        poses = [("none", 0.0)]
        for number in range(len(file.all("animations"))):
            duration = file.duration(number)
            poses += [(number, moment * duration) for moment in moments]
        for (animation, seconds), found in zip(poses, dumped(PROGRAM, path, poses), strict=True):
            with self.subTest(file=path.name, animation=animation, seconds=seconds):
                expected = file.triangles(None if animation == "none" else animation, seconds)
                self.assertIsNone(mismatch(found, expected))

    def test_files_made_at_random(self):
        with tempfile.TemporaryDirectory(prefix="romascope-motion-") as folder:
            for seed in range(30):
                path = pathlib.Path(folder) / f"random{seed}.gltf"
                random_gltf.Writer(seed).write(path)
                self.check(path)

    def test_own_scenes(self):
        moving = [path for path in sorted(ASSETS.glob("*.glb")) if evaluator.File(path).all("animations")]
        for path in moving:
            self.check(path, moments=(0.37, 0.9))  # each takes seconds
        self.assertTrue(moving, "no scene in assets/ moves")

    def test_public_scenes(self):
        folder = os.environ.get("ROMASCOPE_SCENES")
        if not folder:
            self.skipTest("ROMASCOPE_SCENES names no folder of glTF files")
        moving = [path for path in sorted(pathlib.Path(folder).rglob("*.gl*"))
                  if path.suffix in (".glb", ".gltf") and self.moves(evaluator.File(path))]
        for path in moving:
            self.check(path)
        self.assertTrue(moving, "nothing there moves")

    @staticmethod
    def moves(file):
        return not file.json.get("extensionsRequired") and (
            file.all("animations") or any("targets" in primitive for mesh in file.all("meshes")
                                          for primitive in mesh["primitives"]))


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
