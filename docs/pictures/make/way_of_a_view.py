#!/usr/bin/env python3
"""Makes docs/pictures/way_of_a_view.jpg: one view as master, through its lens, with its crop, and as an image.

    docs/pictures/make/way_of_a_view.py build/release/bin/cps docs/pictures/city_view.jpg docs/pictures/way_of_a_view.jpg

The first picture is the master: a view that `cps render` made without a lens at 1392x512 and 70 degrees, such as
out/demo/view.png of `./dev demo`. Needs Debian's python3-numpy and python3-pil. Takes seconds.
Panels 1 and 4 are the program's output. It never makes what panels 2 and 3 show, a distorted picture with its
black border: this script draws that by moving every master pixel to where the lens puts it.
"""
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

WIDTH, HEIGHT = 696, 256  # of the image; the master has twice as many pixels a side
BASE_HFOV_DEG = 70.0
SCALED = dict(k1=-0.372, k2=0.203, k3=-0.071)  # KITTI's camera 00, in units of its master's half diagonal
FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"


def lens_of_base():
    """Coefficients on the plane z = 1, and the base's focal length in image pixels."""
    half_width = math.tan(math.radians(BASE_HFOV_DEG) / 2)
    radius = half_width * math.hypot(1, HEIGHT / WIDTH)
    return {name: value / radius ** (2 * int(name[1])) for name, value in SCALED.items()}, WIDTH / 2 / half_width


def write_calibration(path, lens, focal):
    cx, cy = (WIDTH - 1) / 2, (HEIGHT - 1) / 2
    camera = dict(fov=BASE_HFOV_DEG, K=[[focal, 0, cx], [0, focal, cy], [0, 0, 1]], width=WIDTH, height=HEIGHT,
                  p1=0, p2=0, cx=cx, cy=cy, **lens)
    path.write_text(json.dumps(camera))


def with_black_border(master, lens, focal):
    """The whole master through the lens at the base's focal length: black where nothing of it is seen."""
    pixels = np.asarray(master, dtype=float) / 255
    light = np.where(pixels <= 0.04045, pixels / 12.92, ((pixels + 0.055) / 1.055) ** 2.4)
    light = light.repeat(2, 0).repeat(2, 1)  # four points of each master pixel
    rows, columns = light.shape[:2]
    x = ((np.arange(columns) + 0.5) * WIDTH / columns - WIDTH / 2)[None, :] / focal
    y = ((np.arange(rows) + 0.5) * HEIGHT / rows - HEIGHT / 2)[:, None] / focal
    s = x * x + y * y
    scale = 1 + lens["k1"] * s + lens["k2"] * s**2 + lens["k3"] * s**3
    u = np.floor(focal * x * scale + WIDTH / 2).astype(int).ravel()
    v = np.floor(focal * y * scale + HEIGHT / 2).astype(int).ravel()
    total, count = np.zeros((HEIGHT * WIDTH, 3)), np.zeros(HEIGHT * WIDTH)
    np.add.at(total, v * WIDTH + u, light.reshape(-1, 3))
    np.add.at(count, v * WIDTH + u, 1)
    mean = (total / np.maximum(count, 1)[:, None]).reshape(HEIGHT, WIDTH, 3)
    coded = np.where(mean <= 0.0031308, mean * 12.92, 1.055 * mean ** (1 / 2.4) - 0.055)
    return Image.fromarray(np.round(255 * coded).astype(np.uint8))


def with_frame(picture, zoom):
    """The picture, pale outside of what the crop keeps."""
    half = np.array([WIDTH, HEIGHT]) / 2 / zoom
    corners = [tuple(np.array([WIDTH, HEIGHT]) / 2 - half), tuple(np.array([WIDTH, HEIGHT]) / 2 + half)]
    shade = Image.new("L", picture.size, 150)
    ImageDraw.Draw(shade).rectangle(corners, fill=0)
    framed = Image.composite(Image.new("RGB", picture.size, "white"), picture, shade)
    ImageDraw.Draw(framed).rectangle(corners, outline=(230, 60, 20), width=3)
    return framed


def sheet(panels):
    gap, line = 12, 34
    out = Image.new("RGB", (2 * WIDTH + 3 * gap, 2 * (HEIGHT + line) + 3 * gap), "white")
    draw, font = ImageDraw.Draw(out), ImageFont.truetype(FONT, 19)
    for number, (picture, words) in enumerate(panels):
        left = gap + number % 2 * (WIDTH + gap)
        top = gap + number // 2 * (HEIGHT + line + gap)
        draw.text((left, top + 4), words, fill=(30, 30, 30), font=font)
        out.paste(picture, (left, top + line))
    return out


def main(cps, view, target):
    lens, focal = lens_of_base()
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        run = lambda *words: subprocess.run([cps, *map(str, words)], check=True, stdout=subprocess.DEVNULL)
        master = Image.open(view).convert("RGB")
        master.save(folder / "master.png")
        write_calibration(folder / "lens.json", lens, focal)
        run("distort", folder / "master.png", "-o", folder / "image.png", "--hfov", BASE_HFOV_DEG,
            "--lens", folder / "lens.json", "--label", folder / "label.json")
        label = json.loads((folder / "label.json").read_text())
        image = Image.open(folder / "image.png").convert("RGB")
        zoom = label["K"][0][0] / focal
        seen = with_black_border(master, lens, focal)
        fov = 2 * math.degrees(math.atan(WIDTH / 2 / label["K"][0][0]))
        out = sheet([
            (master.resize((WIDTH, HEIGHT), Image.BOX), f"1  Master: rendered without a lens, base H-FOV {BASE_HFOV_DEG:.0f}°"),
            (seen, "2  Through the lens: the border turns black"),
            (with_frame(seen, zoom), f"3  Crop: the largest frame without black, zoom {zoom:.3f}"),
            (image, f"4  Image: label H-FOV {fov:.1f}°, resampled once"),
        ])
        out.save(target, quality=88)


main(*sys.argv[1:])
