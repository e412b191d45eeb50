"""Errors of Eqs. 3 and 4 of Belcin et al. for a free roller, of Cattaneo for a wedged one.

A free roller uses tan(alpha/2)/mu of its friction: forces in balance, so that finite elements miss
next to nothing on any mesh. Errors are relative, formula over truth less one.
"""

from math import tan

from analytic.bounds.polyhedral.contacts import Interval, about

STATICS = 1e-6  # relative error of forces in balance
MODEL = 2.0  # bound of the error of half planes over (a/R)²


def torque_error(*, alpha: float, mu: float) -> Interval:
    """Error of the torque of friction's limit (Eq. 3) for a free roller; alpha in rad.

    >>> low, high = torque_error(alpha=0.1, mu=2 * tan(0.05))
    >>> round(low, 9), round(high, 9)
    (0.999998, 1.000002)
    """
    m = 1 / (tan(alpha / 2) / mu) - 1
    return about(m, STATICS * (1 + m))


def normal_force_error(*, alpha: float, mu: float) -> Interval:
    """Error of the normal force of friction's limit (Eq. 4) for a free roller; alpha in rad."""
    m = tan(alpha / 2) / mu - 1
    return about(m, STATICS)


def half_planes(*, a: float, R: float, mu: float) -> Interval:
    """Error of Cattaneo's stick half-width on inclined surfaces of bodies of radius R.

    Argued: (a/(mu R))² of the inclination against the angle of friction, 2 (a/R)² of half planes.
    """
    return about(0.0, (a / (mu * R)) ** 2 + MODEL * (a / R) ** 2)
