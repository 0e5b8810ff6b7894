"""Reads a CPS dataset, or what `cps export` makes of it, for training in Python.

    data = CpsDataset("data", "train")      # a dataset, a WebDataset export or a Hugging Face export alike
    sample = data[0]                        # {"image": …, "label": …, "file": …, "group": …}

Needs NumPy and Pillow; `collate` makes PyTorch tensors where torch is installed, else NumPy arrays. This file
needs no other: copy it beside your own code.

Images are arrays (height, width, channels), with one channel for gray ones. Supported: 8-bit PNG and JPEG
(uint8), and 16-bit gray PNG (uint16). Refused, since Pillow cannot read them in full: EXR and 16-bit colour
PNG; give `decode` a function from a file's bytes to an array, with OpenCV or OpenImageIO in it.

A label is an array of float64 with the values that LABELS names, in that order and the units it gives.
"""

import io
import json
import tarfile
from pathlib import Path

import numpy as np
from PIL import Image

# The names in calibration.json. Distortion runs from ideal to distorted with OpenCV's order and signs, on the
# plane z = 1; pixels count from the centre of the top-left one, which is (0, 0).
LABELS = {
    "fov": "horizontal field of view, 2 atan(width / 2 fx), degrees",
    "k1": "radial distortion, r^2",
    "k2": "radial distortion, r^4",
    "k3": "radial distortion, r^6",
    "p1": "tangential distortion",
    "p2": "tangential distortion",
    "cx": "principal point, pixels",
    "cy": "principal point, pixels",
    "fx": "focal length, pixels",
    "fy": "focal length, pixels",
}
SPLITS = ("train", "val", "test")


class CpsDataset:
    """The images of one split, in the order of its list. Works as a map-style dataset of torch.utils.data.

    root       a dataset's folder, or that of `cps export --to webdataset` or `--to huggingface`
    split      train, val or test
    transform  called with each sample (a dict), returns what [] shall return
    decode     from the bytes of an image's file to an array; the default is decode_image
    """

    def __init__(self, root, split, transform=None, decode=None):
        self.root, self.split = Path(root), split
        if split not in SPLITS:
            raise ValueError(f"split {split!r} is none of {', '.join(SPLITS)}")
        self.transform, self.decode = transform, decode or decode_image
        self._source = _open(self.root, split)

    def __len__(self):
        return len(self._source)

    def __getitem__(self, index):
        if not -len(self) <= index < len(self):
            raise IndexError(index)
        data, record = self._source[index % len(self)]
        try:
            image = self.decode(data)
        except Exception as error:
            raise ValueError(f"{self.root}: {record['file']}: {error}") from error
        sample = {"image": image, "label": label_of(record), "file": record["file"], "group": record["group"]}
        return self.transform(sample) if self.transform else sample

    def size(self, index):
        """(width, height) of an image in pixels, from its label."""
        record = self._source.record(index)
        return record["width"], record["height"]


def label_of(record):
    """The values of LABELS as an array, from a dict that has them."""
    return np.array([record[name] for name in LABELS], np.float64)


def decode_image(data):
    """The pixels in the bytes of a PNG or JPEG file: (height, width, channels), uint8 or uint16."""
    if data[:4] == b"\x76\x2f\x31\x01":
        raise ValueError("is an EXR file, which Pillow cannot read: give CpsDataset a decode function")
    if data[:8] == b"\x89PNG\r\n\x1a\n" and data[24] == 16 and data[25] != 0:  # IHDR: bit depth, colour type
        raise ValueError("is a 16-bit colour PNG, of which Pillow keeps 8: give CpsDataset a decode function")
    with Image.open(io.BytesIO(data)) as image:
        if image.mode in ("I", "I;16"):
            return np.asarray(image).astype(np.uint16)[:, :, None]
        if image.mode == "L":
            return np.array(image)[:, :, None]
        return np.array(image.convert("RGB"))


