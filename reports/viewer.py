"""A line field extended to a ribbon that can be rotated: data for templates/viewer.js."""

import base64
import json
from typing import Any

import numpy as np
from markupsafe import Markup

from reports import ramps
from reports.bodies import body
from reports.scene import exaggeration
from verify.core.figures import Field, Picture

WIDEST_INDEX = 65535  # that 16 bits hold
STEPS = 20  # of the slider up to the displacement as drawn


def viewer(field: Field, picture: Picture) -> Markup:
    """HTML of the view; colours and range are those of the two-dimensional picture of the field.

    The page must contain templates/viewer.js once, and a colour bar if the picture beside the view
    has none. Raises ValueError for fields other than plane lines with `Picture.width`.
    """
    if field.points.shape[1] != 2 or field.cells.shape[-1] != 2:
        raise ValueError(f"field {field.name!r}: a ribbon requires lines in a plane")
    if not picture.width:
        raise ValueError(f"field {field.name!r}: a ribbon requires a width")
    shown = body(field, picture)
    by = exaggeration(shown)
    values = shown.values
    scale = ramps.plain() if values is None else ramps.scale(values)
    shares = np.zeros(len(shown.cells)) if values is None else scale.shares(values)
    wide = len(shown.points) > WIDEST_INDEX
    packed = {
        "points": _base64(shown.points[:, :2], "<f4"),
        "displacement": _base64(shown.displacement[:, :2], "<f4"),
        "shares": _base64(shares, "<f4"),
        "cells": _base64(shown.cells, "<u4" if wide else "<u2"),
        "wide": wide, "width": picture.width, "ramp": scale.stops or (ramps.PLAIN,),
    }  # fmt: skip
    return Markup(
        '<div class="view"><canvas tabindex="0" role="application" aria-label="{}: view in space. '
        'Arrow keys or dragging rotate it, plus and minus zoom, R resets."></canvas>'
        '<script type="application/json">{}</script>'
        '<p class="controls"><label>Displacement <input type="range" min="0" max="{}" step="{}" '
        'value="{}"></label> <output>× {}</output> <span>Rotate by dragging or by the arrow keys; '
        "zoom by + and −; reset by R.</span></p></div>"
    ).format(
        picture.caption, _plain(packed), *(f"{x:g}" for x in (2 * by, by / STEPS or 1, by, by))
    )


def _base64(values: np.ndarray[Any, Any], kind: str) -> str:
    return base64.b64encode(np.ascontiguousarray(values, dtype=kind).tobytes()).decode()


def _plain(data: Any) -> Markup:
    """JSON for a script element: numbers, base64 texts and colours, which cannot end it."""
    return Markup(json.dumps(data).replace("<", "\\u003c"))  # noqa: S704
