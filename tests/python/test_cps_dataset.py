#!/usr/bin/python3
"""Tests python/cps_dataset.py, and with it `cps export`'s tars and folders.

    test_cps_dataset.py CPS REPOSITORY            what needs NumPy and Pillow
    test_cps_dataset.py CPS REPOSITORY --torch    what needs PyTorch; exit status 77 where it is not installed

CPS is the program. The datasets are written here, number by number from docs/formats.md, so that readers and
exports are compared with values that no code of the project has touched.
"""

import hashlib
import importlib.util
import io
import json
import math
import re
import subprocess
import sys
import tarfile
import tempfile
import unittest
from pathlib import Path

import numpy as np
from PIL import Image

CPS, REPOSITORY = sys.argv[1], Path(sys.argv[2])
sys.path.insert(0, str(REPOSITORY / "python"))
from cps_dataset import LABELS, CpsDataset, SizeBatches, collate, decode_image

# folder, part, width, height, hfov_deg, k1 k2 k3 p1 p2, cx cy
GROUPS = [
    ("96x54_hfov060/front_lens0000", "all", 96, 54, 60, (0, 0, 0, 0, 0), (47.5, 26.5)),
    ("96x54_hfov060/front_lens0001", "train", 96, 54, 52.125, (-0.21, 0.03, -0.001, 1e-3, -2e-3), (46.25, 27)),
    ("96x54_hfov060/front_lens0002", "val", 96, 54, 55, (0.11, -0.02, 0, 0, 1e-4), (48, 26.0625)),
    ("320x240_hfov090/left_lens0003", "train", 320, 240, 81.5, (-0.1, 0.01, 0.002, 0, 0), (160.5, 118.75)),
]
IMAGES = {  # by part: group and number, in the order of the list
    "train": [(0, 1), (1, 1), (3, 0), (0, 2), (3, 1), (1, 2), (3, 2), (3, 3), (3, 4), (3, 5), (1, 7)],
    "val": [(2, 3), (0, 3)],
    "test": [],
}
DEEP_COLOUR_PNG = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR" + bytes(8) + bytes([16, 2]) + bytes(20)


def true_label(group):
    _, _, width, _, hfov, lens, centre = GROUPS[group]
    focal = width / (2 * math.tan(math.radians(hfov) / 2))
    return np.array([hfov, *lens, *centre, focal, focal])


def calibration(group):
    """Everything that calibration.json must have; what the reader does not use is plausible."""
    folder, part, width, height, hfov, lens, (cx, cy) = GROUPS[group]
    focal = true_label(group)[8]
    return {
        "schema": 1,
        "fov": hfov,
        "K": [[focal, 0, cx], [0, focal, cy], [0, 0, 1]],
        "width": width,
        "height": height,
        **dict(zip(("k1", "k2", "k3", "p1", "p2"), lens)),
        "cx": cx,
        "cy": cy,
        "fov_base_deg": 100,
        "fov_true_deg": {"h": 61, "v": 40, "d": 70},
        "crop": {"zoom": 1.5},
        "certificate": {"min_eigenvalue": 0.5, "max_roundtrip_px": 1e-12},
        "limits": {name: None for name in ("k1", "k2", "k3", "p1", "p2", "cx", "cy")},
        "camera": {"name": folder.split("/")[1].split("_")[0], "T_vehicle_camera": np.eye(4).tolist()},
        "part": part,
        "seed": 1,
        "generator": "a test",
    }


def file_of(group, number, ending):
    return f"{GROUPS[group][0]}/{number:06}.{ending}"


def pixels_of(group, number, channels=3):
    _, _, width, height, *_ = GROUPS[group]
    random = np.random.default_rng((group, number))
    return random.integers(0, 256, (height, width, channels), np.uint8)


def write_dataset(root, ending="png", channels=3):
    for group in range(len(GROUPS)):
        folder = root / GROUPS[group][0]
        folder.mkdir(parents=True)
        (folder / "calibration.json").write_text(json.dumps(calibration(group)))
    (root / "splits").mkdir()
    for part, images in IMAGES.items():
        for group, number in images:
            pixels = pixels_of(group, number, channels)
            Image.fromarray(pixels if channels == 3 else pixels[:, :, 0]).save(root / file_of(group, number, ending))
        lines = [file_of(group, number, ending) + "\n" for group, number in images]
        (root / "splits" / f"{part}.txt").write_text("".join(lines))


