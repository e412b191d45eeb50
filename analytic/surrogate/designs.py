"""Designs of a computer experiment: full factorial designs and random points."""

import numpy as np

from analytic.contact.checks import Array
from analytic.surrogate.box import Box


def full_factorial(box: Box, levels: int) -> Array:
    """Full factorial design (levels**d, d), with `levels` equally spaced values of each parameter.

    The first and last levels are the bounds of the box. The last parameter changes fastest. Raises
    ValueError if levels < 2.

    >>> full_factorial(Box((0.0, 10.0), (1.0, 20.0)), 2).tolist()
    [[0.0, 10.0], [0.0, 20.0], [1.0, 10.0], [1.0, 20.0]]
    """
    if levels < 2:
        raise ValueError(f"a factorial design must have at least 2 levels, got {levels}")
    axes = np.meshgrid(*[np.linspace(0, 1, levels)] * box.dimension, indexing="ij")
    return box.from_unit(np.column_stack([axis.ravel() for axis in axes]))


def random_designs(box: Box, count: int, seed: int) -> Array:
    """Random points (count, d); all parameters are independent and uniform between their bounds."""
    if count < 1:
        raise ValueError(f"count must be at least 1, got {count}")
    return box.from_unit(np.random.default_rng(seed).random((count, box.dimension)))
