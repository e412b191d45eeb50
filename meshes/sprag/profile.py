"""Outline of a sprag (spiral below, arc above, two straight flanks), and contacts with races.

In the local frame, the pole of the spiral is the origin and the top of the arc is on +y. Directions
of the spiral are measured anticlockwise from -y, angles of the arc clockwise from +y.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

if TYPE_CHECKING:
    from meshes.contact.blocks import Point

Array = NDArray[np.float64]

STEEPEST = math.radians(75)  # largest angle from the column's line to the ends of spiral and arc


@dataclass(frozen=True)
class Sprag:
    """Column between the spiral rho = `rho_0` exp(`m` (theta - `theta_0`)) and an arc.

    `r_e` is the radius of the arc. The spiral is about the pole, the arc about `centre`; all
    lengths have the same unit. `centre` is the pole, unless the sprag is in the compressed state.
    The middle line of the column passes through the point of the spiral at `theta_0` [rad] and the
    top of the arc. The column has the width `b`.
    """

    rho_0: float
    theta_0: float
    m: float
    r_e: float
    b: float
    centre: "Point" = (0.0, 0.0)

    def __post_init__(self) -> None:
        for name, value in (("rho_0", self.rho_0), ("r_e", self.r_e), ("b", self.b)):
            if not 0 < value < math.inf:
                raise ValueError(f"a sprag must have {name} > 0, got {name}={value:g} m")
        if not (0 < self.m < 1 and abs(self.theta_0) < math.pi / 4):
            raise ValueError(
                "the spiral of a sprag must have 0 < m < 1 and theta_0 within 45 degrees, got "
                f"m={self.m:g}, theta_0={self.theta_0:g} rad"
            )
        for end, place in (("spiral", self._ends_below), ("arc", self._ends_above)):
            if place is None:
                raise ValueError(
                    f"the width b={self.b:g} m of a sprag must not exceed the width of its {end}, "
                    f"which extends {math.degrees(STEEPEST):g} degrees to both sides of the middle"
                )

    @property
    def below(self) -> tuple[float, float]:
        """Directions [rad] at which the left and the right flank end the spiral."""
        assert self._ends_below is not None
        return self._ends_below

    @property
    def above(self) -> tuple[float, float]:
        """Directions [rad] at which the left and the right flank end the arc."""
        assert self._ends_above is not None
        return self._ends_above

    def radius(self, theta: float) -> float:
        """Radius of the spiral in the direction `theta` [rad]."""
        return self.rho_0 * math.exp(self.m * (theta - self.theta_0))

    def along_spiral(self, start: float, s: Array) -> Array:
        """Points (2, ...) of the spiral at the lengths `s` (...) from the direction `start`."""
        reach = math.sqrt(1 + self.m**2)
        grown = np.log1p(self.m * s / (reach * self.radius(start))) / self.m
        rho = self.radius(start) * np.exp(self.m * grown)
        return np.asarray(rho * np.array([np.sin(start + grown), -np.cos(start + grown)]))

    def spiral_length(self, start: float, end: float) -> float:
        """Length of the spiral from the direction `start` to `end`, with sign."""
        grown = self.radius(end) - self.radius(start)
        return grown * math.sqrt(1 + self.m**2) / self.m

    def along_arc(self, start: float, s: Array) -> Array:
        """Points (2, ...) of the arc at the lengths `s` (...) from the direction `start`."""
        angle = start + s / self.r_e
        x, y = self.centre
        return np.array([x + self.r_e * np.sin(angle), y + self.r_e * np.cos(angle)])

    @cached_property
    def middle(self) -> tuple["Point", "Point"]:
        """Ends of the middle line of the column: on the spiral and on the arc."""
        x, y = self.centre
        low = self.rho_0 * math.sin(self.theta_0), -self.rho_0 * math.cos(self.theta_0)
        return low, (x, y + self.r_e)

    @property
    def lean(self) -> float:
        """Direction of the middle line, clockwise from +y [rad]."""
        (x_0, y_0), (x_1, y_1) = self.middle
        return math.atan2(x_1 - x_0, y_1 - y_0)

    def _across(self, x: float, y: float) -> float:
        """Distance of a point from the middle line, positive to the right."""
        (x_0, y_0), _ = self.middle
        return (x - x_0) * math.cos(self.lean) - (y - y_0) * math.sin(self.lean)

    @cached_property
    def _ends_below(self) -> tuple[float, float] | None:
        def across(theta: float) -> float:
            rho = self.radius(theta)
            return self._across(rho * math.sin(theta), -rho * math.cos(theta))

        return self._ends(across, -self.lean)

    @cached_property
    def _ends_above(self) -> tuple[float, float] | None:
        def across(phi: float) -> float:
            x, y = self.centre
            return self._across(x + self.r_e * math.sin(phi), y + self.r_e * math.cos(phi))

        return self._ends(across, self.lean)

    def _ends(self, across: Callable[[float], float], middle: float) -> tuple[float, float] | None:
        """Angles at which `across` equals half the width on both sides of `middle`, or None."""
        low, high = middle - STEEPEST, middle + STEEPEST
        half = self.b / 2
        if not across(low) < -half < half < across(high):
            return None
        left, right = (
            brentq(lambda angle, side=side: across(angle) - side, low, high, xtol=1e-14)
            for side in (-half, half)
        )
        return left, right


@dataclass(frozen=True)
class Placed:
    """Sprag with its pole at `pole`, rotated clockwise by `turn` [rad]; the axis is (0, 0)."""

    sprag: Sprag
    pole: "Point"
    turn: float

    @cached_property
    def theta(self) -> float:
        """Direction [rad] at which the normal of the spiral passes through the axis.

        Raises ValueError if this direction is beyond the flanks.
        """
        sprag = self.sprag
        left, right = sprag.below

        def off(theta: float) -> float:
            """Position vector of a point of the spiral, projected onto its tangent there."""
            c, s = math.cos(theta - self.turn), math.sin(theta - self.turn)
            x, y = self.pole
            return x * (sprag.m * s + c) + y * (s - sprag.m * c) + sprag.m * sprag.radius(theta)

        if not off(left) < 0 < off(right):
            raise ValueError(
                f"the sprag, rotated by {math.degrees(self.turn):.4g} degrees, touches the inner "
                "race beyond a flank: make the sprag wider or rotate it less"
            )
        return brentq(off, left, right, xtol=1e-15)

    @cached_property
    def phi(self) -> float:
        """Direction [rad] at which the normal of the arc passes through the axis."""
        left, right = self.sprag.above
        x, y = self.placed(np.array(self.sprag.centre))
        phi = math.atan2(x, y) - self.turn
        if not left < phi < right:
            raise ValueError(
                f"the sprag, rotated by {math.degrees(self.turn):.4g} degrees, touches the outer "
                "race beyond a flank: make the sprag wider or rotate it less"
            )
        return phi

    @property
    def inner(self) -> "Point":
        """Point of the spiral whose normal passes through the axis."""
        x, y = self.placed(self.sprag.along_spiral(self.theta, np.zeros(())))
        return float(x), float(y)

    @property
    def outer(self) -> "Point":
        """Point of the arc whose normal passes through the axis."""
        x, y = self.placed(self.sprag.along_arc(self.phi, np.zeros(())))
        return float(x), float(y)

    def placed(self, x: Array) -> Array:
        """Positions in space of points (2, ...) given in the local frame of the sprag."""
        c, s = math.cos(self.turn), math.sin(self.turn)
        return np.array([c * x[0] + s * x[1] + self.pole[0], c * x[1] - s * x[0] + self.pole[1]])
