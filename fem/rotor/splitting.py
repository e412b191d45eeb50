"""Gyroscopic splitting of the natural frequencies of forward and backward whirl."""

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from fem.rotor.elements import Array

PAIRED = 0.5  # M-product of two shapes of unit modal mass, from which on they are one pair


class Matrix(Protocol):
    """Protocol of dense and sparse matrices that can multiply a dense matrix."""

    def __matmul__(self, other: Array, /) -> Array: ...


@dataclass(frozen=True)
class Whirl:
    """Positive frequencies `w` (k,) [rad/s] and shapes (n, k) for one sense of whirl."""

    w: Array
    shapes: Array


def gyroscopic_splitting(
    speed: float, M: Matrix, G: Matrix, forward: Whirl, backward: Whirl
) -> Array:
    r"""Forward minus backward frequency (k,) [rad/s] of each pair of modes at `speed` [rad/s].

    Both shapes satisfy :math:`(K + w\,\Omega G - w^2 M)\,v = 0`, at :math:`w_f > 0` and at
    :math:`-w_b < 0`. Multiplying each equation by the other shape, and subtracting, gives

    .. math:: w_f - w_b = \Omega\, \frac{v_b \cdot G v_f}{v_b \cdot M v_f}

    This form avoids the round-off of K in the difference of nearly equal frequencies. At speeds at
    which the order of modes changes, the forward and the backward shape with the same number k
    belong to different pairs. The difference of their frequencies is then not small and is computed
    directly.
    """
    f, b = (
        v.shapes / np.sqrt((v.shapes * (M @ v.shapes)).sum(axis=0)) for v in (forward, backward)
    )
    shared = (b * (M @ f)).sum(axis=0)
    alike = abs(shared) > PAIRED
    direct = speed * (b * (G @ f)).sum(axis=0) / np.where(alike, shared, 1.0)
    return np.asarray(np.where(alike, direct, forward.w - backward.w))
