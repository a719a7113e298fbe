# SPDX-License-Identifier: MIT
"""The faults of tests/mutation/mutants.json still have their places in the sources."""
import json
import pathlib
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


class PlantedFaults(unittest.TestCase):
    def test_each_has_one_place(self):
        mutants = json.loads((ROOT / "tests/mutation/mutants.json").read_text())
        self.assertGreater(len(mutants), 10)
        for mutant in mutants:
            with self.subTest(mutant):
                source = ROOT / mutant["file"]
                self.assertEqual(source.read_text().count(mutant["old"]) if source.is_file() else 0, 1)
                self.assertNotEqual(mutant["old"], mutant["new"])


if __name__ == "__main__":
    unittest.main()
