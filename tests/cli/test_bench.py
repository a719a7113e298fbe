# SPDX-License-Identifier: MIT
"""Benchmarks: what their tables hold, not how fast anything is."""

import csv
import json
import os
import pty
import subprocess

import helper
from helper import CliTest

QUICK = ("--size", "32x24", "--set", "occupancy.resolution=32")


class Bench(CliTest):
    def bench(self, *words, rounds=3):
        """The facts and the rows of the CSV; the table is on stdout."""
        result = self.succeed("bench", "scene.glb", "--csv", "out.csv", *QUICK,
                              "--frames", rounds, *words)
        self.assertEqual(result.stderr, "")
        self.table = result.stdout
        lines = self.path("out.csv").read_text().splitlines()
        facts = dict(line[2:].split(": ", 1) for line in lines if line.startswith("# "))
        return facts, list(csv.DictReader(line for line in lines if not line.startswith("# ")))

    def names(self, rows):
        return list(dict.fromkeys(row["variant"] for row in rows if row["variant"]))

    def test_every_tracer_and_its_choices(self):
        facts, rows = self.bench()
        self.assertEqual(self.names(rows), [
            "roma roma.alignment=rotate", "roma roma.alignment=shear", "dda",
            "dda2d dda2d.hierarchy=true", "dda2d dda2d.hierarchy=false", "samples"])
        for name in ("program", "date", "machine", "renderer", "driver", "clock", "scene", "camera",
                     "size", "settings", "rounds", "baseline"):
            self.assertTrue(facts[name], name)
            self.assertIn(f"{name}: {facts[name]}\n", self.table)
        self.assertEqual((facts["size"], facts["baseline"]),
                         ("32x24", "roma roma.alignment=rotate"))
        self.assertRegex(facts["rounds"], r"^3\b")
        for row in rows:
            self.assertIn(row["phase"], ("build", "trace", "shared"))
            self.assertIn(row["kind"], ("compute", "rasterises", "both"))
            self.assertEqual(row["rounds"], "3")
            low, median, high = (float(row[key]) for key in ("p5_ms", "median_ms", "p95_ms"))
            self.assertTrue(0 < low <= median <= high, row)
            # Rounded for the CSV already, the last digit may come out as its neighbour.
            self.assertTrue(any(f"{median + error:.4f}" in self.table for error in (-1e-5, 0, 1e-5)), row)
        shared = [row["pass"] for row in rows if row["phase"] == "shared"]
        self.assertEqual(shared, ["empty dispatch", "gbuffer"])

    def test_build_is_apart_from_trace_and_sums_are_of_rounds(self):
        _, rows = self.bench(rounds=1)
        for name in self.names(rows):
            build = [row for row in rows if (row["variant"], row["phase"]) == (name, "build")]
            trace = [row for row in rows if (row["variant"], row["phase"]) == (name, "trace")]
            self.assertEqual([row["pass"] for row in trace], ["ambient occlusion"])
            passes = [row for row in build if not row["pass"].startswith("sum")]
            # One round: its median is the round, so sums add up.
            for kind, label in (({"compute", "rasterises"}, "sum"), ({"compute"}, "sum of compute"),
                                ({"rasterises"}, "sum of rasterising")):
                found = [row for row in build if row["pass"] == label]
                of_kind = [float(row["median_ms"]) for row in passes if row["kind"] in kind]
                if label == "sum":
                    self.assertEqual(len(found), 1)
                    self.assertGreater(int(found[0]["bytes"]), 0)
                for row in found:
                    self.assertAlmostEqual(float(row["median_ms"]), sum(of_kind),
                                           delta=1e-5 * sum(of_kind))
            beyond = [float(row["median_ms"]) for row in passes if row["pass"] != "occupancy map"]
            found = [row for row in build if row["pass"] == "sum beyond occupancy"]
            self.assertEqual(len(found), 1 if beyond else 0)
            for row in found:
                self.assertAlmostEqual(float(row["median_ms"]), sum(beyond), delta=1e-5 * sum(beyond))
                # Alignments have passes of other names, and are compared by this.
                self.assertGreater(float(row["ratio"]), 0)

    def test_ratios_are_to_the_baseline(self):
        for name in ("dda", "dda2d dda2d.hierarchy=false", "dda2d.hierarchy=true"):
            facts, rows = self.bench("--baseline", name, rounds=1)
            baseline = facts["baseline"]
            self.assertTrue(baseline.endswith(name))
            base = {(row["phase"], row["pass"]): float(row["median_ms"])
                    for row in rows if row["variant"] == baseline}
            for row in rows:
                key = (row["phase"], row["pass"])
                if row["variant"] == baseline:
                    self.assertEqual((row["ratio"], row["ratio_p5"], row["ratio_p95"]),
                                     ("1", "1", "1"))
                elif row["variant"] and key in base:
                    self.assertAlmostEqual(
                        float(row["ratio"]) / (float(row["median_ms"]) / base[key]), 1, places=4)
                else:
                    self.assertEqual(row["ratio"], "")

    def test_variations(self):
        _, rows = self.bench("--vary", "technique.tracer=dda,roma", "--vary",
                             "occupancy.resolution=32,40", "--vary", "dda.escape=0,2")
        self.assertEqual(self.names(rows), [
            "dda occupancy.resolution=32 dda.escape=0", "dda occupancy.resolution=32 dda.escape=2",
            "dda occupancy.resolution=40 dda.escape=0", "dda occupancy.resolution=40 dda.escape=2",
            "roma occupancy.resolution=32", "roma occupancy.resolution=40"])
        size = {row["variant"]: int(row["bytes"]) for row in rows if row["pass"] == "sum"}
        self.assertGreater(size["roma occupancy.resolution=40"],
                           size["roma occupancy.resolution=32"])

    def test_one_tracer_by_technique(self):
        facts, rows = self.bench("--technique", "samples", "--set", "samples.count=4")
        self.assertEqual(self.names(rows), ["samples"])
        self.assertIn("samples.count=4", facts["settings"])

    def test_a_value_that_is_given_is_the_only_one(self):
        self.write("shear.toml", "roma.alignment = 'shear'")
        self.write("other.toml", "ao.rays = 1")
        roma = ("--set", "technique.tracer=roma")
        dda2d = ("--set", "technique.tracer=dda2d")
        both = ["roma roma.alignment=rotate", "roma roma.alignment=shear"]
        for words, names in (
                (roma, both), ((*roma, "--config", "other.toml"), both),
                ((*roma, "--set", "roma.alignment=shear"), ["roma"]),
                ((*roma, "--set", "roma.alignment=rotate"), ["roma"]),
                ((*roma, "--config", "shear.toml"), ["roma"]),
                (("--technique", "roma"), ["roma"]), (("--technique", "roma-rotate"), ["roma"]),
                (dda2d, ["dda2d dda2d.hierarchy=true", "dda2d dda2d.hierarchy=false"]),
                ((*dda2d, "--set", "dda2d.hierarchy=on"), ["dda2d"]),
                (("--technique", "dda2d"), ["dda2d"])):
            with self.subTest(words):
                _, rows = self.bench(*words, rounds=1)
                self.assertEqual(self.names(rows), names)
        facts, _ = self.bench(*roma, "--set", "roma.alignment=rotate", rounds=1)
        self.assertIn("roma.alignment=rotate", facts["settings"])

    def test_time_stands_still(self):
        for command in ("bench", "split"):
            self.assertNotIn("--fps", self.succeed(command, "--help").stdout)
            for words in (("--fps", "25"), ("--set", "render.fps=25")):
                self.refuse(command, "scene.glb", *words, says="--fps: all rays are of one moment")
        self.assertIn("--fps", self.succeed("render", "--help").stdout)

    def test_json_holds_the_same(self):
        facts, rows = self.bench("--json", "out.json", "--set", "technique.tracer=dda")
        found = json.loads(self.path("out.json").read_text())
        self.assertEqual(found["facts"], facts)
        self.assertEqual([(row["variant"], row["pass"]) for row in found["rows"]],
                         [(row["variant"], row["pass"]) for row in rows])
        for row, other in zip(found["rows"], rows):
            self.assertAlmostEqual(row["ms"]["median"] / float(other["median_ms"]), 1, places=5)

    def test_seconds_bound_the_rounds(self):
        result = self.succeed("bench", "scene.glb", "--size", "32x24", "--seconds", "0.001",
                              "--technique", "dda")
        self.assertIn("rounds: 5,", result.stdout)  # the fewest

    def test_a_terminal_sees_how_far_it_is(self):
        terminal, stderr = pty.openpty()
        try:
            subprocess.run([helper.PROGRAM, "bench", "scene.glb", "--size", "32x24", "--seconds",
                            "1.5", "--technique", "dda"], env=self.env, cwd=self.folder,
                           stdout=subprocess.DEVNULL, stderr=stderr, check=True, timeout=60)
            told = os.read(terminal, 4096).decode()
        finally:
            os.close(stderr)
            os.close(terminal)
        self.assertRegex(told, r"\A(\rmeasured +\d+ %)+\r\n\Z")
        self.assertIn("100 %", told)

    def test_notices_are_told_once_for_all_variants(self):
        for command in ("bench", "split"):
            result = self.succeed(command, "scene.glb", *QUICK, "--frames", "1", "--vary",
                                  "technique.tracer=dda,samples", "--set", "frame.view=history")
            self.assertRegex(result.stderr, r"\Anotice: scene.glb: frame.view=history [^\n]*\n\Z")

    def test_refused_before_the_work(self):
        for words, says in (
                (("--vary", "roma.taps"), "KEY=VALUE"),
                (("--vary", "roma.tap=1"), "did you mean 'roma.taps'"),
                (("--vary", "roma.taps=1,9"), "1 to 3"),
                (("--vary", "roma.taps="), "no value"),
                (("--vary", "roma.taps=1,1"), "twice"),
                (("--vary", "dda2d.hierarchy=true,on"), "twice"),
                (("--vary", "roma.taps=1", "--vary", "roma.taps=2"), "twice"),
                (("--vary", "render.width=64,128"), "share one picture"),
                (("--vary", "technique.tracer=dda,rom"), "did you mean 'roma'"),
                (("--vary", "technique.tracer=dda", "--vary", "roma.taps=1,2"), "none of these"),
                (("--vary", "occupancy.resolution=" + ",".join(map(str, range(32, 132)))),
                 "more than 64"),
                (("--set", "roma.alignment=rotate", "--vary", "roma.taps=1,2"),
                 "decides nothing without roma.alignment=shear"),
                (("--vary", "hash.enabled=true,false"), "without the stages that reuse"),
                (("--set", "hash.enabled=true"), "hash.enabled: tracers are looked at"),
                (("--technique", "roma-hash"), "--technique roma-hash: it has hash.enabled=true,"),
                (("--technique", "roma-filtered"), "they found; take --technique roma\n"),
                (("--technique", "roma", "--set", "hash.enabled=true"), "hash.enabled: tracers"),
                (("--set", "technique.tracer=rom"), "did you mean 'roma'"),
                (("--baseline", "bvh"), "no variant is that (the first is 'roma"),
                (("--baseline", "roma"), "could be"),
                (("--seconds", "0"), "--seconds"),
                (("--frames", "0"), "render.frames"),
                (("--max-memory", "1KiB"), "--max-memory")):
            self.refuse("bench", "scene.glb", "--csv", "out.csv", *words, says=says)
        self.refuse("bench", "nowhere.glb", says="nowhere.glb")
        self.refuse("bench", "scene.glb", "--csv", "scene.glb", says="input")
        self.refuse("bench", "scene.glb", "--csv", "a.csv", "--json", "a.csv", says="two outputs")
