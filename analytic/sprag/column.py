"""Sprag as an elastic body: a column with rounded ends under two opposite forces.

In the middle of a Hertz patch of half-width a, the logarithm of a point force (`goursat`) becomes
ln(2/a) + 1/2. For a disc, the result agrees with `hertz_line_approach.approach_to_centre` to
round-off. Neglected terms: (a/r)² and the square of the angle between forces and normals.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.optimize import brentq

from analytic.contact.checks import Array, positive
from analytic.sprag.geometry import LogSprag
from analytic.sprag.goursat import DEGREE, Complex, Outline, displaced, flamant, forces_along, rest

POINTS = 160  # of each smooth piece of the outline
STEEPEST = np.radians(75)  # largest angle from the line AB to the ends of spiral and arc


def approach(outline: Outline, *, a: tuple[float, float], nu: float, degree: int = DEGREE) -> float:
    """Approach of the load points A and B of a body, divided by P/E', in plane strain.

    The forces act through Hertz patches of the half-widths a [length].

    >>> turn = np.exp(1j * np.linspace(-1.5, 1.5, 99))
    >>> disc = Outline(A=-1j, B=1j, left=-turn.conj(), right=turn)
    >>> exact = 2 * (2 * np.log(4 / 0.01) - 1) / np.pi
    >>> bool(abs(approach(disc, a=(0.01, 0.01), nu=0.3) - exact) < 1e-9)
    True
    """
    positive(a, "half-width", "m")
    kappa = 3 - 4 * nu
    G = (kappa + 1) / 8  # of a body with E' = 1
    forces = forces_along(outline)
    others = rest(outline, forces, degree)
    total = 0.0
    for (z, F), other, half in zip(forces, forces[::-1], a, strict=True):
        there = np.array([z])
        u = sum(displaced(there, g, kappa)[0] for g in (flamant(there, other), others(there)))
        local = 2 / np.pi * (np.log(2 / half) + 0.5) - 1 / (4 * np.pi * G)
        total += float(local) + float((u * np.conj(F)).real) / (2 * G)
    return total


@dataclass(frozen=True, kw_only=True)
class Column:
    """Sprag with two flanks at the distance b [length] from each other.

    The flanks are parallel to the line through both unloaded contacts. Raises ValueError if they do
    not intersect the spiral or the arc within 75 degrees.
    """

    sprag: LogSprag
    b: float

    def __post_init__(self) -> None:
        assert self._flanks

    @property
    def turned(self) -> float:
        """Angle theta - theta_0 [rad] at which the inner contact reaches a flank."""
        (right, _), _ = self._flanks
        return float(right - self.sprag.eta_0)

    @property
    def alpha_b(self) -> float:
        """Rotation relative to OB [rad] at which the outer contact reaches a flank."""
        _, (_, left) = self._flanks
        return -float(left)

    @property
    def core(self) -> complex:
        """Point of the middle line nearest to the pole."""
        low, along = self._middle
        return complex(low - (low * np.conj(along)).real * along)

    def normal(self, turned: float) -> complex:
        """Inward unit normal at the inner contact for `turned` = theta - theta_0 [rad]."""
        m = float(np.asarray(self.sprag.m))
        inwards = -(1 - 1j * m) * complex(self._spiral(np.array(self.sprag.eta_0 + turned)))
        return inwards / abs(inwards)

    def stands(self, *, turned: float, alpha_b: float) -> bool:
        """True if both contacts lie between the flanks."""
        below, above = self._flanks
        theta = float(self.sprag.eta_0) + turned
        return bool(below[1] < theta < below[0] and above[1] < -alpha_b < above[0])

    def nearest(self, *, turned: float, alpha_b: float) -> tuple[float, float]:
        """Distances of both contacts from the nearer flank, divided by half the width.

        The values are 1 in the middle, 0 at a flank and negative beyond a flank. Angles are used in
        place of lengths.
        """
        at = float(self.sprag.eta_0) + turned, -alpha_b
        inner, outer = (
            2 * min(float(right) - angle, angle - float(left)) / float(right - left)
            for (right, left), angle in zip(self._flanks, at, strict=True)
        )
        return inner, outer

    def outline(self, *, turned: float, alpha_b: float) -> Outline | None:
        """Outline with the contacts at the angles `turned` and `alpha_b` [rad].

        The pole is at 0, the arc at +y. The result is None if a contact lies beyond a flank.
        """
        if not self.stands(turned=turned, alpha_b=alpha_b):
            return None
        theta, phi = float(self.sprag.eta_0) + turned, -alpha_b
        share = np.linspace(0, 1, POINTS + 1)[1:]
        right, left = (
            np.concatenate([
                self._spiral(theta + share * (t - theta)),
                self._spiral(t) + share * (self._arc(p) - self._spiral(t)),
                self._arc(phi + share * (p - phi))[-2::-1],
            ])
            for t, p in zip(*self._flanks, strict=True)
        )  # fmt: skip
        A, B = self._spiral(np.array(theta)), self._arc(np.array(phi))
        return Outline(A=complex(A), B=complex(B), left=left, right=right)

    def _spiral(self, theta: Array) -> Complex:
        """Points of the spiral at the angles theta [rad], anticlockwise from -y."""
        rho_0, m, eta_0 = self.sprag.rho_0, np.asarray(self.sprag.m), self.sprag.eta_0
        return np.asarray(-1j * rho_0 * np.exp((m + 1j) * theta - m * eta_0))

    def _arc(self, phi: Array) -> Complex:
        """Points of the arc at the angles phi [rad], clockwise from +y."""
        return np.asarray(1j * np.asarray(self.sprag.r_e) * np.exp(-1j * phi))

    @property
    def _middle(self) -> tuple[complex, complex]:
        """Inner contact without load, and the unit vector from it to the outer contact."""
        low = complex(self._spiral(np.asarray(self.sprag.eta_0)))
        along = 1j * float(np.asarray(self.sprag.r_e)) - low
        return low, along / abs(along)

    @cached_property
    def _flanks(self) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
        """Angles of the spiral and of the arc at the right and the left flank."""
        low, along = self._middle
        lean = float(np.angle(-1j * along))  # anticlockwise
        below = _ends(lambda t: ((self._spiral(t) - low) / along).imag, lean, self.b)
        above = _ends(lambda t: ((self._arc(t) - low) / along).imag, -lean, self.b)
        if below is None or above is None:
            raise ValueError(
                f"the width b={self.b:g} m of the sprag must not exceed the width of spiral and "
                f"arc within {np.degrees(STEEPEST):g} degrees of the middle line of the sprag"
            )
        return below, above


def _ends(
    leftwards: Callable[[Array], Array], middle: float, b: float
) -> tuple[Array, Array] | None:
    """Angles at which the curve is b/2 right and left of the middle line; None if narrower."""
    low, high = middle - STEEPEST, middle + STEEPEST
    if not leftwards(np.array(high)) < -b / 2 < b / 2 < leftwards(np.array(low)):
        return None
    right, left = (
        np.array(brentq(lambda t, x=x: float(leftwards(np.array(t))) - x, low, high, xtol=1e-14))
        for x in (-b / 2, b / 2)
    )
    return right, left
