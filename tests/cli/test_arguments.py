# SPDX-License-Identifier: MIT
"""Command lines that are refused: one line that says what is wrong, status 2, nothing written."""

import subprocess

import helper
from helper import CliTest


class Words(CliTest):
    def test_no_command_is_a_window(self):
        self.refuse(status=1, says=["no window can be opened", "DISPLAY", "romascope render"])
        self.refuse("view", "scene.glb", status=1, says=["no window can be opened", "DISPLAY"])

    def test_view_refuses_before_it_opens_a_window(self):
        self.refuse("view", "nowhere.glb", says="nowhere.glb")
        self.refuse("view", "halls", says="did you mean 'hall'")
        self.refuse("view", "scene.glb", "--camera", "x", says="camera")
        self.refuse("view", "scene.glb", "--set", "ao.rays=0", says="ao.rays")
        self.refuse("view", "scene.glb", "--shaders", "nowhere", says="nowhere")

    def test_unknown_command(self):
        self.refuse("rendr", "scene.glb", says=["'rendr'", "did you mean 'render'"])

    def test_unknown_option(self):
        self.refuse_render("--framse", "3", says=["'--framse'", "did you mean '--frames'"])
        self.refuse_render("--framse=3", says=["'--framse'", "did you mean '--frames'"])
        self.refuse_render("-q", says="'-q'")
        self.assertNotIn("did you mean", self.refuse_render("--zoom", "3", says="'--zoom'"))
        self.assertNotIn("did you mean", self.refuse("paint", says=["'paint'", "render, compare"]))
        self.refuse("--verion", says="did you mean '--version'")
        self.refuse("info", "--knob", says="did you mean '--knobs'")
        self.refuse("compare", "a.png", "b.png", "--metrik", "mae", says="did you mean '--metric'")

    def test_missing_value(self):
        for option in ("--size", "--camera", "--frames", "--seed", "--set", "--config",
                       "--technique", "--report", "--reference", "--backend", "--egl-device",
                       "--time", "--fps", "--animation", "--max-memory"):
            with self.subTest(option):
                self.refuse_render(option, says=[f"{option} needs ", "nothing stands after it"])
                self.refuse_render(option, "--frames", "2",
                                   says=[f"{option} needs ", "nothing stands before '--frames'"])
        self.refuse("render", "scene.glb", "-o", says="--output needs FILE")
        self.refuse("bench", "scene.glb", "--vary", "--frames", "1", says="--vary needs KEY=A,B,C")
        self.refuse_render("--frames=", "2", says="--frames needs N: nothing stands after its '='")
        self.refuse_render("--jump", says="--jump needs FRAME SECONDS: nothing")
        for words in (("--jump", "2"), ("--jump=2",)):
            self.refuse_render(*words, "--frames", "4",
                               says="--jump needs FRAME SECONDS: only '2' stands before '--frames'")

    def test_negative_numbers_are_values(self):
        self.refuse_render("--time", "-1", says=["render.time", "'-1'"])

    def test_twice(self):
        self.refuse_render("--seed", "1", "--seed", "2", says="--seed is there twice")
        self.refuse_render("--jump", "1", "0", "--jump", "1", "0", says="--jump is there twice")

    def test_value_of_a_flag(self):
        self.refuse_render("--flicker=yes", says="--flicker takes no value: leave out '=yes'")
        self.refuse("--version=3", says="--version takes no value")

    def test_values_that_are_no_numbers(self):
        self.refuse_render("--jump", "a", "1",
                           says="--jump cannot be 'a 1': it takes FRAME SECONDS, a whole number and a")
        self.refuse_render("--reference", "x", says="--reference cannot be 'x': it takes N, a whole")
        self.refuse("bench", "--seconds", "x", says="--seconds cannot be 'x': it takes S, a number")

    def test_what_must_be_there(self):
        self.refuse("sheet", says="--output is missing: picture")
        self.refuse("compare", "a.png", says="TEST is missing: the picture to judge")

    def test_one_word_too_many(self):
        self.refuse_render("scene.glb", says=["'scene.glb'", "too many"])

    def test_nothing_to_do(self):
        self.refuse("render", "scene.glb", says=["nothing to do", "-o", "--report", "--table"])

    def test_the_answer_is_one_line_whatever_was_typed(self):
        self.refuse("render", "a\nb", "-o", "out.png", says="'a b'")
        self.refuse("ren\nder", says="'ren der'")


