"""The figure of a body in space: its colours, edges, colour bar and point of view, for Plotly."""

import base64
import math
import re
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from reports.ramps import PLAIN
from verify.app.page.shapes import Shape
from verify.app.page.sweep_figure import DARK, LIGHT
from verify.core.figures import Array

HEIGHT = 0.3  # of the largest extent, of the range of values drawn as height
UPWARDS = {"x": 0.0, "y": 1.0, "z": 0.0}  # direction on the screen
VIEWS: Mapping[str, tuple[float, float, float]] = {  # direction to the eye
    "front": (0.0, 0.0, 1.0), "oblique": (0.9, 0.7, 1.2), "from the right": (1.0, 0.0, 0.0),
    "from above": (0.0, 1.0, 0.001),
}  # fmt: skip
LENGTH_TICKS = 5
MARGIN = 0.02  # of the largest extent, around the body
SIZE = 1.55  # of the largest extent on the screen, in units of half the height of the figure


def figure(
    shape: Shape, factor: float, *, view: str, as_height: bool = False, dark: bool = False
) -> dict[str, Any]:
    """A description of the deformed body for Plotly, with displacements times `factor`.

    With `as_height`, the values of a plane body are its heights. If `view` is the same as before,
    the body remains turned as the user has turned it.
    """
    colours = DARK if dark else LIGHT
    points, moved = shape.deformed(factor), factor > 0
    if as_height and shape.is_plane and shape.values is not None:
        points, moved = _raised(points, shape.values), False
    return {
        "data": [
            _surface(shape, points, colours), _lines(shape, points, colours["ink"]),
            *([_lines(shape, shape.points, colours["ink"], dash="dash")] if moved else []),
        ],
        "layout": _layout(
            np.concatenate([points, shape.points]) if moved else points, view, colours,
            is_plane=shape.is_plane, stretch=shape.stretch,
        ),
        "config": {"displaylogo": False, "responsive": True, "scrollZoom": True,
                   "modeBarButtonsToRemove": ["tableRotation", "resetCameraLastSave3d"]},
    }  # fmt: skip


def camera(view: str) -> dict[str, Any]:
    """The point of view with this name in `VIEWS`."""
    to_eye = np.array(VIEWS[view])
    eye = to_eye / np.linalg.norm(to_eye)
    return {"eye": dict(zip("xyz", eye.tolist(), strict=True)), "up": UPWARDS,
            "projection": {"type": "orthographic"}}  # fmt: skip


def _raised(points: Array, values: Array) -> Array:
    """Points (k, 3): plane points, with the mean of the values at each point as its height.

    Heights are scaled, so that their range is `HEIGHT` times the extent of the body.
    """
    _, place = np.unique(points[:, :2], axis=0, return_inverse=True)
    place = place.reshape(-1)
    means = (np.bincount(place, values) / np.bincount(place))[place]
    span, extent = float(np.ptp(means)), float(np.ptp(points, axis=0).max())
    heights = (means - means.min()) * (HEIGHT * extent / span if span else 0.0)
    return np.column_stack([points[:, :2], heights])


def _surface(shape: Shape, points: Array, colours: Mapping[str, str]) -> dict[str, Any]:
    """Triangles of all cells, with a value at each vertex."""
    corners = shape.cells
    triangles = [corners[:, [0, k, k + 1]] for k in range(1, corners.shape[1] - 1)]
    trace: dict[str, Any] = {
        "type": "mesh3d", **_coordinates(points), "flatshading": not shape.is_plane,
        **dict(zip("ijk", (_packed(c, "i4") for c in np.concatenate(triangles).T), strict=True)),
        "lighting": {"ambient": 1.0, "diffuse": 0.0, "specular": 0.0} if shape.is_plane
        else {"ambient": 0.65, "diffuse": 0.5, "specular": 0.05},
    }  # fmt: skip
    if shape.values is None:
        return trace | {"color": PLAIN, "hoverinfo": "skip"}
    stops = shape.scale.stops
    steps = max(len(stops) - 1, 1)
    return trace | {
        "intensity": _packed(shape.values, "f4"), "cmin": shape.scale.low, "cmax": shape.scale.high,
        "colorscale": [[i / steps, colour] for i, colour in enumerate(stops)],
        "colorbar": _bar(shape, colours), "showscale": True,
        "hovertemplate": _at_pointer(shape),
    }  # fmt: skip


