"""Sprag clutch with crowned contacts: pressures by slices under its normal forces."""

import math
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

from analytic.contact import slices
from analytic.contact.checks import Array
from analytic.contact.sliced import SlicedContact
from analytic.sprag.closure import Wedged, wedged
from analytic.sprag.clutch import SpragClutch
from analytic.sprag.course import rolled
from analytic.sprag.parts import SpragClutchParts

LEAST = 1e-4  # relative to the largest load: below, no pressure is searched
STEP = 1e-3  # relative to a force, for slopes


@dataclass(frozen=True, eq=False)
class Crowned:
    """Clutch with the crown `gap` [m] of its slices, valid for forces up to `N_top` [N]."""

    parts: SpragClutchParts
    clutch: SpragClutch
    gap: Array
    N_top: float

    def radii(self, now: Wedged) -> tuple[float, float]:
        """Relative radii [m] of the inner and the outer contact in the loaded state `now`."""
        sprag = self.parts.sprag
        r_i = float(now.rho * np.hypot(1, sprag.m))
        R_i = float(np.asarray(sprag.R_i))
        return 1 / (1 / r_i + 1 / R_i), float(self.parts.R_contact_e)

    def pressed(self, N: float) -> tuple[SlicedContact, SlicedContact]:
        """Inner and outer contact in slices under the normal force N [N]."""
        now = wedged(self.clutch, N)
        given = {"length": self.parts.l, "E_star": self.parts.E_star}
        loads = float(now.N), float(now.N_e)
        inner, outer = (
            slices.press_slices(self.gap, R=R, load=load, **given)
            for R, load in zip(self.radii(now), loads, strict=True)
        )
        return inner, outer

    def peaks(self, N: float) -> tuple[float, float]:
        """Largest pressures [Pa] of both contacts under N [N]."""
        inner, outer = self.pressed(N)
        return float(inner.peak_pressure.max()), float(outer.peak_pressure.max())

    def torque_at(self, pressure: float, contact: int) -> float:
        """Torque [N m] at which the peak pressure of contact 0 (inner) or 1 (outer) is `pressure`.

        The result is infinite if the pressure is not reached up to `N_top`.
        """

        def over(log_N: float) -> float:
            return math.log(self.peaks(math.exp(log_N))[contact] / pressure)

        low, high = math.log(LEAST * self.N_top), math.log(self.N_top)
        if over(high) < 0:
            return math.inf
        N = 0.0 if over(low) > 0 else math.exp(brentq(over, low, high, xtol=1e-9))
        T = float(wedged(self.clutch, N).T)
        return T if np.isfinite(T) else math.inf


def mid(contact: SlicedContact) -> float:
    """Pressure [Pa] at mid-length of the contact.

    If mid-length is between two slices, it is the root mean square of their pressures.

    >>> one = slices.press_slices([0.0] * 4, length=1.0, R=1.0, E_star=1.0, load=1.0)
    >>> bool(np.isclose(mid(one), one.peak_pressure[1]))
    True
    """
    p, n = contact.peak_pressure, contact.force.shape[-1]
    return float(np.sqrt((p[(n - 1) // 2] ** 2 + p[n // 2] ** 2) / 2))


def stiffness(clutch: SpragClutch, N: float) -> float:
    """Torsional stiffness dT/dtheta_i [N m/rad] of the clutch under N [N]."""
    around = N * np.array([1 - STEP, 1 + STEP])
    T, turn = wedged(clutch, around).T, rolled(clutch, around)
    return float((T[1] - T[0]) / (turn[1] - turn[0]))