class Values(CliTest):
    def test_size(self):
        for size in ("abc", "64", "64X48", "64,48", " ", "1.5x10", "x10", "10x", "10x10x10",
                     "ax1"):
            with self.subTest(size):
                self.refuse_render_of_size(size, "WIDTHxHEIGHT")
        for size, key in (("0x10", "width"), ("10x0", "height"), ("-5x10", "width"),
                          ("16385x10", "width"), ("10x16385", "height"),
                          ("9999999999999999999999x1", "width")):
            with self.subTest(size):
                self.refuse_render_of_size(size, f"render.{key}", "1 to 16384")

    def refuse_render_of_size(self, size, *says):
        self.refuse("render", "scene.glb", "-o", "out.png", "--size", size, says=says)

    def test_camera(self):
        self.refuse_render("--camera", "frnt", says=["'frnt'", "did you mean 'front'", "front, above"])
        for camera in ("1,2,3/4,5/60", "1,2,3/4,5,6", "1,2,3/4,5,6/60/7", "/", "//",
                       "a,b,c/0,0,0/60", "1,2,3/0,0,nan/60", "1,2,3/inf,0,0/60"):
            with self.subTest(camera):
                self.refuse_render("--camera", camera, says=["eye/target/degrees", camera])
        self.refuse_render("--camera", "1,2,3/1,2,3/60", says="same point")
        for angle in ("0", "180", "-10"):
            self.refuse_render("--camera", f"1,2,3/0,0,0/{angle}", says="between 0 and 180")

    def test_numbers_are_answered_with_their_range(self):
        for option, key, allowed in (("--frames", "render.frames", "1 to 1000000"),
                                     ("--seed", "render.seed", "0 to 4294967295")):
            for value in ("-1", "1.5", "abc", "99999999999999999999", "nan"):
                with self.subTest(option=option, value=value):
                    self.refuse_render(option, value, says=[key, f"'{value}'", allowed])
        for option, key in (("--time", "render.time"), ("--fps", "render.fps")):
            for value in ("-1", "abc", "nan", "inf"):
                with self.subTest(option=option, value=value):
                    self.refuse_render(option, value, says=[key, f"'{value}'", "0 to 1"])
        self.refuse_render("--frames", "0", says="1 to 1000000")
        for value in ("0", "-4", "x", "1.5"):
            self.refuse_render("--reference", value, says="--reference")
        self.refuse_render("--egl-device", "x", says="--egl-device")

    def test_animation(self):
        self.refuse_render("--animation", "walk", says=["'walk'", "none at all"])
        for option in ("--time", "--fps"):
            result = self.succeed("render", "scene.glb", "-o", "out.png", "--size", "8x8", option,
                                  "1")
            self.assertRegex(result.stderr, r"\Anotice: scene.glb: has no animation: [^\n]*\n\Z")

    def test_reference_outputs_need_a_reference(self):
        self.refuse_render("--reference-output", "t.png", says="--reference N")
        self.refuse_render("--error-map", "t.png", says="--reference N")

    def test_reference_of_another_view(self):
        for view in ("lit", "ambient_occlusion_raw", "structure"):
            self.refuse_render("--reference", "1", "--set", f"frame.view={view}",
                               says="ambient_occlusion")

    def test_view_of_a_structure(self):
        self.refuse_render("--set", "frame.view=structure", "--set", "view.structure=trees",
                           says=["view.structure", "'trees'", "occupancy_slice, map_slice"])
        self.refuse_render("--set", "view.slice=1.1", says="0 to 1")

    def test_shader_folder(self):
        self.refuse_render("--shaders", "nowhere", says="there is no folder 'nowhere'")
        # The folder is there but holds no shaders: only the work itself finds out.
        empty = self.folder / "empty"
        empty.mkdir()
        self.refuse_render("--shaders", "empty", status=1, says="empty/")


