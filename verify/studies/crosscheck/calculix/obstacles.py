"""Rigid obstacles without a mesh, as strips of elements with fixed nodes."""

import math
from dataclasses import dataclass

import numpy as np

from fem.contact.pairs import Obstacle
from fem.contact.shapes import Circle
from verify.studies.crosscheck.calculix.keywords import Array, Indices, Side

CELLS = 200  # along a circle's strip
RINGS = 60  # of a flat around a turn
BEYOND = 1.5  # length of the obstacle over the range of possible contact


@dataclass(frozen=True)
class Strip:
    """Nodes `x` (n, 2) and eight-node `cells` (m, 8) of a strip, both counted from 0.

    Side 1 of each cell is the surface of the obstacle.
    """

    x: Array
    cells: Indices
    centre: tuple[float, float]

    def sides(self, first: int) -> list[Side]:
        """Contact side of each cell, with cell numbers that begin at `first`."""
        return [(first + k, 1) for k in range(len(self.cells))]

    def moved(self, motion: tuple[float, float, float]) -> Array:
        """Displacements (n, 2) under a small motion: x, y and a rotation about the centre."""
        arm = self.x - self.centre
        return np.asarray(motion[:2]) + motion[2] * np.column_stack([-arm[:, 1], arm[:, 0]])


def strip_of(obstacle: Obstacle, slave: Array, *, turn: bool = False) -> Strip:
    """Strip of elements where the points `slave` (2, m) may touch the obstacle.

    With `turn` (axisymmetric problems), the strip begins at the axis. Raises ValueError for a
    circle in an axisymmetric problem.
    """
    shape = obstacle.shape
    foot = shape.project(slave)
    depth = float(np.ptp(slave, axis=1).max())
    if isinstance(shape, Circle):
        if turn:
            raise ValueError("obstacles in an axisymmetric problem must be flat, got a circle")
        centre = np.array(shape.centre)[:, None]
        around: Array = np.unwrap(np.sort(np.arctan2(*(foot - centre)[::-1])))
        middle = (around[-1] + around[0]) / 2
        half = min(BEYOND * (around[-1] - around[0]) / 2, math.pi / 3)
        angles = np.linspace(middle - half, middle + half, 2 * CELLS + 1)
        rays = np.array([np.cos(angles), np.sin(angles)])
        out = shape.radius * rays
        back = (shape.radius + depth if shape.hollow else shape.radius / 2) * rays
        return _strip((out + centre).T, (back + centre).T, obstacle.centre)
    n = shape.normal(foot)[:, 0]
    t = np.array([n[1], -n[0]])
    along = t @ foot
    middle, half = (along.max() + along.min()) / 2, BEYOND * max(np.ptp(along) / 2, depth / 2)
    start = foot[:, 0] + t * (middle - along[0])
    out = start + np.linspace(half, -half, 3)[:, None] * t
    if turn:
        depth /= RINGS  # of the first cells, which are short
        out = _from_axis(RINGS * depth * BEYOND)[:, None] * np.abs(t) + [0.0, out[0, 1]]
    return _strip(out, out - depth * n, obstacle.centre)


def _from_axis(reach: float) -> Array:
    """Radii of nodes; near the axis, calculix would miss contacts if element faces were wide."""
    r = np.zeros(2 * RINGS + 1)
    r[::2] = reach * np.linspace(0.0, 1.0, RINGS + 1) ** 2
    r[1::2] = (r[:-1:2] + r[2::2]) / 2
    return r


def _strip(out: Array, back: Array, centre: tuple[float, float]) -> Strip:
    """Strip of cells between two rows (2 k + 1, 2) of nodes; side 1 of each cell is on `out`."""
    if _turns(out, back):
        out, back = out[::-1], back[::-1]
    n = len(out)
    middle = (out[::2] + back[::2]) / 2
    x = np.vstack([out, back, middle])
    k = np.arange(0, n - 1, 2)
    cells = np.column_stack([
        k, k + 2, n + k + 2, n + k, k + 1, 2 * n + k // 2 + 1, n + k + 1, 2 * n + k // 2,
    ])  # fmt: skip
    return Strip(x, cells, centre)


def _turns(out: Array, back: Array) -> bool:
    """Whether the node order of cells along `out` would be clockwise."""
    (a, b), (c, d) = out[2] - out[0], back[0] - out[0]
    return bool(a * d - b * c < 0)
