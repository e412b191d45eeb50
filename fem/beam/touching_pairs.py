"""Probes and the nearest points of other elements, on either side of a line."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from fem.beam.section import Array, Indices
from fem.beam.terms import Positions
from fem.beam.touching_closest import closest, least
from fem.beam.touching_neighbours import Apart
from fem.beam.touching_points import Probes, on, positions, powers

BULGE = 1.2  # of an element beyond the circle through its nodes
CLEAR = 0.5  # sine of the angle from which a place lies clearly on one side of a line
REACH = 4.0  # thicknesses around a line that are searched for others
NEAR = 1.5  # the same: lines at a larger distance need no exact place
TINY = 1e-300


@dataclass(frozen=True)
class Meeting:
    """Points of elements that are nearest to k probes, on the right or left side of the probe.

    The slot number is 2 probe + side. The nearest point is `xi` on `element`; the position of the
    probe is `eta` on its element. `n` (k, 2) is the direction from the nearest point to the probe,
    normal to the element except at an `end`. `distance` along n is negative if the lines have
    crossed since the last accepted state. `held` is True if eta is at a bound of the cell of the
    probe. `eased` is the addition to the gap, `easing` its derivative with respect to eta.
    """

    slot: Indices
    element: Indices
    eta: Array
    xi: Array
    n: Array
    distance: Array
    end: NDArray[np.bool_]
    held: NDArray[np.bool_]
    eased: Array
    easing: Array

    def chosen(self, which: NDArray[np.bool_] | Indices) -> "Meeting":
        return Meeting(*(getattr(self, name)[which] for name in self.__dataclass_fields__))

    def sharpened(self, x: Positions, probes: Probes, elements: Indices) -> "Meeting":
        """Nearest points with distances in the full precision of the positions `x`."""
        at = x[:, :2].astype(np.longdouble)
        here = positions(at, probes.nodes[self.slot // 2], self.eta)
        away = here - positions(at, elements[self.element], self.xi)
        return replace(self, distance=np.copysign(np.hypot(*away.T), self.distance).astype(float))


class Pairs:
    """Pairs of a probe and an element that may touch before the next search."""

    def __init__(self, elements: Indices, probes: Probes, apart: Apart, touching: float) -> None:
        self.elements, self.probes, self.apart = elements, probes, apart
        self.last: tuple[Array, Meeting] | None = None
        self.touching, self.reach = touching, REACH * touching

    def accept(self, x: Array) -> None:
        """Determine from the accepted state `x` on which side of each element a probe lies."""
        self.last = None
        self.accepted = x[:, :2].copy()
        self._look_round(self.accepted)

    def nearest(self, x: Array) -> Meeting:
        """Nearest element within reach at the positions `x`, for each side of a probe (slot)."""
        at = x[:, :2]
        if self.last and np.array_equal(at, self.last[0]):
            return self.last[1]
        if np.abs(at - self.seen).max(initial=0.0) > self.reach / 4:
            self._look_round(at)
        found = self._nearest(at)
        self.last = at.copy(), found
        return found

    def _nearest(self, at: Array) -> Meeting:
        curves = powers(at[self.elements])
        eta = self._least(curves)
        met = self._meet(curves, np.arange(self.slot.size), eta)
        if not met.slot.size:
            return met
        first = np.flatnonzero(np.diff(met.slot, prepend=-1))
        count = np.diff(np.append(first, met.slot.size))
        away = np.abs(met.distance)
        best = np.flatnonzero(away <= np.repeat(np.minimum.reduceat(away, first), count))
        # ties: at a node of two elements
        return met.chosen(best[np.diff(met.slot[best], prepend=-1) > 0])

    def _least(self, curves: Array) -> Array:
        """Position eta of the smallest distance of each pair; for distant pairs, middle of cell."""
        p = self.probes
        eta = p.middle[self.probe]
        met = self._meet(curves, np.arange(self.slot.size), eta)
        half = p.length[self.probe] / 2
        near = np.flatnonzero(met.distance < NEAR * self.touching + half)

        def rise(eta: Array, rows: Indices) -> tuple[Array, Array]:
            """Distance plus additional gap, and the derivative of this sum with respect to eta."""
            pair = near[rows]
            probe = self.probe[pair]
            here, own = on(curves[p.element[probe]], eta)
            n, distance = self._towards(pair, *_project(curves[self.element[pair]], here)[1:])
            easing, eased = self._easing(probe, eta)
            return distance + eased, np.einsum("kd,kd->k", n, own) + easing

        cell = self.probe[near]
        eta[near] = least(p.lower[cell], p.upper[cell], rise, NEAR * self.touching)
        return eta

    def _meet(self, curves: Array, pair: Indices, eta: Array) -> Meeting:
        """For each pair, the point of the element nearest to the position `eta` of the probe."""
        probe, element = self.probe[pair], self.element[pair]
        here, _ = on(curves[self.probes.element[probe]], eta)
        xi, d, tangent, across, end = _project(curves[element], here)
        n, distance = self._towards(pair, d, tangent, across, end)
        held = (eta == self.probes.lower[probe]) | (eta == self.probes.upper[probe])
        easing, eased = self._easing(probe, eta)
        return Meeting(self.slot[pair], element, eta, xi, n, distance, end, held, eased, easing)

    def _easing(self, probe: Indices, eta: Array) -> tuple[Array, Array]:
        """Derivative of the additional gap with respect to eta, and the additional gap."""
        off = eta - self.probes.middle[probe]
        easing = self.probes.ease[probe] * off
        return easing, easing * off / 2

    def _towards(
        self, pair: Indices, d: Array, tangent: Array, across: Array, end: NDArray[np.bool_]
    ) -> tuple[Array, Array]:
        """Direction n towards the probe of each pair, and the distance along n."""
        distance = np.maximum(np.hypot(*d.T), TINY)
        left = np.column_stack([-tangent[:, 1], tangent[:, 0]])
        clear, before = self.clear[pair], self.side[pair]
        side = np.where(clear, before, np.sign(across))
        n = side[:, None] * left
        corner = end | (side == 0)
        crossed = clear & (before * across < -CLEAR * distance)
        signed = np.where(corner, np.where(crossed, -distance, distance), side * across)
        n[corner] = d[corner] / signed[corner, None]
        return n, signed

    def _look_round(self, at: Array) -> None:
        """List candidate pairs near the positions `at`, with their sides in the accepted state."""
        self.seen = at.copy()
        p = self.probes
        corners = at[self.elements]
        here, _ = on(powers(corners)[p.element], p.middle)
        centre = (corners.min(axis=1) + corners.max(axis=1)) / 2
        radius = BULGE * np.hypot(*np.moveaxis(corners - centre[:, None], -1, 0)).max(axis=1)
        half = p.length / 2
        found = cKDTree(here).query_ball_point(centre, radius + self.reach + half.max())
        element = np.repeat(np.arange(len(centre)), [len(own) for own in found])
        probe = np.concatenate([np.asarray(own, int) for own in found])
        away = np.hypot(*(here[probe] - centre[element]).T)
        keep = (away < radius[element] + self.reach + half[probe]) & self.apart(probe, element)
        probe, element = probe[keep], element[keep]
        before = powers(self.accepted[self.elements])
        there, own = on(before[p.element[probe]], p.middle[probe])
        _, d, _, across, _ = _project(before[element], there)
        slot = 2 * probe + (own[:, 0] * -d[:, 1] + own[:, 1] * d[:, 0] > 0)
        order = np.argsort(slot, kind="stable")
        self.slot, self.probe, self.element = slot[order], probe[order], element[order]
        self.side = np.sign(across)[order]
        self.clear = (np.abs(across) > CLEAR * np.hypot(*d.T))[order]


def _project(curve: Array, here: Array) -> tuple[Array, Array, Array, Array, NDArray[np.bool_]]:
    """Nearest point xi of each curve, vector to `here`, unit tangent, offset, and True at ends."""
    xi = closest(curve, here)
    there, slope = on(curve, xi)
    d = here - there
    tangent = slope / np.hypot(*slope.T)[:, None]
    across = tangent[:, 0] * d[:, 1] - tangent[:, 1] * d[:, 0]
    return xi, d, tangent, across, (xi == 0.0) | (xi == 1.0)
