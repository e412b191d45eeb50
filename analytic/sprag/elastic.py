"""Sprag clutches whose parts deflect as elastic bodies, or by two simpler laws for comparison.

- elastic: races are rings under single loads (`analytic.ring.loaded_race`), the sprag is a column
  with rounded ends (`analytic.sprag.column`), all in plane strain. If the contacts are eccentric,
  the column bends, and its compliance increases. It is approximated by a parabola over N through
  the values without load and at two rotations.
- plane: Hertz's line contacts, with deflections down to the depth of the walls and to half the
  height of the sprag, and Eq. 6 for long rings.
- composite: Palmgren's law and Eqs. 6 and 7, as in the paper.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact import hertz_line
from analytic.contact.checks import Array, in_plane
from analytic.ring.fourier_ring import Wall
from analytic.ring.loaded_race import LoadedRace
from analytic.sprag import column
from analytic.sprag.closure import Wedged, wedged
from analytic.sprag.clutch import SpragClutch
from analytic.sprag.column import Column
from analytic.sprag.compliance import Compliance
from analytic.sprag.laws import Law
from analytic.sprag.limits import sprag_torque_limits
from analytic.sprag.parts import SpragClutchParts
from analytic.sprag.search import first_reach

MOST_FRICTION = 0.99  # no limit here
BENDING = 0.2, 0.5  # relative to the rotation with a contact at a flank: evaluation of the bending


@dataclass(frozen=True)
class Race:
    """Deflections of a race under one of its loads in plane strain, divided by P/E'."""

    mean: float
    middle: float  # at the half-width r/1000
    a: float

    def at(self, a: Array) -> Array:
        """Deflection in the middle of a patch of half-width `a` [m], with an error of (a/r)²."""
        return np.asarray(self.middle + 2 / np.pi * np.log(self.a / a))

    def under(self, a: Array) -> Array:
        """Mean of `at` over a patch, weighted with elliptic pressure: at(a) - 1/(2 pi)."""
        return np.asarray(self.at(a) - 1 / (2 * np.pi))


