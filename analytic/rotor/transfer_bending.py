"""Dynamic bending stiffness of a whole rotor, from the exact stiffness of its pieces.

The unknowns are (r, phi L) at the stations and between pieces; the length L scales the entries.
Bearings that differ in x and y couple the parts of r = r+ e^{i omega t} + conj(r-) e^{-i omega t}.
Their force k r + d conj(r) has the matrix (k, d; conj d, k) for (r+, r-). The matrix of the rotor
for r- is that at -omega.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.rotor.transfer_model import (
    Segment,
    Spring,
    StationLink,
    StationSupport,
    TransferMatrixRotor,
)
from analytic.rotor.transfer_segment import dynamic_stiffness, pieces

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


@dataclass(frozen=True)
class Bending:
    """Rotor whose segments are divided into equal pieces; `parts` are the numbers of pieces.

    The pieces are so short that no clamped piece has a natural frequency in the range of `up_to`.
    """

    rotor: TransferMatrixRotor
    parts: tuple[int, ...]

    @staticmethod
    def up_to(rotor: TransferMatrixRotor, w: ArrayLike, Omega: ArrayLike) -> "Bending":
        """Divide the rotor for frequencies from 0 to `w` [rad/s] at the rotor speeds `Omega`."""
        s, b, t = numbers(rotor, w, Omega)
        parts = pieces(s=s, b=b, t=t).reshape(-1, s.shape[-1]).max(axis=0)
        return Bending(rotor, tuple(int(n) for n in parts))

    @cached_property
    def segments(self) -> tuple[Segment, ...]:
        return tuple(s for shaft in self.rotor.shafts for s in shaft.segments)

    @cached_property
    def length(self) -> float:
        """Mean length L [m] of the segments, by which the rotations phi are multiplied."""
        return float(np.mean([s.length for s in self.segments]))

    @cached_property
    def ends(self) -> NDArray[np.int64]:
        """Node indices (pieces, 2) of the near and far ends of the pieces.

        Stations have the first indices; the nodes between pieces of one segment follow.
        """
        first = [k for k, _ in stations_of(self.rotor)]
        found, cut = [], self.rotor.stations
        for near, count in zip(first, self.parts, strict=True):
            chain = [near, *range(cut, cut + count - 1), near + 1]
            cut += count - 1
            found += list(pairwise(chain))
        return np.array(found)

    @property
    def nodes(self) -> int:
        return self.rotor.stations + sum(self.parts) - len(self.parts)

    @cached_property
    def springs(self) -> Array:
        """Stiffness matrix (n, n) [N/m] of all bearings, mean of x and y.

        n is twice the number of nodes.
        """
        return self._lumped([s.stiffness[0] for s in self.bearings],
                            [s.k_tilt for s in self.bearings]).real  # fmt: skip

    @cached_property
    def deviator(self) -> Complex:
        """Stiffness (n, n) [N/m] that multiplies conj(r); 0 if bearings are equal in x and y."""
        return self._lumped([s.stiffness[1] for s in self.bearings], [0.0] * len(self.bearings))

    @cached_property
    def dampers(self) -> tuple[Complex, Complex]:
        """Mean and deviator of the damping matrices of the bearings, each (n, n) [N s/m]."""
        mean = self._lumped([s.damping[0] for s in self.bearings],
                            [s.c_tilt for s in self.bearings])  # fmt: skip
        other = self._lumped([s.damping[1] for s in self.bearings], [0.0] * len(self.bearings))
        return mean, other

    @property
    def bearings(self) -> tuple[Spring, ...]:
        return (*self.rotor.supports, *self.rotor.links)

    def stiffness(self, w: ArrayLike, Omega: ArrayLike) -> Array:
        """Dynamic stiffness D(w, Omega) (m, n, n), isotropic bearings; backward whirl has w < 0."""
        w, Omega = (np.atleast_1d(np.asarray(v, dtype=np.float64)) for v in (w, Omega))
        D = np.repeat(self.springs[None], w.size, axis=0)
        self._add_pieces(D, w, Omega)
        ratio = np.array([shaft.ratio for shaft in self.rotor.shafts])
        for disc in self.rotor.discs:
            r, phi = 2 * disc.node, 2 * disc.node + 1
            spin = ratio[self.rotor.shaft_of[disc.node]] * Omega
            D[:, r, r] -= disc.mass * w**2
            D[:, phi, phi] -= (disc.diametral * w**2 - disc.polar * spin * w) / self.length**2
        return D

    def coupled(self, w: ArrayLike, Omega: ArrayLike, *, damped: bool = False) -> Array | Complex:
        """Dynamic stiffness of (r+, r-), (m, 2n, 2n); Hermitian without damping."""
        w = np.atleast_1d(np.asarray(w, dtype=np.float64))
        n = 2 * self.nodes
        turned = damped or self.deviator.imag.any()
        other = self.deviator if turned else self.deviator.real
        D: Array | Complex = np.empty((w.size, 2 * n, 2 * n))
        if turned:
            D = D.astype(np.complex128)
        D[:, :n, :n], D[:, n:, n:] = self.stiffness(w, Omega), self.stiffness(-w, Omega)
        D[:, :n, n:], D[:, n:, :n] = other, other.conj()
        if damped:
            c, e = self.dampers
            C = np.block([[c, e], [e.conj(), c]])
            D += 1j * w[:, None, None] * C
        return D

    def _add_pieces(self, D: Array, w: Array, Omega: Array) -> None:
        s, b, t = numbers(self.rotor, w, Omega)
        n = np.array(self.parts, dtype=np.float64)
        blocks = dynamic_stiffness(s=s * n**2, b=b / n**4, t=t / n**2)
        long = np.array([seg.length for seg in self.segments]) / n
        turn = np.stack([np.ones_like(long), long / self.length], axis=-1)
        scale = np.tile(turn, 2)
        EI = np.array([seg.E * seg.I for seg in self.segments])
        blocks *= (EI / long**3)[:, None, None] * scale[:, :, None] * scale[:, None, :]
        blocks = np.repeat(blocks, self.parts, axis=1)
        at = 2 * self.ends[..., None] + np.arange(2)  # (pieces, end, unknown)
        for a in range(2):
            for c in range(2):  # a node is the near end of one piece at most, and the far one
                rows, columns = at[:, a, :, None], at[:, c, None, :]
                D[:, rows, columns] += blocks[..., 2 * a : 2 * a + 2, 2 * c : 2 * c + 2]

    def _lumped(self, lateral: Sequence[complex], tilt: Sequence[float]) -> Complex:
        found = np.zeros((2 * self.nodes, 2 * self.nodes), dtype=np.complex128)
        for spring, k, turn in zip(self.bearings, lateral, tilt, strict=True):
            values = np.array([k, turn / self.length**2])
            for a, c, sign in pairs(spring):
                found[[2 * a, 2 * a + 1], [2 * c, 2 * c + 1]] += sign * values
        return found


def pairs(spring: Spring) -> tuple[tuple[int, int, float], ...]:
    """Rows, columns and signs of the entries of a bearing in a stiffness matrix of the stations."""
    if isinstance(spring, StationSupport):
        return ((spring.node, spring.node, 1.0),)
    assert isinstance(spring, StationLink)
    a, b = spring.a, spring.b
    return (a, a, 1.0), (b, b, 1.0), (a, b, -1.0), (b, a, -1.0)


def stations_of(rotor: TransferMatrixRotor) -> list[tuple[int, int]]:
    """Index of the near station and index of the shaft, for each segment."""
    found, node = [], 0
    for k, shaft in enumerate(rotor.shafts):
        found += [(node + j, k) for j in range(len(shaft.segments))]
        node += len(shaft.segments) + 1
    return found


def numbers(
    rotor: TransferMatrixRotor, w: ArrayLike, Omega: ArrayLike
) -> tuple[Array, Array, Array]:
    """Dimensionless numbers s, b, t (m, segments) of undivided segments; see `transfer_segment`."""
    w = np.asarray(w, dtype=np.float64)[..., None]
    spin = np.asarray(Omega, dtype=np.float64)[..., None] * np.array(
        [shaft.ratio for shaft in rotor.shafts for _ in shaft.segments]
    )
    segments = [s for shaft in rotor.shafts for s in shaft.segments]
    long, EI, A, rho, E, kGA = (
        np.array(values) for values in zip(*(
            (s.length, s.E * s.I, s.A, s.rho, s.E, s.shear * s.G * s.A) for s in segments
        ), strict=True)
    )  # fmt: skip
    sheared, inert = rotor.theory == "timoshenko", rotor.theory != "euler"
    s = EI / (kGA * long**2) * sheared
    b = rho * A * w**2 * long**4 / EI
    t = rho * long**2 / E * (w**2 - 2 * spin * w) * inert
    return np.broadcast_to(s, b.shape), b, t
