"""Drawing of scenes by matplotlib (Agg), without display and OpenGL."""

from typing import Any

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.transforms import IdentityTransform

from reports.bitmaps import FINER, webp
from reports.scene import Scene

SEAM = 0.4  # pixels: each face is outlined in its fill colour, which closes gaps to its neighbours


def draw(scene: Scene) -> bytes:
    """WebP image of the scene, transparent around it."""
    figure = Figure(figsize=(FINER * scene.width, FINER * scene.height), dpi=1, facecolor="none")
    canvas: Any = FigureCanvasAgg(figure)  # untyped in matplotlib
    corners: Any = FINER * scene.vertices[scene.faces][..., :2]  # an array is read fastest
    colours = scene.colours / 255
    strokes = np.where(colours[:, 3:] < 1, 0, colours)  # no strokes around half transparent faces
    faces = PolyCollection(
        corners, facecolors=colours, edgecolors=strokes,
        linewidths=72 * SEAM, antialiased=False, snap=False, transform=IdentityTransform(),
    )  # fmt: skip
    figure.add_artist(faces)
    canvas.draw()
    return webp(np.asarray(canvas.buffer_rgba()))
