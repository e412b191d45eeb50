"""Races of a sprag clutch: stresses outside the contacts; deflections relative to Eq. 6."""

import math

import numpy as np

from analytic.ring import lame
from analytic.ring.fourier_ring import Wall
from analytic.ring.smeared import smeared_error
from analytic.sprag.parts import SpragClutchParts

WIDEST = 0.9  # of half a pitch: patches that are wider would overlap


def hoop(p: SpragClutchParts, N: float, N_e: float) -> dict[str, float]:
    """Hoop stresses [Pa] of both races at R_i, R_id and R_e, and Tresca stresses, by name.

    The forces N, N_e [N] of the sprags are uniformly distributed. The stress of the inner race is
    largest at its bore R_id, that of the outer race at R_e.
    """
    R_i, R_e, R_id, R_ed, length = _radii(p)
    inner = {"r_i": R_id, "r_o": R_i, "p_i": 0.0, "p_o": p.n_s * N / (2 * math.pi * R_i * length)}
    outer = {"r_i": R_e, "r_o": R_ed, "p_i": p.n_s * N_e / (2 * math.pi * R_e * length)}
    _, around_i = lame.stresses([R_i, R_id], **inner)
    radial, around_e = lame.stresses(R_e, **outer)
    return {
        "s_i": float(around_i[0]), "s_id": float(around_i[1]), "s_e": float(around_e),
        "Tresca_i": float(-around_i[1]), "Tresca_e": float(around_e - radial),
    }  # fmt: skip


def over_smeared(p: SpragClutchParts, a: float, loaded: Wall) -> float:
    """Ratio of a race deflection under patches of half-width `a` [m] to the deflection by Eq. 6.

    Eq. 6 assumes a uniform load. The deflection excludes the indentation.
    """
    R_i, R_e, R_id, R_ed, _ = _radii(p)
    r, ratio = (R_i, R_i / R_id) if loaded == "rim" else (R_e, R_ed / R_e)
    a_r = min(a / r, WIDEST * math.pi / p.n_s)
    return 1 / (1 + smeared_error(n=p.n_s, ratio=ratio, a_r=a_r, nu=p.nu, loaded=loaded).load)


def _radii(p: SpragClutchParts) -> tuple[float, ...]:
    """Radii R_i, R_e, R_id, R_ed and length l [m] as floats."""
    return tuple(float(np.asarray(x)) for x in (p.sprag.R_i, p.sprag.R_e, p.R_id, p.R_ed, p.l))
