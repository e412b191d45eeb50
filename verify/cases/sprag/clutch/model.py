"""Formulas of one's own sprag clutch: its state under torque, its pressures by slices."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from analytic.contact import slices
from analytic.contact.sliced import SlicedContact
from analytic.sprag import printed
from analytic.sprag.closure import Wedged, at_torque, wedged
from analytic.sprag.clutch import Clutch
from analytic.sprag.course import rolled
from analytic.sprag.geometry import strut, triangle
from analytic.sprag.laws import LOADS
from analytic.sprag.parts import Parts
from analytic.sprag.search import first_reach
from verify.cases.sprag.engagement.model import clutch, gap, parts
from verify.cases.sprag.inputs import SpragInputs
from verify.core.figures import Array

WIDE = 0.15  # of the inner contact's relative radius: half-widths up to which Hertz is asked
MANY, FEW_LOADS = 61, 21  # slices from which on fewer loads make up a contact's law
HALF = 0.5  # of N, where the ends of a crown are free and strips have a highest pressure
STEP = 1e-6  # of a load or length, for slopes


@dataclass(frozen=True, eq=False)
class Built:
    """A clutch with crowned contacts: `gap` [m] of the slices, `N_top` [N] where its laws end."""

    parts: Parts
    clutch: Clutch
    gap: Array
    N_top: float

    def radii(self, now: Wedged) -> tuple[float, float]:
        """Relative radii [m] of the inner and the outer contact under load."""
        sprag = self.parts.sprag
        r_i = float(now.rho * np.hypot(1, sprag.m))
        R_i = float(np.asarray(sprag.R_i))
        return 1 / (1 / r_i + 1 / R_i), float(self.parts.R_contact_e)

    def pressed(self, N: float) -> tuple[SlicedContact, SlicedContact]:
        """The inner and the outer contact under the normal force N [N], slice by slice."""
        now = wedged(self.clutch, N)
        given = {"length": self.parts.l, "E_star": self.parts.E_star}
        loads = float(now.N), float(now.N_e)
        inner, outer = (
            slices.press(self.gap, R=R, load=load, **given)
            for R, load in zip(self.radii(now), loads, strict=True)
        )
        return inner, outer

    def peaks(self, N: float) -> tuple[float, float]:
        """Largest pressures [Pa] of both contacts under N [N]."""
        inner, outer = self.pressed(N)
        return float(inner.peak_pressure.max()), float(outer.peak_pressure.max())


@lru_cache(maxsize=16)
def built(q: SpragInputs) -> Built:
    whole = parts(q)
    N_top = WIDE**2 * np.pi / 4 * q.l * float(whole.R_contact_i) * float(whole.E_star)
    found = clutch(q, 1.01 * N_top, LOADS if q.slices < MANY else FEW_LOADS)
    return Built(whole, found, gap(q), N_top)


@lru_cache(maxsize=16)
def under(q: SpragInputs) -> Wedged | None:
    """The state under the torque; None where no load that the contacts can tell bears it."""
    one = built(q)
    now = at_torque(one.clutch, q.T)
    return now if np.isfinite(now.N) and one.N_top >= now.N else None


def mid(contact: SlicedContact) -> float:
    """Pressure [Pa] at mid-length; between two slices the mean of their squares, which are loads.

    >>> one = slices.press([0.0] * 4, length=1.0, R=1.0, E_star=1.0, load=1.0)
    >>> bool(np.isclose(mid(one), one.peak_pressure[1]))
    True
    """
    p, n = contact.peak_pressure, contact.force.shape[-1]
    return float(np.sqrt((p[(n - 1) // 2] ** 2 + p[n // 2] ** 2) / 2))


def stiffness(clutch: Clutch, N: float) -> float:
    """Torsional stiffness dT/dtheta_i [N m/rad] of the clutch under N [N]."""
    around = N * np.array([1 - STEP**0.5, 1 + STEP**0.5])
    T, turn = wedged(clutch, around).T, rolled(clutch, around)
    return float((T[1] - T[0]) / (turn[1] - turn[0]))


def first_contact(q: SpragInputs, *, dR_i: float = 0.0, dR_e: float = 0.0) -> tuple[float, float]:
    """Wedge angle and turn of the same sprag [rad] between races that are off by dR [m]."""
    sprag = q.sprag
    OA, OB = q.R_i + dR_i, q.R_e + dR_e
    found = triangle(OA=OA, OC_e=OB - float(sprag.r_e), m=sprag.m)
    nu, _ = strut(OA=OA, OB=OB, beta=found.beta)
    turned = np.log(found.rho / sprag.rho_0) / sprag.m - (found.eta - sprag.eta_0)
    return float(nu), float(turned)


def slopes(q: SpragInputs) -> dict[str, float]:
    """What the races' radii do to the wedge angle and to where the sprag stands [rad/m]."""
    found, h = {}, STEP * q.R_i
    for name in ("R_i", "R_e"):
        low, high = (first_contact(q, **{f"d{name}": s * h}) for s in (-1, 1))
        found[f"dnu_0/d{name}"] = (high[0] - low[0]) / (2 * h)
        found[f"dalpha/d{name}"] = (high[1] - low[1]) / (2 * h)
    return found


@lru_cache(maxsize=16)
def analytic_state(q: SpragInputs) -> dict[str, float]:
    """The state under the torque, nothing where there is none."""
    now, one = under(q), built(q)
    if now is None:
        return {}
    N, y = float(now.N), now.yields
    inner, outer = one.pressed(N)
    half = one.pressed(HALF * N)
    turn = float(rolled(one.clutch, N))
    rigid = at_torque(one.clutch.rigid_races(), q.T)
    other = printed.wedged(
        one.clutch,
        first_reach(
            lambda F: printed.wedged(one.clutch, F).T, np.asarray(q.T), start=np.asarray(N)
        ),
    )
    return {
        "N": N, "N_e": float(now.N_e), "nu": float(now.nu), "omega": float(now.omega),
        "OA": float(now.OA), "alpha": float(now.alpha_b), "theta": turn,
        "turned": float(now.turned),
        "stiffness": stiffness(one.clutch, N), "T/theta": q.T / turn,
        "d_HI": float(y.contact_i), "d_HE": float(y.contact_e), "d_BI": float(y.race_i),
        "d_BE": float(y.race_e), "d_g": float(y.sprag), "H": float(y.H),
        "p_i": float(inner.peak_pressure.max()), "p_o": float(outer.peak_pressure.max()),
        "p_i mid": mid(inner), "p_o mid": mid(outer),
        "p_i mid, half": mid(half[0]), "p_o mid, half": mid(half[1]),
        "p_i peak, half": float(half[0].peak_pressure.max()),
        "p_o peak, half": float(half[1].peak_pressure.max()),
        "mu_req": float(np.tan(now.nu)), "safety": q.mu_s / float(np.tan(now.nu)),
        "N Liu": float(rigid.N), "alpha Liu": float(rigid.alpha_b),
        "theta Liu": float(rolled(one.clutch.rigid_races(), float(rigid.N))),
        "N printed": float(other.N), "alpha printed": float(other.alpha_b),
    }  # fmt: skip
