"""Rendered pixels to a small PNG."""

import io

import numpy as np
from numpy.typing import NDArray
from PIL import Image

FINER = 3  # pixels are drawn so many times finer, and averaged


def png(rgba: NDArray[np.uint8]) -> bytes:
    """PNG with a palette, of RGBA pixels (FINER height, FINER width, 4) averaged over FINER^2."""
    image = Image.fromarray(np.ascontiguousarray(rgba), "RGBA")
    small = image.convert("RGBa").reduce(FINER).convert("RGBA")  # colours weighted by their alpha
    data = io.BytesIO()
    small.quantize(256, Image.Quantize.FASTOCTREE).save(data, "PNG", optimize=True)
    return data.getvalue()


def flaw(data: bytes, width: int, height: int) -> str:
    """Why the PNG can't be a picture of a body, or an empty string."""
    try:
        with Image.open(io.BytesIO(data)) as image:
            pixels = np.asarray(image.convert("RGBA"))
    except (OSError, SyntaxError, ValueError) as error:  # PIL raises SyntaxError on broken PNG
        return f"unreadable picture: {error}"
    if pixels.shape[:2] != (height, width):
        return f"picture of {pixels.shape[1]}x{pixels.shape[0]} instead of {width}x{height} pixels"
    opaque = pixels[..., 3] > 127
    if not opaque.any() or (opaque.all() and not np.ptp(pixels.reshape(-1, 4), axis=0).any()):
        return "blank picture"
    return ""
