# SPDX-License-Identifier: MIT
"""The folders of renderer/ stand on each other in one order, and nothing includes app/.

The top CMakeLists.txt adds them in the same order. A file may include its own folder
and folders before it, written from the root; the same holds for DEPENDS of romascope_module, which
must also cover what the sources include. shaders/ includes only shaders/, and anyone may include it.
"""
import pathlib
import re
import shutil
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
ORDER = ("base settings image gl scene passes tracers estimators reuse frame reference metrics").split()
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)
# The host gives this name to the tracer it chose; no file is called so.
CHOSEN_BY_HOST = {"tracer.glsl"}


def sources(root):
    for folder in ("renderer", "app", "shaders"):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in (".cpp", ".h", ".c", ".glsl"):
                yield path.relative_to(root)


def layer(path):
    """(top folder, place in the order or None) of a path from the root."""
    parts = pathlib.PurePosixPath(path).parts
    if parts[0] == "renderer" and len(parts) > 2 and parts[1] in ORDER:
        return "renderer", ORDER.index(parts[1])
    return parts[0], None


def includes(root):
    """(file, line, what it includes) of every include in quotes."""
    for path in sources(root):
        text = (root / path).read_text()
        for match in INCLUDE.finditer(text):
            yield path.as_posix(), text.count("\n", 0, match.start()) + 1, match.group(1)


def include_problem(root, file, included):
    """Why this include is not allowed; None if it is."""
    if included in CHOSEN_BY_HOST and file.startswith("shaders/"):
        return None
    if ".." in included.split("/") or not (root / included).is_file():
        return "is not a file by its path from the root"
    top, place = layer(file)
    included_top, included_place = layer(included)
    if included_top == "shaders" or top == "app" and included_top in ("renderer", "app"):
        return None
    if top == "shaders":
        return "is outside shaders/"
    if included_top != "renderer":
        return f"is in {included_top}/, which renderer/ must not know"
    if place is None or included_place is None:
        return "is in a folder without a place in the order"
    if included_place > place:
        return f"is above {ORDER[place]}/ in the order of folders"
    return None


def modules(root):
    """Folder: names after DEPENDS of its romascope_module call."""
    found = {}
    for path in sorted((root / "renderer").glob("*/CMakeLists.txt")):
        text = re.sub(r"#.*", "", path.read_text())
        call = re.search(r"romascope_module\(\s*(\w+)([^)]*)\)", text)
        if call is None:
            found[path.parent.name] = None
            continue
        words = call.group(2).split()
        depends = words[words.index("DEPENDS") + 1:] if "DEPENDS" in words else []
        for keyword in ("SOURCES", "LIBRARIES"):
            if keyword in depends:
                depends = depends[: depends.index(keyword)]
        found[path.parent.name] = depends if call.group(1) == path.parent.name else None
    return found


def reached(depends, name):
    """The folder and all that its DEPENDS lead to."""
    seen, waiting = set(), [name]
    while waiting:
        at = waiting.pop()
        if at not in seen:
            seen.add(at)
            waiting += depends.get(at) or []
    return seen


def problems(root):
    """One line for each broken rule below root."""
    found = []
    top = (root / "CMakeLists.txt").read_text()
    added = re.search(r"foreach\(module ([\w\s]+)\)", top)
    if added is None or added.group(1).split() != ORDER:
        found.append("CMakeLists.txt: adds the folders of renderer/ in another order than " + " ".join(ORDER))
    depends = modules(root)
    for name in sorted({path.parts[1] for path in sources(root) if path.parts[0] == "renderer"} - set(ORDER)):
        found.append(f"renderer/{name}: has no place in the order of folders")
    for name, below in depends.items():
        file = f"renderer/{name}/CMakeLists.txt"
        if below is None:
            found.append(f"{file}: no romascope_module({name} ...)")
            continue
        for other in below:
            if name in ORDER and (other not in ORDER or ORDER.index(other) >= ORDER.index(name)):
                found.append(f"{file}: DEPENDS {other}, which is not below {name}")
    for file, line, included in includes(root):
        problem = include_problem(root, file, included)
        if problem:
            found.append(f'{file}:{line}: "{included}" {problem}')
            continue
        (top, place), (included_top, included_place) = layer(file), layer(included)
        if top == included_top == "renderer":
            if ORDER[included_place] not in reached(depends, ORDER[place]):
                found.append(f'{file}:{line}: "{included}": DEPENDS of {ORDER[place]} does not lead there')
    return found


