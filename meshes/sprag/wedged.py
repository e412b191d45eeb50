"""Sprag between races: spiral, position, and mesh of one pitch in the compressed state.

The view is along the axis O, with the sprag above O. Angles are measured clockwise from the line
through O and the pole. The sprag rotates clockwise into the wedge.
"""

import math
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

import numpy as np
from scipy.optimize import brentq

from meshes.sprag.profile import Placed, Sprag

if TYPE_CHECKING:
    from skfem.mesh import Mesh2D

GROWTHS = 1e-5, 0.95  # range of growths of the spiral in the search for a wedge angle


@dataclass(frozen=True)
class Races:
    """Set of z sprags of width `b` between the races `R_id`..`R_i` and `R_e`..`R_ed` [m].

    At first contact, the spiral has the radius of curvature `r_i` [m], and the wedge angle is
    `nu_0` [rad].
    """

    R_id: float
    R_i: float
    R_e: float
    R_ed: float
    r_i: float
    nu_0: float
    z: int
    b: float

    @property
    def sprag(self) -> Sprag:
        """Sprag without load."""
        first = first_contact(self.R_i, self.R_e, self.r_i, self.nu_0)
        return Sprag(first.rho, first.theta, first.m, self.R_e - math.hypot(*first.pole), self.b)


@dataclass(frozen=True)
class FirstContact:
    """Pole and contacts [m] at first contact of a spiral of growth `m`.

    The inner contact is on +y.
    """

    R_i: float
    R_e: float
    r_i: float
    m: float

    @property
    def rho(self) -> float:
        """Distance [m] from the pole to the inner contact, where the radius of curvature is r_i."""
        return self.r_i / math.hypot(1, self.m)

    @property
    def pole(self) -> tuple[float, float]:
        """Position of the pole, from the angle arctan m between radius and normal of a spiral."""
        x = math.hypot(1, self.m)
        return -self.rho * self.m / x, self.R_i + self.rho / x

    @property
    def wedge(self) -> float:
        """Angle nu_0 between the line through both contacts and the normal of the inner contact."""
        x, y = self.pole
        share = self.R_e / math.hypot(x, y)
        return math.atan2(-share * x, share * y - self.R_i)

    @property
    def theta(self) -> float:
        """Angle [rad] at the pole between the lines to O and to the inner contact."""
        x, y = self.pole
        return math.atan2(x * (y - self.R_i) - y * x, x * x + y * (y - self.R_i))


@lru_cache(64)
def first_contact(R_i: float, R_e: float, r_i: float, nu_0: float) -> FirstContact:
    """First contact of the sprag with the wedge angle `nu_0` [rad].

    Raises ValueError if no spiral has this wedge angle.
    """

    def missing(m: float) -> float:
        return FirstContact(R_i, R_e, r_i, m).wedge - nu_0

    low, high = GROWTHS
    if not missing(low) < 0 < missing(high):
        raise ValueError(f"no spiral between the races has the wedge angle nu_0 = {nu_0:.4g} rad")
    return FirstContact(R_i, R_e, r_i, brentq(missing, low, high, xtol=1e-15))


