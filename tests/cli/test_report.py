# SPDX-License-Identifier: MIT
"""The report holds what docs/user/report.md says, no more and no less."""

import json
import math
import re

import glb
from helper import CliTest, SOURCE

NUMBER = (int, float)
TYPES = {
    "string": lambda value: isinstance(value, str),
    "string or null": lambda value: value is None or isinstance(value, str),
    "boolean": lambda value: isinstance(value, bool),
    "integer": lambda value: isinstance(value, int) and not isinstance(value, bool),
    "number": lambda value: isinstance(value, NUMBER) and not isinstance(value, bool)
    and math.isfinite(value),
    'number or "n/a"': lambda value: value == "n/a" or isinstance(value, NUMBER),
    "3 numbers": lambda value: len(value) == 3 and all(isinstance(v, float) for v in value),
    "any setting": lambda value: isinstance(value, (bool, int, float, str)),
}


def documented_fields():
    text = (SOURCE / "docs/user/report.md").read_text()
    return dict(re.findall(r"^\| `([^`]+)` \| ([^|]+?) \|", text, re.MULTILINE))


def fields(report):
    """(name as the page writes it, value) of everything in a report."""
    for key, value in report.items():
        if key in ("settings", "bytes", "counts"):
            yield from ((f"{key}.*", entry) for entry in value.values())
        elif key == "passes":
            yield from ((f"passes[].{name}", entry)
                        for element in value for name, entry in element.items())
        elif isinstance(value, dict):
            for name, entry in value.items():
                yield from elements(f"{key}.{name}", entry)
        else:
            yield key, value


def elements(name, value):
    """Of a list of objects each field; of a list of texts each text; of figures by name each; else
    the value itself."""
    if isinstance(value, dict):
        yield from ((f"{name}.*", entry) for entry in value.values())
        return
    if not isinstance(value, list) or any(isinstance(element, float) for element in value):
        yield name, value
        return
    for element in value:
        if isinstance(element, dict):
            yield from ((f"{name}[].{key}", entry) for key, entry in element.items())
        else:
            yield f"{name}[]", element