@dataclass(frozen=True, eq=False)
class ElasticSpragClutch:
    """Sprag clutch of given parts with a choice of deflection laws; dimensions must be scalars."""

    parts: SpragClutchParts

    @cached_property
    def E_plane(self) -> float:
        """Modulus E/(1 - nu²) [Pa] of plane strain."""
        return float(in_plane(self.parts.E, self.parts.nu, "plane strain")[0])

    def half_widths(self, N: Array) -> tuple[Array, Array]:
        """Hertz's half-widths [m] of the inner and the outer contact under N [N]."""
        p = self.parts
        a_i, a_e = (
            hertz_line.half_width(P=np.where(N > 0, N, 1e-300) / p.l, R=R, E_star=p.E_star)
            for R in (p.R_contact_i, p.R_contact_e)
        )
        return a_i, a_e

    @cached_property
    def races(self) -> tuple[Race, Race]:
        """Deflections of the inner and the outer race, each under one of its loads."""
        p, sprag = self.parts, self.parts.sprag
        return self._race(p.R_id, sprag.R_i, "rim"), self._race(sprag.R_e, p.R_ed, "bore")

    def _race(self, inside: ArrayLike, outside: ArrayLike, loaded: Wall) -> Race:
        r_i, r_o = float(np.asarray(inside)), float(np.asarray(outside))
        p, a = self.parts, 1e-3 * (r_i if loaded == "bore" else r_o)
        ring = LoadedRace(
            r_i=r_i, r_o=r_o, E=float(np.asarray(p.E)), nu=p.nu, assumption="plane strain",
            loaded=loaded, n=p.n_s, P=self.E_plane, a=a,
        )  # fmt: skip
        mean, middle = ring.ring.mean_displacement(ring.r), ring.displacement(ring.r, 0.0)
        return Race(abs(float(mean)), abs(middle), a)

    @cached_property
    def column(self) -> Column | None:
        """Sprag as a column between its flanks; None if it is wider than its spiral and arc."""
        try:
            return Column(sprag=self.parts.sprag, b=float(np.asarray(self.parts.b)))
        except ValueError:
            return None

    @cached_property
    def clutch(self) -> SpragClutch:
        """Clutch whose races and sprags deflect as elastic bodies."""
        sprag, n_s = self.parts.sprag, self.parts.n_s
        still = self._constant(turned=0.0, alpha_b=0.0) or self._disc
        compliance = self._compliance(lambda N: np.full_like(N, still))
        clutch = SpragClutch(sprag=sprag, n_s=n_s, compliance=compliance)
        bent = [(float(at.N), self._constant(turned=float(at.turned), alpha_b=float(at.alpha_b)))
                for at in self._on_the_way(clutch)]  # fmt: skip
        (N_1, half), (N_2, full) = bent if len(bent) == 2 else [(1.0, None), (2.0, None)]
        if half is None or full is None:
            return clutch
        slope_1, slope_2 = (half - still) / N_1, (full - still) / N_2
        second = (slope_2 - slope_1) / (N_2 - N_1)

        def bending(N: Array) -> Array:
            return np.asarray(still + N * (slope_1 + second * (N - N_1)))

        return replace(clutch, compliance=self._compliance(bending))

    @cached_property
    def plane(self) -> SpragClutch:
        """Clutch with Hertz's line contacts and Eq. 6 for long rings."""
        p = self.parts
        return SpragClutch(sprag=p.sprag, n_s=p.n_s, compliance=p.plane())

    @cached_property
    def composite(self) -> SpragClutch:
        """Clutch with Palmgren's law and Eqs. 6 and 7."""
        p = self.parts
        return SpragClutch(sprag=p.sprag, n_s=p.n_s, compliance=p.palmgren())

    @cached_property
    def by_contacts_and_races(self) -> SpragClutch:
        """Clutch with Palmgren's law and Eq. 6; with Eq. 7, the sprag would be counted twice."""
        compliance = replace(self.parts.palmgren(), sprag=0.0)
        return replace(self.composite, compliance=compliance)

    @property
    def rolls_over_at(self) -> float:
        """Torque [N m] at which a contact reaches a flank; infinite if no contact reaches one."""
        if self.column is None:
            return math.inf
        turned = min(self.column.turned, self.column.alpha_b)  # theta - theta_0 within 1 %
        return float(
            sprag_torque_limits(self.clutch, mu=MOST_FRICTION, theta_max=turned).end_of_cam
        )

    def _constant(self, *, turned: float, alpha_b: float) -> float | None:
        """Approach of a sprag divided by P/E', without the logarithms of the half-widths in metres.

        The result is None if a contact is beyond a flank.
        """
        outline = self.column and self.column.outline(turned=turned, alpha_b=alpha_b)
        return column.approach(outline, a=(1.0, 1.0), nu=self.parts.nu) if outline else None

    @property
    def _disc(self) -> float:
        """Approach of a disc between both races divided by P/E', for a sprag without flanks."""
        R_i, R_e = (float(np.asarray(R)) for R in (self.parts.sprag.R_i, self.parts.sprag.R_e))
        return 2 / math.pi * (2 * math.log(2 * (R_e - R_i)) - 1)

    def _compliance(self, constant: Callable[[Array], Array]) -> Compliance:
        """Compliance with races as rings under single loads.

        The difference of a ring's deflection from its mean is part of the contact law.
        `constant(N)` is the approach of the sprag as in `_constant`; half of it counts for each
        contact.
        """
        unit = 1 / (float(np.asarray(self.parts.l)) * self.E_plane)
        inner, outer = self.races

        def law(race: Race, which: int) -> Law:
            def approach(N: Array) -> Array:
                a = self.half_widths(N)[which]
                over = race.at(a) - race.mean + constant(N) / 2 - 2 / np.pi * np.log(a)
                return np.where(N > 0, N * unit * over, 0.0 * N)

            return approach

        return Compliance(
            contact_i=law(inner, 0), contact_e=law(outer, 1), race_i=unit * inner.mean,
            race_e=unit * outer.mean, sprag=0.0,
        )  # fmt: skip

    def _on_the_way(self, clutch: SpragClutch) -> list[Wedged]:
        """States at the fractions `BENDING` of the rotation at which a contact reaches a flank.

        States without equilibrium are omitted.
        """
        whole, p = self.column, self.parts
        if whole is None:
            return []
        turned = np.array(BENDING) * min(whole.turned, whole.alpha_b)
        small = 1e-4 * self.E_plane * np.asarray(p.l) * np.asarray(p.sprag.R_i)
        start = np.full_like(turned, small)
        found = first_reach(lambda N: np.asarray(wedged(clutch, N).turned), turned, start=start)
        return [wedged(clutch, N) for N in found if np.isfinite(N)]


Elastic = ElasticSpragClutch  # its name in version 0.1
