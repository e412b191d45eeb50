"""Drawing of scenes by pyvista, in the process of `reports.drawing_process`.

Each input line is the name of a folder; the process prints an empty line when the scenes of this
folder are drawn. Without a working OpenGL, VTK may end the process by a signal, or may hang.
"""

import sys
from pathlib import Path

import numpy as np
import pyvista
from numpy.typing import NDArray

from reports.bitmaps import FINER, webp

FAR = 1e5  # pixels from the camera, more than any body is deep


def main() -> None:
    """Draw the scenes of the folders that the input lines name."""
    for line in sys.stdin:
        draw(Path(line.removesuffix("\n")))
        print(flush=True)


def draw(folder: Path) -> None:
    """Draw every scene of `scenes.npz` to a numbered WebP image in the same folder."""
    with np.load(folder / "scenes.npz", allow_pickle=False) as data:
        for i in range(int(data["count"])):
            arrays = {name: data[f"{name} {i}"] for name in ("vertices", "faces", "colours")}
            width, height = data[f"size {i}"].tolist()
            (folder / f"{i}.webp").write_bytes(webp(pixels(width, height, **arrays)))


def pixels(
    width: int,
    height: int,
    *,
    vertices: NDArray[np.float64],
    faces: NDArray[np.int64],
    colours: NDArray[np.uint8],
) -> NDArray[np.uint8]:
    """RGBA pixels (FINER height, FINER width, 4) of a scene.

    One unit of the vertices is one pixel of the final image.
    """
    plotter = pyvista.Plotter(off_screen=True, window_size=[FINER * width, FINER * height])
    plotter.disable_anti_aliasing()
    opaque = colours[:, 3] == 255
    for part in (opaque, ~opaque):
        if part.any():
            corners = np.column_stack([np.full(part.sum(), 4), faces[part]])
            plotter.add_mesh(
                pyvista.PolyData(vertices, faces=corners.ravel()), scalars=colours[part],
                rgb=True, lighting=False, show_scalar_bar=False,
            )  # fmt: skip
    camera = plotter.camera
    camera.parallel_projection = True
    camera.focal_point = (width / 2, height / 2, 0)
    camera.position = (width / 2, height / 2, FAR)
    camera.up = (0, 1, 0)
    camera.parallel_scale = height / 2
    camera.clipping_range = (1, 2 * FAR)
    image = plotter.screenshot(transparent_background=True, return_img=True)
    plotter.close()
    return np.asarray(image, dtype=np.uint8)


if __name__ == "__main__":
    main()
