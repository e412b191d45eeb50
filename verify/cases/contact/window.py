"""Values and fields of contacts in results, by name."""

from collections.abc import Mapping
from typing import Any, TypeVar

import numpy as np

from verify.core.figures import Array, Field

T = TypeVar("T")
Data = Mapping[str, tuple[Array, str]]  # values and their unit


def named(found: Mapping[str, T], end: str) -> dict[str, T]:
    """The mapping `found` of numbers or arrays, with `end` appended to each name."""
    return {f"{key}{end}": value for key, value in found.items()}


def field(name: str, cells: Mapping[str, Any], data: Data, at_nodes: Data | None = None) -> Field:
    """Field of `cells`: displacements, values `data` of cells, and values `at_nodes` of nodes."""
    nodes = at_nodes or {}
    return Field(
        name=name, points=cells["points"], cells=cells["cells"].astype(np.int64),
        point_data={"displacement": cells["displacement"], **{k: v for k, (v, _) in nodes.items()}},
        cell_data={k: v for k, (v, _) in data.items()},
        units={"displacement": "m", **{k: unit for k, (_, unit) in {**data, **nodes}.items()}},
    )  # fmt: skip


def grid(name: str, x: Array, y: Array, pressure: Array) -> Field:
    """Field of `pressure` [Pa], shape (n m,), on cells between n + 1 values of x and m + 1 of y."""
    points = np.column_stack([a.ravel() for a in np.meshgrid(x, y, indexing="ij")])
    i = np.arange(len(x) - 1)[:, None] * len(y) + np.arange(len(y) - 1)
    cells = np.stack([i, i + 1, i + len(y) + 1, i + len(y)], axis=-1).reshape(-1, 4)
    return Field(
        name=name, points=points, cells=cells.astype(np.int64),
        cell_data={"pressure": pressure}, units={"pressure": "Pa"},
    )  # fmt: skip