def export(root, target, out, *options):
    run = subprocess.run([CPS, "export", root, "--to", target, "-o", out, *options], capture_output=True, text=True)
    if run.returncode != 0:
        raise AssertionError(run.stdout + run.stderr)


class Layouts(unittest.TestCase):
    """One dataset in its three layouts."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.folder = Path(cls.temporary.name)
        write_dataset(cls.folder / "data")
        export(cls.folder / "data", "webdataset", cls.folder / "tars", "--shard_mb", "1")
        export(cls.folder / "data", "huggingface", cls.folder / "hub", "--license", "cc0-1.0")
        cls.roots = [cls.folder / name for name in ("data", "tars", "hub")]


class Core(Layouts):
    def test_all_layouts_give_the_true_labels_and_pixels_in_the_order_of_the_list(self):
        for root in self.roots:
            for part, images in IMAGES.items():
                with self.subTest(root=root.name, part=part):
                    data = CpsDataset(root, part)
                    self.assertEqual(len(data), len(images))
                    for index, (group, number) in enumerate(images):
                        sample = data[index]
                        np.testing.assert_array_equal(sample["image"], pixels_of(group, number))
                        self.assertEqual(sample["image"].dtype, np.uint8)
                        np.testing.assert_allclose(sample["label"], true_label(group), rtol=1e-14, atol=0)
                        self.assertEqual(sample["file"], file_of(group, number, "png"))
                        self.assertEqual(sample["group"], GROUPS[group][0])
                        self.assertEqual(data.size(index), GROUPS[group][2:4])

    def test_the_layouts_agree_to_the_last_bit(self):
        folder, tars, hub = (CpsDataset(root, "train") for root in self.roots)
        for index in range(len(folder)):
            for other in (tars, hub):
                np.testing.assert_array_equal(folder[index]["image"], other[index]["image"])
                # The labels above were not written by cps, which computes fov from fx.
                np.testing.assert_array_equal(folder[index]["label"][1:], other[index]["label"][1:])
            np.testing.assert_array_equal(tars[index]["label"], hub[index]["label"])

    def test_indices_behave_as_a_lists(self):
        data = CpsDataset(self.roots[1], "val")
        self.assertEqual(data[-1]["file"], data[1]["file"])
        for index in (2, -3):
            self.assertRaises(IndexError, data.__getitem__, index)
        self.assertEqual(len([sample for sample in data]), 2)

    def test_tars_are_ustar_without_owner_and_time_and_hold_the_images_as_stored(self):
        index = json.loads((self.roots[1] / "train-index.json").read_text())
        shards = [shard["url"] for shard in index["shardlist"]]
        self.assertGreater(len(shards), 1)
        self.assertEqual(shards, sorted(shards))
        self.assertEqual(sum(shard["nsamples"] for shard in index["shardlist"]), len(IMAGES["train"]))
        number = 0
        for shard in index["shardlist"]:
            tar = self.roots[1] / shard["url"]
            data = tar.read_bytes()
            self.assertEqual(hashlib.sha256(data).hexdigest(), shard["sha256"])
            self.assertEqual(len(data), shard["filesize"])
            self.assertLessEqual(len(data), 1_000_000)
            self.assertEqual(data[257:265], b"ustar\x0000")
            self.assertEqual(data[-1024:], bytes(1024))
            with tarfile.open(tar, "r:") as members:
                headers = members.getmembers()
                self.assertEqual(len(headers), 2 * shard["nsamples"])
                for image, label in zip(headers[::2], headers[1::2]):
                    for header in (image, label):
                        self.assertEqual((header.mtime, header.uid, header.gid, header.mode), (0, 0, 0, 0o644))
                        self.assertTrue(header.isreg())
                    self.assertEqual(image.name, f"{number:09}.png")
                    self.assertEqual(label.name, f"{number:09}.json")
                    record = json.load(members.extractfile(label))
                    stored = self.roots[0] / record["file"]
                    self.assertEqual(members.extractfile(image).read(), stored.read_bytes())
                    self.assertEqual(record.keys(), {
                        "file", "group", "camera", "width", "height", "fov", "k1", "k2", "k3", "p1", "p2", "cx",
                        "cy", "fx", "fy", "fov_true_h_deg", "fov_true_v_deg", "fov_true_d_deg",
                    })
                    number += 1

    def test_gnu_tar_unpacks_them(self):
        (self.folder / "unpacked").mkdir()
        for tar in self.roots[1].glob("train-*.tar"):
            subprocess.run(["tar", "-xf", tar, "-C", self.folder / "unpacked"], check=True)
        self.assertEqual(len(list((self.folder / "unpacked").iterdir())), 2 * len(IMAGES["train"]))

    def test_hugging_face_metadata_begins_with_the_name_of_a_file_that_is_there(self):
        for part in ("train", "val"):
            lines = (self.roots[2] / part / "metadata.jsonl").read_text().splitlines()
            self.assertEqual(len(lines), len(IMAGES[part]))
            for line in lines:
                record = json.loads(line)
                self.assertEqual(next(iter(record)), "file_name")
                self.assertTrue((self.roots[2] / part / record["file_name"]).is_file())
        self.assertFalse((self.roots[2] / "test").exists())

    def test_batches_have_one_size_and_seeds_decide_their_order(self):
        data = CpsDataset(self.roots[0], "train")
        batches = list(SizeBatches(data, 4))
        self.assertEqual(batches, [[0, 1, 3, 5], [10], [2, 4, 6, 7], [8, 9]])
        self.assertEqual(len(SizeBatches(data, 4)), 4)
        shuffled = SizeBatches(data, 4, seed=5)
        first, second = list(shuffled), list(shuffled)
        self.assertNotEqual(first, second)
        self.assertEqual(first, list(SizeBatches(data, 4, seed=5)))
        for order in (first, second):
            self.assertEqual(sorted(sum(order, [])), list(range(len(data))))
            for batch in order:
                self.assertEqual(len({data.size(index) for index in batch}), 1)
        with self.assertRaisesRegex(ValueError, "SizeBatches"):
            collate([data[0], data[2]])

    def test_collate_puts_channels_first_and_white_at_one(self):
        data = CpsDataset(self.roots[0], "train")
        batch = collate([data[0], data[1]])
        self.assertEqual(tuple(batch["image"].shape), (2, 3, 54, 96))
        image = np.asarray(batch["image"])[1].transpose(1, 2, 0)
        np.testing.assert_allclose(image, data[1]["image"] / 255, atol=1e-7)
        np.testing.assert_allclose(np.asarray(batch["label"])[1], true_label(1), rtol=1e-6)
        self.assertEqual(batch["file"], [data[0]["file"], data[1]["file"]])

    def test_transforms_get_the_sample(self):
        data = CpsDataset(self.roots[0], "train", transform=lambda sample: sample["label"][1])
        self.assertEqual(data[1], -0.21)

    def test_jpeg_and_gray_images(self):
        write_dataset(self.folder / "gray", channels=1)
        sample = CpsDataset(self.folder / "gray", "train")[2]
        np.testing.assert_array_equal(sample["image"], pixels_of(3, 0, 1))
        write_dataset(self.folder / "jpeg", ending="jpg")
        export(self.folder / "jpeg", "webdataset", self.folder / "jpeg_tars")
        with Image.open(self.folder / "jpeg" / file_of(3, 0, "jpg")) as image:
            np.testing.assert_array_equal(CpsDataset(self.folder / "jpeg_tars", "train")[2]["image"], np.array(image))

    def test_sixteen_bits_are_kept_in_gray_and_refused_in_colour(self):
        stream = io.BytesIO()
        deep = np.arange(12, dtype=np.uint16).reshape(3, 4) * 5000
        Image.fromarray(deep).save(stream, "png")
        np.testing.assert_array_equal(decode_image(stream.getvalue())[:, :, 0], deep)
        self.assertEqual(decode_image(stream.getvalue()).dtype, np.uint16)
        self.assertRaisesRegex(ValueError, "16-bit colour PNG", decode_image, DEEP_COLOUR_PNG)

    def test_own_decoder_reads_what_pillow_does_not(self):
        write_dataset(self.folder / "deep")
        file = self.folder / "deep" / file_of(0, 1, "png")
        file.write_bytes(DEEP_COLOUR_PNG)
        with self.assertRaisesRegex(ValueError, "000001.png.*16-bit colour PNG"):
            CpsDataset(self.folder / "deep", "train")[0]
        data = CpsDataset(self.folder / "deep", "train", decode=lambda data: np.full((2, 2, 1), len(data), np.float32))
        self.assertEqual(data[0]["image"].max(), len(DEEP_COLOUR_PNG))

    def test_what_is_no_finished_dataset_is_named(self):
        with self.assertRaisesRegex(FileNotFoundError, "neither splits/train.txt"):
            CpsDataset(self.folder, "train")
        self.assertRaisesRegex(ValueError, "'validation' is none of", CpsDataset, self.roots[0], "validation")
        begun = self.folder / "begun"
        (begun / ".cps").mkdir(parents=True)
        (begun / ".cps" / "export.json").write_text("{}")
        self.assertRaisesRegex(ValueError, "not finished", CpsDataset, begun, "train")

    def test_labels_of_another_lens_family_are_refused_by_its_name(self):
        root = self.folder / "fisheyes"
        leaf = root / "96x54_eucm_hfov120" / "front_lens0001"
        leaf.mkdir(parents=True)
        (leaf / "calibration.json").write_text(json.dumps({"schema": 2, "model": "eucm", "params": {"alpha": 0.6}}))
        (root / "splits").mkdir()
        (root / "splits" / "train.txt").write_text("96x54_eucm_hfov120/front_lens0001/000000.png\n")
        with self.assertRaisesRegex(ValueError, "calibration.json: model: is eucm: only datasets of brown_conrady"):
            CpsDataset(root, "train").size(0)

    def test_a_tar_that_lost_samples_is_named(self):
        cut = self.folder / "cut"
        cut.mkdir()
        for file in self.roots[1].iterdir():
            (cut / file.name).write_bytes(file.read_bytes())
        (cut / "train-000000.tar").write_bytes((cut / "val-000000.tar").read_bytes())
        self.assertRaisesRegex(ValueError, "train-000000.tar: holds 2 samples", CpsDataset, cut, "train")


class Torch(Layouts):
    def loop(self):
        """The training loop of docs/guide.md."""
        blocks = re.findall(r"```python\n(.*?)```", (REPOSITORY / "docs/guide.md").read_text(), re.S)
        (loop,) = [block for block in blocks if "CpsDataset" in block and "backward" in block]
        self.assertLessEqual(len([line for line in loop.splitlines() if line.strip()]), 12)
        return loop

    def test_the_guides_loop_trains_from_each_layout(self):
        import torch

        weights = []
        for root in self.roots:
            code = self.loop()
            self.assertIn('CpsDataset("data", "train")', code)
            names = {}
            torch.set_num_threads(1)
            torch.manual_seed(1)
            exec(code.replace('CpsDataset("data"', f'CpsDataset("{root}"'), names)
            self.assertTrue(math.isfinite(names["loss"].item()))
            weights.append([p.detach() for p in names["network"].parameters()])
        for other in weights[1:]:
            for a, b in zip(weights[0], other):
                self.assertTrue(torch.equal(a, b))

    def test_batches_are_the_same_tensors_from_each_layout(self):
        import torch
        from torch.utils.data import DataLoader

        batches = []
        for root in self.roots:
            data = CpsDataset(root, "train")
            sampler = SizeBatches(data, 3, seed=2)
            batches.append(list(DataLoader(data, batch_sampler=sampler, collate_fn=collate, num_workers=2)))
        for other in batches[1:]:
            self.assertEqual(len(batches[0]), len(other))
            for a, b in zip(batches[0], other):
                self.assertEqual(a["file"], b["file"])
                self.assertEqual(a["image"].dtype, torch.float32)
                self.assertTrue(torch.equal(a["image"], b["image"]))
                self.assertTrue(torch.equal(a["label"], b["label"]))


if __name__ == "__main__":
    case = Core
    if sys.argv[3:] == ["--torch"]:
        if importlib.util.find_spec("torch") is None:
            print("NOT TESTED: tensors and the training loop: PyTorch is not installed (python3-torch)")
            sys.exit(77)
        case = Torch
    suite = unittest.defaultTestLoader.loadTestsFromTestCase(case)
    sys.exit(not unittest.TextTestRunner(verbosity=1).run(suite).wasSuccessful())
