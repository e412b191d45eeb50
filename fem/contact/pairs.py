"""Definition of contacts: pairs of surfaces that may touch, rigid obstacles, and rigid bodies."""

from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np

from fem.contact.shapes import Circle, Flat, Shape

MOTIONS = "xyr"
Normal = Literal["between", "master"]


@dataclass(frozen=True)
class Rigid:
    """Material of a body that does not deform."""


@dataclass(frozen=True)
class Obstacle:
    """A rigid surface without a mesh.

    `free` names the motions that result from the loads: x, y and r (rotation [rad] about the point
    or the centre of the shape). All other motions are prescribed.
    """

    shape: Flat | Circle
    free: str = ""

    def __post_init__(self) -> None:
        if set(self.free) - set(MOTIONS) or len(set(self.free)) < len(self.free):
            raise ValueError(
                f"free motions of an obstacle must be different letters of 'xyr', got {self.free!r}"
            )

    @property
    def centre(self) -> tuple[float, float]:
        """Centre of rotation."""
        return self.shape.centre if isinstance(self.shape, Circle) else self.shape.point


@dataclass(frozen=True, kw_only=True)
class Pair:
    """Two surfaces that may touch, by boundary name; the master may be the surface of an obstacle.

    The nodes of the slave carry the traction. The slave should have the finer mesh or the smaller
    surface. `friction` is Coulomb's coefficient. `slave_shape` and `master_shape` are the exact
    shapes of the meshed boundaries; with these shapes, the facets do not affect the gap.
    `interference` [length] is subtracted from the gap everywhere; `press_fit` permits surfaces that
    overlap in the mesh. `normal` is the direction of gap and pressure: the normal of the surface
    "between" the deformed bodies, on which the bodies meet, or the normal of the "master", for a
    body that slides along a flat of constant inclination. Raises ValueError for negative friction,
    infinite interference, or a surface paired with itself.
    """

    slave: str
    master: str
    friction: float = 0.0
    slave_shape: Shape | None = None
    master_shape: Shape | None = None
    interference: float = 0.0
    press_fit: bool = False
    normal: Normal = "between"

    def __post_init__(self) -> None:
        if not 0 <= self.friction < np.inf:
            raise ValueError(
                f"contact {self}: friction must be 0 or more and finite, got {self.friction:g}"
            )
        if not np.isfinite(self.interference):
            raise ValueError(
                f"contact {self}: interference must be finite, got {self.interference}"
            )
        if self.normal not in get_args(Normal):
            raise ValueError(
                f"contact {self}: normal must be 'between' or 'master', got {self.normal!r}"
            )
        if self.slave == self.master:
            raise ValueError(f"contact {self}: a boundary cannot touch itself")

    def __str__(self) -> str:
        return f"{self.slave!r} on {self.master!r}"
