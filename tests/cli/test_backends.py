# SPDX-License-Identifier: MIT
"""Ways to an OpenGL context, and drivers that are not good enough."""

import resource
import shutil
import subprocess
import unittest

import helper
from helper import CliTest, read_png


class Backends(CliTest):
    def test_unknown(self):
        self.refuse_render("--backend", "windw", says=["'windw'", "auto, window, egl, osmesa"])
        self.refuse("info", "--backend", "windw", says="auto, window, egl, osmesa")

    def test_missing_device(self):
        for number in ("99", "-1", "-3"):
            self.refuse_render("--egl-device", number, says=[f"device {number}", "romascope info"])

    def test_device_of_another_backend(self):
        self.refuse_render("--egl-device", "0", "--backend", "osmesa", says=["--egl-device", "egl"])

    def test_window_without_a_display(self):
        self.refuse_render("--backend", "window", status=1, says=["window", "DISPLAY"])

    def test_window_of_a_dead_display(self):
        self.refuse_render("--backend", "window", env={"DISPLAY": ":9871"}, status=1,
                           says="window")
        # `auto` takes the next.
        self.render("out.png", env={"DISPLAY": ":9871"})

    def test_auto_tells_why(self):
        result = self.render("out.png", "--verbose")
        self.assertRegex(result.stderr, r"\Aromascope: using EGL [^\n]*OpenGL 4[^\n]*"
                                        r"window: neither DISPLAY nor WAYLAND_DISPLAY[^\n]*\n\Z")
        result = self.render("out.png", "--verbose", "--backend", "osmesa")
        self.assertRegex(result.stderr, r"\Aromascope: using OSMesa: OpenGL[^\n]*\n\Z")

    def test_auto_without_egl_takes_osmesa(self):
        # EGL's loader finds no vendor library.
        nowhere = {"__EGL_VENDOR_LIBRARY_DIRS": str(self.folder / "nowhere")}
        result = self.render("out.png", "--verbose", env=nowhere)
        self.assertIn("using OSMesa", result.stderr)
        self.assertIn("egl", result.stderr)
        self.refuse_render("--backend", "egl", env=nowhere, status=1, says="egl")

    def test_all_give_the_same_bytes(self):
        if "llvmpipe" not in self.succeed("info", "--backend", "egl").stdout:
            self.skipTest("EGL takes another renderer than OSMesa here")
        words = ("--frames", "3", "--set", "frame.view=lit")
        pictures = {self.picture_bytes(*words, *backend)
                    for backend in (("--backend", "egl"), ("--egl-device", "0"),
                                    ("--backend", "osmesa"), ())}
        self.assertEqual(len(pictures), 1)

    @unittest.skipUnless(shutil.which("xvfb-run"), "no Xvfb is installed")
    def test_window(self):
        words = ("xvfb-run", "-a", helper.PROGRAM, "render", "scene.glb", "--size", "64x48",
                 "--verbose", "-o")
        for backend in ("window", "auto"):
            result = self.command(*words, f"{backend}.png", "--backend", backend)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn("using a hidden GLFW window", result.stderr)
        self.render("egl.png", "--backend", "egl")
        self.assertLess(self.figures("egl.png", "window.png")["mae"], 0.02)


