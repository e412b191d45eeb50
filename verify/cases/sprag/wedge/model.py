"""Formulas of a sprag clutch under torque: the closure, with yields of three kinds.

- elastic: races as rings under single loads (`analytic.ring.loaded_race`), the sprag as a rounded
  column (`analytic.sprag.column`), all in plane strain. As contacts leave its middle the column
  bends and yields more: a parabola through what it has without load and at two rotations.
- plane: Hertz's line contacts to the walls' depth and to half the sprag's height, and Eq. 6 of long
  rings.
- composite: Palmgren's law, Eqs. 6 and 7, as the paper has it.

The printed closure has Eq. 9's OA in the triangle of Eq. 10.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from analytic.contact import hertz_line
from analytic.contact.checks import Array, in_plane
from analytic.ring.fourier_ring import Wall
from analytic.ring.loaded_race import LoadedRace
from analytic.sprag import column, printed
from analytic.sprag.closure import Wedged, at_torque, wedged
from analytic.sprag.clutch import Clutch
from analytic.sprag.column import Column
from analytic.sprag.compliance import Compliance
from analytic.sprag.course import energy, rolled
from analytic.sprag.laws import Law
from analytic.sprag.limits import limits, pressures
from analytic.sprag.parts import Parts
from analytic.sprag.search import first_reach
from verify.cases.sprag.inputs import WedgeInputs
from verify.core.case import Values

STROKE = {"N_0/4": 0.25, "N_0/2": 0.5, "N_0": 1.0, "1.8 N_0": 1.8}
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


def analytic(q: WedgeInputs) -> Values:
    clutch, N_0 = elastic(q), rigid_force(q)
    under = at_torque(clutch, q.T)
    if not np.isfinite(under.N):
        raise ValueError(f"the sprags never bear T = {q.T:g} N m: the spiral grows too little")
    p_i, p_e = pressures(parts(q), under)
    a_i, a_e = half_widths(q, under.N)
    values: dict[str, object] = {
        "one": 1.0, "N_0": N_0, "m": q.sprag.m, "r_e": q.sprag.r_e, "nu_0": q.sprag.nu_0,
        "omega_0": q.sprag.omega_0, "nu": under.nu, "omega": under.omega,
        "tan nu": np.tan(under.nu), "N": under.N, "T_i": under.T_i, "alpha": under.alpha_b,
        "turned": under.turned,
        "H": under.yields.H, "theta": rolled(clutch, under.N), "p_i": p_i, "p_e": p_e, "a_i": a_i,
        "a_e": a_e, "U": energy(clutch, under.N),
        "T_roll": rolls_over_at(q), "alpha plane": at_torque(plane(q), q.T).alpha_b,
        "alpha composite": at_torque(composite(q), q.T).alpha_b,
        "alpha printed": printed_at_torque(composite(q), q.T).alpha_b,
    }  # fmt: skip
    for name, share in STROKE.items():
        values |= {f"{key}, {name}": value for key, value in _at_force(q, share * N_0).items()}
    return {key: float(np.asarray(value)) for key, value in values.items()}


def _at_force(q: WedgeInputs, N: float) -> Mapping[str, object]:
    """What is compared at the normal force N [N] on the inner contact."""
    clutch, (inner, outer) = elastic(q), races(q)
    at, p = wedged(clutch, N), parts(q)
    a_i, a_e = half_widths(q, np.asarray(N))
    p_i, p_e = pressures(p, at)
    unit, N_e = 1 / (q.l * plane_modulus(q)), at.N_e
    by_paper = composite(q).compliance.yields(N)
    return {
        "tan nu": np.tan(at.nu), "tan omega": np.tan(at.omega), "N_e/N_i": N_e / N - 1, "T": at.T,
        "alpha": at.alpha_b, "H": at.yields.H, "OC_e": at.OC_e,
        "theta": rolled(clutch, N), "U": energy(clutch, N),
        "mean i": unit * inner.mean * N, "mean e": unit * outer.mean * N_e,
        "thin i": by_paper.race_i, "thin e": by_paper.race_e,
        "race i": unit * inner.under(a_i) * N, "race e": unit * outer.under(a_e) * N_e,
        "alpha plane": wedged(plane(q), N).alpha_b,
        "H composite": by_paper.H,
        "alpha composite": wedged(composite(q), N).alpha_b,
        "alpha printed": printed.wedged(clutch, N).alpha_b,
        "p_i": p_i, "p_e": p_e, "a_i": a_i, "a_e": a_e,
    }  # fmt: skip
