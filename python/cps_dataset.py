"""Reads a CPS dataset, or what `cps export` makes of it, for training in Python.

    data = CpsDataset("data", "train")      # a dataset, a WebDataset export or a Hugging Face export alike
    sample = data[0]                        # {"image": …, "label": …, "file": …, "group": …}

Needs NumPy and Pillow; `collate` makes PyTorch tensors where torch is installed, else NumPy arrays. This file
needs no other: copy it beside your own code.

Images are arrays (height, width, channels), with one channel for gray ones. Supported: 8-bit PNG and JPEG
(uint8), 16-bit gray PNG (uint16), and the EXR files of a dataset (float16: linear, 1 is the sensor's white).
Refused, since Pillow cannot read it in full: 16-bit colour PNG; give `decode` a function from a file's bytes
to an array, with OpenCV or OpenImageIO in it.

A label is an array of float64 with the values that LABELS names, in that order and the units it gives. Where
`dense` names some of DENSE, a sample also has "dense", an array (height, width, channels) for each of them:

    data = CpsDataset("data", "train", dense=("depth", "semantic"))
    data[0]["dense"]["depth"]
"""

import io
import json
import struct
import tarfile
import zlib
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

# The dense labels that a dataset can have, by the recipe's key `labels`. Each pixel's values are those of the
# ray through its centre and the image's own lens. Vectors are in the camera frame (x right, y down, z
# forward), except those of `up`.
DENSE = {
    "depth": "metres along the optical axis, infinite where nothing is; 1 channel, float32",
    "distance": "metres along the ray, infinite where nothing is; 1 channel, float32",
    "normal": "unit vector of the surface, towards the camera, 0 where nothing is; 3 channels, float32",
    "instance": "1 + number of the object in the scene, 0 where nothing is; 1 channel, uint16",
    "semantic": "id of the class: `classes` of the scene in dataset.json, classes.json of an export; 1 channel, "
    "uint16",
    "rays": "unit vector of the ray; 3 channels, float32",
    "up": "unit vector in the picture (x right, y down), where the picture of a rising point goes, 0 for a "
    "vertical ray; 2 channels, float32",
    "latitude": "of the ray above the horizon, degrees; 1 channel, float32",
}
SPLITS = ("train", "val", "test")


class CpsDataset:
    """The images of one split, in the order of its list. Works as a map-style dataset of torch.utils.data.

    root       a dataset's folder, or that of `cps export --to webdataset` or `--to huggingface`
    split      train, val or test
    transform  called with each sample (a dict), returns what [] shall return
    decode     from the bytes of an image's file to an array; the default is decode_image
    dense      names of DENSE: the dense labels to read with each image
    """

    def __init__(self, root, split, transform=None, decode=None, dense=()):
        self.root, self.split, self.dense = Path(root), split, tuple(dense)
        if split not in SPLITS:
            raise ValueError(f"split {split!r} is none of {', '.join(SPLITS)}")
        for name in self.dense:
            if name not in DENSE:
                raise ValueError(f"dense label {name!r} is none of {', '.join(DENSE)}")
        self.transform, self.decode = transform, decode or decode_image
        self._source = _open(self.root, split, self.dense)

    def __len__(self):
        return len(self._source)

    def __getitem__(self, index):
        if not -len(self) <= index < len(self):
            raise IndexError(index)
        index %= len(self)
        data, record = self._source[index]
        name = f"{self.root}: {record['file']}"
        image = _decoded(self.decode, data, name)
        sample = {"image": image, "label": label_of(record), "file": record["file"], "group": record["group"]}
        if self.dense:
            sample["dense"] = {
                label: _decoded(decode_image, self._source.dense(index, label), f"{name}: {label}")
                for label in self.dense
            }
        return self.transform(sample) if self.transform else sample

    def size(self, index):
        """(width, height) of an image in pixels, from its label."""
        record = self._source.record(index)
        return record["width"], record["height"]


def label_of(record):
    """The values of LABELS as an array, from a dict that has them."""
    return np.array([record[name] for name in LABELS], np.float64)


def _decoded(decode, data, name):
    try:
        return decode(data)
    except Exception as error:
        raise ValueError(f"{name}: {error}") from error