class Drivers(CliTest):
    """Mesa can play an older driver."""

    def test_old_version(self):
        for version in ("3.3", "4.3", "4.4"):
            for words in ((), ("--backend", "osmesa"), ("--egl-device", "0")):
                with self.subTest(version=version, words=words):
                    self.refuse_render(*words, env={"MESA_GL_VERSION_OVERRIDE": version}, status=1,
                                       says=["OpenGL 4.5", f"offers OpenGL {version}", "llvmpipe"])

    def test_missing_extension_is_named(self):
        env = {"MESA_GL_VERSION_OVERRIDE": "4.3",
               "MESA_EXTENSION_OVERRIDE": "-GL_ARB_clip_control -GL_ARB_buffer_storage"}
        result = self.run_program("render", "scene.glb", "-o", "out.png", env=env)
        self.assertEqual(result.returncode, 1)
        self.assertIn("lacks ARB_buffer_storage, ARB_clip_control", result.stderr)

    def test_info_on_an_old_driver(self):
        result = self.run_program("info", env={"MESA_GL_VERSION_OVERRIDE": "3.3"})
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stdout, r"osmesa +no +OpenGL 4.5 core is needed")
        self.assertRegex(result.stderr, r"\Aromascope: [^\n]+\n\Z")

    def test_version_4_6(self):
        self.assertRegex(self.succeed("info", env={"MESA_GL_VERSION_OVERRIDE": "4.6"}).stdout,
                         r"OpenGL 4.6 core +yes")
        self.assertEqual(self.picture_bytes(env={"MESA_GL_VERSION_OVERRIDE": "4.6"}),
                         self.picture_bytes())

    def test_debug_context(self):
        self.render("out.png", "--gl-debug", "--set", "frame.view=lit")


class Memory(CliTest):
    HUGE = "16384x16384"

    def test_address_space(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_AS, (1500 << 20, 1500 << 20))
        if subprocess.run([helper.PROGRAM, "--version"], preexec_fn=limit,
                          capture_output=True).returncode:
            self.skipTest("the program does not start in 1.5 GiB of addresses: sanitizers?")
        self.refuse("render", "scene.glb", "-o", "out.png", "--size", self.HUGE, status=1,
                    says=["no room", "smaller"], preexec_fn=limit)

    def test_memory_of_the_machine(self):
        facts = "MemTotal: 4000000 kB\nMemAvailable: 1000000 kB\n"
        self.write("meminfo", facts)
        inside = (f"mount --bind {self.folder}/meminfo /proc/meminfo && exec \"$@\"")
        alone = ["unshare", "--mount", "--map-root-user", "sh", "-c", inside, "sh"]
        if not shutil.which("unshare") or subprocess.run([*alone, "true"],
                                                         capture_output=True).returncode:
            self.skipTest("no mount namespace may be made here")
        result = self.command(*alone, helper.PROGRAM, "render", "scene.glb", "-o", "out.png",
                              "--size", self.HUGE)
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, r"\Aromascope: [^\n]*16384x16384[^\n]*GiB[^\n]*\n\Z")
        self.assertFalse(self.path("out.png").exists())

    def test_longest_sides(self):
        for size in ("16384x1", "1x16384"):
            self.succeed("render", "scene.glb", "-o", "out.png", "--size", size)
            self.assertEqual("%dx%d" % read_png(self.path("out.png"))[:2], size)

    def test_bound_of_the_user(self):
        # 256 aligned maps of 256^3 bits alone are 512 MiB, what belongs to them some 10 MiB.
        maps = ("--set", "occupancy.resolution=256", "--set", "roma.angular_resolution=16")
        self.refuse_render(*maps, "--max-memory", "500MiB", says=["--max-memory", "'roma'", "52"])
        self.refuse("render", "scene.glb", "-o", "out.png", "--size", "4000x4000", "--max-memory",
                    "500MiB", says=["--max-memory", "4000x4000", "MiB"])
        self.refuse_render("--max-memory", "1KiB", says="--max-memory")
        self.render("out.png", "--max-memory", "500MiB")
        self.refuse("render", "hall", "-o", "other.png", "--max-memory", "1MiB",
                    says="--max-memory")
        self.succeed("render", "hall", "-o", "hall.png", "--size", "16x9", "--max-memory", "1GiB")

    def test_amounts_of_memory(self):
        for amount in ("", "x", "-1", "0", "4 apples", "nan", "1e30GiB"):
            self.refuse_render("--max-memory", amount, says=["--max-memory", f"'{amount}'"])