def _at_pointer(shape: Shape) -> str:
    """Text at the pointer: the value, and the position at which it is drawn."""
    symbol, _, unit = lowered(shape.label).partition(" [")
    value = "10<sup>%{intensity:.3g}</sup>" if shape.decades else "%{intensity:.4g}"
    return (
        f"{symbol} = {value} {unit.removesuffix(']')}<br>drawn at x = %{{x:.4g}}, y = %{{y:.4g}}, "
        "z = %{z:.4g} mm<extra></extra>"
    )


def _lines(shape: Shape, points: Array, colour: str, dash: str = "solid") -> dict[str, Any]:
    """The free edges of the body whose vertices are at `points`."""
    ends = points[shape.edges]
    gaps = np.full((len(ends), 1, 3), np.nan)
    broken = np.concatenate([ends, gaps], axis=1).reshape(-1, 3)
    return {
        "type": "scatter3d", "mode": "lines", **_coordinates(broken), "showlegend": False,
        "line": {"color": colour, "width": 2, "dash": dash}, "hoverinfo": "skip",
    }  # fmt: skip


def _bar(shape: Shape, colours: Mapping[str, str]) -> dict[str, Any]:
    """The colour bar; its labels are powers of ten if the values are logarithms."""
    bar: dict[str, Any] = {
        "title": {"text": lowered(shape.label), "side": "right"}, "thickness": 14, "len": 0.8,
        "tickfont": {"color": colours["ink"]}, "titlefont": {"color": colours["ink"]},
        "outlinewidth": 0,
    }  # fmt: skip
    if shape.decades:
        whole = range(math.ceil(shape.scale.low), math.floor(shape.scale.high) + 1)
        bar |= {"tickvals": list(whole), "ticktext": [f"10<sup>{k}</sup>" for k in whole]}
    return bar


def _layout(
    points: Array, view: str, colours: Mapping[str, str], *, is_plane: bool, stretch: float
) -> dict[str, Any]:
    """Axes around the body, without the third one for a plane body.

    Their scales are equal, but lengths along y are drawn `stretch` times as large.
    """
    axis = {
        "color": colours["ink"], "gridcolor": colours["line"], "showbackground": False,
        "zeroline": False, "nticks": LENGTH_TICKS, "showspikes": False,
    }  # fmt: skip
    low, high = points.min(axis=0), points.max(axis=0)
    drawn = np.array([1.0, stretch, 1.0])
    room = MARGIN * ((high - low) * drawn).max() / drawn
    extent = (high - low + 2 * room) * drawn
    axes = {
        f"{k}axis": axis | {"title": {"text": f"{k} [mm]"}, "range": [start, end]}
        for k, start, end in zip("xyz", (low - room).tolist(), (high + room).tolist(), strict=True)
    }
    axes["zaxis"]["visible"] = not is_plane
    if stretch != 1:
        axes["yaxis"]["title"] = {"text": f"y [mm], magnified {stretch:g} times"}
    return {
        "scene": {
            **axes, "aspectmode": "manual", "camera": camera(view), "dragmode": "orbit",
            "aspectratio": dict(zip("xyz", (SIZE * extent / extent.max()).tolist(), strict=True)),
        },
        "uirevision": view, "margin": {"l": 0, "r": 0, "t": 0, "b": 0},
        "paper_bgcolor": "rgba(0,0,0,0)", "font": {"color": colours["ink"]},
        "hoverlabel": {"align": "left"},
    }  # fmt: skip


def lowered(text: str) -> str:
    """Text in which indices of symbols are subscripts of Plotly: σ_v becomes σ<sub>v</sub>."""
    return re.sub(r"_(\w+|\{[^}]*\})", r"<sub>\1</sub>", text)


def _coordinates(points: Array) -> dict[str, Any]:
    return {axis: _packed(column, "f4") for axis, column in zip("xyz", points.T, strict=True)}


def _packed(values: NDArray[Any], kind: str) -> dict[str, str]:
    """An array of numbers as Plotly reads it, in base64 with 4 bytes per number."""
    data = np.ascontiguousarray(values, dtype=f"<{kind}")
    return {"dtype": kind, "bdata": base64.b64encode(data.tobytes()).decode()}
