"""EXR files, written from https://openexr.com/en/latest/OpenEXRFileLayout.html for the tests of their reader."""

import struct
import zlib

import numpy as np

TYPES = {"uint32": 0, "float16": 1, "float32": 2}


def attribute(name, kind, value):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value


def packed(raw):
    """As ZIP and ZIPS store a chunk's bytes."""
    data = np.frombuffer(raw, np.uint8)
    data = np.concatenate([data[0::2], data[1::2]]).astype(int)
    data[1:] = np.diff(data) + 128
    small = zlib.compress((data % 256).astype(np.uint8).tobytes())
    return small if len(small) < len(raw) else raw


def exr_bytes(channels, compression=3, origin=(0, 0), sampling=1, flags=0, backwards=False):
    """`channels`: arrays (height, width) by name. `backwards`: the last lines come first in the file."""
    names = sorted(channels)
    height, width = channels[names[0]].shape
    listed = b"".join(
        name.encode() + b"\0" + struct.pack("<iIii", TYPES[channels[name].dtype.name], 0, sampling, sampling)
        for name in names
    )
    window = struct.pack("<4i", *origin, origin[0] + width - 1, origin[1] + height - 1)
    header = (
        b"\x76\x2f\x31\x01"
        + struct.pack("<I", 2 | flags)
        + attribute("channels", "chlist", listed + b"\0")
        + attribute("compression", "compression", bytes([compression]))
        + attribute("dataWindow", "box2i", window)
        + attribute("displayWindow", "box2i", window)
        + attribute("lineOrder", "lineOrder", bytes([backwards]))
        + attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
        + attribute("screenWindowCenter", "v2f", bytes(8))
        + attribute("screenWindowWidth", "float", struct.pack("<f", 1))
        + b"\0"
    )
    lines = 16 if compression == 3 else 1
    chunks = []
    for begin in range(0, height, lines):
        raw = b"".join(
            channels[name][y].tobytes() for y in range(begin, min(begin + lines, height)) for name in names
        )
        data = packed(raw) if compression else raw
        chunks.append(struct.pack("<ii", origin[1] + begin, len(data)) + data)
    place, offsets = len(header) + 8 * len(chunks), [0] * len(chunks)
    stored = list(enumerate(chunks))[::-1] if backwards else list(enumerate(chunks))
    for number, chunk in stored:
        offsets[number] = place
        place += len(chunk)
    return header + struct.pack(f"<{len(chunks)}Q", *offsets) + b"".join(chunk for _, chunk in stored)
