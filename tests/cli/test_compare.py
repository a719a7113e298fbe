# SPDX-License-Identifier: MIT
"""Figures and exit statuses of `romascope compare`."""

import struct
import zlib

from helper import CliTest, read_png


def write_grey_png(path, rows):
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(
            ">I", zlib.crc32(kind + body))
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0)
    data = b"".join(b"\0" + bytes(row) for row in rows)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
                     + chunk(b"IDAT", zlib.compress(data)) + chunk(b"IEND", b""))


class Compare(CliTest):
    def setUp(self):
        super().setUp()
        # sRGB 0 is 0, 255 is 1: a quarter of the pixels is off by 1, darker in the test.
        write_grey_png(self.path("truth.png"), [[0, 0, 255, 255]] * 8)
        write_grey_png(self.path("test.png"), [[0, 0, 255, 0]] * 8)

    def test_figures(self):
        figures = self.figures("truth.png", "test.png")
        self.assertEqual(sorted(figures), ["bias", "flip", "mae", "rmse"])
        self.assertEqual((figures["mae"], figures["bias"], figures["rmse"]), (0.25, -0.25, 0.5))
        self.assertTrue(0.1 < figures["flip"] < 1)
        self.assertEqual(set(self.figures("truth.png", "truth.png").values()), {0})
        self.assertEqual(self.figures("test.png", "truth.png")["bias"], 0.25)

    def test_one_metric(self):
        self.assertEqual(self.figures("truth.png", "test.png", "--metric", "mae"), {"mae": 0.25})

    def test_bound(self):
        for metric, bound, status in (("mae", "0.25", 0), ("mae", "0.2499", 1), ("bias", "0.25", 0),
                                      ("bias", "0.2", 1), ("rmse", "1", 0), ("rmse", "0", 1)):
            with self.subTest(metric=metric, bound=bound):
                result = self.run_program("compare", "truth.png", "test.png", "--metric", metric,
                                          "--max", bound)
                self.assertEqual(result.returncode, status)
                self.assertTrue(result.stdout.startswith(metric))
                if status:
                    self.assertRegex(result.stderr, rf"\Aromascope: {metric} is .*{bound}\n\Z")
        self.assertEqual(self.run_program("compare", "truth.png", "test.png", "--max",
                                          "0.3").returncode, 1)
        self.succeed("compare", "truth.png", "truth.png", "--max", "0")

    def test_error_map(self):
        for metric in ("flip", "rmse", "mae", "bias"):
            result = self.succeed("compare", "truth.png", "test.png", "--metric", metric,
                                  "--error-map", f"new/{metric}.png")
            self.assertIn(f"new/{metric}.png", result.stdout)
            width, height, channels, rows = read_png(self.path(f"new/{metric}.png"))
            self.assertEqual((width, height, channels), (4, 8, 3))
            self.assertNotEqual(rows[4][0], rows[4][3], metric)
        # Too dark is blue, right is white.
        self.assertEqual(rows[4][0], (255, 255, 255))
        self.assertEqual(max(rows[4][3]), rows[4][3][2])

    def test_error_map_is_written_above_the_bound_too(self):
        result = self.run_program("compare", "truth.png", "test.png", "--max", "0", "--error-map",
                                  "map.png")
        self.assertEqual(result.returncode, 1)
        read_png(self.path("map.png"))

    def test_grey_against_colour(self):
        self.render("grey.png")
        self.render("colour.png", "--set", "frame.view=lit")
        self.assertGreater(self.figures("grey.png", "colour.png")["mae"], 0)
