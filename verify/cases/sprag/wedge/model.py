"""Sprag clutches as the formulas take them: the closure, with yields of three kinds.

- elastic: races as rings under single loads (`analytic.ring.loaded_race`), the sprag as a rounded
  column (`analytic.sprag.column`), all in plane strain. As contacts leave its middle the column
  bends and yields more: a parabola through what it has without load and at two rotations.
- plane: Hertz's line contacts to the walls' depth and to half the sprag's height, and Eq. 6 of long
  rings.
- composite: Palmgren's law, Eqs. 6 and 7, as the paper has it.

The printed closure has Eq. 9's OA in the triangle of Eq. 10.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from analytic.contact import hertz_line
from analytic.contact.checks import Array, in_plane
from analytic.ring.fourier_ring import Wall
from analytic.ring.loaded_race import LoadedRace
from analytic.sprag import column, printed
from analytic.sprag.closure import Wedged, wedged
from analytic.sprag.clutch import Clutch
from analytic.sprag.column import Column
from analytic.sprag.compliance import Compliance
from analytic.sprag.laws import Law
from analytic.sprag.limits import limits
from analytic.sprag.parts import Parts
from analytic.sprag.search import first_reach
from verify.cases.sprag.inputs import WedgeInputs

MOST_FRICTION = 0.99  # no limit here
BENDING = 0.2, 0.5  # of the rotation with a contact at a flank, where the column's bending is taken


@dataclass(frozen=True)
class Race:
    """A race under one of its loads in plane strain, over P/E': mean, middle, mean over a patch."""

    mean: float
    middle: float  # at the half-width r/1000
    a: float

    def at(self, a: Array) -> Array:
        """At the middle of a patch of the half-width `a` [m]; what is left out is of (a/r)²."""
        return np.asarray(self.middle + 2 / np.pi * np.log(self.a / a))

    def under(self, a: Array) -> Array:
        """On the average over the pressure, which is 1/4 of 2/pi below."""
        return np.asarray(self.at(a) - 1 / (2 * np.pi))


@lru_cache(maxsize=32)
def parts(q: WedgeInputs) -> Parts:
    return Parts(sprag=q.sprag, n_s=q.z, l=q.l, b=q.b, R_id=q.R_id, R_ed=q.R_ed, E=q.E, nu=q.nu)


def rigid_force(q: WedgeInputs) -> float:
    """N_0 = T/(n_s R_i tan(nu_0)) [N]."""
    return float(q.T / (q.z * q.R_i * np.tan(q.nu_0)))


def plane_modulus(q: WedgeInputs) -> float:
    """E/(1 - nu²) [Pa]."""
    return float(in_plane(q.E, q.nu, "plane strain")[0])


def half_widths(q: WedgeInputs, N: Array) -> tuple[Array, Array]:
    """Hertz's half-widths [m] at both contacts under N [N]."""
    p = parts(q)
    a_i, a_e = (
        hertz_line.half_width(P=np.where(N > 0, N, 1e-300) / q.l, R=R, E_star=p.E_star)
        for R in (p.R_contact_i, p.R_contact_e)
    )
    return a_i, a_e


@lru_cache(maxsize=32)
def races(q: WedgeInputs) -> tuple[Race, Race]:
    inner = _race(q, q.R_id, q.R_i, "rim")
    return inner, _race(q, q.R_e, q.R_ed, "bore")


def _race(q: WedgeInputs, r_i: float, r_o: float, loaded: Wall) -> Race:
    a = 1e-3 * (r_i if loaded == "bore" else r_o)
    ring = LoadedRace(
        r_i=r_i, r_o=r_o, E=q.E, nu=q.nu, assumption="plane strain", loaded=loaded, n=q.z,
        P=plane_modulus(q), a=a,
    )  # fmt: skip
    mean, middle = ring.ring.mean_displacement(ring.r), ring.displacement(ring.r, 0.0)
    return Race(abs(float(mean)), abs(middle), a)


@lru_cache(maxsize=32)
def sprag_column(q: WedgeInputs) -> Column | None:
    """The sprag between its flanks; None where it is wider than it is round."""
    try:
        return Column(sprag=q.sprag, b=q.b)
    except ValueError:
        return None


