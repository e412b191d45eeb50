"""Branches of eigenvalues over the speed, tracked from each speed to the next."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import linear_sum_assignment

from fem.rotor.blocks import Block, Complex, blocks, to_whirl
from fem.rotor.elements import Array
from fem.rotor.model import Rotor
from fem.rotor.pencil import Spectrum, spectrum

SPARE = 4  # eigenvalues besides those requested, which may become lower than these
BATCH = 64  # speeds solved together
STILL = 1e-7  # Im lambda over its size, below which a motion does not oscillate
# of a motion's squares [m², rad²]: less is round-off of a part at rest, some 1e-32 of the others
NOTHING = 1e-20
ROUND = 1e-6  # share of the other sense in a motion, below which it has one


@dataclass(frozen=True)
class Branches:
    """Eigenvalues lambda (speeds, k) of branches, and mode shapes (speeds, k, n) of the nodes.

    `sense` is the sense of whirl.
    """

    values: Complex
    shapes: Complex
    sense: NDArray[np.int64]


def check_speeds(speeds: ArrayLike) -> Array:
    """Speeds (m,) as an array. Raises ValueError unless all speeds are finite numbers."""
    given = np.atleast_1d(np.asarray(speeds, float))
    if given.ndim != 1 or not given.size or not np.all(np.isfinite(given)):
        raise ValueError("speeds must be one or more finite numbers in rad/s, in one dimension")
    return given


def check_count(count: int) -> int:
    """Number of modes. Raises ValueError unless `count` is an integer of at least 1."""
    if count != int(count) or count < 1:
        raise ValueError(f"count, the number of modes, must be an integer >= 1, got {count}")
    return int(count)


def parts(rotor: Rotor, speed: float, plane: str) -> list[Block]:
    """Blocks with motions in `plane`, without backward blocks (conjugates of forward blocks)."""
    known = ("bending", "torsion", "axial", "all")
    if plane not in known:
        raise ValueError(f"plane must be one of {', '.join(known)}, got {plane!r}")
    made = blocks(rotor.system, speed)
    return [b for b in made if b.sense >= 0 and (plane == "all" or plane in b.planes)]


def branches(rotor: Rotor, speeds: Array, count: int, plane: str) -> list[Branches]:
    """For each block of `rotor`, at least `count` branches, or all if the block has fewer."""
    unknowns = rotor.system.M.shape[0]
    if not rotor.system.varying:
        return [_followed(b, speeds, count, unknowns) for b in parts(rotor, 0.0, plane)]
    made = [parts(rotor, float(s), plane) for s in speeds]
    if len({tuple(b.at.tobytes() for b in own) for own in made}) > 1:
        raise ValueError(
            "supports must couple the same unknowns at every speed: solve each speed separately"
        )
    columns = zip(*made, strict=True)
    return [_joined(list(own), speeds, count, unknowns) for own in columns]


def _followed(block: Block, speeds: Array, count: int, unknowns: int) -> Branches:
    chosen = []
    for i in range(0, speeds.size, BATCH):
        chosen += _lowest(spectrum(block, speeds[i : i + BATCH]), block, count + SPARE, unknowns)
    return _tracked(chosen, block.sense)


def _joined(own: list[Block], speeds: Array, count: int, unknowns: int) -> Branches:
    chosen = [
        _lowest(spectrum(b, speeds[i : i + 1]), b, count + SPARE, unknowns)[0]
        for i, b in enumerate(own)
    ]
    return _tracked(chosen, own[0].sense)


Chosen = tuple[Complex, Complex, NDArray[np.inexact]]


def _lowest(found: Spectrum, block: Block, count: int, unknowns: int) -> list[Chosen]:
    """Lowest oscillating eigenvalues (k,), shapes (k, unknowns), states (m, k), for each speed.

    A block with both senses of whirl has conjugate pairs, of which only one half is returned. In a
    forward block, eigenvalues of backward modes have negative imaginary parts.
    """
    made = []
    for i, values in enumerate(found.values):
        size = abs(values)
        resting = size <= STILL * np.median(size[np.isfinite(size)])
        kept = np.isfinite(size) & ((abs(values.imag) > STILL * size) | resting)
        if block.sense == 0:
            kept &= (values.imag > 0) & ~resting
            kept[np.flatnonzero(resting)[::2]] = True  # at rest both halves are zero
        at = np.flatnonzero(kept)
        at = at[np.argsort(abs(values.imag[at]), kind="stable")]
        at = np.concatenate([at[values.imag[at] >= 0][:count], at[values.imag[at] < 0][:count]])
        vectors, states = found.take(i, at)
        made.append((values[at], block.real(vectors.T, unknowns), states))
    return made


def _tracked(chosen: list[Chosen], sense: int) -> Branches:
    """Branches that begin at the first speed, tracked over all speeds.

    The values of a branch are NaN after it ceases to oscillate.
    """
    values, shapes, states = chosen[0]
    rows = [(values, shapes)]
    for own, shape, state in chosen[1:]:
        match = abs(states.conj().T @ state) ** 2
        jump = abs(values.imag[:, None] - own.imag[None, :])
        scale = 1 + abs(values.imag[:, None]) + abs(own.imag[None, :])
        branch, to = linear_sum_assignment(jump / scale - match)
        now = np.full(values.size, complex(np.nan, np.nan))
        now[branch] = own[to]
        values, states = values.copy(), states.copy()
        values[branch], states[:, branch] = own[to], state[:, to]
        moved = rows[-1][1].copy()
        moved[branch] = shape[to]
        rows.append((now, moved))
    whole, real = (np.array(column) for column in zip(*rows, strict=True))
    if sense > 0:  # backward: the same whirl, written with a positive frequency
        real = np.where((whole.imag < 0)[..., None], real.conj(), real)
        whole = np.where(whole.imag < 0, whole.conj(), whole)
    rests = abs(whole.imag) <= STILL * np.nanmedian(abs(whole.imag), axis=1, keepdims=True)
    return Branches(whole, real, np.where(rests, 0, whirl_sense(real)))


def whirl_sense(shapes: Complex) -> NDArray[np.int64]:
    """Sense of whirl of shapes (..., n): +1 forward, -1 backward, 0 for motion in a line.

    The shapes are amplitudes of e^(i omega t), omega > 0.
    """
    nodes = to_whirl(shapes).reshape(*shapes.shape[:-1], -1, 6)
    squares = (abs(nodes) ** 2).sum(axis=-2)
    across, tilt, nothing = squares[..., :2], squares[..., 3:5], NOTHING * squares.sum(axis=-1)
    moves = across.sum(axis=-1, keepdims=True) > nothing[..., None]
    forward, backward = np.moveaxis(np.where(moves, across, tilt), -1, 0)
    both = forward + backward
    even = (abs(forward - backward) <= ROUND * both) | (both <= nothing)
    return np.where(even, 0, np.sign(forward - backward)).astype(int)


def damping_ratios(values: Complex) -> Array:
    """Damping ratios -Re lambda/|lambda|; zero for a motion of frequency zero."""
    size = abs(values)
    return np.asarray(-values.real / np.where(size > 0, size, 1))
