"""Expected errors of Eqs. 3 and 4 of Belcin et al. for a free roller, and of Cattaneo's formula.

The ratio of tangential to normal force of a free roller is tan(alpha/2) instead of mu. As this
follows from equilibrium, the error of finite elements is nearly zero on every mesh. Errors are
formula/true value - 1.
"""

from math import tan

from analytic.bounds.polyhedral.contacts import Interval, about

STATICS = 1e-6  # relative error of forces in balance
MODEL = 2.0  # bound of the error of half planes over (a/R)²


def torque_error(*, alpha: float, mu: float) -> Interval:
    """Interval of the error of the torque at the friction limit (Eq. 3) for a free roller.

    >>> low, high = torque_error(alpha=0.1, mu=2 * tan(0.05))
    >>> round(low, 9), round(high, 9)
    (0.999998, 1.000002)
    """
    m = 1 / (tan(alpha / 2) / mu) - 1
    return about(m, STATICS * (1 + m))


def normal_force_error(*, alpha: float, mu: float) -> Interval:
    """Interval of the error of the normal force at the friction limit (Eq. 4) for a free roller."""
    m = tan(alpha / 2) / mu - 1
    return about(m, STATICS)


def half_planes(*, a: float, R: float, mu: float) -> Interval:
    """Interval of the error of Cattaneo's stick half-width on inclined surfaces of radius R.

    The tolerance is an estimate: (a/(mu R))² for the inclination relative to the friction angle,
    and 2 (a/R)² for the half planes.
    """
    return about(0.0, (a / (mu * R)) ** 2 + MODEL * (a / R) ** 2)