class SizeBatches:
    """Batches of indices whose images have one size: a `batch_sampler` of torch.utils.data.DataLoader.

    With a seed, every pass has another order, which seed and number of the pass decide; without one, the
    order is that of the list. The last batch of a size may be smaller.
    """

    def __init__(self, dataset, batch_size, seed=None):
        self.batch_size, self.seed, self.epoch = batch_size, seed, 0
        sizes = {}
        for index in range(len(dataset)):
            sizes.setdefault(dataset.size(index), []).append(index)
        self._indices = [np.array(indices) for indices in sizes.values()]

    def __len__(self):
        return sum(-(-len(indices) // self.batch_size) for indices in self._indices)

    def __iter__(self):
        random = None if self.seed is None else np.random.default_rng((self.seed, self.epoch))
        self.epoch += 1
        batches = []
        for indices in self._indices:
            order = indices if random is None else random.permutation(indices)
            batches += [order[i : i + self.batch_size] for i in range(0, len(order), self.batch_size)]
        if random is not None:
            random.shuffle(batches)
        return iter([batch.tolist() for batch in batches])


def collate(samples):
    """One batch of samples whose images have one size (see SizeBatches): a dict with

    image  (batch, channels, height, width), float32; integers become shares of the largest, 0 to 1
    label  (batch, len(LABELS)), float32
    file, group   lists of names

    The first two are tensors if torch is installed, else arrays.
    """
    shapes = {sample["image"].shape for sample in samples}
    if len(shapes) != 1:
        raise ValueError(f"images of one batch must have one size, not {sorted(shapes)}: use SizeBatches")
    images = np.stack([sample["image"] for sample in samples])
    scale = 1 / np.iinfo(images.dtype).max if np.issubdtype(images.dtype, np.integer) else 1
    images = np.ascontiguousarray(images.transpose(0, 3, 1, 2), np.float32) * np.float32(scale)
    labels = np.stack([sample["label"] for sample in samples]).astype(np.float32)
    try:
        from torch import from_numpy  # only here: it takes seconds to load
    except ImportError:
        from_numpy = np.asarray
    return {
        "image": from_numpy(images),
        "label": from_numpy(labels),
        "file": [sample["file"] for sample in samples],
        "group": [sample["group"] for sample in samples],
    }


# Where samples come from. Each source has a length, record(i), a dict with file, group, width, height and the
# values of LABELS, and [i], the bytes of an image's file with its record.


def _open(root, split):
    if (root / ".cps" / "export.json").exists():
        raise ValueError(f"{root}: the export is not finished; run cps export again")
    if (root / "splits" / f"{split}.txt").exists():
        return _Folder(root, split)
    if (root / f"{split}-index.json").exists():
        return _Tars(root, split)
    if any(root.glob("*/metadata.jsonl")):
        return _HuggingFace(root, split)
    raise FileNotFoundError(
        f"{root}: has neither splits/{split}.txt (a finished dataset) nor {split}-index.json (webdataset) "
        "nor */metadata.jsonl (huggingface)"
    )


class _Folder:
    def __init__(self, root, split):
        self.root = root
        self.files = (root / "splits" / f"{split}.txt").read_text(encoding="utf-8").splitlines()
        self.labels = {}  # by group

    def __len__(self):
        return len(self.files)

    def record(self, index):
        file = self.files[index]
        group = file.rpartition("/")[0]
        if group not in self.labels:
            label = json.loads((self.root / group / "calibration.json").read_text(encoding="utf-8"))
            self.labels[group] = {**label, "fx": label["K"][0][0], "fy": label["K"][1][1], "group": group}
        return {**self.labels[group], "file": file}

    def __getitem__(self, index):
        return (self.root / self.files[index]).read_bytes(), self.record(index)


class _Tars:
    """Reads samples at their places in the tars, so that any order is as good as theirs."""

    def __init__(self, root, split):
        self.tars, places = [], []
        for shard in json.loads((root / f"{split}-index.json").read_text(encoding="utf-8"))["shardlist"]:
            before = len(places)
            places += _places_in(root / shard["url"], len(self.tars))
            self.tars.append(root / shard["url"])
            if len(places) - before != shard["nsamples"]:
                raise ValueError(
                    f"{self.tars[-1]}: holds {len(places) - before} samples; "
                    f"the index says {shard['nsamples']}"
                )
        self.places = np.array(places, np.int64).reshape(-1, 5)

    def __len__(self):
        return len(self.places)

    def _read(self, index, *which):
        tar, *places = self.places[index].tolist()
        with open(self.tars[tar], "rb") as file:
            for place in which:
                file.seek(places[2 * place])
                yield file.read(places[2 * place + 1])

    def record(self, index):
        (label,) = self._read(index, 1)
        return json.loads(label)

    def __getitem__(self, index):
        image, label = self._read(index, 0, 1)
        return image, json.loads(label)


def _places_in(tar, number):
    """(number, image's offset and size, label's offset and size) of each sample."""
    with tarfile.open(tar, "r:") as members:
        samples = {}
        while (member := members.next()) is not None:
            members.members = []  # or tarfile keeps every header
            name, _, ending = member.name.partition(".")
            samples.setdefault(name, {})["json" if ending == "json" else "image"] = (
                member.offset_data,
                member.size,
            )
    for name, files in samples.items():
        if set(files) != {"image", "json"}:
            raise ValueError(f"{tar}: {name}: needs an image and a .json, has {', '.join(files)}")
    return [(number, *files["image"], *files["json"]) for files in samples.values()]


class _HuggingFace:
    def __init__(self, root, split):
        self.folder = root / split
        self.metadata, self.lines, end = self.folder / "metadata.jsonl", [], 0
        if not self.metadata.exists():  # a split without images has no folder
            return
        with open(self.metadata, "rb") as file:
            for line in file:
                self.lines.append(end)
                end += len(line)

    def __len__(self):
        return len(self.lines)

    def record(self, index):
        with open(self.metadata, "rb") as file:
            file.seek(self.lines[index])
            return json.loads(file.readline())

    def __getitem__(self, index):
        record = self.record(index)
        return (self.folder / record["file_name"]).read_bytes(), record
