"""Stepped shaft as a Timoshenko beam, with nominal diameters or by the 45° rule.

By the 45° rule, the diameter for the stiffness of the thick part is d_1 plus twice the distance
from the nearer step, but at most d_2: the corners of the thick part carry no load. The masses
are the real masses.
"""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from analytic.rotor.transfer_model import (
    Segment,
    SegmentedShaft,
    StationDisc,
    StationSupport,
    TransferMatrixRotor,
)

SLICES = 16  # number of slices of a cone; each slice has its mean diameter
SMALLEST = 1e-9  # relative to the length: a shorter piece is caused by round-off


@dataclass(frozen=True)
class Piece:
    """Piece of a shaft: length, diameter, and diameter for the stiffness [m]."""

    length: float
    d: float
    d_stiff: float


@dataclass(frozen=True, kw_only=True)
class SteppedShape:
    """Shaft of length L and diameter d_1; its thick part (d_2, L_2) begins at `start` [m].

    Bearings act at the two `seats` [m], both outside the thick part.
    """

    L: float
    d_1: float
    d_2: float
    L_2: float
    start: float
    seats: tuple[float, float]

    @property
    def reach(self) -> float:
        """Distance [m] from a step up to which the 45° rule reduces the stiffness."""
        return min((self.d_2 - self.d_1) / 2, self.L_2 / 2)

    def pieces(self, *, cone: bool, slices: int = SLICES) -> tuple[Piece, ...]:
        """Pieces from end to end, with stations at the seats; if `cone`, stiffness by the 45° rule.

        >>> shape = SteppedShape(L=8.0, d_1=1.0, d_2=3.0, L_2=4.0, start=2.0, seats=(0.5, 7.5))
        >>> [(p.length, p.d_stiff) for p in shape.pieces(cone=False)]
        [(0.5, 1.0), (1.5, 1.0), (4.0, 3.0), (1.5, 1.0), (0.5, 1.0)]
        >>> [p.d_stiff for p in shape.pieces(cone=True, slices=1)]
        [1.0, 1.0, 2.0, 3.0, 2.0, 1.0, 1.0]
        """
        reach = self.reach if cone else 0.0
        first, last = self.start, self.start + self.L_2
        slope = reach * np.linspace(0, 1, slices + 1) if cone else np.zeros(1)
        z = np.concatenate([
            [0.0, self.seats[0]], first + slope, last - slope[::-1], [self.seats[1], self.L]
        ])  # fmt: skip
        found = []
        for low, high in pairwise(z):
            if high - low <= SMALLEST * self.L:
                continue
            middle = (low + high) / 2
            thick = first < middle < last
            d = self.d_2 if thick else self.d_1
            depth = min(middle - first, last - middle)
            stiff = min(d, self.d_1 + 2 * depth) if cone and thick else d
            found.append(Piece(float(high - low), d, float(stiff)))
        return tuple(found)


def stepped_beam(
    shape: SteppedShape, *, E: float, nu: float, rho: float, k: float, cone: bool = False,
    slices: int = SLICES,
) -> TransferMatrixRotor:  # fmt: skip
    """Rotor model of the shaft on two bearings with the radial stiffness k [N/m].

    The reduced stiffness diameters of a cone have too little rotary inertia. The difference is
    added as discs at the ends of the slices.
    """
    segments, lumps, node = [], [], 0
    for i, piece in enumerate(shape.pieces(cone=cone, slices=slices)):
        share = (piece.d / piece.d_stiff) ** 2  # ratio of the areas; it preserves the mass
        segments.append(
            Segment(length=piece.length, d_o=piece.d_stiff, E=E, nu=nu, rho=rho * share)
        )
        missing = np.pi / 64 * piece.d**2 * (piece.d**2 - piece.d_stiff**2)
        half = rho * missing * piece.length / 2
        if half > 0:
            lumps += [
                StationDisc(node=at, mass=0.0, polar=2 * half, diametral=half) for at in (i, i + 1)
            ]
        node = i + 1
    return TransferMatrixRotor(
        shafts=(SegmentedShaft(segments=tuple(segments)),), discs=tuple(lumps),
        supports=(StationSupport(node=1, kxx=k), StationSupport(node=node - 1, kxx=k)),
    )  # fmt: skip
