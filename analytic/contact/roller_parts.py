"""Evaluation of pressures and line loads that are given on parts of equal length of a roller."""

from dataclasses import dataclass

import numpy as np

from analytic.contact.checks import Array


@dataclass(frozen=True, kw_only=True)
class RollerParts:
    """Pressure at x = 0 and line load at the centres y of equal parts of a roller, shape (n,).

    `length` is the length of the roller, d [length] that of an end zone; y is measured from
    mid-length.
    """

    y: Array
    p: Array  # [stress]
    line: Array  # [force/length]
    delta: float  # approach [length]
    length: float
    d: float

    @property
    def width(self) -> float:
        """Length of one part."""
        return self.length / len(self.y)

    @property
    def p_max(self) -> float:
        """Largest pressure outside end zones, by the parabola through three neighbouring parts."""
        limit = self.length / 2 - self.d
        at = self.place
        return float(max(vertex(self.p, at), *np.interp([-limit, limit], self.y, self.p)))

    @property
    def place(self) -> int:
        """Index of the part with the largest pressure outside the end zones."""
        inner = np.abs(self.y) <= self.length / 2 - self.d
        return int(np.argmax(np.where(inner, self.p, -1.0)))

    @property
    def p_mid(self) -> float:
        """Pressure at mid-length; between two parts, the root mean square of their pressures."""
        n = len(self.p)
        return float(np.sqrt((self.p[(n - 1) // 2] ** 2 + self.p[n // 2] ** 2) / 2))

    @property
    def q_mid(self) -> float:
        """Line load [force/length] at mid-length."""
        return float(np.mean(self.line[[(len(self.y) - 1) // 2, len(self.y) // 2]]))

    @property
    def p_top(self) -> float:
        """Largest pressure of the whole roller, ends included."""
        return vertex(self.p, int(np.argmax(self.p)))

    @property
    def ends(self) -> tuple[float, float]:
        """Loads [force] of the end zones at -l/2 and l/2; a cut part counts in proportion.

        >>> y, load = np.array([-1.5, -0.5, 0.5, 1.5]), np.array([1.0, 2.0, 3.0, 4.0])
        >>> RollerParts(y=y, p=load, line=load, delta=0.0, length=4.0, d=1.5).ends
        (2.0, 5.5)
        """
        share = np.clip(self.d / self.width - np.arange(len(self.y)), 0.0, 1.0)
        force = self.line * self.width
        return float(share @ force), float(share[::-1] @ force)


Parts = RollerParts  # its name in version 0.1


def vertex(p: Array, at: int) -> float:
    """Vertex of the parabola through p[at] and its two neighbours; p[at] if there is no maximum."""
    below, top, above = np.pad(p, 1)[at : at + 3]
    bend = below - 2 * top + above
    if min(below, above) <= 0 or top < max(below, above) or bend >= 0:  # it may go on rising
        return float(top)
    return float(top - (above - below) ** 2 / (8 * bend))


def load_elsewhere(line: Array, other: Array, length: float) -> tuple[float, float]:
    """Fraction of the load by which `line` (n,) differs from `other` (m,), and relative L2 error.

    `line` and `other` are line loads on parts of equal length of the roller. The fraction hardly
    depends on the number of parts; the L2 error is mostly due to the parts at the end of contact.

    >>> load_elsewhere(np.array([2.0, 0.0]), np.ones(8), 1.0)
    (0.5, 1.0)
    """
    n = len(line)
    edges = np.linspace(-length / 2, length / 2, n + 1)
    stations = np.linspace(-length / 2, length / 2, len(other) + 1)
    total = np.concatenate([[0.0], np.cumsum(other) * (length / len(other))])
    reference = np.diff(np.interp(edges, stations, total)) * (n / length)
    off = line - reference
    share = float(np.abs(off).sum() / reference.sum() / 2)
    return share, float(np.linalg.norm(off) / np.linalg.norm(reference))
