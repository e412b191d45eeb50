"""Expected errors of models of a finite roller, before a more accurate model is solved."""

from math import isfinite

LEAST = 1e-4  # smallest half-width of an interval, relative to a model error
LEAST_USER = 1e-3  # the same for user inputs, for which strips and grids are not optimised
LOADED = 3e-3  # the same at a loaded end, to which no expansion applies
SLENDER = 0.03  # relative to the length: largest half-width for which the expansion is valid there
WIDEST = 0.01  # an interval wider than the required sensitivity proves nothing
TIMES = 2.0  # factor within which the strips' estimate of the neglected terms holds
CELLS = 1e-3  # of cells across with uniform pressure

Interval = tuple[float, float]


def of_strips(
    missing: float,
    *,
    value: float,
    twice: float,
    b: float,
    length: float,
    loaded: bool,
    user_inputs: bool,
) -> Interval | None:
    """Interval of the error strips/half-space - 1, estimated without solving the half-space.

    The interval extends from half to twice the error `missing` of the `value`. On both sides, the
    remaining first-order error of the strips is added: twice the change of the value with `twice`
    as many strips, or once this change at a `loaded` end, where more strips need not be more
    accurate. None if no estimate is known. b is the half-width. With `user_inputs`, the interval is
    wider, because the number of strips is not adapted to these inputs.

    >>> contact = {"b": 1.0, "length": 100.0, "loaded": False, "user_inputs": False}
    >>> low, high = of_strips(0.02, value=1.0, twice=1.0, **contact)
    >>> round(low, 6), round(high, 6)
    (-0.0401, -0.0099)
    """
    left = -missing
    if not isfinite(left) or not value:
        return None
    if user_inputs and b > SLENDER * length:
        return None
    change = abs(twice / value - 1)
    least = LEAST if not user_inputs else LOADED if loaded else LEAST_USER
    cut = (1 if loaded else 2) * change + least
    low, high = sorted((left / TIMES, TIMES * left))
    if user_inputs and high - low + 2 * cut > WIDEST:
        return None
    return low - cut, high + cut


def local_pressure(*, b: float, R: float, length: float) -> Interval:
    """Interval of the error of Hertz's pressure that is computed from the line load at mid-length.

    Hertz's theory neglects the circular shape and the change of load along the roller. These
    effects are estimated by (b/R)² and (2b/length)² with the half-width b.
    """
    most = (b / R) ** 2 + (2 * b / length) ** 2 + CELLS
    return -most, most
