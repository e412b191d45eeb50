"""Test whether lines cross each other on the straight path from one state to the next.

A contact stores the side of approach only while the lines are close to each other. A long step
could therefore move one line completely across another, into a state without contact.
"""

import numpy as np
from numpy.typing import NDArray

from fem.beam.section import Array, Indices
from fem.beam.touching_neighbours import Apart, Arcs
from fem.beam.touching_points import powers

SAGITTA = 0.1  # relative to the thickness: largest distance of an element's chords from its curve
ENDS = 1e-9  # relative to a chord: beyond its ends counts as on it


class Passing:
    """Movement of lines since the last accepted state, with elements approximated by chords.

    Excluded are lines that cross in the reference state, and pairs of elements too close to each
    other along the line for contact.
    """

    def __init__(self, arcs: Arcs, apart: Apart, per_element: int, thickness: float) -> None:
        self.elements, self.member = arcs.elements, arcs.member
        self.apart, self.per_element = apart, per_element
        self.sagitta = SAGITTA * thickness

    def start(self, x: Array) -> None:
        self.through = np.zeros((self.member.max() + 1,) * 2, bool)
        self.accept(x)
        chords = self._chords(x)
        one, other = self._near(chords)
        cross = _cross(chords[0, one], chords[0, other])
        one, other = self.member[one[cross]], self.member[other[cross]]
        self.through[one, other] = self.through[other, one] = True

    def accept(self, x: Array) -> None:
        self.accepted = x[:, :2].copy()

    def passed(self, x: Array) -> bool:
        """True if lines passed through each other between the last accepted state and `x`."""
        chords = self._chords(x)
        one, other = self._near(chords)
        ways = (one, other), (other, one)
        return any(_hit(chords[:, own], chords[:, their]) for own, their in ways)

    def _chords(self, x: Array) -> Array:
        """Corners (2, m, s + 1, 2) of the chords of all elements: last accepted state, and `x`."""
        curves = powers(np.stack([self.accepted, x[:, :2]])[:, self.elements])
        bend = np.hypot(*np.moveaxis(curves[..., 2], -1, 0)).max()
        xi = np.linspace(0, 1, 1 + max(1, int(np.ceil(np.sqrt(bend / (4 * self.sagitta))))))
        found: Array = np.einsum("smdp,cp->smcd", curves, xi[:, None] ** np.arange(3))
        return found

    def _near(self, chords: Array) -> tuple[Indices, Indices]:
        """Pairs of elements whose paths are close to each other."""
        low, high = chords.min(axis=(0, 2)), chords.max(axis=(0, 2))
        near = (low[:, None, 0] <= high[:, 0]) & (low[:, None, 1] <= high[:, 1])
        one, other = np.nonzero(np.triu(near & near.T, 1))
        keep = ~self.through[self.member[one], self.member[other]]
        for probe in range(self.per_element):
            keep &= self.apart(self.per_element * one + probe, other)
        return one[keep], other[keep]


def _cross(own: Array, their: Array) -> Indices:
    """Indices of the pairs of chains of chords (k, s + 1, 2) that cross."""
    a, b = own[:, :-1, None], own[:, 1:, None]
    c, d = their[:, None, :-1], their[:, None, 1:]
    around = _turn(b - a, c - a) * _turn(b - a, d - a) < 0
    across = _turn(d - c, a - c) * _turn(d - c, b - c) < 0
    return np.nonzero(around & across)[0]


def _hit(corners: Array, chains: Array) -> bool:
    """True if a corner crosses a chord of its partner; arrays (2, k, s + 1, 2) before and after."""
    p = corners[:, :, :, None]
    a, b = chains[:, :, None, :-1], chains[:, :, None, 1:]
    low, high = np.minimum(a, b).min(axis=0), np.maximum(a, b).max(axis=0)
    pair, corner, chord = np.nonzero(
        ((p.min(axis=0) <= high) & (p.max(axis=0) >= low)).all(axis=-1)
    )
    a, b = chains[:, pair, chord], chains[:, pair, chord + 1]
    along, off = b - a, corners[:, pair, corner] - a
    for time in _times(along, off):
        met = np.flatnonzero((time >= 0) & (time <= 1))
        if _on(along[:, met], off[:, met], time[met, None]).any():
            return True
    return False


def _times(along: Array, off: Array) -> tuple[Array, Array]:
    """Two times (k,) at which a corner is on the line of a chord; nan or inf if there is none."""
    (d, e), (f, g) = (along[0], along[1] - along[0]), (off[0], off[1] - off[0])
    c_0, c_1, c_2 = _turn(d, f), _turn(d, g) + _turn(e, f), _turn(e, g)
    with np.errstate(invalid="ignore", divide="ignore"):
        q = -(c_1 + np.copysign(np.sqrt(c_1**2 - 4 * c_0 * c_2), c_1)) / 2
        return c_0 / q, q / c_2


def _on(along: Array, off: Array, time: Array) -> NDArray[np.bool_]:
    """True where a corner on the line of a chord is between the ends of this chord at `time`."""
    way, at = ((1 - time) * v[0] + time * v[1] for v in (along, off))
    share = (way * at).sum(axis=1) / (way**2).sum(axis=1)
    found: NDArray[np.bool_] = (share >= -ENDS) & (share <= 1 + ENDS)
    return found


def _turn(a: Array, b: Array) -> Array:
    """Cross products of a and b; positive if b points to the left of a."""
    found: Array = a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
    return found
