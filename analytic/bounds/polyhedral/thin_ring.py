r"""Expected errors of thin-ring formulas (Belcin et al., Eqs. 8-10) against Lamé's formulas.

In plane stress, Lamé's pressure that closes the clearance at the rim is d_m²/(d_i d_e) times p_1.
The mean hoop stress has the same relative error as p_1 at every pressure. The free rim has the
strain j_D/d_e. The stress at the bore is the largest one, ((d_e/d_i)² + 1)/2 times the stress at
the rim. The stresses of finite elements are evaluated at the ends of cells. They are less accurate
in thick walls, where a cell covers a larger range of ln r.

Errors are formula/true value - 1. d_e is the outer diameter, `wall` the thickness of the ring.
"""

from analytic.bounds.polyhedral.contacts import Interval, about
from analytic.ring import lame

SLACK = 1e-4  # of the closed forms that expected errors are computed from
CELL = 1e-2  # of (wall/d_m)²: stress at the end of a cell


def pressure_error(*, d_e: float, wall: float) -> Interval:
    """Interval of the error of p_1, and of sigma_t as the mean hoop stress over the wall.

    >>> low, high = pressure_error(d_e=2.0, wall=0.5)  # 8/9
    >>> round((low + high) / 2, 12)
    -0.111111111111
    """
    return about(1 / _thick_over_thin(d_e, wall) - 1, SLACK)


def rim_stress_error(*, d_e: float, wall: float) -> Interval:
    """Interval of the error of sigma_t as the hoop stress at the rim."""
    d_m = d_e - wall
    return about(d_e / d_m - 1, SLACK + CELL * (wall / d_m) ** 2)


def bore_stress_error(*, d_e: float, wall: float) -> Interval:
    """Interval of the error of sigma_t as the hoop stress in the bore.

    The true stress is E j_D (d_e² + d_i²)/(2 d_i² d_e). The fraction of the stress that varies as
    1/r² is 1/2 at the rim and R²/(1 + R²) in the bore, with R = d_e/d_i. The error of the stress at
    the ends of cells is proportional to this fraction.

    >>> low, high = bore_stress_error(d_e=2.0, wall=0.5)  # 8/15
    >>> round((low + high) / 2, 12)
    -0.466666666667
    """
    d_m, d_i = d_e - wall, d_e - 2 * wall
    share = d_e**2 / (d_e**2 + d_i**2)
    error = 2 * d_i**2 * d_e / (d_m * (d_e**2 + d_i**2)) - 1
    return about(error, SLACK + 2 * share * CELL * (wall / d_m) ** 2)


def growth_error(*, d_e: float, wall: float, j_D: float, E: float, nu: float) -> Interval:
    """Interval of the error of j_D as growth of the mean diameter; j_D is the growth of the rim."""
    d_i = d_e - 2 * wall
    p_1 = (d_e - d_i) * (E * j_D / ((d_i + d_e) / 2)) / d_i
    grown = 2 * float(lame.radial_displacement(
        (d_e - wall) / 2, r_i=d_i / 2, r_o=d_e / 2, p_i=p_1, E=E, nu=nu, ends="plane stress"
    ))  # fmt: skip
    return about(j_D / (grown * _thick_over_thin(d_e, wall)) - 1, SLACK)


def outside_growth_error(*, d_e: float, wall: float) -> Interval:
    """Interval of the error of sigma_t d_m/E as growth of the rim; sigma_t is the mean hoop stress.

    >>> low, high = outside_growth_error(d_e=2.0, wall=0.5)  # 9/8
    >>> round((low + high) / 2, 12)
    0.125
    """
    return about(_thick_over_thin(d_e, wall) - 1, SLACK)


def _thick_over_thin(d_e: float, wall: float) -> float:
    d_i = d_e - 2 * wall
    return (d_i + d_e) ** 2 / (4 * d_i * d_e)
