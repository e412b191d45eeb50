"""Formulas of one's own sprag clutch: its state under torque, its pressures by slices."""

import math
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
from analytic.sprag.limits import Limits, limits
from analytic.sprag.parts import Parts
from analytic.sprag.search import first_reach
from analytic.sprag.start import spring_equilibrium
from verify.cases.sprag.engagement.model import clutch, gap, parts
from verify.cases.sprag.inputs import EngagementInputs, SpragInputs
from verify.core.figures import Array

WIDE = 0.15  # of the inner contact's relative radius: half-widths up to which Hertz is asked
MANY, FEW_LOADS = 61, 21  # slices from which on fewer loads make up a contact's law
HALF = 0.5  # of N, where the ends of a crown are free and strips have a highest pressure
STEP = 1e-6  # of a load or length, for slopes
FAST = 20_000 * 2 * math.pi / 60  # rad/s: the outer race grows by 2 µm


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


def slope(q: SpragInputs, radius: str) -> tuple[float, float]:
    """What a race's radius does to the wedge angle and to the unloaded sprag's turn [rad/m]."""
    h = STEP * q.R_i
    low, high = (first_contact(q, **{radius: s * h}) for s in (-1, 1))
    return (high[0] - low[0]) / (2 * h), (high[1] - low[1]) / (2 * h)


@lru_cache(maxsize=16)
def rigid(q: SpragInputs) -> Wedged | None:
    """The state under the torque with rigid races (Liu); None where there is none with others."""
    return None if under(q) is None else at_torque(built(q).clutch.rigid_races(), q.T)


@lru_cache(maxsize=16)
def literal(q: SpragInputs) -> Wedged | None:
    """The same with Eqs. 9 and 10 as printed."""
    if (now := under(q)) is None:
        return None
    clutch = built(q).clutch
    N = first_reach(
        lambda F: printed.wedged(clutch, F).T, np.asarray(q.T), start=np.asarray(float(now.N))
    )
    return printed.wedged(clutch, N)


def normal_force(state: Wedged | None) -> float:
    """The inner contact's [N]; nan without a state."""
    return math.nan if state is None else float(state.N)


@lru_cache(maxsize=16)
def spring_force(q: EngagementInputs) -> float:
    """Force N_0 [N] of the springs alone; nan where no state that bears them is found."""
    clutch = built(q).clutch
    if not q.alpha_max > wedged(clutch, 0.0).alpha:
        return 0.0
    try:
        now, _ = spring_equilibrium(clutch, K_r=q.K_r, alpha_max=q.alpha_max)
    except ArithmeticError:
        return math.nan
    return float(now.N)


@lru_cache(maxsize=16)
def grip(q: SpragInputs) -> Limits:
    """Torques at which the contacts slip and at which the profile ends."""
    return limits(built(q).clutch, mu=q.mu_s, theta_max=q.alpha_max)


def low_friction(q: SpragInputs) -> float:
    """Friction twice as far above that of first contact as the torque's is: about 2 T slip it.

    At the paper's friction no torque slips: the spiral keeps its wedge angle.
    """
    now = under(q)
    required = math.nan if now is None else float(np.tan(float(now.nu)))
    return 2 * required - float(np.tan(q.sprag.nu_0))


def fast(q: SpragInputs) -> SpragInputs:
    """The clutch with its outer race at 20,000 r/min; the paper's starts at rest."""
    return q.model_copy(update={"n": FAST})
