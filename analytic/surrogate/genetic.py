"""Genetic algorithm with binary codes, for the minimum of an objective in a box.

Source: Huang et al. 2018, Sec. 3: a population of 500, 100 generations, crossover with probability
0.9 and mutation with 0.01. The paper does not state coding, selection and survival. The simple
algorithm of textbooks is assumed. Every parameter is a Gray code of `bits` bits. Parents are
selected by tournaments of two. The codes of a pair are combined by one-point crossover with the
given probability. Each bit is inverted with the probability of mutation. The best individual so far
is the first child. The random first generation is one of the 100, so that 500 x 100 points are
evaluated.
"""

import numpy as np
from numpy.typing import NDArray

from analytic.contact.checks import Array
from analytic.surrogate.box import Box
from analytic.surrogate.found import Found, Objective, asked

Codes = NDArray[np.bool_]  # (population, d * bits), most significant bit first


def genetic(
    objective: Objective,
    box: Box,
    *,
    population: int = 500,
    generations: int = 100,
    crossover: float = 0.9,
    mutation: float = 0.01,
    bits: int = 16,
    seed: int = 0,
) -> Found:
    """Minimum found by a genetic algorithm; the objective takes a whole population (n, d).

    Raises ValueError if the population is odd or empty, there is no generation, a probability is
    outside [0, 1] or bits is outside 1 to 52.
    """
    _checked(population, generations, crossover, mutation, bits)
    rng = np.random.default_rng(seed)
    codes = rng.random((population, box.dimension * bits)) < 0.5
    values = asked(objective, box.from_unit(decoded(codes, bits)))
    history = [values.min()]
    for _ in range(generations - 1):
        best = codes[values.argmin()]
        codes = crossed(codes[selected(values, rng)], crossover, rng)
        codes = mutated(codes, mutation, rng)
        codes[0] = best
        values = asked(objective, box.from_unit(decoded(codes, bits)))
        history.append(values.min())
    x = box.from_unit(decoded(codes[[values.argmin()]], bits))[0]
    return Found(x, float(history[-1]), population * generations, np.array(history))


def decoded(codes: Codes, bits: int) -> Array:
    """Points (n, d) of the unit cube from Gray codes (n, d * bits), bounds included.

    >>> decoded(np.array([[0, 0], [0, 1], [1, 1], [1, 0]], bool), 2).ravel().round(3).tolist()
    [0.0, 0.333, 0.667, 1.0]
    """
    binary = np.logical_xor.accumulate(codes.reshape(len(codes), -1, bits), axis=2)
    return np.asarray(binary @ 2.0 ** np.arange(bits)[::-1] / (2.0**bits - 1))


def selected(values: Array, rng: np.random.Generator) -> NDArray[np.intp]:
    """Indices (n,) of selected parents; of two random candidates, that with the smaller value."""
    one, other = rng.integers(len(values), size=(2, len(values)))
    return np.asarray(np.where(values[one] <= values[other], one, other))


def crossed(codes: Codes, probability: float, rng: np.random.Generator) -> Codes:
    """Children (n, length) of the pairs (0, n/2), (1, n/2 + 1) ... by one-point crossover."""
    mothers, fathers = np.split(codes, 2)
    pairs, length = mothers.shape
    point = rng.integers(1, max(length, 2), size=(pairs, 1))
    swap = (np.arange(length) >= point) & (rng.random((pairs, 1)) < probability)
    return np.vstack([np.where(swap, fathers, mothers), np.where(swap, mothers, fathers)])


def mutated(codes: Codes, probability: float, rng: np.random.Generator) -> Codes:
    """Codes in which every bit is inverted with the given probability."""
    return np.asarray(codes ^ (rng.random(codes.shape) < probability))


def _checked(
    population: int, generations: int, crossover: float, mutation: float, bits: int
) -> None:
    if population < 2 or population % 2:
        raise ValueError(f"the population must be even and at least 2, got {population}")
    if generations < 1:
        raise ValueError(f"generations must be at least 1, got {generations}")
    if not 1 <= bits <= 52:
        raise ValueError(f"bits must lie between 1 and 52, got {bits}")
    for what, value in (("crossover", crossover), ("mutation", mutation)):
        if not 0 <= value <= 1:
            raise ValueError(f"the probability of {what} must lie in [0, 1], got {value}")
