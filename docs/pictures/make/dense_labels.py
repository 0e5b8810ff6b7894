"""Draws docs/pictures/dense_labels.jpg: an image and its dense labels, side by side.

    cps city --seed 1 -o city.glb
    cps generate --recipe demo --scene city.glb --size 480x270 --views 3 --base_hfov_deg 90 --lenses 1 --samples 8 \
        --labels depth,normal,instance,semantic,up,latitude --out data
    python3 dense_labels.py data 480x270_hfov090/front_lens0001/000000.png dense_labels.jpg
"""

import sys
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "python"))
from cps_dataset import SPLITS, CpsDataset  # noqa: E402

LABELS = ("depth", "normal", "instance", "semantic", "up", "latitude")
# Of Cityscapes' own palette.
CLASS_COLORS = {
    6: (81, 0, 81), 7: (128, 64, 128), 8: (244, 35, 232), 11: (70, 70, 70), 12: (102, 102, 156), 13: (190, 153, 153),
    17: (153, 153, 153), 19: (250, 170, 30), 20: (220, 220, 0), 21: (107, 142, 35), 22: (152, 251, 152),
    23: (70, 130, 180), 24: (220, 20, 60), 25: (255, 0, 0), 26: (0, 0, 142), 27: (0, 0, 70), 28: (0, 60, 100),
    32: (0, 0, 230), 33: (119, 11, 32),
}  # fmt: skip


def find(root, file):
    for split in SPLITS:
        for sample in CpsDataset(root, split, dense=LABELS):
            if sample["file"] == file:
                return sample
    raise SystemExit(f"{file}: is not in {root}")


def depth_picture(depth):
    nearness = np.clip(1 - np.log(np.maximum(depth, 1e-3) / 2) / np.log(75), 0, 1)
    colors = 255 * np.stack([nearness, nearness**1.5, 0.75 - 0.5 * nearness], -1)
    return np.where(np.isinf(depth)[:, :, None], 0, colors)


def normal_picture(normal):
    is_hit = (normal != 0).any(-1, keepdims=True)
    return np.where(is_hit, 127.5 * (normal * (1, -1, -1) + 1), 0)


def id_picture(ids, colors):
    return colors[ids]


def gravity_picture(image, up, latitude):
    """Lines of equal latitude, every 10 degrees, and strokes that point upwards."""
    shade = np.clip(latitude / 40 + 0.5, 0, 1)
    colors = 0.3 * image + 0.45 * np.stack([255 * shade, np.full_like(shade, 90), 255 * (1 - shade)], -1)
    colors[np.abs((latitude + 5) % 10 - 5) < 0.25] = 255
    picture = Image.fromarray(colors.clip(0, 255).astype(np.uint8))
    draw = ImageDraw.Draw(picture)
    for y in range(15, picture.height, 30):
        for x in range(15, picture.width, 30):
            draw.line([x, y, x + 13 * up[y, x, 0], y + 13 * up[y, x, 1]], fill=(255, 255, 0))
            draw.ellipse([x - 1, y - 1, x + 1, y + 1], fill=(255, 255, 0))
    return np.asarray(picture)


def main(root, file, out):
    sample = find(root, file)
    image, dense = sample["image"], sample["dense"]
    object_colors = np.random.default_rng(3).integers(40, 255, (1 << 16, 3))
    object_colors[0] = 0
    class_colors = np.zeros((1 << 16, 3), int)
    for number, color in CLASS_COLORS.items():
        class_colors[number] = color
    panels = [
        image,
        depth_picture(dense["depth"][:, :, 0]),
        normal_picture(dense["normal"]),
        id_picture(dense["instance"][:, :, 0], object_colors),
        id_picture(dense["semantic"][:, :, 0], class_colors),
        gravity_picture(image, dense["up"], dense["latitude"][:, :, 0]),
    ]
    height, width = image.shape[:2]
    sheet = Image.new("RGB", (3 * width + 8, 2 * height + 4), "white")
    for i, panel in enumerate(panels):
        place = i % 3 * (width + 4), i // 3 * (height + 4)
        sheet.paste(Image.fromarray(np.clip(panel, 0, 255).astype(np.uint8)), place)
    sheet.save(out, quality=85)


main(*sys.argv[1:])
