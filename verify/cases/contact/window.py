"""The part of a mesh about a contact, for pictures."""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from verify.core.figures import Array


def cut(
    cells: Mapping[str, Array], inside: Callable[[Array], Array]
) -> tuple[dict[str, Any], NDArray[np.int64]]:
    """Points, cells and data of the cells of which `inside` is true by their centres (m, 2).

    Beside them the numbers of the points that are left.
    """
    corners = cells["cells"].astype(np.int64)
    kept = np.flatnonzero(inside(cells["points"][corners].mean(axis=1)))
    used, corners = np.unique(corners[kept], return_inverse=True)
    left = {"points": cells["points"][used], "cells": corners.reshape(kept.size, -1),
            "displacement": cells["displacement"][used],
            "stress": cells["stress"][kept], "von_mises": cells["von_mises"][kept]}  # fmt: skip
    return left, used
