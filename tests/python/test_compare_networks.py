#!/usr/bin/python3
"""Tests the scripts that compare networks, bench/trainer/ladder.sh, ablation.sh, deepcalib.sh and model_table.py.

    test_compare_networks.py REPOSITORY

The tables are made from evaluations written here, number by number. The scripts run with a program in the place of
cps that notes what it is asked for and leaves the files that cps leaves.
"""

import importlib.util
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

REPOSITORY = Path(sys.argv.pop(1))
SCRIPTS = REPOSITORY / "bench" / "trainer"
specification = importlib.util.spec_from_file_location("model_table", SCRIPTS / "model_table.py")
model_table = importlib.util.module_from_spec(specification)
specification.loader.exec_module(model_table)

CORRUPTIONS = ("as it is", "Gaussian blur, 2 px", "ISO noise, 10 of 255")


def estimate(value, low=None, high=None):
    return {"value": value, "low": low, "high": high}


def ray_comparison(images, angle, without_angles=0, **more):
    """As cps eval writes it, `rays`; the constant's angle is 8 degrees."""
    def summary(angle, without_angles):
        return {"images": images, "angle_mean_deg": angle, "turned_mean_deg": angle / 2, "reprojection_mean_px": 10 * angle,
                "reprojection_median_px": 5 * angle, "seen_hfov_mean_deg": 2 * angle, "without_angles": without_angles,
                "without_reprojection": 1, "without_seen_hfov": 0}
    network = summary(angle, without_angles)
    return {"intervals_95": {key: estimate(value, value - 1, value + 1) for key, value in network.items()
                             if "_mean_" in key or "_median_" in key},
            "network": network, "training_mean": summary(8, 0), **more}


def evaluation(hfov, k1_r2, losses=()):
    """As cps eval writes it; what the tables leave out is left out. null bounds are those of a single place."""
    return {"intervals_95": {"hfov_mean_deg": hfov, "hfov_ratio": estimate(.5, .375, .625),
                             "reprojection_mean_px": estimate(1234.5, 1100, 1400), "k1_r2": k1_r2},
            "network": {"raw": {"mae": {"k1": .0123456}}, "apparent": {"mae": {"k1": .25}}},
            "robustness": [{"name": name, "loss": loss, "hfov_mean_deg": 10 + loss, "reprojection_mean_px": 1}
                           for name, loss in zip(CORRUPTIONS, losses)],
            "rays": ray_comparison(3, 2),
            "images": [{}, {}, {}]}


def ray_evaluation(rays):
    """Of pictures or of a network of another lens family: nothing but this."""
    return {"rays": rays, "images": [{}, {}, {}]}


def write_model(folder, outputs, validation_loss):
    folder.mkdir(parents=True)
    (folder / "model.json").write_text(json.dumps(
        {"options": {"outputs": outputs}, "dataset": {"folder": "somewhere/cps-v1", "training_images": 196}, "epoch": 2,
         "validation_loss": validation_loss}))
    (folder / "history.csv").write_text("epoch,training_loss\n1,1\n2,.5\n3,.25\n")
    (folder / "cpu_seconds").write_text("100 20\n45 15\n")


def cells(page, heading, network):
    """The cells of a network's row in the table below a heading, without the name."""
    section = page.split(f"## {heading}\n")[1].split("\n## ")[0]
    row = next(line for line in section.splitlines() if line.startswith(f"| {network} |"))
    return [cell.strip() for cell in row.strip("|").split("|")][1:]


class TableTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def make(self):
        write_model(self.root / "v0.1", ["fov", "k1"], .987654)
        write_model(self.root / "v0.7", list("abcdefgh"), .5)
        (self.root / "later").mkdir()
        (self.root / "v0.1/eval.json").write_text(
            json.dumps(evaluation(estimate(11.84, 10.9, 12.75), estimate(.5, -.25, .75), (.9, 1.5, 2500))))
        older = evaluation(estimate(9), estimate(0), (.8, 1, 1.25))
        del older["intervals_95"]["k1_r2"]  # of a program that did not measure it
        (self.root / "v0.7/eval.json").write_text(json.dumps(older))
        (self.root / "v0.7/eval_kitti.json").write_text(json.dumps(evaluation(estimate(4, 3, 5), estimate(-2e7, -3e7, -1e7))))
        model_table.main(["--out", str(self.root / "table"), "--title", "Two networks", "--set", "own test part=eval.json",
                          "--set", "KITTI=eval_kitti.json",
                          *(str(self.root / name) for name in ("v0.1", "v0.7", "later"))])
        return (self.root / "table.md").read_text(), json.loads((self.root / "table.json").read_text())

    def test_numbers_have_their_intervals(self):
        page, _ = self.make()
        self.assertEqual(cells(page, "Errors: own test part", "v0.1"),
                         ["3", "11.8 [10.9, 12.8]", "0.5 [0.375, 0.625]", "0.0123", "0.25", "0.5 [-0.25, 0.75]",
                          "1234 [1100, 1400]", "2 [1, 3]"])
        # An unbounded interval is left out, a number that is not there is a dash.
        self.assertEqual(cells(page, "Errors: own test part", "v0.7")[1], "9")
        self.assertEqual(cells(page, "Errors: own test part", "v0.7")[5], "–")
        self.assertEqual(cells(page, "Errors: KITTI", "v0.7")[5], "-2e+07 [-3e+07, -1e+07]")

    def test_trainings_and_corruptions(self):
        page, _ = self.make()
        self.assertEqual(cells(page, "Training", "v0.1"), ["cps-v1", "fov k1", "196", "3 (2)", "3", "0.988"])
        self.assertEqual(cells(page, "Training", "v0.7")[1], "all")
        self.assertEqual(cells(page, "Loss under corruption: own test part", "v0.1"), ["0.9", "1.5", "2500"])
        self.assertEqual(cells(page, "H-FOV error under corruption, °: own test part", "v0.7"), ["10.8", "11", "11.2"])
        self.assertIn("Gaussian blur, 2 px", page)

    def test_what_is_not_measured_is_named_and_left_out(self):
        page, result = self.make()
        self.assertIn("Not measured: later.", page)
        self.assertNotIn("| v0.1 |", page.split("## Errors: KITTI")[1].split("\n## ")[0])
        self.assertEqual(result["not_measured"], ["later"])
        self.assertEqual([network["name"] for network in result["networks"]], ["v0.1", "v0.7"])
        self.assertNotIn("KITTI", result["networks"][0]["sets"])

    def test_json_keeps_all_digits(self):
        _, result = self.make()
        network = result["networks"][0]
        self.assertEqual(network["sets"]["own test part"]["hfov_mean_deg"], estimate(11.84, 10.9, 12.75))
        self.assertEqual(network["sets"]["own test part"]["k1_mae_raw"], estimate(.0123456))
        self.assertEqual(network["training"]["validation_loss"], .987654)
        self.assertEqual(network["robustness"]["ISO noise, 10 of 255"]["loss"], 2500)

    def test_the_tables_are_tables(self):
        page, _ = self.make()
        for section in page.split("\n## ")[1:]:
            lines = [line for line in section.splitlines() if line.startswith("|")]
            self.assertGreater(len(lines), 2)
            self.assertEqual(len({line.count("|") for line in lines}), 1)


class RayTableTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = Path(self.folder.name)
        write_model(self.root / "ours", list("abcdefgh"), .5)
        write_model(self.root / "spheres", list("abcdefgh"), .25)
        card = self.root / "spheres/model.json"
        model = json.loads(card.read_text())
        model["options"]["head"] = "deepcalib_regression"
        model["outputs"] = {"names": ["focal", "xi"]}
        card.write_text(json.dumps(model))
        cameras = [{"camera": "KITTI 00", **ray_comparison(2, 3)}, {"camera": "KITTI 03", **ray_comparison(2, 0, 2)}]
        self.write("ours", "eval.json", evaluation(estimate(9), estimate(0)))
        self.write("ours", "eval_kitti.json", ray_evaluation(ray_comparison(4, 3, 2, by_camera=cameras)))
        self.write("spheres", "eval.json", ray_evaluation(ray_comparison(3, 4)))
        model_table.main(["--rays", "--out", str(self.root / "table"), "--title", "Two families", "--set", "own=eval.json",
                          "--set", "KITTI=eval_kitti.json", str(self.root / "ours"), str(self.root / "spheres")])
        self.page = (self.root / "table.md").read_text()
        self.result = json.loads((self.root / "table.json").read_text())

    def tearDown(self):
        self.folder.cleanup()

    def write(self, model, file, text):
        (self.root / model / file).write_text(json.dumps(text))

    def test_each_error_stands_beside_the_constant(self):
        self.assertEqual(cells(self.page, "Errors: own", "ours"),
                         ["3", "0, 1, 0", "4 [3, 5]", "16", "2 [1, 3]", "8", "1 [0, 2]", "4", "20 [19, 21]", "80",
                          "10 [9, 11]", "40"])
        self.assertEqual(cells(self.page, "Errors: own", "spheres")[4:6], ["4 [3, 5]", "8"])
        self.assertNotIn("k1", self.page)
        self.assertEqual(cells(self.page, "Training", "spheres")[1], "focal xi")
        self.assertEqual(cells(self.page, "Training", "ours")[1], "all")

    def test_several_cameras_have_rows_of_their_own(self):
        self.assertNotIn("## Errors by camera: own", self.page)
        section = self.page.split("## Errors by camera: KITTI\n")[1]
        rows = [line for line in section.splitlines() if line.startswith("| ours |")]
        self.assertEqual([row.split("|")[2].strip() for row in rows], ["KITTI 00", "KITTI 03"])
        self.assertNotIn("| spheres |", section)  # not measured there

    def test_a_mean_over_no_images_is_a_dash(self):
        rows = self.page.split("## Errors by camera: KITTI\n")[1].splitlines()
        row = [cell.strip() for cell in next(line for line in rows if "KITTI 03" in line).strip("|").split("|")]
        self.assertEqual(row[3:], ["2, 1, 0", "0 [-1, 1]", "16", "–", "–", "–", "–", "0 [-1, 1]", "80", "0 [-1, 1]", "40"])
        of_camera = self.result["networks"][0]["sets"]["KITTI"]["by_camera"]["KITTI 03"]
        self.assertNotIn("angle_mean_deg", of_camera)
        self.assertEqual(of_camera["left_out"]["without_angles"], 2)

    def test_json_keeps_values_and_constants(self):
        errors = self.result["networks"][0]["sets"]["own"]
        self.assertEqual(errors["turned_mean_deg"], {"value": 1, "low": 0, "high": 2, "constant": 4})
        self.assertEqual(errors["images"], 3)

    def test_the_tables_are_tables(self):
        for section in self.page.split("\n## ")[1:]:
            lines = [line for line in section.splitlines() if line.startswith("|")]
            self.assertGreater(len(lines), 2)
            self.assertEqual(len({line.count("|") for line in lines}), 1)


# Notes its arguments, and does what the next steps look for. A file `fail` beside it makes trainings end after an epoch, a
# file `interrupt` makes cps generate end like a process that got a signal.
CPS = r"""#!/usr/bin/env bash
set -euo pipefail
here=${0%/*}
echo "$*" >>"$here/calls"
verb=$1 out=""
while [ $# -gt 0 ]; do case $1 in --out) out=$2 ;; esac; shift; done
case $verb in
  generate) mkdir -p "$out/174x64_hfov090"; [ ! -e "$here/interrupt" ] || exit 75 ;;
  train)
    cp "$here/model.json" "$here/history.csv" "$out"
    if [ -e "$here/fail" ]; then touch "$out/state.pt"; exit 1; fi ;;
  eval) cp "$here/eval.json" "$out" ;;
esac
"""


class ScriptTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = Path(self.folder.name)
        write_model(self.root / "cps", list("abcdefgh"), .5)
        (self.root / "cps/eval.json").write_text(json.dumps(evaluation(estimate(4, 3, 5), estimate(.5, .25, .75), (1, 2, 3))))
        (self.root / "cps/cps").write_text(CPS)
        (self.root / "cps/cps").chmod(0o755)

    def tearDown(self):
        self.folder.cleanup()

    def run_script(self, script, *arguments, status=0):
        """Its calls of cps, as lists of words."""
        calls = self.root / "cps/calls"
        calls.unlink(missing_ok=True)
        done = subprocess.run([SCRIPTS / script, self.root / "work", "--cps", self.root / "cps/cps", "--threads", "1",
                               *arguments], capture_output=True, text=True)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        self.output = done.stdout + done.stderr
        return [line.split() for line in calls.read_text().splitlines()] if calls.exists() else []

    def dataset(self, name, **keys):
        folder = self.root / name
        folder.mkdir()
        recipe = {"name": name, "seed": "1", "size": "696x256", "samples": "4", "full_well_min_e": "2000", **keys}
        (folder / "dataset.json").write_text(json.dumps({"recipe": recipe, "counts": {"samples": 1}}, indent=2))
        return str(folder)

    def test_the_ladder_uses_the_shipped_recipes_and_presets(self):
        rows = "v0.1,v0.7-orientation-fit"
        calls = self.run_script("ladder.sh", "--rows", rows, "--minutes", "7", "--kitti", "/kitti")
        generated = [" ".join(call) for call in calls if call[0] == "generate"]
        self.assertEqual(len(generated), 2)  # each recipe once
        self.assertIn("cps-v3.cfg", generated[1])  # for the common test part
        self.assertIn("--size 240x135,174x64 --views 40,20 ", generated[1])
        self.assertIn("--size 240x135 --views 160 ", generated[0])
        trained = [" ".join(call) for call in calls if call[0] == "train"]
        self.assertEqual(len(trained), 2)
        for preset, command in zip(("cps-v0.1", "cps-v0.7 --orientation true --head fit"), trained):
            self.assertIn(f"--preset {preset} --arch resnet18-16 ", command)
            self.assertIn("--minutes 7 ", command)
        self.assertIn("/data/cps-v1 ", trained[0])
        self.assertIn("/data/cps-v3 ", trained[1])
        self.assertIn("measures orientation in images of 174 pixels", self.output)
        evaluated = [call for call in calls if call[0] == "eval"]
        self.assertEqual(len(evaluated), 3 + 2)  # own test part, cps-v3's where that is another, KITTI
        page = (self.root / "work/ladder.md").read_text()
        for heading in ("Training", "Errors: test part of its own data", "Errors: test part of cps-v3", "Errors: KITTI",
                        "Loss under corruption: test part of its own data"):
            for name in rows.split(","):
                self.assertTrue(cells(page, heading, name))
        # Datasets that are finished cps itself leaves alone; nothing else is asked for again.
        again = self.run_script("ladder.sh", "--rows", rows, "--minutes", "7", "--kitti", "/kitti")
        self.assertEqual({call[0] for call in again}, {"generate"})
        (self.root / "work/models/v0.1/eval_kitti.json").unlink()
        again = self.run_script("ladder.sh", "--rows", rows, "--minutes", "7", "--kitti", "/kitti")
        self.assertEqual([call[0] for call in again if call[0] != "generate"], ["eval"])

    def test_both_methods_see_the_same_places_and_are_measured_on_both_families(self):
        calls = self.run_script("deepcalib.sh", "--minutes", "7", "--kitti", "/kitti", "--views", "9", "--seed", "3")
        generated = [call for call in calls if call[0] == "generate"]
        self.assertEqual(len(generated), 2)
        folders = [call[call.index("--out") + 1] for call in generated]
        self.assertEqual([folder.rsplit("/", 1)[1] for folder in folders], ["spherical", "brown-conrady"])
        for call in generated:
            self.assertTrue(call[call.index("--recipe") + 1].endswith("deepcalib.cfg"))
            self.assertEqual(call[call.index("--views") + 1], "9")
        spherical, flat = ([word for word in call if "/data/" not in word] for call in generated)
        lenses = "--lens_model brown_conrady --lens_draw shape_prior --real_lenses_share 0.3".split()
        at = flat.index(lenses[0])
        self.assertEqual(flat[at:at + 6], lenses)
        self.assertEqual(flat[:at] + flat[at + 6:], spherical)  # the lenses are all that differs

        trained = {call[call.index("--out") + 1].rsplit("/", 1)[1]: call for call in calls if call[0] == "train"}
        options = {"deepcalib-regression": "--preset deepcalib-regression",
                   "deepcalib-classification": "--preset deepcalib-classification",
                   "ours": "--preset reference --size-features false --orientation false",
                   "ours-orientation": "--preset reference --size-features false",
                   "ours-fit": "--preset reference --size-features false --head fit"}
        self.assertEqual(list(trained), list(options))
        for name, call in trained.items():
            self.assertIn(folders[0] if name.startswith("deepcalib") else folders[1], call)
            self.assertEqual(" ".join(call[call.index("--preset"):]), options[name] +
                             " --arch resnet18-32 --width 128 --epochs 100000 --minutes 7 --threads 1 --seed 3")

        evaluated = [" ".join(call) for call in calls if call[0] == "eval"]
        self.assertEqual(len(evaluated), 5 * 3)
        for measured in (f"--data {folders[0]}", f"--data {folders[1]}", "--kitti /kitti"):
            self.assertEqual(sum(call.endswith(measured) for call in evaluated), 5)
        page = (self.root / "work/deepcalib.md").read_text()
        for heading in ("Training", "Errors: spherical test part", "Errors: Brown–Conrady test part", "Errors: KITTI"):
            for name in options:
                self.assertTrue(cells(page, heading, name))
        again = self.run_script("deepcalib.sh", "--minutes", "7", "--kitti", "/kitti", "--views", "9", "--seed", "3")
        self.assertEqual({call[0] for call in again}, {"generate"})

    def test_an_interrupted_dataset_ends_the_script_with_its_status(self):
        (self.root / "cps/interrupt").touch()
        calls = self.run_script("ladder.sh", "--rows", "v0.1", status=75)
        self.assertEqual([call[0] for call in calls], ["generate"])

    def test_a_training_that_was_interrupted_resumes(self):
        (self.root / "cps/fail").touch()
        self.run_script("ladder.sh", "--rows", "v0.7", status=1)
        self.assertIn("cps train failed", self.output)
        (self.root / "cps/fail").unlink()
        calls = self.run_script("ladder.sh", "--rows", "v0.7")
        trained = [call for call in calls if call[0] == "train"]
        self.assertEqual(len(trained), 1)
        self.assertEqual(trained[0][-1], "--resume")
        self.assertEqual(len((self.root / "work/models/v0.7/cpu_seconds").read_text().splitlines()), 2)

    def test_other_options_need_another_folder(self):
        self.run_script("ladder.sh", "--rows", "v0.7")
        self.run_script("ladder.sh", "--rows", "v0.7", "--seed", "2", status=2)
        self.assertIn("was trained with other options", self.output)

    def test_wrong_usage_is_refused(self):
        for wrong in (["--rows", "v0.9"], ["--divide", "7"], ["--views", "3"], ["--minuets", "3"], ["--minutes"]):
            self.run_script("ladder.sh", *wrong, status=2)
        self.run_script("deepcalib.sh", "--rows", "theirs", status=2)
        self.run_script("ablation.sh", status=2)
        self.run_script("ablation.sh", "--data", "no such folder", "--rows", "bass", status=2)

    def test_the_ablation_changes_one_thing_a_row(self):
        data, quiet = self.dataset("data"), self.dataset("quiet", full_well_min_e="8000", samples="16")
        calls = self.run_script("ablation.sh", "--data", data, "--data", quiet, "--seed", "3", "--", "--online-lenses", "true")
        commands = {call[call.index("--out") + 1].rsplit("/", 1)[1]: call for call in calls if call[0] == "train"}
        base = commands.pop("base")
        self.assertEqual(base[base.index("--preset"):],
                         "--preset reference --epochs 100000 --minutes 30 --threads 1 --seed 3 --online-lenses true".split())
        added = {"no-orientation": "--orientation false", "width-348": "--width 348", "width-696": "--width 696",
                 "resnet18-16": "--arch resnet18-16", "resnet18": "--arch resnet18", "places-half": "--places-share .5",
                 "places-quarter": "--places-share .25", "head-fit": "--head fit", "noise-half": ""}
        self.assertEqual(set(commands), set(added))
        for name, command in commands.items():
            expected = [word for word in base if "/models/" not in word]
            at = expected.index("--epochs")
            expected[at:at] = added[name].split()
            if name == "noise-half":
                expected[expected.index(data)] = quiet
            self.assertEqual([word for word in command if "/models/" not in word], expected)
        # All are measured on the test part of the first dataset.
        for call in calls:
            if call[0] == "eval":
                self.assertIn(data, call)
                self.assertIn("--robustness", call)
        self.assertTrue(cells((self.root / "work/ablation.md").read_text(), "Errors: test part", "places-quarter"))

    def test_a_second_dataset_may_differ_in_noise_alone(self):
        data, other = self.dataset("data"), self.dataset("other", seed="2")
        self.assertEqual(self.run_script("ablation.sh", "--data", data, "--data", other, status=2), [])
        self.assertIn("more than noise", self.output)

    def test_the_head_of_a_script_is_its_help(self):
        for script in ("ladder.sh", "ablation.sh", "deepcalib.sh"):
            done = subprocess.run([SCRIPTS / script, "--help"], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0)
            self.assertIn("--minutes M", done.stdout)
            self.assertNotIn("#", done.stdout)
            self.assertNotIn("pipefail", done.stdout)


if __name__ == "__main__":
    unittest.main()
