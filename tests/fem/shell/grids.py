"""Cells on any surface, for tests with special shapes."""

from typing import NamedTuple

import numpy as np


class Grid(NamedTuple):
    """Nodes `number[i, j]` at u = i / (2 n_u), v = j / (2 n_v); boundaries u=0, u=1, v=0, v=1."""

    points: np.ndarray
    cells: np.ndarray
    boundaries: dict[str, np.ndarray]
    number: np.ndarray


def over(n_u, n_v, surface):
    """`n_u` x `n_v` cells; surface(u, v) gives x, y, z on the unit square."""
    u, v = np.meshgrid(
        np.linspace(0, 1, 2 * n_u + 1), np.linspace(0, 1, 2 * n_v + 1), indexing="ij"
    )
    points = np.stack([np.broadcast_to(x, u.shape) for x in surface(u, v)], axis=-1)
    number = np.arange(u.size).reshape(u.shape)
    corner = number[:-2:2, :-2:2].ravel()
    step_u, step_v = number[1, 0], 1
    at = [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1), (1, 1)]
    cells = np.stack([corner + i * step_u + j * step_v for i, j in at], axis=1)
    lines = {"u=0": number[0], "u=1": number[-1], "v=0": number[:, 0], "v=1": number[:, -1]}
    boundaries = {
        name: np.stack([line[:-2:2], line[2::2], line[1::2]], axis=1)
        for name, line in lines.items()
    }
    return Grid(points.reshape(-1, 3), cells, boundaries, number)


def straightened(grid):
    """The same corners with straight edges between them."""
    points = grid.points.copy()
    corner = points[grid.cells[:, :4]]
    after = np.roll(corner, -1, axis=1)
    points[grid.cells[:, 4:8]] = (corner + after) / 2
    points[grid.cells[:, 8]] = corner.mean(axis=1)
    return grid._replace(points=points)