def column_constant(q: WedgeInputs, *, turned: float, alpha_b: float) -> float | None:
    """A sprag's approach over P/E' but for the logarithms of both half-widths in metres.

    None where it does not stand between its flanks.
    """
    whole = sprag_column(q)
    outline = whole and whole.outline(turned=turned, alpha_b=alpha_b)
    return column.approach(outline, a=(1.0, 1.0), nu=q.nu) if outline else None


def disc_constant(q: WedgeInputs) -> float:
    """The same of the disc between both races, which a sprag without flanks about is."""
    return 2 / math.pi * (2 * math.log(2 * (q.R_e - q.R_i)) - 1)


def elastic_compliance(q: WedgeInputs, constant: Callable[[Array], Array]) -> Compliance:
    """Races as rings under single loads: what exceeds their mean is the contacts' own.

    `constant(N)` is the sprag's, as of `column_constant`; each contact has half of it.
    """
    unit = 1 / (q.l * plane_modulus(q))
    inner, outer = races(q)

    def law(race: Race, which: int) -> Law:
        def approach(N: Array) -> Array:
            a = half_widths(q, N)[which]
            over = race.at(a) - race.mean + constant(N) / 2 - 2 / np.pi * np.log(a)
            return np.where(N > 0, N * unit * over, 0.0 * N)

        return approach

    return Compliance(
        contact_i=law(inner, 0), contact_e=law(outer, 1), race_i=unit * inner.mean,
        race_e=unit * outer.mean, sprag=0.0,
    )  # fmt: skip


@lru_cache(maxsize=32)
def elastic(q: WedgeInputs) -> Clutch:
    """The clutch whose parts yield as elastic bodies."""
    still = column_constant(q, turned=0.0, alpha_b=0.0) or disc_constant(q)
    compliance = elastic_compliance(q, lambda N: np.full_like(N, still))
    clutch = Clutch(sprag=q.sprag, n_s=q.z, compliance=compliance)
    bent = [(float(at.N), column_constant(q, turned=float(at.turned), alpha_b=float(at.alpha_b)))
            for at in _on_the_way(q, clutch)]  # fmt: skip
    (N_1, half), (N_2, full) = bent if len(bent) == 2 else [(1.0, None), (2.0, None)]
    if half is None or full is None:
        return clutch
    slope_1, slope_2 = (half - still) / N_1, (full - still) / N_2
    second = (slope_2 - slope_1) / (N_2 - N_1)

    def bending(N: Array) -> Array:
        return np.asarray(still + N * (slope_1 + second * (N - N_1)))

    return replace(clutch, compliance=elastic_compliance(q, bending))


def _on_the_way(q: WedgeInputs, clutch: Clutch) -> list[Wedged]:
    """States of rotations at `BENDING` of that with a contact at a flank, as far as there are."""
    whole = sprag_column(q)
    if whole is None:
        return []
    turned = np.array(BENDING) * min(whole.turned, whole.alpha_b)
    start = np.full_like(turned, 1e-4 * plane_modulus(q) * q.l * q.R_i)
    found = first_reach(lambda N: np.asarray(wedged(clutch, N).turned), turned, start=start)
    return [wedged(clutch, N) for N in found if np.isfinite(N)]


@lru_cache(maxsize=32)
def plane(q: WedgeInputs) -> Clutch:
    return Clutch(sprag=q.sprag, n_s=q.z, compliance=parts(q).plane())


@lru_cache(maxsize=32)
def composite(q: WedgeInputs) -> Clutch:
    return Clutch(sprag=q.sprag, n_s=q.z, compliance=parts(q).palmgren())


def printed_at_torque(clutch: Clutch, T: float) -> Wedged:
    """The state of the printed closure under the torque T [N m]."""
    start = np.asarray(T / (clutch.n_s * np.asarray(clutch.sprag.R_i) * np.tan(clutch.sprag.nu_0)))
    N = first_reach(lambda N: printed.wedged(clutch, N).T, np.asarray(T), start=start)
    return printed.wedged(clutch, N)


def rolls_over_at(q: WedgeInputs) -> float:
    """Torque [N m] at which a contact reaches a flank; infinite where none does."""
    whole = sprag_column(q)
    if whole is None:
        return math.inf
    turned = min(whole.turned, whole.alpha_b)  # alpha_b is theta - theta_0 but for 1 %
    return float(limits(elastic(q), mu=MOST_FRICTION, theta_max=turned).end_of_cam)
