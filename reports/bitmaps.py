"""Conversion of rendered pixels into a small WebP image.

The image is stored without loss with a palette, or with loss at high quality if that file is
smaller.
"""

import io

import numpy as np
from numpy.typing import NDArray
from PIL import Image

QUALITY = 90  # of the coding with loss, in percent; its flaws are not visible at double size
# of the coding without loss, in percent; 100, and method 6 with loss, save 4 % of the size and
# take twenty to forty times as long
EFFORT = 99
FINER = 3  # factor by which pixels are drawn finer, and averaged
INSIDE, RIM = 207, 48  # colours of a palette for opaque and half transparent pixels


def webp(rgba: NDArray[np.uint8]) -> bytes:
    """WebP image; each of its pixels is the mean of FINER^2 pixels of `rgba`.

    `rgba` is (FINER height, FINER width, 4).
    """
    image = Image.fromarray(np.ascontiguousarray(rgba), "RGBA")
    small = image.convert("RGBa").reduce(FINER).convert("RGBA")  # colours weighted by their alpha
    pixels = np.asarray(small)
    indices = np.zeros(pixels.shape[:2], dtype=np.uint8)  # 0 is transparent
    palette = np.zeros((1, 4), dtype=np.uint8)
    alpha = pixels[..., 3]
    # Pillow's only method for transparency is coarse: it would make bands in a smooth field
    for part, mode, count, method in (
        (alpha == 255, "RGB", INSIDE, Image.Quantize.MEDIANCUT),
        ((alpha > 0) & (alpha < 255), "RGBA", RIM, Image.Quantize.FASTOCTREE),
    ):
        if part.any():
            row = Image.fromarray(pixels[part][None]).convert(mode)
            few = row.quantize(count, method, kmeans=2)
            indices[part] = np.asarray(few)[0] + len(palette)
            colours = np.array(few.getpalette(mode), dtype=np.uint8).reshape(-1, len(mode))
            solid = np.full((len(colours), 4 - len(mode)), 255, dtype=np.uint8)
            palette = np.concatenate([palette, np.hstack([colours, solid])])
    exact = _coded(Image.fromarray(palette[indices]), lossless=True, quality=EFFORT, method=6)
    return min(exact, _coded(small, lossless=False, quality=QUALITY, method=5), key=len)


def _coded(image: Image.Image, **options: int) -> bytes:
    data = io.BytesIO()
    image.save(data, "WEBP", **options)
    return data.getvalue()


def flaw(data: bytes, width: int, height: int) -> str:
    """Reason why the image cannot be a picture of a body; "" if it can."""
    try:
        with Image.open(io.BytesIO(data)) as image:
            pixels = np.asarray(image.convert("RGBA"))
    except (OSError, SyntaxError, ValueError) as error:  # PIL raises SyntaxError on broken ones
        return f"unreadable picture: {error}"
    if pixels.shape[:2] != (height, width):
        return f"picture of {pixels.shape[1]}x{pixels.shape[0]} instead of {width}x{height} pixels"
    opaque = pixels[..., 3] > 127
    if not opaque.any() or (opaque.all() and not np.ptp(pixels.reshape(-1, 4), axis=0).any()):
        return "blank picture"
    return ""