class Report(CliTest):
    def report(self, *words, **options):
        self.render("out.png", "--report", "out.json", *words, **options)
        return json.loads(self.path("out.json").read_text())

    def test_documented_fields(self):
        documented = documented_fields()
        self.assertGreater(len(documented), 30)
        for words in ((), ("--technique", "roma"), ("--reference", "4"),
                      ("--reference", "4", "--flicker", "--frames", "3"),
                      ("--path", "all", "--frames", "2", "--technique", "roma-hash"),
                      ("--reference", "4", "--jump", "1", "0.5", "--frames", "2"),
                      ("--set", "frame.view=lit", "--camera", "1,2,3/0,0,0/60"),
                      ("--set", "roma.snap=false")):
            moves = {"scene": "dancers"} if "--jump" in words else {}
            report = self.report(*words, **moves)
            found = {name for name, _ in fields(report)}
            # A scene need not have animations or notices.
            maybe = {name for name in documented if name.startswith(
                ("scene.animations[]", "scene.notices[]")
                + (() if "--reference" in words else ("errors.",))
                + (() if "--flicker" in words else ("errors.flicker",))
                + (() if "--jump" in words else ("errors.lag_frames",))
                + (() if "--path" in words else ("flight.",))
                + (() if "--jump" in words else ("jump.",))
                + (() if "roma.snap=false" in words or "--path" in words else ("counts.",)))}
            self.assertEqual(found - documented.keys(), set())
            self.assertEqual(documented.keys() - found - maybe, set())
            self.assertIn("animations", report["scene"])
            self.assertIn("notices", report["scene"])
            self.assertEqual("errors" in report, "--reference" in words)
            for name, value in fields(report):
                self.assertTrue(TYPES[documented[name]](value), f"{name}: {value!r}")

    def test_schema(self):
        schema = self.report()["schema"]
        self.assertRegex(schema, r"\Aromascope-report/\d+\Z")
        self.assertIn(f"`{schema}`", (SOURCE / "docs/user/report.md").read_text())

    def test_program(self):
        version = self.succeed("--version").stdout.strip()
        program = self.report()["program"]
        self.assertEqual(version, f"romascope {program['version']} ({program['commit']})")

    def test_every_setting_in_effect(self):
        listed = re.findall(r"^(\S+\.\S+) ", self.succeed("info", "--knobs").stdout, re.MULTILINE)
        self.write("file.toml", "ao.rays = 3")
        report = self.report("--technique", "roma-snap", "--config", "file.toml", "--frames", "3",
                             "--seed", "9", "--set", "ao.radius=0.25", "--camera", "above")
        settings = report["settings"]
        self.assertEqual(sorted(settings), sorted(listed))
        self.assertEqual(report["technique"], "roma-snap")
        for key, value in {"roma.sampling": "snap", "ao.rays": 3, "render.frames": 3,
                           "render.seed": 9, "ao.radius": 0.25, "render.camera": "above",
                           "render.width": 64, "render.height": 48}.items():
            self.assertEqual(settings[key], value, key)

    def test_settings_can_be_given_back(self):
        report = self.report("--set", "ao.rays=2")
        self.assertEqual(report["settings"]["ao.radius"], "inf")
        picture = self.path("out.png").read_bytes()
        words = []
        for key, value in report["settings"].items():
            words += ["--set", f"{key}={json.dumps(value) if isinstance(value, bool) else value}"]
        self.assertEqual(self.picture_bytes(*words), picture)

    def test_scene_and_camera(self):
        report = self.report("--camera", "above")
        scene, camera = report["scene"], report["camera"]
        self.assertEqual((scene["triangles"], scene["vertices"], scene["materials"]), (24, 48, 2))
        self.assertEqual((scene["name"], scene["file"]), ("scene", "scene.glb"))
        self.assertEqual([scene[name] for name in ("moving_vertices", "textures", "lights",
                                                   "cameras", "animations", "notices")],
                         [0, 0, 0, 2, [], []])
        self.assertGreaterEqual(scene["bytes"], 48 * 28 + 72 * 4)
        self.assertEqual(report["time"], {"animation": None, "first_s": 0, "last_s": 0})
        for measured, known in ((scene["bounds_min_m"], (-3, -0.2, -3)),
                                (scene["bounds_max_m"], (3, 1, 3)),
                                (camera["eye_m"], (0, 5, 0.01)), (camera["forward"], (0, -1, 0)),
                                (camera["up"], (0, 0, -1)),
                                ([camera["vertical_fov_degrees"]], [math.degrees(0.9)])):
            for a, b in zip(measured, known):
                self.assertAlmostEqual(a, b, places=4)
        self.assertEqual(camera["name"], "above")

    def test_notices_are_told_once_each_and_are_in_the_report(self):
        document, buffer = glb.box_on_floor()
        document["materials"][1]["alphaMode"] = "BLEND"
        glb.write_glb(self.path("glass.glb"), document, buffer)
        words = ("glass.glb", "--size", "8x8", "--report", "out.json")
        result = self.succeed("render", *words)
        notices = json.loads(self.path("out.json").read_text())["scene"]["notices"]
        self.assertEqual(len(notices), 1)
        self.assertIn("materials[1]", notices[0])
        self.assertEqual(result.stderr, f"notice: glass.glb: {notices[0]}\n")
        self.assertRegex(self.succeed("info", "glass.glb").stdout, r"notices +materials\[1\]")
        self.assertEqual(self.succeed("render", *words, "--print-config").stderr, "")

    def test_passes(self):
        for frames, timed in ((1, 1), (2, 1), (5, 4)):
            report = self.report("--frames", str(frames), "--set", "occupancy.builder=raster")
            passes = {entry["name"]: entry for entry in report["passes"]}
            self.assertEqual([name for name, entry in passes.items() if entry["rasterises"]],
                             ["gbuffer", "occupancy map"])
            for name, entry in passes.items():
                if report["clock"] == "n/a":
                    self.assertEqual((entry["n"], entry["median_ms"]), (0, "n/a"))
                    continue
                self.assertEqual(entry["n"], timed, name)
                self.assertGreater(entry["median_ms"], 0, name)
                self.assertGreaterEqual(entry["p95_ms"], entry["median_ms"], name)

    def test_software_is_timed_by_the_cpu(self):
        report = self.report()
        if not report["driver"]["software"]:
            self.skipTest("a GPU renders")
        self.assertEqual(report["clock"], "cpu clock with glFinish")

    def test_bytes(self):
        # Built in compute, there is a list of work besides.
        raster = ("--set", "occupancy.builder=raster", "--set")
        coarse = self.report(*raster, "occupancy.resolution=32")["bytes"]
        fine = self.report(*raster, "occupancy.resolution=64")["bytes"]
        self.assertTrue(all(entry > 0 for entry in coarse.values()))
        self.assertGreater(fine["occupancy map"], 3 * coarse["occupancy map"])
        self.assertEqual(fine["visibility"], 64 * 48 * 2)  # R16

    def test_errors_are_those_of_the_picture(self):
        words = ("--reference", "16", "--reference-output", "truth.hdr")
        errors = self.report(*words)["errors"]
        self.assertEqual((errors["reference_samples"], errors["reference_from_cache"]), (16, False))
        self.render("out.hdr")
        for name, value in self.figures("truth.hdr", "out.hdr").items():
            self.assertAlmostEqual(errors[name], value, delta=0.005, msg=name)
        again = self.report(*words)["errors"]
        self.assertTrue(again["reference_from_cache"])
        self.assertEqual(errors["reference_seconds"], again["reference_seconds"])
        self.assertEqual(errors["flip"], again["flip"])

    def test_report_alone_and_to_a_pipe(self):
        self.succeed("render", "scene.glb", "--size", "8x8", "--report", "alone.json")
        text = self.succeed("render", "scene.glb", "--size", "8x8", "--report",
                            "/dev/stdout").stdout
        self.assertEqual(list(json.loads(text)), list(json.loads(
            self.path("alone.json").read_text())))
