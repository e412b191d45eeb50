"""Probes and the nearest places of other elements, on either side of a line."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from fem.beam.section import Array, Indices
from fem.beam.touching_closest import closest
from fem.beam.touching_neighbours import Apart
from fem.beam.touching_points import Probes, shapes

BULGE = 1.2  # of an element beyond the circle through its nodes
CLEAR = 0.5  # sine of the angle from which a place lies clearly on one side of a line
TINY = 1e-300


@dataclass(frozen=True)
class Meeting:
    """The nearest place of an element for k slots (a probe's right or left: 2 probe + side).

    `xi` on `element`; `n` (k, 2) from there towards the probe, across the element except at an
    `end`; `distance` along n, negative where the lines crossed since the last accepted state.
    """

    slot: Indices
    element: Indices
    xi: Array
    n: Array
    distance: Array
    end: NDArray[np.bool_]

    def chosen(self, which: NDArray[np.bool_] | Indices) -> "Meeting":
        return Meeting(*(getattr(self, name)[which] for name in self.__dataclass_fields__))


class Pairs:
    """Candidates: pairs of a probe and an element that may touch before the next look-round."""

    def __init__(self, elements: Indices, probes: Probes, apart: Apart, reach: float) -> None:
        self.elements, self.probes, self.apart, self.reach = elements, probes, apart, reach

    def accept(self, x: Array) -> None:
        """From now on sides are those of the state `x`."""
        self.accepted = x[:, :2].copy()
        self._look_round(self.accepted)

    def nearest(self, x: Array) -> Meeting:
        """Every slot's nearest element within reach at `x`."""
        at = x[:, :2]
        if np.abs(at - self.seen).max(initial=0.0) > self.reach / 4:
            self._look_round(at)
        xi, d, tangent, across, end = self._project(at, self.probe, self.element)
        distance = np.maximum(np.hypot(*d.T), TINY)
        left = np.column_stack([-tangent[:, 1], tangent[:, 0]])
        side = np.where(self.clear, self.side, np.sign(across))
        n = side[:, None] * left
        corner = end | (side == 0)
        crossed = self.clear & (self.side * across < -CLEAR * distance)
        signed = np.where(corner, np.where(crossed, -distance, distance), side * across)
        n[corner] = d[corner] / signed[corner, None]
        if not self.slot.size:
            return Meeting(self.slot, self.element, xi, n, signed, end)
        first = np.flatnonzero(np.diff(self.slot, prepend=-1))
        least = np.repeat(
            np.minimum.reduceat(distance, first), np.diff(np.append(first, self.slot.size))
        )
        best = np.flatnonzero(distance <= least)
        best = best[np.diff(self.slot[best], prepend=-1) > 0]  # ties: at a node of two elements
        return Meeting(self.slot, self.element, xi, n, signed, end).chosen(best)

    def _look_round(self, at: Array) -> None:
        """Lists the candidates around the positions `at`, with their sides when last accepted."""
        self.seen = at.copy()
        corners, here = at[self.elements], self._places(at)
        centre = (corners.min(axis=1) + corners.max(axis=1)) / 2
        radius = BULGE * np.hypot(*np.moveaxis(corners - centre[:, None], -1, 0)).max(axis=1)
        found = cKDTree(here).query_ball_point(centre, radius + self.reach)
        element = np.repeat(np.arange(len(centre)), [len(own) for own in found])
        probe = np.concatenate([np.asarray(own, int) for own in found])
        keep = self.apart(probe, element)
        probe, element = probe[keep], element[keep]
        _, d, _, across, _ = self._project(self.accepted, probe, element)
        p = self.probes
        own = np.einsum("kp,kpd->kd", p.slope[probe], self.accepted[p.nodes[probe]])
        slot = 2 * probe + (own[:, 0] * -d[:, 1] + own[:, 1] * d[:, 0] > 0)
        order = np.argsort(slot, kind="stable")
        self.slot, self.probe, self.element = slot[order], probe[order], element[order]
        self.side = np.sign(across)[order]
        self.clear = (np.abs(across) > CLEAR * np.hypot(*d.T))[order]

    def _places(self, at: Array) -> Array:
        return np.einsum("kp,kpd->kd", self.probes.shape, at[self.probes.nodes])

    def _project(
        self, at: Array, probe: Indices, element: Indices
    ) -> tuple[Array, Array, Array, Array, NDArray[np.bool_]]:
        """xi, vector to the probe, unit tangent, offset to its left, whether xi is an end."""
        corners, place = at[self.elements[element]], self._places(at)[probe]
        xi = closest(corners, place)
        N, slope, _ = shapes(xi, self.elements.shape[1])
        d = place - np.einsum("kp,kpd->kd", N, corners)
        tangent = np.einsum("kp,kpd->kd", slope, corners)
        tangent /= np.hypot(*tangent.T)[:, None]
        across = tangent[:, 0] * d[:, 1] - tangent[:, 1] * d[:, 0]
        return xi, d, tangent, across, (xi == 0.0) | (xi == 1.0)
