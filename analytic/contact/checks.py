"""Checks of arguments of contact formulas; each error message names rule, value and unit."""

from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Assumption = Literal["plane stress", "plane strain"]


def positive(value: ArrayLike, what: str, unit: str) -> Array:
    """`value` as an array; raises ValueError unless all elements are positive and finite."""
    value = np.asarray(value, dtype=np.float64)
    if not np.all((value > 0) & np.isfinite(value)):
        raise ValueError(f"{what} must be positive and finite, got {value} {unit}".rstrip())
    return value


def not_negative(value: ArrayLike, what: str, unit: str) -> Array:
    """`value` as an array; raises ValueError unless all elements are finite and not negative."""
    value = np.asarray(value, dtype=np.float64)
    if not np.all((value >= 0) & np.isfinite(value)):
        raise ValueError(f"{what} must be finite and not negative, got {value} {unit}")
    return value


def finite(value: ArrayLike, what: str, unit: str) -> Array:
    """`value` as an array; raises ValueError unless all elements are finite."""
    value = np.asarray(value, dtype=np.float64)
    if not np.all(np.isfinite(value)):
        raise ValueError(f"{what} must be finite, got {value} {unit}")
    return value


def poisson(nu: ArrayLike) -> Array:
    """Poisson's ratio as an array; raises ValueError outside (-1, 0.5)."""
    nu = np.asarray(nu, dtype=np.float64)
    if not np.all((nu > -1) & (nu < 0.5)):
        raise ValueError(f"Poisson's ratio must lie in (-1, 0.5), got nu={nu}")
    return nu


def in_plane(E: ArrayLike, nu: ArrayLike, assumption: Assumption) -> tuple[Array, Array]:
    """Elastic constants E', nu' with which Hooke's law has the form of plane stress.

    >>> E, nu = in_plane(3.0, 0.25, "plane strain")  # E/(1 - nu²) = 3.2, nu/(1 - nu) = 1/3
    >>> round(float(E), 12), round(float(nu), 12)
    (3.2, 0.333333333333)
    """
    nu = poisson(nu)
    E = np.asarray(E, dtype=np.float64)  # infinite: a rigid body
    if not np.all(E > 0):
        raise ValueError(f"Young's modulus must be positive, got E={E} Pa")
    if assumption not in get_args(Assumption):
        known = ", ".join(get_args(Assumption))
        raise ValueError(f"assumption must be one of {known}, got {assumption!r}")
    return (E, nu) if assumption == "plane stress" else (E / (1 - nu**2), nu / (1 - nu))


def pair_in_plane(
    E_1: ArrayLike, nu_1: ArrayLike, E_2: ArrayLike, nu_2: ArrayLike, assumption: Assumption
) -> tuple[Array, Array, Array, Array]:
    """Compliances 1/E' and constants nu' of both bodies; at most one body may be rigid."""
    plane_1, cross_1 = in_plane(E_1, nu_1, assumption)
    plane_2, cross_2 = in_plane(E_2, nu_2, assumption)
    if np.any(np.isinf(plane_1) & np.isinf(plane_2)):
        raise ValueError(
            f"at least one body must be elastic, got E_1={plane_1} Pa, E_2={plane_2} Pa"
        )
    return np.asarray(1 / plane_1), cross_1, np.asarray(1 / plane_2), cross_2
