#!/usr/bin/python3
"""Tests how python/cps_dataset.py reads EXR files and dense labels.

    test_dense_labels.py CPS REPOSITORY

CPS is the program. EXR files are compared with what OpenImageIO's oiiotool reads in them, and with numbers that
are put into them here; the labels of a dataset with its calibrations, by formulas that are written out here.
"""

import csv
import io
import json
import subprocess
import tarfile
import tempfile
import unittest
from pathlib import Path

import numpy as np
from exr_file import exr_bytes
from PIL import Image
from street import write_street
from test_cps_dataset import CPS, GROUPS, IMAGES, CpsDataset, calibration, collate, decode_image, file_of, write_dataset

from cps_dataset import DENSE, decode_exr  # from where test_cps_dataset has found it

IDS = ("instance", "semantic")
CHANNELS = {"normal": "XYZ", "rays": "XYZ", "up": "XY", "depth": "Z", "distance": "Y", "latitude": "Y"}


def run(*command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(done.stdout + done.stderr)


class Temporary(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)


def noise(kind, shape, seed=0):
    random = np.random.default_rng(seed)
    if kind == np.uint32:
        return random.integers(0, 2**32, shape, np.uint32)
    return random.normal(0, 100, shape).astype(kind)


class Exr(Temporary):
    def test_oiiotools_files_give_what_oiiotool_reads_in_them(self):
        for names, kind, compression in [
            ("X,Y,Z", "float", "zip"),
            ("R,G,B", "half", "zip"),
            ("R,G,B,A", "float", "zips"),
            ("X,Y", "float", "none"),
            ("Z", "float", "zip"),
        ]:
            with self.subTest(names=names, kind=kind, compression=compression):
                exr, tif, channels = self.folder / "a.exr", self.folder / "a.tif", names.split(",")
                noise_of = "noise:type=gaussian:mean=0:stddev=10:mono=0:seed=7"
                run("oiiotool", "--pattern", noise_of, "53x37", str(len(channels)), "--chnames", names,
                    "-d", kind, "--compression", compression, "-o", exr)  # fmt: skip
                pixels = decode_exr(exr.read_bytes())
                self.assertEqual(pixels.shape, (37, 53, len(channels)))
                self.assertEqual(pixels.dtype, {"half": np.float16, "float": np.float32}[kind])
                self.assertGreater(pixels.astype(np.float32).std(), 5)
                for i, channel in enumerate(channels):
                    run("oiiotool", exr, "--ch", channel, "-d", "float", "-o", tif)
                    with Image.open(tif) as image:
                        np.testing.assert_array_equal(pixels[:, :, i].astype(np.float32), np.array(image))

    def test_every_kind_of_file_gives_back_the_numbers_put_into_it(self):
        for kind in (np.float32, np.float16, np.uint32):
            for compression in (0, 2, 3):
                for shape in [(1, 1), (16, 3), (37, 21)]:
                    for options in ({}, {"origin": (-5, 9)}, {"backwards": True}):
                        with self.subTest(kind=kind, compression=compression, shape=shape, options=options):
                            values = {name: noise(kind, shape, ord(name)) for name in "ZXY"}
                            pixels = decode_exr(exr_bytes(values, compression, **options))
                            self.assertEqual(pixels.dtype, kind)
                            np.testing.assert_array_equal(pixels, np.stack([values[c] for c in "XYZ"], -1))

    def test_numbers_of_every_size_and_lines_that_shrink_are_kept(self):
        values = np.zeros((20, 30), np.float32)  # shrinks; the noise above does not
        values[3, :6] = [np.inf, -np.inf, -0.0, 1e-45, 3.4e38, 65536]
        pixels = decode_exr(exr_bytes({"Z": values}))
        np.testing.assert_array_equal(pixels[:, :, 0].view(np.uint32), values.view(np.uint32))

    def test_colours_come_in_their_order(self):
        values = {name: noise(np.float16, (5, 4), ord(name)) for name in "RGBA"}
        pixels = decode_image(exr_bytes(values))
        np.testing.assert_array_equal(pixels, np.stack([values[c] for c in "RGBA"], -1))

    def test_other_files_are_refused_in_one_line(self):
        values = {"Z": noise(np.float32, (20, 30))}
        good = exr_bytes(values)
        for data, expected in [
            (exr_bytes(values, compression=4), "another compression than none, ZIPS and ZIP"),
            (exr_bytes(values, sampling=2), "subsampled"),
            (exr_bytes(values, flags=0x200), "tiles"),
            (exr_bytes(values, flags=0x800), "deep"),
            (exr_bytes(values, flags=0x1000), "several parts"),
            (exr_bytes({**values, "Y": noise(np.float16, (20, 30))}), "several types"),
            (good[:-1], "damaged"),
            (good[:-1000], "damaged"),
            (good[:200], "damaged"),
            (good[:8], "damaged"),
            (good.replace(b"dataWindow", b"dateWindow"), "damaged"),
            (good[:4], "damaged"),
            (b"P6 2 2 255 ", "no EXR"),
        ]:
            with self.subTest(expected=expected), self.assertRaises(ValueError) as raised:
                decode_exr(data)
            self.assertIn(expected, str(raised.exception))
            self.assertNotIn("\n", str(raised.exception))


def dense_name(image, label):
    return str(Path(image).with_suffix(f".{label}.{'png' if label in IDS else 'exr'}"))


def dense_of(group, number, label):
    """Its array, and its file's bytes."""
    _, _, width, height, *_ = GROUPS[group]
    if label in IDS:
        ids = np.random.default_rng((group, number)).integers(0, 65536, (height, width), np.uint16)
        stream = io.BytesIO()
        Image.fromarray(ids).save(stream, "png")
        return ids[:, :, None], stream.getvalue()
    values = {c: noise(np.float32, (height, width), (group, number, ord(c))) for c in CHANNELS[label]}
    return np.stack([values[c] for c in CHANNELS[label]], -1), exr_bytes(values)


def add_dense(root, part, labels):
    for group, number in IMAGES[part]:
        for label in labels:
            image = file_of(group, number, "png")
            (root / dense_name(image, label)).write_bytes(dense_of(group, number, label)[1])


def write_tars(root, folder, part, labels):
    """What docs/formats.md says of webdataset, two samples a tar."""
    folder.mkdir(exist_ok=True)
    shards = []
    for begin in range(0, len(IMAGES[part]), 2):
        images = IMAGES[part][begin : begin + 2]
        shards.append({"url": f"{part}-{begin // 2:06}.tar", "nsamples": len(images)})
        with tarfile.open(folder / shards[-1]["url"], "w", format=tarfile.USTAR_FORMAT) as tar:
            for i, (group, number) in enumerate(images):
                image, label = file_of(group, number, "png"), calibration(group)
                focal = {"fx": label["K"][0][0], "fy": label["K"][1][1]}
                record = {**label, **focal, "file": image, "group": GROUPS[group][0]}
                members = [("png", (root / image).read_bytes())]
                members += [(dense_name("x.png", name)[2:], dense_of(group, number, name)[1]) for name in labels]
                for ending, data in [*members, ("json", json.dumps(record).encode())]:
                    header = tarfile.TarInfo(f"{begin + i:09}.{ending}")
                    header.size = len(data)
                    tar.addfile(header, io.BytesIO(data))
    (folder / f"{part}-index.json").write_text(json.dumps({"shardlist": shards}))


class Reader(Temporary):
    def setUp(self):
        super().setUp()
        self.root, self.tars = self.folder / "data", self.folder / "tars"
        write_dataset(self.root)
        self.labels = ("depth", "normal", "up", "instance", "semantic")
        add_dense(self.root, "train", self.labels)
        write_tars(self.root, self.tars, "train", self.labels)

    def test_folders_and_tars_give_every_label_of_every_image(self):
        for root in (self.root, self.tars):
            data = CpsDataset(root, "train", dense=self.labels[::-1])
            self.assertEqual(len(data), len(IMAGES["train"]))
            for index, (group, number) in enumerate(IMAGES["train"]):
                sample = data[index]
                self.assertEqual(sample["file"], file_of(group, number, "png"))
                self.assertEqual(sample["image"].shape[2], 3)
                self.assertEqual(set(sample["dense"]), set(self.labels))
                for label in self.labels:
                    wanted = dense_of(group, number, label)[0]
                    np.testing.assert_array_equal(sample["dense"][label], wanted)
                    self.assertEqual(sample["dense"][label].dtype, wanted.dtype)

    def test_labels_that_are_not_asked_for_are_left_alone(self):
        for root in (self.root, self.tars):
            self.assertEqual(set(CpsDataset(root, "train")[0]), {"image", "label", "file", "group"})
            self.assertEqual(list(CpsDataset(root, "train", dense=["up"])[-1]["dense"]), ["up"])

    def test_batches_have_channels_first_and_ids_as_int64(self):
        data = CpsDataset(self.root, "train", dense=self.labels)
        same_size = [0, 1, 3]
        batch = collate([data[i] for i in same_size])
        for label in self.labels:
            stacked = np.asarray(batch["dense"][label])
            self.assertEqual(stacked.dtype, np.int64 if label in IDS else np.float32)
            for place, i in enumerate(same_size):
                np.testing.assert_array_equal(stacked[place].transpose(1, 2, 0), data[i]["dense"][label])
        self.assertEqual(np.asarray(batch["dense"]["normal"]).shape, (3, 3, 54, 96))
        self.assertNotIn("dense", collate([CpsDataset(self.root, "train")[0]]))

    def test_a_missing_label_is_named_with_the_fix(self):
        fix = "is missing: make the dataset with depth among the recipe's `labels`"
        write_tars(self.root, self.folder / "bare", "train", ())
        (self.root / dense_name(file_of(1, 1, "png"), "depth")).unlink()
        for root, named in [("data", "000001.depth.exr"), ("bare", "train-000000.tar: .*: depth.exr")]:
            data = CpsDataset(self.folder / root, "train", dense=["depth"])
            with self.assertRaisesRegex(ValueError, f"{named}: {fix}"):
                data[1]
        with self.assertRaisesRegex(ValueError, "'deep' is none of depth, distance, .*, latitude"):
            CpsDataset(self.root, "train", dense=["deep"])

    def test_a_damaged_label_is_named(self):
        file = self.root / dense_name(file_of(0, 1, "png"), "depth")
        file.write_bytes(file.read_bytes()[:-9])
        with self.assertRaisesRegex(ValueError, "000001.png: depth: is a damaged EXR"):
            CpsDataset(self.root, "train", dense=["depth"])[0]


def distorted(label, x, y):
    """Pixels of points on the plane z = 1, by docs/formats.md."""
    k1, k2, k3, p1, p2, cx, cy, fx, fy = label[1:]
    r2 = x * x + y * y
    radial = 1 + k1 * r2 + k2 * r2**2 + k3 * r2**3
    return np.stack([
        fx * (x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x)) + cx,
        fy * (y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y) + cy,
    ], -1)  # fmt: skip


