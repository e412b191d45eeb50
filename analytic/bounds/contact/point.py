"""Errors of Hertz's point contact for finite spheres.

`beyond` is (a/R)² of the smaller sphere, the order of the terms after the first correction.
"""

from analytic.bounds.contact.estimate import Estimate


def corrected(excess: float, *, beyond: float, power: float = 1.0) -> Estimate:
    """Expected error of a formula, if the true value is the formula times 1 + `excess`.

    `excess` is the first correction for finite spheres. The tolerance is `power` times `beyond`,
    because the value is proportional to the approach to this power (3/2 for the load).

    >>> corrected(1.0, beyond=0.01)
    Estimate(error=-0.5, slack=0.01)
    """
    return Estimate(1 / (1 + excess) - 1, beyond * power)


def axis_shear(*, beyond: float) -> Estimate:
    """Expected error of the largest shear stress on the axis: zero; the tolerance is a/R.

    The pressure on the curved surface is inclined by r/R. On the axis, this adds the fraction a/R
    of p_0 to the shear stress.
    """
    return Estimate(0.0, beyond**0.5)
