r"""Error of the thin ring under pressure (Belcin et al., Eqs. 8-10) against Lamé's thick one.

In plane stress Lamé's pressure that takes up the clearance outside is d_m²/(d_i d_e) times p_1;
the mean hoop stress errs as p_1 does, whatever the pressure; the free outside has the strain
j_D/d_e, and the bore the largest stress, (d_e/d_i)² + 1 over 2 times that of the outside. Finite
elements have stresses at the ends of cells, which span more of ln r in thick walls.

Errors are relative, formula over truth less one, of the outer diameter d_e and the wall.
"""

from analytic.bounds.polyhedral.contacts import Interval, about
from analytic.ring import lame

SLACK = 1e-4  # of the closed forms that expected errors are computed from
CELL = 1e-2  # of (wall/d_m)²: stress at the end of a cell


def pressure_error(*, d_e: float, wall: float) -> Interval:
    """Error of p_1, and of sigma_t as the mean over the wall.

    >>> low, high = pressure_error(d_e=2.0, wall=0.5)  # 8/9
    >>> round((low + high) / 2, 12)
    -0.111111111111
    """
    return about(1 / _thick_over_thin(d_e, wall) - 1, SLACK)


def rim_stress_error(*, d_e: float, wall: float) -> Interval:
    """Error of sigma_t as the hoop stress outside."""
    d_m = d_e - wall
    return about(d_e / d_m - 1, SLACK + CELL * (wall / d_m) ** 2)


def bore_stress_error(*, d_e: float, wall: float) -> Interval:
    """Error of sigma_t as the hoop stress in the bore, E j_D (d_e² + d_i²)/(2 d_i² d_e).

    The part of the stress that varies, as 1/r², has the share 1/2 outside and R²/(1 + R²) in the
    bore, R = d_e/d_i: the stress at the ends of cells is less accurate there in that proportion.

    >>> low, high = bore_stress_error(d_e=2.0, wall=0.5)  # 8/15
    >>> round((low + high) / 2, 12)
    -0.466666666667
    """
    d_m, d_i = d_e - wall, d_e - 2 * wall
    share = d_e**2 / (d_e**2 + d_i**2)
    error = 2 * d_i**2 * d_e / (d_m * (d_e**2 + d_i**2)) - 1
    return about(error, SLACK + 2 * share * CELL * (wall / d_m) ** 2)


def growth_error(*, d_e: float, wall: float, j_D: float, E: float, nu: float) -> Interval:
    """Error of j_D as the growth of the mean diameter, where the outside grows by j_D."""
    d_i = d_e - 2 * wall
    p_1 = (d_e - d_i) * (E * j_D / ((d_i + d_e) / 2)) / d_i
    grown = 2 * float(lame.radial_displacement(
        (d_e - wall) / 2, r_i=d_i / 2, r_o=d_e / 2, p_i=p_1, E=E, nu=nu, ends="plane stress"
    ))  # fmt: skip
    return about(j_D / (grown * _thick_over_thin(d_e, wall)) - 1, SLACK)


def outside_growth_error(*, d_e: float, wall: float) -> Interval:
    """Error of sigma_t d_m/E, of the mean hoop stress sigma_t, as the growth of the outside.

    >>> low, high = outside_growth_error(d_e=2.0, wall=0.5)  # 9/8
    >>> round((low + high) / 2, 12)
    0.125
    """
    return about(_thick_over_thin(d_e, wall) - 1, SLACK)


def _thick_over_thin(d_e: float, wall: float) -> float:
    d_i = d_e - 2 * wall
    return (d_i + d_e) ** 2 / (4 * d_i * d_e)