class Outputs(CliTest):
    """Refused before the work: each command asks for so many frames that it could not end."""

    def refuse_at_once(self, *words, **options):
        self.refuse("render", "scene.glb", "--frames", "1000000", *words, **options)

    def test_unknown_kind_of_picture(self):
        for name in ("out.jpg", "out", "out.png.txt", ".png"):
            self.refuse_at_once("-o", name, says=[name, ".png or .hdr"])
        for option in ("--reference-output", "--error-map"):
            self.refuse_at_once("-o", "out.png", "--reference", "1", option, "t.tif",
                                says=["t.tif", ".png or .hdr"])
        self.refuse("compare", "a.png", "b.png", "--error-map", "t.tif", says="t.tif")

    def test_folder_in_the_place_of_the_file(self):
        self.path("there.png").mkdir()
        self.refuse_at_once("-o", "there.png", says=["there.png", "folder"])
        self.refuse_at_once("--report", ".", says="folder")

    def test_file_in_the_place_of_the_folder(self):
        self.refuse_at_once("-o", "scene.glb/out.png", says=["scene.glb", "not a folder"])

    def test_folder_without_the_right_to_write(self):
        self.path("locked").mkdir(mode=0o500)
        for name in ("locked/out.png", "locked/new/out.png"):
            self.refuse_at_once("-o", name, says=[name, "Permission denied"],
                                **self.without_root())

    def test_place_that_only_writing_shows_to_be_unwritable(self):
        self.assertIn("/proc/out.png", self.run_program("render", "scene.glb", "-o",
                                                        "/proc/out.png", "--size", "8x8").stderr)
        self.refuse("render", "scene.glb", "--report", "/dev/full", "--size", "8x8", status=1,
                    says=["/dev/full", "No space left"])

    def test_one_name_for_two_outputs(self):
        self.refuse_at_once("-o", "out.png", "--report", f"{self.folder}/./out.png",
                            says="two outputs")

    def test_output_over_an_input(self):
        self.refuse_at_once("--report", "scene.glb", says=["scene.glb", "input"])
        config = self.write("a.toml", "")
        self.refuse_at_once("--config", config, "--report", config, says=["a.toml", "input"])
        self.path("link.glb").symlink_to("scene.glb")
        self.refuse_at_once("--report", "link.glb", says="input")

    def test_full_standard_output(self):
        for what in ("--techniques", "--knobs"):
            with open("/dev/full", "w") as full:
                result = self.command_to(full, "info", what)
            self.assertEqual(result.returncode, 1)
            self.assertIn("No space left", result.stderr)

    def command_to(self, stdout, *words):
        return subprocess.run([helper.PROGRAM, *words], env=self.env, stdout=stdout,
                              stderr=subprocess.PIPE, text=True, timeout=60)


class Scenes(CliTest):
    def test_missing_file(self):
        for name in ("nowhere.glb", "no/where", "/nowhere/scene.gltf"):
            self.refuse("render", name, "-o", "out.png", says=name)

    def test_misspelt_name(self):
        for name in ("cornell", "hall"):
            self.path(name + ".glb").write_bytes(self.scene.read_bytes())
        env = {"ROMASCOPE_ASSETS": str(self.folder)}
        self.refuse("render", "cornel", "-o", "out.png", env=env,
                    says=["'cornel'", "did you mean 'cornell'", "hall, scene"])

    def test_folder(self):
        self.refuse("render", ".", "-o", "out.png", says="folder")

    def test_not_a_scene(self):
        self.write("text.glb", "Once upon a time")
        self.write("empty.glb", "")
        self.write("json.gltf", "{}")
        self.write("brace.gltf", "{")
        whole = self.scene.read_bytes()
        self.path("cut.glb").write_bytes(whole[:len(whole) // 2])
        self.path("header.glb").write_bytes(whole[:12])
        for name in ("text.glb", "empty.glb", "json.gltf", "brace.gltf", "cut.glb", "header.glb"):
            with self.subTest(name):
                self.refuse("render", name, "-o", "out.png", says=name)

    def test_unreadable_file(self):
        self.scene.chmod(0)
        self.refuse("render", "scene.glb", "-o", "out.png", says="Permission denied",
                    **self.without_root())


class Comparisons(CliTest):
    def test_missing_picture(self):
        self.render("a.png")
        self.refuse("compare", "a.png", says="TEST")
        self.refuse("compare", "a.png", "nowhere.png", says="nowhere.png")

    def test_unknown_metric(self):
        self.refuse("compare", "a.png", "b.png", "--metric", "flp",
                    says=["'flp'", "did you mean 'flip'", "rmse"])

    def test_bound(self):
        for bound in ("-1", "nan", "x"):
            self.refuse("compare", "a.png", "b.png", "--max", bound, says="--max")

    def test_not_a_picture(self):
        self.render("a.png")
        self.refuse("compare", "a.png", "scene.glb", says=["scene.glb", ".png"])
        whole = self.path("a.png").read_bytes()
        self.path("cut.png").write_bytes(whole[:len(whole) // 2])
        self.refuse("compare", "cut.png", "a.png", says="cut.png")

    def test_other_size(self):
        self.render("a.png")
        self.succeed("render", "scene.glb", "-o", "b.png", "--size", "8x8")
        self.refuse("compare", "a.png", "b.png", says=["64x48", "8x8"])

    def test_error_map_over_an_input(self):
        self.render("a.png")
        self.refuse("compare", "a.png", "a.png", "--error-map", "a.png", says="input")