def decode_image(data):
    """The pixels in the bytes of a PNG, JPEG or EXR file: (height, width, channels); uint8, uint16, or what
    decode_exr gives."""
    if data[:4] == _EXR_MAGIC:
        return decode_exr(data)
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
    dense  where the samples have it, for each name (batch, channels, height, width): float32, or int64 for
           instance and semantic, as torch's losses and indices must be

    All but the names are tensors if torch is installed, else arrays.
    """
    shapes = {sample["image"].shape for sample in samples}
    if len(shapes) != 1:
        raise ValueError(f"images of one batch must have one size, not {sorted(shapes)}: use SizeBatches")
    images = np.stack([sample["image"] for sample in samples])
    scale = 1 / np.iinfo(images.dtype).max if _is_integer(images) else 1
    images = _channels_first(images, np.float32) * np.float32(scale)
    labels = np.stack([sample["label"] for sample in samples]).astype(np.float32)
    try:
        from torch import from_numpy  # only here: it takes seconds to load
    except ImportError:
        from_numpy = np.asarray
    batch = {
        "image": from_numpy(images),
        "label": from_numpy(labels),
        "file": [sample["file"] for sample in samples],
        "group": [sample["group"] for sample in samples],
    }
    if "dense" in samples[0]:
        batch["dense"] = {}
        for name in samples[0]["dense"]:
            values = np.stack([sample["dense"][name] for sample in samples])
            values = _channels_first(values, np.int64 if _is_integer(values) else np.float32)
            batch["dense"][name] = from_numpy(values)
    return batch


def _is_integer(array):
    return np.issubdtype(array.dtype, np.integer)


def _channels_first(pixels, dtype):
    return np.ascontiguousarray(pixels.transpose(0, 3, 1, 2), dtype)


# Where samples come from. Each source has a length, record(i), a dict with file, group, width, height and the
# values of LABELS; [i], the bytes of an image's file with its record; and dense(i, label), those of the file of
# a dense label.


def _dense_ending(label):
    return f"{label}.png" if label in ("instance", "semantic") else f"{label}.exr"


def _dense_bytes(image, label):
    """`image`: the path that the file would have if it were the image's."""
    file = image.with_suffix("." + _dense_ending(label))
    if not file.exists():
        raise _missing(file, label)
    return file.read_bytes()


def _missing(name, label):
    return ValueError(f"{name}: is missing: make the dataset with {label} among the recipe's `labels`")


def _open(root, split, dense):
    if (root / ".cps" / "export.json").exists():
        raise ValueError(f"{root}: the export is not finished; run cps export again")
    if (root / "splits" / f"{split}.txt").exists():
        return _Folder(root, split)
    if (root / f"{split}-index.json").exists():
        return _Tars(root, split, dense)
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
            calibration = self.root / group / "calibration.json"
            label = json.loads(calibration.read_text(encoding="utf-8"))
            if "params" in label:
                raise ValueError(
                    f"{calibration}: model: is {label.get('model')}: only datasets of brown_conrady lenses "
                    "are read here; read its model, params and K yourself"
                )
            self.labels[group] = {**label, "fx": label["K"][0][0], "fy": label["K"][1][1], "group": group}
        return {**self.labels[group], "file": file}

    def __getitem__(self, index):
        return (self.root / self.files[index]).read_bytes(), self.record(index)

    def dense(self, index, label):
        return _dense_bytes(self.root / self.files[index], label)


class _Tars:
    """Reads samples at their places in the tars, so that any order is as good as theirs."""

    def __init__(self, root, split, dense):
        self.tars, self.labels, places = [], dense, []
        for shard in json.loads((root / f"{split}-index.json").read_text(encoding="utf-8"))["shardlist"]:
            before = len(places)
            places += _places_in(root / shard["url"], len(self.tars), dense)
            self.tars.append(root / shard["url"])
            if len(places) - before != shard["nsamples"]:
                raise ValueError(
                    f"{self.tars[-1]}: holds {len(places) - before} samples; "
                    f"the index says {shard['nsamples']}"
                )
        self.places = np.array(places, np.int64).reshape(-1, 5 + 2 * len(dense))

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

    def dense(self, index, label):
        column = 2 + self.labels.index(label)
        if self.places[index, 1 + 2 * column] < 0:
            sample = f"{self.tars[self.places[index, 0]]}: {self.record(index)['file']}"
            raise _missing(f"{sample}: {_dense_ending(label)}", label)
        (data,) = self._read(index, column)
        return data


def _places_in(tar, number, dense):
    """(number, image's offset and size, label's offset and size, those of each dense label) of each sample. Of
    a dense label that is missing the offset is -1."""
    with tarfile.open(tar, "r:") as members:
        samples = {}
        while (member := members.next()) is not None:
            members.members = []  # or tarfile keeps every header
            name, _, ending = member.name.partition(".")
            # The image's ending is the only one, except json, without a second point.
            kind = ending if ending == "json" or "." in ending else "image"
            samples.setdefault(name, {})[kind] = (member.offset_data, member.size)
    for name, files in samples.items():
        if not {"image", "json"} <= set(files):
            raise ValueError(f"{tar}: {name}: needs an image and a .json, has {', '.join(files)}")
    kinds = ["image", "json", *map(_dense_ending, dense)]
    return [(number, *(n for kind in kinds for n in files.get(kind, (-1, 0)))) for files in samples.values()]


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

    def dense(self, index, label):
        folder = self.folder.parent / "dense" / self.folder.name
        return _dense_bytes(folder / self.record(index)["file_name"], label)


