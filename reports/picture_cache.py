"""Store of drawn pictures; the key includes all data on which a picture depends."""

import hashlib
import json
import os
import struct
import zipfile
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from verify.core.figures import Array, Field, Picture
from verify.core.store import Store, packed, unpacked

CODE = (
    "bitmaps", "bodies", "drawing_process", "outlines", "picture_cache", "pictures", "polygons",
    "ramps", "raster", "render", "scene",
)  # fmt: skip
KIND, SUBJECT = "picture", "report"  # of entries of the store
LIBRARIES = ("numpy", "matplotlib", "pillow", "pyvista", "vtk")
# libraries of OpenGL on Linux: after an installation pyvista is tried again
OPENGL = ("lib/*", "lib64", "local/lib")
# errors of numpy, zipfile and json for incomplete or changed files
UNREADABLE = (
    OSError, ValueError, LookupError, EOFError, RuntimeError, TypeError, AttributeError,
    zipfile.BadZipFile, zlib.error, struct.error,
)  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Drawn:
    """A field as a bitmap without text, and the data for the texts and lines on the page.

    `image` is a WebP image of `width` by `height` pixels, transparent around the body; it contains
    the region `rectangle` (left, bottom, right, top) in the length unit of the model. Values are
    from `low` to `high` in the unit of the picture, with evenly spaced colours `ramp`, which is
    empty for a body without data. Displacements are scaled by `exaggeration` (0: none); `outline`
    is the undeformed body. `by` is the program that drew the picture. `why` is the reason if `by`
    is not pyvista, otherwise empty.
    """

    image: bytes
    width: int
    height: int
    rectangle: tuple[float, float, float, float]
    low: float
    high: float
    ramp: tuple[str, ...]
    exaggeration: float
    outline: tuple[Array, ...]
    by: str
    why: str = ""

    def pixels(self, points: Array) -> Array:
        """Pixel coordinates (right, down) of points (n, 2) of the model in the bitmap."""
        left, _, right, top = self.rectangle
        return np.asarray((points - (left, top)) * (1, -1) * self.width / (right - left))

    def outline_path(self) -> str:
        """Undeformed outline as data of an SVG path, in pixels of the bitmap."""
        lines = (
            "L".join(f"{x:.1f},{y:.1f}" for x, y in self.pixels(line)) for line in self.outline
        )
        return "".join(f"M{line}" for line in lines)


def key(field: Field, picture: Picture) -> str:
    """Key of a picture: a hexadecimal digest of all data that determine the image."""
    digest = hashlib.sha256(_code().encode())
    spec = {
        **vars(picture),
        "caption": "",
        "symbol": "",
        "unit": "",
        "field": "",
        "decades": False,
    }  # the page's
    digest.update(json.dumps(spec, sort_keys=True).encode())
    arrays: Mapping[str, Any] = {
        "points": field.points, "cells": field.cells,
        "moved": field.point_data.get(picture.displacement),
        "point": field.point_data.get(picture.data), "cell": field.cell_data.get(picture.data),
    }  # fmt: skip
    for name, array in arrays.items():
        if array is not None:
            digest.update(f"{name} {array.shape} {array.dtype}".encode())
            digest.update(np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()[:32]


def load(folder: Path, name: str) -> Drawn | None:
    """Stored picture; None if it is missing or unreadable.

    It is also None for a picture that was drawn without pyvista if OpenGL has changed since then.
    """
    content = Store(folder).one(KIND, name)
    if content is None:
        return None
    try:
        data = unpacked(content)
        head = json.loads(str(data["head"]))
        current = head.pop("opengl") == opengl() or not head["why"]
        outline = tuple(data[f"outline {i}"] for i in range(head.pop("lines")))
        head |= {name: tuple(head[name]) for name in ("rectangle", "ramp")}
        drawn = Drawn(image=data["image"].tobytes(), outline=outline, **head)
    except UNREADABLE:
        return None
    return drawn if current else None


def store(folder: Path, name: str, drawn: Drawn) -> None:
    """Write the picture to the store. Raises OSError if the store cannot be written."""
    head = {**vars(drawn), "lines": len(drawn.outline), "opengl": opengl()}
    del head["image"], head["outline"]
    arrays: dict[str, Any] = {f"outline {i}": line for i, line in enumerate(drawn.outline)}
    image = np.frombuffer(drawn.image, dtype=np.uint8)
    arrays |= {"head": np.array(json.dumps(head)), "image": image}
    Store(folder).store(KIND, SUBJECT, {name: packed(arrays)})


@cache
def _code() -> str:
    """Text of the drawing code, with the versions of its libraries."""
    sources = [(Path(__file__).parent / f"{name}.py").read_text("utf-8") for name in CODE]
    return "\0".join([*sources, *(f"{name} {version(name)}" for name in LIBRARIES)])


def opengl() -> str:
    """Text with the OpenGL libraries and the display in use."""
    found = sorted(
        path.name for place in OPENGL for path in Path("/usr").glob(f"{place}/lib*GL*.so*")
    )
    found += sorted(path.name for path in Path("/usr").glob("lib/*/libOSMesa*.so*"))
    names = ("DISPLAY", "VTK_DEFAULT_OPENGL_WINDOW")
    return " ".join([*found, *(f"{name}={os.environ.get(name, '')}" for name in names)])
