#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How alike pictures look: SSIM and FLIP of pairs of PNGs, as `sheen compare` asks for them.

    picture_metrics.py PAIRS.json

PAIRS.json is an array of objects {"mask": PNG, "expected": PNG, "actual": PNG}. For each pair, in order, one line
{"ssim": number, "flip": number} is printed as soon as it is known. Both are means over the pixels where the mask is
not black, of maps made of the whole pictures, so that the background counts only as far as it is seen next to them:

    ssim  scikit-image's structural_similarity as its authors define it (Gaussian window of sigma 1.5, 11 pixels wide),
          each component by itself; 1 for equal pictures
    flip  the FLIP evaluator for displays (LDR), pictures taken as sRGB, 67 pixels a degree of the visual angle;
          0 for equal pictures

A number is null where it has no meaning: the mask is black, or, for ssim, a side is shorter than the window.
Exit status: 0 done, 1 a file is no picture of the right size, 2 usage, 3 a package is missing; one line says which.
"""

import json
import sys

try:
    import flip_evaluator
    import numpy
    from PIL import Image
    from skimage.metrics import structural_similarity
except ImportError as missing:
    print(f"no Python package '{missing.name}'; install scikit-image and flip-evaluator, as `make setup` does, or let "
          "SHEEN_PYTHON name a Python that has them", file=sys.stderr)
    sys.exit(3)

WINDOW = 11  # pixels: 3.5 standard deviations of 1.5 pixels to either side


class PictureError(Exception):
    """A file that is no picture, or one of another size than its partner."""


def load(path):
    """The picture as an array of height x width x 3 bytes."""
    try:
        with Image.open(path) as image:
            return numpy.asarray(image.convert("RGB"))
    except (OSError, Image.DecompressionBombError) as error:
        raise PictureError(f"{path}: {error}") from error


def ssim(expected, actual, mask):
    """Mean of the SSIM map over the mask, or None where the picture is smaller than the window."""
    if min(expected.shape[:2]) < WINDOW:
        return None
    _, similarity = structural_similarity(expected, actual, channel_axis=2, data_range=255, full=True,
                                          gaussian_weights=True, sigma=1.5, use_sample_covariance=False)
    return float(similarity[mask].mean())


def flip(expected, actual, mask):
    """Mean of the FLIP error map over the mask."""
    pair = [picture.astype(numpy.float32) / 255 for picture in (expected, actual)]
    error, _, _ = flip_evaluator.evaluate(*pair, "LDR", inputsRGB=True, applyMagma=False, computeMeanError=False)
    return float(error[..., 0][mask].mean(dtype=numpy.float64))


def compare(expected, actual, mask):
    """Both metrics of a pair of arrays; `mask` is true at the pixels that count."""
    if not expected.shape == actual.shape == mask.shape + (3,):
        raise PictureError(f"pictures of {expected.shape[:2]} and {actual.shape[:2]} pixels under a mask of {mask.shape}")
    if not mask.any():
        return {"ssim": None, "flip": None}
    return {"ssim": ssim(expected, actual, mask), "flip": flip(expected, actual, mask)}


def main(arguments):
    """Compares every pair of the file; pictures with the same pixels once."""
    if len(arguments) != 1:
        print("usage: picture_metrics.py PAIRS.json", file=sys.stderr)
        return 2
    try:
        with open(arguments[0], encoding="utf-8") as file:
            pairs = json.load(file)
        known = {}
        for pair in pairs:
            mask, expected, actual = (load(pair[name]) for name in ("mask", "expected", "actual"))
            key = (mask.tobytes(), expected.tobytes(), actual.tobytes())
            if key not in known:
                known[key] = compare(expected, actual, mask.any(axis=2))
            print(json.dumps(known[key]), flush=True)
    except (OSError, ValueError, PictureError) as error:
        print(f"picture_metrics: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