# EXR files.

_EXR_MAGIC = b"\x76\x2f\x31\x01"
_EXR_TYPES = {0: np.dtype("<u4"), 1: np.dtype("<f2"), 2: np.dtype("<f4")}
_EXR_LINES = {0: 1, 2: 1, 3: 16}  # lines of a chunk, by compression: none, ZIPS, ZIP


def decode_exr(data):
    """The pixels in the bytes of an EXR file such as a dataset has: (height, width, channels); float32,
    float16 or uint32, as stored. Channels R, G, B are in this order, others in that of their names: X, Y, Z.

    The file has one part of scanlines, with compression none, ZIPS or ZIP and channels of one type. Others
    are refused. The format: https://openexr.com/en/latest/OpenEXRFileLayout.html
    """
    if data[:4] != _EXR_MAGIC:
        raise ValueError("is no EXR file")
    try:
        header, place = _exr_header(data)
        channels = _exr_channels(header["channels"])
        refusal = _exr_refusal(header, channels)
        pixels = None if refusal else _exr_pixels(data, place, header, channels)
    except (struct.error, zlib.error, ValueError, IndexError, KeyError, MemoryError) as error:
        raise ValueError(f"is a damaged EXR file ({error})") from error
    if refusal:
        raise ValueError(f"is an EXR file with {refusal}, which is not read here")
    names = [name for name, _, _ in channels]
    order = [names.index(name) for name in "RGBA" if name in names]
    order += [i for i in range(len(names)) if i not in order]
    return np.ascontiguousarray(pixels[:, order].transpose(0, 2, 1))


def _exr_header(data):
    """Its attributes as bytes by name, the version's number, and where what follows begins."""
    header, place = {"version": struct.unpack_from("<I", data, 4)[0]}, 8
    while data[place]:
        name, place = _exr_text(data, place)
        _, place = _exr_text(data, place)  # type
        begin = place + 4
        place = begin + struct.unpack_from("<I", data, place)[0]
        header[name] = data[begin:place]
    return header, place + 1


def _exr_text(data, place):
    """The text that ends with the next zero, and where what follows begins."""
    end = data.index(0, place)
    return data[place:end].decode(), end + 1


def _exr_channels(data):
    """Name, number of the type and sampling in x and y of each channel, in the file's order."""
    channels, place = [], 0
    while data[place]:
        name, place = _exr_text(data, place)
        kind, _, *sampling = struct.unpack_from("<iIii", data, place)
        channels.append((name, kind, sampling))
        place += 16
    return channels


def _exr_refusal(header, channels):
    """What of the file is not read here; empty if all is."""
    if header["version"] & 0x1A00:
        return "tiles, deep pixels or several parts"
    if header["compression"][0] not in _EXR_LINES:
        return "another compression than none, ZIPS and ZIP"
    if any(sampling != [1, 1] for _, _, sampling in channels):
        return "subsampled channels"
    if len({kind for _, kind, _ in channels}) != 1:
        return "channels of several types"
    return ""


def _exr_pixels(data, place, header, channels):
    """(height, channels, width), from the table of offsets at that place on."""
    x0, y0, x1, y1 = struct.unpack("<4i", header["dataWindow"])
    lines = _EXR_LINES[header["compression"][0]]
    pixels = np.empty((y1 - y0 + 1, len(channels), x1 - x0 + 1), _EXR_TYPES[channels[0][1]])
    starts = range(0, len(pixels), lines)
    for start, offset in zip(starts, struct.unpack_from(f"<{len(starts)}Q", data, place)):
        y, size = struct.unpack_from("<iI", data, offset)
        if y != y0 + start:
            raise ValueError("a chunk of lines is in another's place")
        rows = pixels[start : start + lines]
        unpacked = _exr_unpacked(data[offset + 8 : offset + 8 + size], rows.nbytes)
        rows[:] = unpacked.view(rows.dtype).reshape(rows.shape)
    return pixels


def _exr_unpacked(packed, size):
    """A chunk's bytes. Each was stored as its difference from the one before, plus 128, and those at even
    places before those at odd ones; unless that did not make them fewer."""
    if len(packed) == size:
        return np.frombuffer(packed, np.uint8)
    stored = np.frombuffer(zlib.decompress(packed), np.uint8).copy()
    stored[1:] -= 128
    stored = np.cumsum(stored, dtype=np.uint8)
    unpacked, half = np.empty_like(stored), (len(stored) + 1) // 2
    unpacked[0::2], unpacked[1::2] = stored[:half], stored[half:]
    return unpacked