class Generated(unittest.TestCase):
    """What cps generate writes, from the dataset's folder and from both exports."""

    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = Path(temporary.name)
        cls.data = cls.folder / "data"
        run(CPS, "generate", "--name", "t", "--seed", "3", "--scene", write_street(cls.folder), "--size", "80x45",
            "--base_hfov_deg", "90", "--views", "5", "--lenses", "1", "--samples", "2", "--image_format", "exr",
            "--mount_error_deg", "3", "--labels", ",".join(DENSE), "--out", cls.data)  # fmt: skip
        run(CPS, "export", cls.data, "--to", "webdataset", "-o", cls.folder / "tars")
        run(CPS, "export", cls.data, "--to", "huggingface", "-o", cls.folder / "hub", "--license", "cc0-1.0")

    def samples(self, root):
        parts = [CpsDataset(self.folder / root, part, dense=DENSE) for part in ("train", "val", "test")]
        return [sample for part in parts for sample in part]

    def test_the_layouts_agree_to_the_last_bit(self):
        folder = self.samples("data")
        self.assertEqual(len(folder), 10)
        for other in ("tars", "hub"):
            for a, b in zip(folder, self.samples(other), strict=True):
                self.assertEqual(a["file"], b["file"])
                np.testing.assert_array_equal(a["image"], b["image"])
                for label in DENSE:
                    np.testing.assert_array_equal(a["dense"][label], b["dense"][label])

    def test_exr_images_are_read_as_oiiotool_reads_them(self):
        sample = self.samples("data")[0]
        self.assertEqual((sample["image"].shape, sample["image"].dtype), ((45, 80, 3), np.float16))
        self.assertGreater(sample["image"].std(), 0)
        for i, channel in enumerate("RGB"):
            tif = self.folder / "channel.tif"
            run("oiiotool", self.data / sample["file"], "--ch", channel, "-d", "float", "-o", tif)
            with Image.open(tif) as image:
                np.testing.assert_array_equal(sample["image"][:, :, i].astype(np.float32), np.array(image))

    def test_channels_and_types_are_those_of_the_documentation(self):
        for label, values in self.samples("data")[-1]["dense"].items():
            self.assertEqual(values.shape, (45, 80, len(CHANNELS.get(label, "Y"))))
            self.assertEqual(values.dtype, np.uint16 if label in IDS else np.float32)

    def test_labels_agree_with_calibration_pose_and_each_other(self):
        gravities = {}
        for table in self.data.glob("*/*/frames.csv"):
            with open(table, newline="", encoding="utf-8") as file:
                for row in csv.DictReader(file):
                    name = (table.parent / row["file"]).relative_to(self.data).as_posix()
                    gravities[name] = np.array([float(row[f"gravity_{axis}"]) for axis in "xyz"])
        xs, ys = np.meshgrid(np.arange(80), np.arange(45))
        hits = 0
        for sample in self.samples("data"):
            dense = {label: values.astype(float) for label, values in sample["dense"].items()}
            rays, gravity = dense["rays"], gravities[sample["file"]]
            on_plane = rays[:, :, :2] / rays[:, :, 2:]

            def picture(x, y):
                return distorted(sample["label"], x, y)

            # Floats leave some 1e-7 of a ray; focal lengths are some 50 pixels.
            pixels = picture(on_plane[:, :, 0], on_plane[:, :, 1])
            np.testing.assert_allclose(pixels, np.stack([xs, ys], -1), atol=5e-5)
            latitude = np.degrees(np.arcsin(-rays @ gravity))
            np.testing.assert_allclose(dense["latitude"][:, :, 0], latitude, atol=2e-5)
            # Where a point 1 m away goes when it rises by 0.1 mm.
            ends = [rays + step * gravity for step in (-1e-4, 1e-4)]
            up = np.subtract(*(picture(end[:, :, 0] / end[:, :, 2], end[:, :, 1] / end[:, :, 2]) for end in ends))
            np.testing.assert_allclose(dense["up"], up / np.linalg.norm(up, axis=-1, keepdims=True), atol=1e-6)

            depth, distance, normal = dense["depth"], dense["distance"], dense["normal"]
            hit = np.isfinite(depth)
            hits += hit.mean()
            np.testing.assert_array_equal(hit, np.isfinite(distance))
            np.testing.assert_array_equal(hit, dense["instance"] > 0)
            np.testing.assert_allclose(depth[hit], (distance * rays[:, :, 2:])[hit], rtol=1e-6)
            np.testing.assert_array_equal(np.linalg.norm(normal, axis=-1) > 0.5, hit[:, :, 0])
            facing = (normal * rays).sum(-1, keepdims=True)[hit]
            self.assertLess(facing.max(), 1e-6)
        self.assertTrue(0 < hits < 10)  # neither nothing nor no sky in ten images

    def test_semantic_ids_are_classes_of_the_scene(self):
        (scene,) = json.loads((self.data / "dataset.json").read_text())["scenes"]
        ids = {entry["id"] for entry in scene["classes"]}
        found = {int(i) for sample in self.samples("data") for i in np.unique(sample["dense"]["semantic"])}
        self.assertGreaterEqual(len(found), 2)
        self.assertLessEqual(found, ids | {0})


if __name__ == "__main__":
    suite = unittest.TestSuite(map(unittest.defaultTestLoader.loadTestsFromTestCase, (Exr, Reader, Generated)))
    raise SystemExit(not unittest.TextTestRunner(verbosity=1).run(suite).wasSuccessful())