class Tree(unittest.TestCase):
    def test_every_include_and_depends_keeps_the_order(self):
        self.assertGreater(len(list(includes(ROOT))), 100, "the includes were not found")
        self.assertEqual(problems(ROOT), [])


class Planted(unittest.TestCase):
    """Each broken rule, planted in a copy, is found there and is the only thing found."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="romascope-structure-")
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        shutil.copy(ROOT / "CMakeLists.txt", self.root)
        for name in ("renderer", "app", "shaders"):
            shutil.copytree(ROOT / name, self.root / name)
        # What is wrong with the tree itself is the business of the test above.
        self.before = problems(self.root)

    def plant(self, file, text):
        path = self.root / file
        path.write_text((path.read_text() if path.exists() else "") + text)

    def change(self, file, old, new):
        path = self.root / file
        text, count = re.subn(old, new, path.read_text(), count=1)
        self.assertEqual(count, 1)
        path.write_text(text)

    def assert_found(self, *parts):
        found = [line for line in problems(self.root) if line not in self.before]
        self.assertEqual(len(found), 1, found)
        for part in parts:
            self.assertIn(part, found[0])

    def test_folder_above(self):
        self.plant("renderer/base/planted.h", '#pragma once\n#include "renderer/frame/pipeline.h"\n')
        self.assert_found("renderer/base/planted.h:2:", "above base/")

    def test_next_folder_with_odd_spaces(self):
        self.plant("renderer/reuse/planted.cpp", '\n  #  include   "renderer/frame/pipeline.h"\n')
        self.assert_found("renderer/reuse/planted.cpp:2:", "above reuse/")

    def test_app(self):
        self.plant("renderer/metrics/planted.h", '#include "app/report.h"\n')
        self.assert_found("renderer/metrics/planted.h:1:", "app/")

    def test_tests(self):
        (self.root / "tests").mkdir()
        self.plant("tests/planted.h", "")
        self.plant("renderer/metrics/planted.h", '#include "tests/planted.h"\n')
        self.assert_found("renderer/metrics/planted.h:1:", "tests/")

    def test_relative_path(self):
        self.plant("renderer/gl/planted.h", '#include "context.h"\n')
        self.assert_found("renderer/gl/planted.h:1:", "from the root")

    def test_path_through_a_parent(self):
        self.plant("renderer/gl/planted.h", '#include "renderer/gl/../frame/pipeline.h"\n')
        self.assert_found("renderer/gl/planted.h:1:", "from the root")

    def test_shader_includes_renderer(self):
        self.plant("shaders/common/planted.h", '#include "renderer/base/error.h"\n')
        self.assert_found("shaders/common/planted.h:1:", "outside shaders/")

    def test_shader_is_included(self):
        self.plant("renderer/base/planted.h", '#include "shaders/common/cross.h"\n')
        self.assertEqual(problems(self.root), self.before)

    def test_depends_upwards(self):
        self.change("renderer/base/CMakeLists.txt", r"DEPENDS", "DEPENDS settings")
        self.assert_found("renderer/base/CMakeLists.txt", "DEPENDS settings")

    def test_include_without_depends(self):
        # metrics stands above scene in the order, yet does not depend on it.
        self.plant("renderer/metrics/planted.h", '#include "renderer/scene/scene.h"\n')
        self.assert_found("renderer/metrics/planted.h:1:", "DEPENDS of metrics")

    def test_order_changed_in_cmake(self):
        self.change("CMakeLists.txt", r"base settings", "settings base")
        self.assert_found("CMakeLists.txt", "another order")

    def test_folder_without_a_place(self):
        (self.root / "renderer/planted").mkdir()
        self.plant("renderer/planted/planted.h", "")
        self.assert_found("renderer/planted", "no place")


if __name__ == "__main__":
    unittest.main()
