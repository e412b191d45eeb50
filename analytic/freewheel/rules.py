"""Checks of the arguments of the freewheel's formulas; errors name rule, value, unit."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.contact.checks import Array, positive


def require(holds: ArrayLike, rule: str, unit: str = "m", **values: ArrayLike) -> None:
    """ValueError with the rule and the first values that break it, unless `holds` throughout."""
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
    """The number of rollers as an array; ValueError unless whole and at least 2."""
    z = positive(z, "number of rollers", "")
    require((z >= 2) & (z == np.round(z)), "number of rollers must be whole, 2 or more", "", z=z)
    return z
