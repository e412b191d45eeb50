r"""Approaches of the roller to both parts under P = N/L (plane strain).

The displacement of each body contains a logarithm of the distance between the contact and a
reference point. The division of an approach d into local flattening f and structural deflection u
depends on this point. Therefore, only d = f + u is computed. It is the sum of delta of half a
roller and delta of the part,

.. math:: \delta = \frac{P}{\pi E'}\left[2\ln\frac{l}{a} + k + c\,\frac{a}{l}\right]

with the following constants of the bodies:

- half a roller, from the contact to the centre: l = r, k = 2 ln 4 - 1;
- a circular race on a shaft or on a ring with a free rim: l = R, k from `series`, with the bending
  and the expansion under all z loads;
- a star that is clamped on its bore. "annulus": a disc whose rim passes through the contacts,
  l = sqrt(X² + x²), under all loads (`series`). "half space": l = 2 (X - r_b), k = -nu', the
  displacement of a half space down to the depth X - r_b, without clamping; it underestimates d_i
  by about 2 %;
- a cup with z flats: a ring whose bore encloses the same area as the flats.

The tangential force has no effect: on a ring, it causes no radial displacement at its point of
action.

References
----------
.. [1] K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, sec. 5.6.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, not_negative
from analytic.freewheel import series
from analytic.freewheel.clutch import ContactMaterial, RollerClutch
from analytic.freewheel.geometry import InnerCam

ROLLER = 2 * np.log(4) - 1  # k of half a roller


@dataclass(frozen=True, kw_only=True, eq=False)
class Body:
    """Constants of the approach of one body: E' [stress], l [length], k and c (no unit)."""

    E: Array
    l: Array  # noqa: E741
    k: Array
    c: Array | float = 0.0

    def approach(self, P: Array, a: Array) -> tuple[Array, Array]:
        """Approach [length] and its derivative by P; the half-width a is proportional to sqrt P."""
        loaded = np.where(a > 0, a, self.l)  # the product vanishes for P = 0 with any logarithm
        bracket = 2 * np.log(self.l / loaded) + self.k
        linear = self.c * loaded / self.l
        scale = 1 / (np.pi * self.E)
        return P * scale * (bracket + linear), scale * (bracket - 1 + 1.5 * linear)


@dataclass(frozen=True, kw_only=True, eq=False)
class Approaches:
    """Approaches d_i, d_o [length] and their derivatives by P [length²/force]."""

    d_i: Array
    d_o: Array
    slope_i: Array
    slope_o: Array


@dataclass(frozen=True, kw_only=True, eq=False)
class Compliance:
    """Bodies of a clutch: half a roller at each contact, inner part and outer part."""

    clutch: RollerClutch
    inner: Body
    outer: Body
    half_roller: Body

    def approaches(self, P: ArrayLike) -> Approaches:
        """Approaches d_i and d_o under P = N/L [force/length]."""
        P = not_negative(P, "load per length", "N/m")
        found = [
            np.add(part.approach(P, a), self.half_roller.approach(P, a))
            for part, a in zip((self.inner, self.outer), self.clutch.half_widths(P), strict=True)
        ]
        (d_i, slope_i), (d_o, slope_o) = found
        return Approaches(d_i=d_i, d_o=d_o, slope_i=slope_i, slope_o=slope_o)

    def tangent(self, N: ArrayLike) -> tuple[Array, Array]:
        """tan(alpha) at the normal force N, and its derivative by N [1/force].

        It follows from tan² alpha = (rho - y)/(rho + y). The values are nan beyond pop-through.
        """
        cam, L = self.clutch.cam, np.asarray(self.clutch.L)
        d = self.approaches(np.asarray(N) / L)
        rho = cam.distance(d_i=d.d_i, d_o=d.d_o)
        lower = cam.sense * (d.d_i + d.d_o - cam.pop_through)
        d_lower = cam.sense * (d.slope_i + d.slope_o) / L
        d_rho = cam.sense * (d.slope_o if cam.sense > 0 else d.slope_i) / L
        tangent = np.sqrt(np.where(lower > 0, lower, np.nan) / (2 * rho - lower))
        return tangent, (rho * d_lower - lower * d_rho) / (2 * rho - lower) ** 2 / tangent


def compliance(clutch: RollerClutch) -> Compliance:
    """Compliances of the bodies of `clutch`."""
    E, _ = clutch.roller.plane
    half = Body(E=E, l=clutch.cam.roller, k=np.asarray(ROLLER))
    flat = _star(clutch) if isinstance(clutch.cam, InnerCam) else _cup(clutch)
    race = _race(clutch)
    inner, outer = (flat, race) if isinstance(clutch.cam, InnerCam) else (race, flat)
    return Compliance(clutch=clutch, inner=inner, outer=outer, half_roller=half)


def _race(clutch: RollerClutch) -> Body:
    R = clutch.cam.race
    if isinstance(clutch.cam, InnerCam):
        return _ring(clutch, clutch.outer, R)
    with np.errstate(divide="ignore"):
        ratio = R / np.asarray(clutch.r_b)
    E, nu = clutch.inner.plane
    k = series.race_constant(ratio=ratio, n=clutch.cam.count, nu=nu, loaded="rim")
    return Body(E=E, l=R, k=k, c=series.curvature_term(nu=nu, loaded="rim"))


def _ring(clutch: RollerClutch, material: ContactMaterial, bore: Array) -> Body:
    E, nu = material.plane
    ratio = np.asarray(clutch.R_a) / bore
    k = series.race_constant(ratio=ratio, n=clutch.cam.count, nu=nu, loaded="bore")
    return Body(E=E, l=bore, k=k, c=series.curvature_term(nu=nu, loaded="bore"))


def _cup(clutch: RollerClutch) -> Body:
    """Cup as a ring whose bore has the area enclosed by the flats.

    A ring with the bore radius X_o is too stiff, one with X_o/cos(pi/z) is too compliant.
    """
    angle = np.pi / clutch.cam.count
    return _ring(clutch, clutch.outer, clutch.cam.flat * np.sqrt(np.tan(angle) / angle))


def _star(clutch: RollerClutch) -> Body:
    cam, r_b = clutch.cam, np.asarray(clutch.r_b)
    E, nu = clutch.inner.plane
    if clutch.star == "half space":
        return Body(E=E, l=2 * (cam.flat - r_b), k=-nu)
    x, _ = cam.centre(d_i=0.0, d_o=0.0)
    rim = np.hypot(cam.flat, x)
    return Body(E=E, l=rim, k=series.star_constant(ratio=rim / r_b, n=cam.count, nu=nu))
