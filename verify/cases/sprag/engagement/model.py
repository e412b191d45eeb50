"""Model of a sprag clutch for an engagement: contacts, spring, moving parts.

This module contains formulas only, no compiled code.
"""

import math
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact import crown, slices, strips
from analytic.contact.sliced import SlicedContact
from analytic.contact.strips import Strips
from analytic.sprag.clutch import SpragClutch
from analytic.sprag.laws import LOADS, Law, sliced_law
from analytic.sprag.motion import Motion
from analytic.sprag.parts import SpragClutchParts
from analytic.sprag.race_spring import CACHE_SIZE, Blades, RaceSpring, reached
from verify.cases.sprag.inputs import EngagementInputs, SpragInputs
from verify.core.figures import Array

LAWS = 2048  # laws of both contacts: crowns of two factorials and of the searches after them
HEADROOM = 2.5  # over the static load: a sudden load reaches nearly twice the static load


def parts(q: SpragInputs) -> SpragClutchParts:
    """Dimensions and material of the clutch."""
    return SpragClutchParts(
        sprag=q.sprag, n_s=q.z, l=q.l, b=q.b, R_id=q.R_id, R_ed=q.R_ed, E=q.E, nu=q.nu,
        rho=q.density, omega=q.n,
    )  # fmt: skip


def crowned_for(q: SpragInputs) -> float:
    """Design load [N] of the crown: Q or, if Q is not given, the static load of rigid bodies."""
    return q.Q or q.T / (q.z * q.R_i * math.tan(q.nu_0))


def gap(q: SpragInputs) -> Array:
    """Drop [m] of the crown at the centres of the slices, shape (slices,)."""
    y = crown.slice_centres(length=q.l, slices=q.slices)
    if q.z_m == 0:
        return np.zeros_like(y)
    return crown.logarithmic(
        y, K_1=q.K_1, K_2=q.K_2, z_m=q.z_m, load=crowned_for(q), length=q.l,
        E_star=float(parts(q).E_star),
    )  # fmt: skip


def in_slices(q: SpragInputs, gap: Array, R: ArrayLike, N: ArrayLike) -> SlicedContact:
    """Contact by slices with the relative radius R [m] and the drop `gap` [m], under N [N]."""
    return slices.press_slices(gap, length=q.l, R=R, E_star=float(parts(q).E_star), load=N)


def in_strips(q: SpragInputs, gap: Array, R: ArrayLike, N: ArrayLike) -> Strips:
    """Contact by strips on a half-space, with the drop `gap` [m] at their centres, under N [N]."""
    return strips.press_strips(gap, length=q.l, R=R, E_star=float(parts(q).E_star), load=N)


@lru_cache(maxsize=LAWS)
def _law(gap: tuple[float, ...], **contact: Any) -> Law:
    """Law of a contact by `sliced_law`, computed once for all torques and motions of a clutch."""
    return sliced_law(gap, **contact)


def clutch(q: SpragInputs, N_end: float, loads: int = LOADS) -> SpragClutch:
    """The clutch with contacts by slices, solved at `loads` loads up to N_end [N]."""
    whole, drop = parts(q), tuple(gap(q).tolist())
    E_star = float(whole.E_star)
    inner, outer = (
        _law(drop, l=q.l, R=float(R), E_star=E_star, N_max=float(N_end), loads=loads)
        for R in (whole.R_contact_i, whole.R_contact_e)
    )
    return SpragClutch(
        sprag=q.sprag, n_s=q.z, compliance=whole.compliance(contact_i=inner, contact_e=outer)
    )


@lru_cache(maxsize=CACHE_SIZE)
def wedge(q: EngagementInputs, *, rigid: bool = False) -> RaceSpring:
    """Clutch as a spring, tabulated up to the largest expected force or the end of the profile.

    The races are rigid (Liu) if `rigid`.
    """

    def made(N: float) -> SpragClutch:
        found = clutch(q, N)
        return found.rigid_races() if rigid else found

    return reached(
        made, HEADROOM * crowned_for(q), T=q.T, kinetic=q.I_bi * q.w_i**2 / 2,
        blades=Blades(K_r=q.K_r, alpha_max=q.alpha_max),
    )  # fmt: skip


def motion(q: EngagementInputs) -> Motion:
    """Inertias, springs, damping and friction of the clutch."""
    return Motion(
        m_g=q.m_g, I_g=q.I_g, I_bi=q.I_bi, I_be=q.I_be, K_r=q.K_r, alpha_max=q.alpha_max,
        C_rl=q.C_rl, k_out=q.k_out, mu_s=q.mu_s, mu_c=q.mu_c, gamma_b=q.gamma_b,
    )  # fmt: skip
