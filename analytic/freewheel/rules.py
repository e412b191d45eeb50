"""Checks of the arguments of freewheel formulas; error messages name rule, value and unit."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.contact.checks import Array, positive


def require(holds: ArrayLike, rule: str, unit: str = "m", **values: ArrayLike) -> None:
    """Raise ValueError with the rule and the first violating values, unless `holds` is true."""
    valid: NDArray[np.bool_] = np.asarray(holds, dtype=np.bool_)
    if np.all(valid):
        return
    first = np.unravel_index(int(np.argmin(valid)), valid.shape)
    given = ", ".join(
        f"{name}={np.broadcast_to(np.asarray(value), valid.shape)[first]:.7g} {unit}".rstrip()
        for name, value in values.items()
    )
    raise ValueError(f"{rule}, got {given}")


def rollers(z: ArrayLike) -> Array:
    """Number of rollers as an array; raises ValueError unless integer and at least 2."""
    z = positive(z, "number of rollers", "")
    require((z >= 2) & (z == np.round(z)), "number of rollers must be whole, 2 or more", "", z=z)
    return z