@dataclass(frozen=True)
class Place:
    """Position of the sprag: rotated by `alpha` [rad], pole at the distance `D` [m] from O.

    `shares` are the fractions of the inner and of the outer overlap that are deflections of the
    races; the rest is deflection of the sprag. Bodies are meshed in the compressed state, so that
    forces act at their real positions. `bends` [m] are the overlaps that remain in the mesh at both
    contacts: the mean distance between the curved surfaces, weighted by the pressure.
    """

    q: Races
    alpha: float
    D: float
    shares: tuple[float, float] = (0.6, 0.8)
    bends: tuple[float, float] = (0.0, 0.0)

    @classmethod
    def overlapping(cls, q: Races, alpha: float) -> "Place":
        """Position rotated by `alpha`, with nearly equal overlaps of both contacts."""
        D = q.R_e - q.sprag.r_e
        return cls(q, alpha, D + cls(q, alpha, D).overlaps[0] / 2)

    @cached_property
    def free(self) -> Placed:
        """Sprag with its undeformed outline in this position; it overlaps both races."""
        return Placed(self.q.sprag, (0.0, self.D), self.alpha)

    @cached_property
    def overlaps(self) -> tuple[float, float]:
        """Overlaps [m] of the undeformed outlines at both contacts: the deflections there."""
        at = self.free
        return self.q.R_i - math.hypot(*at.inner), math.hypot(*at.outer) - self.q.R_e

    @property
    def H(self) -> float:
        """Total deflection [m]."""
        return sum(self.overlaps)

    @property
    def OA(self) -> float:
        """Radius [m] at which the force of the inner contact acts."""
        return self.q.R_i - self.shares[0] * self.overlaps[0]

    @property
    def OB(self) -> float:
        """Radius [m] at which the force of the outer contact acts."""
        return self.q.R_e + self.shares[1] * self.overlaps[1]

    @property
    def beta(self) -> float:
        """Angle AOB [rad]."""
        (x_i, y_i), (x_e, y_e) = self.free.inner, self.free.outer
        return math.atan2(x_i * y_e - y_i * x_e, x_i * x_e + y_i * y_e)

    @property
    def strut(self) -> tuple[float, float]:
        """Angles [rad] of the line AB with OA (nu) and with OB (omega)."""
        x, y = self.OB * math.sin(self.beta), self.OB * math.cos(self.beta)
        nu = math.atan2(x, y - self.OA)
        return nu, nu - self.beta

    @cached_property
    def drawn(self) -> Placed:
        """Compressed sprag, whose ends have moved along their normals."""
        at, (x_i, y_i) = self.free, self.free.inner
        inwards = (self.OA - self.bends[0]) / math.hypot(x_i, y_i) - 1
        pole = x_i * inwards, self.D + y_i * inwards
        away = -pole[0], self.OB + self.bends[1] - at.sprag.r_e - pole[1]
        c, s = math.cos(self.alpha), math.sin(self.alpha)
        centre = c * away[0] - s * away[1], s * away[0] + c * away[1]
        return Placed(replace(at.sprag, centre=centre), pole, self.alpha)

    @property
    def core(self) -> tuple[float, float]:
        """Point on the middle line of the compressed sprag that is nearest to the pole."""
        at = self.drawn
        low, high = np.array(at.sprag.middle)
        along = (high - low) / np.hypot(*(high - low))
        x, y = at.placed(low - (low @ along) * along)
        return float(x), float(y)

    @property
    def touched(self) -> tuple[float, float]:
        """Coordinates y [m] of both contacts of the compressed sprag; O is at y = 0."""
        return self.drawn.inner[1], self.drawn.outer[1]

    @property
    def spiral(self) -> tuple[tuple[float, float], float, float, float]:
        """Spiral of the compressed sprag: pole, radius rho_0 [m], its direction [rad], growth m.

        The direction is measured from +x.
        """
        at, s = self.drawn, self.drawn.sprag
        return at.pole, s.rho_0, s.theta_0 - at.turn - math.pi / 2, s.m

    @property
    def arc(self) -> tuple[tuple[float, float], float]:
        """Arc of the compressed sprag: centre and radius [m]."""
        x, y = self.drawn.placed(np.array(self.drawn.sprag.centre))
        return (float(x), float(y)), self.drawn.sprag.r_e

    def settled(
        self, outwards: float, races: tuple[float, float], opened: tuple[float, float]
    ) -> "Place":
        """Position of the sprag after a displacement `outwards` [m].

        The races have moved outwards at the contacts by `races` [m], and the gap between the curved
        surfaces in the mesh has increased by `opened` [m].
        """
        moved = replace(self, D=self.D + outwards)
        (inner, outer), (d_i, d_e) = races, moved.overlaps
        b_i, b_e = (before + more for before, more in zip(self.bends, opened, strict=True))
        return replace(moved, shares=(-inner / d_i, outer / d_e), bends=(b_i, b_e))

    def turned(self, alpha: float) -> tuple["Place", float]:
        """Approximate position rotated by `alpha` [rad], and ratio of its H to the present H."""
        far = Place.overlapping(self.q, alpha)
        share, (b_i, b_e) = far.H / self.H, self.bends
        # as the overlaps of both contacts share the whole
        D = far.D + share * self.overlaps[1] - far.overlaps[1]
        return replace(self, alpha=alpha, D=D, bends=(share * b_i, share * b_e)), share

    def mesh(self, zones: tuple[float, float], cells: int) -> "Mesh2D":
        """Mesh of one pitch with `cells` cells on each half of the fine zones.

        `zones` are the half-widths [m] of the fine zones at the inner and the outer contact.
        """
        from meshes.sprag.sector import sprag_sector

        q, at = self.q, self.drawn
        return sprag_sector(
            R_id=q.R_id * self.OA / q.R_i, R_i=self.OA, R_e=self.OB, R_ed=q.R_ed * self.OB / q.R_e,
            z=q.z, sprag=at.sprag, pole=at.pole, turn=at.turn, zones=zones, cells=cells,
        )  # fmt: skip
