#!/usr/bin/python3
"""Is an image that is traced ray by ray through its lens as noisy as one that is warped from a master?
    bench/renderer/traced_noise.py FOLDER [OPTION...]
Makes images of the same places by cps generate in both ways, without sensor noise: undistorted Brown-Conrady images, which
are warped like all others, with the noise that the warp adds, and images through unified spherical lenses, which are traced
with four times as many paths. Under 20 degrees both show the same to a fraction of a pixel, whatever xi. The noise of an
image is its difference from the image made the same way with many more samples. (Those have some noise, too, and share
paths with the others: as much of it in both ways.) Prints a row for each number of samples, of flat blocks (the quarter of
the blocks of 8x8 pixels with the least contrast) and of all; blocks without noise, such as those of the sky, are left out:
    warped, traced       rms noise, per cent of a block's mean luminance
    ratio                traced by warped, with a 95 % interval by bootstrap over blocks
    median               of the ratios of single blocks, which a few bright paths hardly move
    2x2                  the ratio for means of 2x2 pixels, as in a reduced picture, where noise that neighbours share stays
    neighbours           correlation of the noise of pixels side by side, warped and traced
Needs python3-numpy and python3-pil. FOLDER keeps the datasets; run it again after an interruption."""
import argparse
import csv
import subprocess
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "python"))
from cps_dataset import decode_exr  # noqa: E402

# Options of cps generate.
WAYS = {"warped": ["--lenses", "0"], "traced": ["--lens_model", "unified_spherical", "--lenses", "1"]}
BLOCK = 8
LUMINANCE = np.array([.2126, .7152, .0722])  # Rec. 709
LEAST_NOISE = .001  # of a block's mean: below is nothing but rounding to half floats


def make(options, way, samples):
    """Makes a dataset unless it is there; returns its folder."""
    scene, folder = options.folder / "city.glb", options.folder / f"{way}_{samples}"
    if not scene.exists():
        subprocess.run([options.cps, "city", "--seed", "1", "--extent-m", "400", "-o", scene], check=True)
    subprocess.run([options.cps, "generate", "--scene", scene, "--out", folder, "--seed", str(options.seed), *WAYS[way],
                    "--size", options.size, "--hfov_deg", str(options.hfov), "--views", str(options.views),
                    "--conditions_per_scene", "3", "--split", "thesis", "--samples", str(samples), "--image_format", "exr",
                    "--exposure_bias_min_ev", "0", "--exposure_bias_max_ev", "0", "--threads", str(options.threads)],
                   check=True, stdout=subprocess.DEVNULL)
    return folder


def luminances(folder):
    """Of the images by the number of their place, in the scene's units: each image's exposure is divided out."""
    images = {}
    for frames in folder.glob("*/*/frames.csv"):
        with open(frames, newline="") as rows:
            for row in csv.DictReader(rows):
                pixels = decode_exr((frames.parent / row["file"]).read_bytes()).astype(float)
                images[row["file"]] = pixels @ LUMINANCE / float(row["exposure"])
    return [images[name] for name in sorted(images)]


def blocks(images):
    """(number, BLOCK, BLOCK); what is left at the right and lower edges is cut off."""
    cut = []
    for image in images:
        rows, columns = (side // BLOCK for side in image.shape)
        whole = image[:rows * BLOCK, :columns * BLOCK].reshape(rows, BLOCK, columns, BLOCK)
        cut.append(whole.swapaxes(1, 2).reshape(-1, BLOCK, BLOCK))
    return np.concatenate(cut)


def rms(noise):
    """Of each block."""
    return np.sqrt((noise ** 2).mean(axis=(1, 2)))


def percent_of_all(blocks_rms):
    return 100 * np.sqrt((blocks_rms ** 2).mean())


def halved(noise):
    return noise.reshape(len(noise), BLOCK // 2, 2, BLOCK // 2, 2).mean(axis=(2, 4))


def correlation(noise):
    return (noise[:, :, 1:] * noise[:, :, :-1]).mean() / (noise ** 2).mean()


def ratio(traced, warped):
    return np.sqrt((traced ** 2).sum(axis=-1) / (warped ** 2).sum(axis=-1))


def row(warped, traced):
    """The numbers of a row, from the relative noise of the same blocks both ways."""
    of_warped, of_traced = rms(warped), rms(traced)
    drawn = np.random.default_rng(0).integers(len(of_warped), size=(1000, len(of_warped)))
    low, high = np.quantile(ratio(of_traced[drawn], of_warped[drawn]), [.025, .975])
    return (f"{len(of_warped):7} {percent_of_all(of_warped):8.3g} {percent_of_all(of_traced):8.3g} "
            f"{ratio(of_traced, of_warped):7.3f} [{low:.3f}, {high:.3f}] {np.median(of_traced / of_warped):8.3f} "
            f"{ratio(rms(halved(traced)), rms(halved(warped))):7.3f} {correlation(warped):8.3f} {correlation(traced):7.3f}")


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--samples", default="2,4,16", help="paths per master pixel, even, separated by commas [2,4,16]")
    parser.add_argument("--reference", type=int, default=256, help="those of the images to compare with [256]")
    parser.add_argument("--views", type=int, default=6, help="places, in three lights [6]")
    parser.add_argument("--size", default="96x96")
    parser.add_argument("--hfov", type=float, default=20, help="degrees; the wider, the more the lenses differ [20]")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--threads", type=int, default=0, help="[all]")
    parser.add_argument("--cps", default="build/release/bin/cps")
    options = parser.parse_args(arguments)
    options.folder.mkdir(parents=True, exist_ok=True)
    reference = {way: blocks(luminances(make(options, way, options.reference))) for way in WAYS}
    mean = {way: reference[way].mean(axis=(1, 2), keepdims=True) for way in WAYS}
    is_lit = ((mean["warped"] > 0) & (mean["traced"] > 0)).ravel()
    print(f"{'samples':>7} {'blocks':<6} {'number':>7} {'warped %':>8} {'traced %':>8} {'ratio':>7} {'95 % interval':<14} "
          f"{'median':>8} {'2x2':>7} {'neighbours':>16}")
    for samples in (int(word) for word in options.samples.split(",")):
        noise = {}
        for way in WAYS:
            difference = blocks(luminances(make(options, way, samples))) - reference[way]
            noise[way] = difference[is_lit] / mean[way][is_lit]
        is_noisy = np.minimum(rms(noise["warped"]), rms(noise["traced"])) > LEAST_NOISE
        contrast = (reference["warped"].std(axis=(1, 2)) / mean["warped"].ravel())[is_lit]
        is_flat = is_noisy & (contrast <= np.quantile(contrast[is_noisy], .25))
        for name, chosen in (("flat", is_flat), ("all", is_noisy)):
            print(f"{samples:7} {name:<6} {row(noise['warped'][chosen], noise['traced'][chosen])}")


if __name__ == "__main__":
    main()
