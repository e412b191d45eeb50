"""The points of a sweep: a grid over axes, or a sample within tolerances."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from verify.core.case import Case
from verify.core.figures import Array
from verify.core.inputs import InputError, Inputs
from verify.studies.sweep.axes import Axis, Tolerance, axis, tolerance
from verify.studies.sweep.pairs import Pair

MOST_POINTS = 2_000_000


@dataclass(frozen=True)
class Plan:
    """Plan of a sweep: values [SI] of the varied inputs `names` at all points (m, d)."""

    case: Case
    name: str
    inputs: Inputs
    chosen: tuple[Pair, ...]
    points: Array
    axes: tuple[Axis, ...] = ()
    tolerances: tuple[Tolerance, ...] = ()
    base: int = 0  # points of a sample's first matrix
    star: bool = False

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the varied inputs, in the order of the columns of `points`."""
        return tuple(one.name for one in self.axes or self.tolerances)

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of values on each axis of a grid."""
        return tuple(len(one.values) for one in self.axes)


def grid(
    case: Case, name: str, inputs: Inputs, chosen: tuple[Pair, ...], vary: Sequence[str],
    *, star: bool = False,
) -> Plan:  # fmt: skip
    """Plan with all combinations of the axis values; with `star`, one input varies at a time.

    The last axis varies fastest. Raises InputError if an axis is wrong or there are too many
    points.
    """
    axes = tuple(axis(inputs, text) for text in vary)
    _once([one.name for one in axes], "--vary")
    if star:
        centre = [_centre(one) for one in axes]
        rows = [centre] + [
            [v if k == j else c for k, c in enumerate(centre)]
            for j, one in enumerate(axes) for v in one.values if v != centre[j]
        ]  # fmt: skip
        points = np.array(rows)
    else:
        _few(math.prod(len(one.values) for one in axes))
        mesh = np.meshgrid(*(one.values for one in axes), indexing="ij")
        points = np.column_stack([m.ravel() for m in mesh])
    return Plan(case, name, inputs, chosen, points, axes=axes, star=star)


def sample(
    case: Case, name: str, inputs: Inputs, chosen: tuple[Pair, ...], count: str,
    tolerances: Sequence[str], *, seed: int = 0,
) -> Plan:  # fmt: skip
    """Plan with a scrambled Sobol sample for sensitivity indices.

    `count` is "sobol:N" with N a power of two. The points are those of Saltelli's design: the rows
    of the matrices A and B, then, for each input, of A with the column of this input taken from B.
    Raises InputError if an argument is wrong.
    """
    from scipy.stats import qmc  # half a second, which a grid does without

    base = _base(count)
    off = tuple(tolerance(inputs, text) for text in tolerances)
    if not off:
        raise InputError("--sample requires at least one --tolerance NAME=±x")
    _once([one.name for one in off], "--tolerance")
    d = len(off)
    _few(base * (d + 2))
    unit = qmc.Sobol(2 * d, scramble=True, seed=seed).random_base2(int(math.log2(base)))
    low = np.array([one.nominal - one.off for one in off])
    width = np.array([2 * one.off for one in off])
    a, b = low + width * unit[:, :d], low + width * unit[:, d:]
    mixed = [np.where(np.arange(d) == k, b, a) for k in range(d)]
    return Plan(case, name, inputs, chosen, np.vstack([a, b, *mixed]), tolerances=off, base=base)


def _base(count: str) -> int:
    kind, _, number = count.partition(":")
    if kind != "sobol" or not number.isdecimal():
        raise InputError(f"--sample must be sobol:N, such as sobol:64, got {count!r}")
    n = int(number)
    if not 8 <= n <= 2**20 or n & (n - 1):
        raise InputError(f"--sample {count}: N must be a power of two from 8 to {2**20}")
    return n


def _centre(one: Axis) -> float:
    if one.nominal is None:
        raise InputError(
            f"{one.name}: give its value in the file, which applies while another input is varied"
        )
    return one.nominal


def _once(names: Sequence[str], option: str) -> None:
    for name in names:
        if names.count(name) > 1:
            raise InputError(f"{option}: {name} must be given only once")


def _few(count: int) -> None:
    if count > MOST_POINTS:
        raise InputError(f"the sweep has {count:,} points, the maximum is {MOST_POINTS:,}")
