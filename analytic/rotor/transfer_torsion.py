r"""Torsional frequencies of coupled shafts by exact transfer matrices.

With :math:`\beta = \omega l\sqrt{\rho/G}`, a piece has the dynamic stiffness
:math:`(GJ/l)\,[\beta\cot\beta, -\beta/\sin\beta; -\beta/\sin\beta, \beta\cot\beta]`.
"""

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from analytic.rotor.transfer_bending import pairs, stations_of
from analytic.rotor.transfer_model import TransferMatrixRotor
from analytic.rotor.transfer_roots import count_below, roots_below

Array = NDArray[np.float64]
MOST_NODES = 400
FREE = 1e-12


def torsional_frequencies(rotor: TransferMatrixRotor, *, count: int = 3) -> Array:
    """Lowest `count` non-zero natural frequencies of torsion [rad/s], (count,).

    The zero frequency of freely rotating shafts is omitted. Raises ValueError if count < 1.
    """
    if count < 1:
        raise ValueError(f"count must be at least 1, got {count}")
    wanted = free_turns(rotor) + np.arange(count)
    top = min(
        np.sqrt(s.G / s.rho) / sum(p.length for p in shaft.segments)
        for shaft in rotor.shafts for s in shaft.segments
    )  # fmt: skip
    while True:
        parts = _parts(rotor, top)
        if count_below(_stiffness(rotor, parts, np.array([top])))[0] > wanted[-1]:
            break
        if sum(parts) > MOST_NODES:
            break
        top *= 2
    found = roots_below(lambda w, _: _stiffness(rotor, parts, w), np.array([top]), wanted)
    return np.asarray(found[0])


def free_turns(rotor: TransferMatrixRotor) -> int:
    """Number of independent rotations of the shafts that no torsional stiffness restrains."""
    count = len(rotor.shafts)
    K = np.zeros((count, count))
    for spring in (*rotor.supports, *rotor.links):
        for a, b, sign in pairs(spring):
            K[rotor.shaft_of[a], rotor.shaft_of[b]] += sign * spring.k_turn
    values = np.linalg.eigvalsh(K)
    return int((values <= FREE * max(values[-1], 1e-300)).sum())


def _parts(rotor: TransferMatrixRotor, w: float) -> list[int]:
    """Number of pieces of each segment; no clamped piece has a frequency below w [rad/s]."""
    return [
        max(1, int(np.ceil(w * s.length * np.sqrt(s.rho / s.G) / (np.pi / 2))))
        for shaft in rotor.shafts for s in shaft.segments
    ]  # fmt: skip


def _stiffness(rotor: TransferMatrixRotor, parts: list[int], w: Array) -> Array:
    """Dynamic stiffness D (m, n, n) [N m/rad] of torsion; stations first, then inner nodes."""
    nodes = rotor.stations + sum(parts) - len(parts)
    D = np.zeros((w.size, nodes, nodes))
    cut = rotor.stations
    segments = [s for shaft in rotor.shafts for s in shaft.segments]
    for (near, _), segment, n in zip(stations_of(rotor), segments, parts, strict=True):
        length = segment.length / n
        beta = w * length * np.sqrt(segment.rho / segment.G)
        over = 2 * segment.I * segment.G / length / np.sinc(beta / np.pi)
        chain = [near, *range(cut, cut + n - 1), near + 1]
        cut += n - 1
        for a, b in pairwise(chain):
            D[:, a, a] += over * np.cos(beta)
            D[:, b, b] += over * np.cos(beta)
            D[:, a, b] -= over
            D[:, b, a] -= over
    for disc in rotor.discs:
        D[:, disc.node, disc.node] -= disc.polar * w**2
    for spring in (*rotor.supports, *rotor.links):
        for a, b, sign in pairs(spring):
            D[:, a, b] += sign * spring.k_turn
    return D
