"""Deflection between the stations of a rotor, from exact transfer inside every piece."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from analytic.rotor.transfer_bending import Bending, numbers, stations_of
from analytic.rotor.transfer_modes import TransferModes
from analytic.rotor.transfer_segment import transfer

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


@dataclass(frozen=True)
class Line:
    """Deflection of one shaft at `z` (m,): r = `plus` e^{iwt} + conj(`minus`) e^{-iwt}.

    z [m] is measured along the shaft; `tilt_plus` and `tilt_minus` are the components of phi.
    """

    z: Array
    plus: Complex
    minus: Complex
    tilt_plus: Complex
    tilt_minus: Complex

    @property
    def largest(self) -> Array:
        """Major half-axis of the orbit at each position."""
        return np.asarray(np.abs(self.plus) + np.abs(self.minus))


def mode_lines(found: TransferModes, k: int, *, points: int = 9) -> tuple[Line, ...]:
    """Deflection lines of the shafts in mode `k`; the largest orbit has the half-axis 1.

    Each piece has `points` points.
    """
    lines = lines_of(
        found.bending, float(found.w[k]), float(found.speeds[k]), found.unknowns[k], points=points
    )
    size = max(float(line.largest.max()) for line in lines)
    return tuple(
        Line(o.z, o.plus / size, o.minus / size, o.tilt_plus / size, o.tilt_minus / size)
        for o in lines
    )


def lines_of(
    bending: Bending, w: float, Omega: float, unknowns: Complex, *, points: int = 9
) -> tuple[Line, ...]:
    """Deflection lines of the shafts from (r+, r-) of all nodes; the pieces are undamped."""
    plus, minus = (
        _carried(bending, sign * w, Omega, half, points)
        for sign, half in zip((1, -1), np.split(unknowns, 2), strict=True)
    )
    places, owner = bending.rotor.places, [shaft for _, shaft in stations_of(bending.rotor)]
    near = [node for node, _ in stations_of(bending.rotor)]
    start: list[float] = []
    for node, segment, n in zip(near, bending.segments, bending.parts, strict=True):
        start += [places[node] + j * segment.length / n for j in range(n)]
    shaft = np.repeat(owner, bending.parts)
    long = np.repeat([s.length / n for s, n in zip(bending.segments, bending.parts, strict=True)],
                  bending.parts)  # fmt: skip
    z = np.array(start)[:, None] + long[:, None] * np.linspace(0, 1, points)
    return tuple(
        Line(z[shaft == k].ravel(), *(v[shaft == k].ravel() for v in (
            plus[..., 0], minus[..., 0], plus[..., 1], minus[..., 1])))
        for k in range(len(bending.rotor.shafts))
    )  # fmt: skip


def _carried(bending: Bending, w: float, Omega: float, q: Complex, points: int) -> Complex:
    """Deflection r and tilt phi (pieces, points, 2) in the pieces, from values at their ends."""
    n = np.array(bending.parts, dtype=np.float64)
    s, b, t = (
        np.repeat(v, bending.parts)
        for v in (f * x[0] for f, x in zip(
            (n**2, n**-4.0, n**-2.0), numbers(bending.rotor, [w], [Omega]), strict=True))
    )  # fmt: skip
    long = np.repeat(np.array([seg.length for seg in bending.segments]) / n, bending.parts)
    nodes = q.reshape(-1, 2)[bending.ends]  # (pieces, end, unknown)
    u = np.stack([nodes[..., 0] / long[:, None], nodes[..., 1] / bending.length], axis=-1)
    T = transfer(s=s, b=b, t=t)
    force = np.linalg.solve(
        T[:, :2, 2:].astype(np.complex128),
        (u[:, 1] - (T[:, :2, :2] @ u[:, 0, :, None])[..., 0])[..., None],
    )[..., 0]
    state = np.concatenate([u[:, 0], force], axis=1)
    inside = transfer(s=s[:, None], b=b[:, None], t=t[:, None], at=np.linspace(0, 1, points)[None])
    found = (inside @ state[:, None, :, None])[..., :2, 0]
    found[..., 0] *= long[:, None]
    return np.asarray(found)
